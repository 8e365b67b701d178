"""Share of each material in the visible area of an asset."""

from collections.abc import Iterable

import numpy as np

from rna_export.capture.geometry.exported_parts import ExportedParts
from rna_export.capture.preflight.material_record import MaterialFacts
from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.capture.rays.view_rays import outside_rays

_RAYS = 16384


def visible_shares(
    exported: ExportedParts, scene: AssetScene, facts: Iterable[MaterialFacts]
) -> dict[str, float]:
    """Share of each material, by its full name, of the hits of rays from all sides.

    Those of strands have a share of them each that is the same.
    """
    rays = outside_rays(scene, _RAYS, "sphere", np.random.default_rng(0))
    first = scene.first_hits(rays.origins, rays.directions)
    hits = max(int((first.geometry >= 0).sum()), 1)
    on_hair = [each.full_name for each in facts if "hair" in each.kinds]
    result: dict[str, float] = {}
    for k, name in enumerate(exported.geometries):
        on = first.geometry == k
        if name not in exported.materials:
            for hair in on_hair:
                result[hair] = result.get(hair, 0.0) + float(on.sum()) / len(on_hair) / hits
            continue
        of_hits = exported.materials[name][first.primitive[on]]
        materials, counts = np.unique(of_hits, return_counts=True)
        for material, count in zip(materials, counts, strict=True):
            result[str(material)] = result.get(str(material), 0.0) + float(count) / hits
    return result
