"""The exported geometry: repair, pieces, and stored form."""
