"""`rna-motion`: motions of packages, as files."""
