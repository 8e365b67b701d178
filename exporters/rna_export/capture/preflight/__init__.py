"""What each material of a source is, and how well it will be learnt, before the first ray."""
