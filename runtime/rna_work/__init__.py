"""Long work in many pieces, on this machine's threads and processes, or on a Ray cluster."""
