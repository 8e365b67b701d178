"""Every case of the corpus: the modules that register them, and their list."""

from __future__ import annotations

from tests.package.corpus import (
    base_color_cases,
    container_cases,
    content_cases,
    curve_cases,
    extension_cases,
    manifest_cases,
    normal_map_cases,
    part_cases,
    quantised_cases,
)
from tests.package.corpus.registry import CASES as REGISTERED

MODULES = (
    container_cases,
    manifest_cases,
    content_cases,
    curve_cases,
    part_cases,
    normal_map_cases,
    base_color_cases,
    quantised_cases,
    extension_cases,
)

CASES = [c for m in MODULES for c in REGISTERED if c.breaker.__module__ == m.__name__]
"""In one order, whatever was imported first."""
