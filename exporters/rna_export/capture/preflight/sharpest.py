"""Roughness of the sharpest highlights that view rays look for."""

from collections.abc import Iterable

from rna_export.capture.capture_settings import LEAST_ROUGHNESS, SHARPEST
from rna_export.capture.preflight.material_record import MaterialFacts


def sharpest_of(materials: Iterable[MaterialFacts]) -> tuple[float, str | None]:
    """That of a capture, and the name of the material that it is for; None for the usual one."""
    rough = [(each.roughness, each.name) for each in materials if each.roughness is not None]
    least, name = min(rough, default=(SHARPEST, None))
    return (max(least, LEAST_ROUGHNESS), name) if least < SHARPEST else (SHARPEST, None)
