"""Share of each material in the visible area of an asset, and of that what mirrors the asset."""

from collections.abc import Iterable

import numpy as np

from rna_export.capture.geometry.exported_parts import ExportedParts
from rna_export.capture.preflight.material_record import MaterialFacts, Visible
from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.capture.rays.view_rays import outside_rays

_RAYS = 16384


def visible_shares(
    exported: ExportedParts, scene: AssetScene, facts: Iterable[MaterialFacts]
) -> dict[str, Visible]:
    """By full name of a material, from the hits of rays from all sides, which panes let through.

    Those of strands have a share of them each that is the same, and mirror nothing.
    """
    rng = np.random.default_rng(0)
    rays = outside_rays(scene, _RAYS, "sphere", rng)
    first = scene.first_hits(rays.origins, rays.directions, rng)
    names = np.full(len(rays), "", object)  # that of strands
    for k, triangles in enumerate(map(exported.materials.get, exported.geometries)):
        if triangles is not None:
            names[first.geometry == k] = triangles[first.primitive[first.geometry == k]]
    hit = np.flatnonzero(first.geometry >= 0)
    names, d, normals = names[hit], rays.directions[hit], first.ng[hit]
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), np.float32(1e-30))
    cosines = np.sum(d * normals, axis=1, keepdims=True)
    points, mirrored = rays.origins[hit] + first.t[hit, None] * d, d - 2.0 * cosines * normals
    meets = np.isfinite(scene.free_distance(points, -np.sign(cosines) * normals, mirrored))
    on = {str(name): names == name for name in set(names) - {""}}
    hair = [each.full_name for each in facts if "hair" in each.kinds]
    of_hair = Visible(float(np.sum(names == "")) / max(len(hair) * len(hit), 1))
    surfaces = {m: Visible(float(here.mean()), float(meets[here].mean())) for m, here in on.items()}
    return dict.fromkeys(hair, of_hair) | surfaces
