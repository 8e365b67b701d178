"""`rna-run`: images, sequences, pieces of an image, and progress."""
