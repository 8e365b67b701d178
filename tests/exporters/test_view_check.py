"""Assets that view rays hardly meet: why is said before a capture begins."""

from pathlib import Path

import numpy as np
import pytest

from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.capture.rays.view_check import check_seen
from rna_sdk.errors import CaptureError
from rna_sdk.package import Curves, Mesh
from rna_sdk.package.textures.transmittance import Transmittance
from tests.exporters.meshes import merged, moved, sphere, square

SOURCE = Path("asset.glb")


def tuft(stray: float = 0.0) -> Curves:
    """200 strands of two points in a box of 0.1; the root of strand 7 is `stray` away."""
    rng = np.random.default_rng(1)
    points = rng.uniform(-0.05, 0.05, (200, 2, 3)).astype(np.float32)
    points[7] += np.float32([0.0, stray, 0.0])
    offsets = np.arange(201, dtype=np.uint32) * 2
    return Curves(points.reshape(-1, 3), np.full(400, 0.001, np.float32), offsets)


def check(geometry: Mesh | Curves, holes: tuple[Transmittance, ...] = ()) -> list[str]:
    scene = AssetScene([geometry], transmittances=[holes])
    return check_seen(SOURCE, scene, {"asset": geometry}, "sphere")


@pytest.mark.parametrize("geometry", [tuft(), tuft(0.3), sphere(2), square(1.0)])
def test_ordinary_assets_have_no_note(geometry):
    assert check(geometry) == []


def test_a_stray_strand_is_named():
    with pytest.raises(CaptureError, match=r"^asset\.glb: strand 7 of part 'asset' is 1,000 m "):
        check(tuft(1000.0))


def test_a_stray_strand_near_by_is_a_note():
    (note,) = check(tuft(2.0))
    assert note.startswith("strand 7 of part 'asset' is 2 m from the rest")


def test_a_stray_triangle_is_named():
    """Which piece it is, counted by its first vertex."""
    with pytest.raises(CaptureError, match="piece 1 of part 'asset' is 5,000 m from"):
        check(merged(sphere(2), moved(square(0.1), (5000.0, 0.0, 0.0))))


def test_holes_all_over_leave_nothing_to_see():
    mesh = square(1.0)
    hole = Transmittance(0, len(mesh.triangles), np.full((1, 1, 1), 255, np.uint8), 0.5, None)
    with pytest.raises(CaptureError, match="all rays pass through its surfaces"):
        check(mesh, (hole,))
