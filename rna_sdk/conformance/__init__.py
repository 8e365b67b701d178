"""Whether a reader of `.rna` packages agrees with the format: the kit, and `rna-conform`."""
