"""A module a case."""

CASE_NAMES = (
    "sharp",
    "grazing",
    "near-light",
    "unseen",
    "shadow-edges",
    "thin",
    "zoom",
    "noise",
    "little-data",
    "luck",
    "energy",
)
