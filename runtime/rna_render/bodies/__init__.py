"""Bodies: what rays hit (`kinds`), and points on it with how they scatter light (`points`)."""
