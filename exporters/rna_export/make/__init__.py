"""`rna-make`: from a model to a package that is as good as asked for, in one command."""
