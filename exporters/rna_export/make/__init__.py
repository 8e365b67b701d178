"""`rna-make`: from a model to a package that meets an error target, in one command."""
