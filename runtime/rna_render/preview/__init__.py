"""`rna-run --preview`: the scene in a browser page, while it is rendered."""
