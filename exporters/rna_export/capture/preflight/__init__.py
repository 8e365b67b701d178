"""The materials of a source, and how well each will be learnt, before the first ray."""
