"""RNA SDK: read, validate and evaluate relightable neural assets (`.rna` packages)."""

__version__ = "0.1.0"
