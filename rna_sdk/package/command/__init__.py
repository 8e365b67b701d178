"""The commands `rna-info`, `rna-validate` and `rna-pack`."""
