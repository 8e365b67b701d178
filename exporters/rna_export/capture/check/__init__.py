"""The check of a capture against Cycles."""
