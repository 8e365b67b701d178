"""Broken packages: one small function each, made from a good package, with the code expected."""
