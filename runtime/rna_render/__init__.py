"""The reference path tracer for relightable neural assets, and `rna-run`."""
