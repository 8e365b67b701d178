"""Every case of the corpus: the modules that register them, and their list."""

from tests.package.corpus import (
    base_color_cases,
    container_cases,
    content_cases,
    curve_cases,
    decoder_cases,
    extension_cases,
    manifest_cases,
    nearby_cases,
    normal_map_cases,
    part_cases,
    quantised_cases,
)

MODULES = (
    container_cases,
    manifest_cases,
    content_cases,
    decoder_cases,
    curve_cases,
    part_cases,
    normal_map_cases,
    base_color_cases,
    nearby_cases,
    quantised_cases,
    extension_cases,
)

CASES = [case for module in MODULES for case in module.CASES]
