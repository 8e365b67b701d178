"""The check of a capture against Cycles, with a teacher that renders geometry of its own."""

import io
from dataclasses import dataclass, replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.blender_process.exchanged_files import RenderedRays
from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.check.disagreement import ELSEWHERE, EXTRA, MISSING, TURNED
from rna_export.capture.check.self_check import PICTURE, SelfCheck, picture_side
from rna_export.capture.geometry.exported_parts import exported_parts
from rna_export.capture.opened_source import refuse_nothing
from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.capture.rays.traced_rays import TracedRays
from rna_export.capture.rays.view_rays import ViewRays, sample_view_rays
from rna_export.make.rna_make import _saved_picture
from rna_sdk.errors import CaptureError
from rna_sdk.package import Curves, Mesh
from rna_sdk.package.textures.transmittance import Transmittance
from rna_trace import SurfacePoints
from tests.exporters.meshes import merged, moved, sphere, square

WI = np.array([0.0, 1.0, 0.0], np.float32)
SAMPLES = 4
BALL = sphere(3)
CARD = replace(square(2.0), uvs=np.float32([[0, 1], [1, 1], [1, 0], [0, 0]]))
SMALL = moved(sphere(2, radius=0.3), (1.4, 0.0, 0.0))


class Cycles:
    """Answers rays as Cycles does, from a scene that need not be the exported one."""

    def __init__(self, scene: AssetScene, turn: float = 0.0, filter_width: float = 0.0):
        self._scene, self._turn, self._width = scene, np.radians(turn), filter_width
        self._rng = np.random.default_rng(7)

    def render_rays(
        self, origins, directions, wi, samples, seed, reach=None, normals=False
    ) -> RenderedRays:
        share = self._scene.coverage(origins, directions)
        if reach is not None:
            share = share * (self._scene.distance(origins, directions) <= reach)
        alpha = (self._rng.random((samples, len(share))) < share).mean(axis=0)
        points = self._scene.shade_points(origins, directions)
        normal = np.zeros_like(points.position)
        for on in points.on:
            if isinstance(on.points, SurfacePoints):
                normal[on.rows] = self._towards(on.points.mapped, directions[on.rows])
        answers = np.abs(directions), alpha.astype(np.float32), points.position, None, normal
        return RenderedRays(*answers)

    def render_pixel_centres(self, camera, wi, samples, seed):
        pixels = np.arange(camera.width * camera.height, dtype=np.uint32)
        u = 0.5 + self._width * (self._rng.random((len(pixels), 2)) - 0.5)
        directions = camera.directions(pixels, u)
        return self.render_rays(
            np.tile(camera.position, (len(pixels), 1)), directions, wi, samples, seed
        )

    def _towards(self, normals: np.ndarray, directions: np.ndarray) -> np.ndarray:
        facing = normals * -np.sign(np.sum(normals * directions, axis=1, keepdims=True))
        other = np.cross(facing, [[0.3, 0.5, 0.8]])
        other /= np.linalg.norm(other, axis=1, keepdims=True)
        return np.cos(self._turn) * facing + np.sin(self._turn) * other


@dataclass
class Card:
    """Answers what radiance a white card has."""

    radiance: float

    def render_card(self) -> float:
        return self.radiance


def checked(
    exported: AssetScene, rendered: AssetScene, turn: float = 0.0, filter_width: float = 0.0
) -> SelfCheck:
    """What a capture of `exported` finds if Cycles renders `rendered`."""
    check, cycles = SelfCheck(exported, SAMPLES, normals=True), Cycles(rendered, turn, filter_width)
    check.render_chords(cycles, WI, 2048, "sphere", 0)
    rng = np.random.default_rng(1)
    rays = sample_view_rays(exported, WI, 1024, "sphere", rng)
    check.add(TracedRays.of(exported, cycles, rays, WI, SAMPLES, 0, rng, False, True))
    check.render_picture(cycles, "test.blend")
    return check


def holes(mesh: Mesh, value: int, cutoff: float | None) -> AssetScene:
    """A scene whose mesh lets value / 255 of the light through where u is below 1 / 2."""
    texture = np.zeros((4, 4, 1), np.uint8)
    texture[:, :2] = value
    return AssetScene(
        [mesh], transmittances=[(Transmittance(0, len(mesh.triangles), texture, cutoff, None),)]
    )


def strands(radius: float, at: float = 0.0, count: int = 40) -> AssetScene:
    turns = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    ends = np.stack([np.cos(turns) + at, np.zeros(count), np.sin(turns)], axis=1)
    tops = ends + np.array([0.0, 1.0, 0.0])
    points = np.stack([ends, tops], axis=1).reshape(-1, 3).astype(np.float32)
    return AssetScene(
        [
            Curves(
                points,
                np.full(2 * count, radius, np.float32),
                np.arange(0, 2 * count + 1, 2, dtype=np.uint32),
            )
        ]
    )


@pytest.mark.parametrize(
    "scene",
    [
        AssetScene([BALL]),
        AssetScene([BALL, moved(BALL, (3.0, 0.0, 0.0))]),
        AssetScene([BALL], positions=[BALL.positions[:, [1, 2, 0]]]),
        holes(CARD, 255, 0.5),
        holes(CARD, 100, None),
        strands(0.05),
    ],
    ids=["surface", "parts", "pose", "holes", "thin", "fibers"],
)
def test_what_is_rendered_as_it_was_exported_has_no_note(scene):
    check = checked(scene, scene, turn=5.0)
    assert check.note() is None
    assert check.picture is None
    assert check.used_rays > 0.5 * check.rays  # a ray that passes what is thin may meet nothing


def test_strands_thinner_than_a_pixel_have_no_note():
    """Cycles' least filter of 0.01 pixels moves rays by a good part of such a strand's width."""
    scene = strands(5e-4, count=2000)
    assert checked(scene, scene, filter_width=0.01).note() is None


@pytest.mark.parametrize(
    ("exported", "rendered", "kind"),
    [
        (AssetScene([BALL, SMALL]), AssetScene([BALL]), MISSING),
        (AssetScene([BALL]), AssetScene([merged(BALL, SMALL)]), EXTRA),
        (AssetScene([BALL]), AssetScene([sphere(3, radius=0.99)]), ELSEWHERE),
        (holes(CARD, 0, 0.5), holes(CARD, 255, 0.5), MISSING),
        (holes(CARD, 255, 0.5), holes(CARD, 0, 0.5), EXTRA),
        (holes(CARD, 40, None), holes(CARD, 120, None), MISSING),
        (holes(CARD, 120, None), holes(CARD, 40, None), EXTRA),
        (strands(0.05), strands(0.04), MISSING),
        (strands(0.05), strands(0.05, at=0.02), ELSEWHERE),
    ],
)
def test_what_differs_is_told(exported, rendered, kind):
    check = checked(exported, rendered)
    assert check.shares[kind] >= 0.01
    assert kind in check.worth_telling()
    assert Image.open(io.BytesIO(check.picture)).size[0] == 3 * 384


def test_other_normals_are_told_of_surfaces_whose_relief_is_mapped():
    scene = AssetScene([BALL])
    check = checked(scene, scene, turn=40.0)
    assert set(check.worth_telling()) == {TURNED}
    assert check.shares[TURNED] > 0.8
    unmapped = SelfCheck(scene, SAMPLES, normals=False)
    unmapped.render_chords(Cycles(scene, 40.0), WI, 2048, "sphere", 0)
    assert unmapped.note() is None


def test_normals_of_the_picture_alone_are_not_told():
    """Slopes of Bump nodes follow from the size of a pixel, which is larger there."""
    scene = AssetScene([BALL])
    check = SelfCheck(scene, SAMPLES, normals=True)
    check.render_chords(Cycles(scene), WI, 2048, "sphere", 0)
    check.render_picture(Cycles(scene, turn=40.0), "test.blend")
    assert check.note() is None


@pytest.mark.blender
def test_normals_that_cycles_bends_are_not_told(open_worker):
    """Few faces, smooth: normals far from the triangles', which Cycles bends to the viewer."""
    worker = open_worker("""
text = bpy.data.curves.new("letters", "FONT")
text.body, text.extrude, text.bevel_depth, text.resolution_u = "Wax", 0.16, 0.03, 3
bpy.context.scene.collection.objects.link(bpy.data.objects.new("letters", text))
text.materials.append(principled(Subsurface_Weight=1.0))
""")
    scene = AssetScene(tuple(exported_parts(worker, CaptureSettings()).geometries.values()))
    check = SelfCheck(scene, SAMPLES, normals=True)
    check.render_chords(worker, WI, 4096, "sphere", 0)
    assert check.shares == dict.fromkeys(check.shares, 0.0)


@pytest.mark.parametrize(("radiance", "reported"), [(0.3183, False), (1.2732, True), (0.31, True)])
def test_light_that_settings_change_is_told(radiance, reported):
    check = SelfCheck(AssetScene([BALL]), SAMPLES, normals=True)
    check.render_card(Card(radiance))
    assert (check.note() is not None) == reported


def test_the_picture_is_taken_from_where_most_differs():
    below = moved(sphere(2, radius=0.2), (0.0, -1.0, 0.0))
    check = checked(AssetScene([BALL]), AssetScene([merged(BALL, below)]))
    assert check._camera().position[1] < -1.0


def test_the_picture_marks_what_is_missing_in_red_and_what_is_not_exported_in_blue():
    check = checked(AssetScene([BALL]), AssetScene([merged(BALL, SMALL)]))
    pixels = np.asarray(Image.open(io.BytesIO(check.picture)), np.int32)
    marked = pixels[60:420, 2 * 384 :].reshape(-1, 3)
    blue = (marked == (31, 119, 230)).all(axis=1)
    red = (marked == (214, 39, 40)).all(axis=1)
    assert blue.mean() > 0.005
    assert not red.any()


def test_nothing_kept_is_an_error_of_one_line():
    check = checked(AssetScene([BALL]), AssetScene([moved(sphere(2), (100.0, 0.0, 0.0))]))
    assert not check.used_rays
    with pytest.raises(CaptureError, match=r"^ball.gltf: none of 1,024 view rays can be kept: "):
        refuse_nothing(check, Source(Path("ball.gltf")))


def test_rna_make_keeps_the_picture_beside_the_package(tmp_path):
    options = SimpleNamespace(work=tmp_path / "toy.make")
    assert _saved_picture(options, tmp_path / "toy.rna") is None
    rays = tmp_path / "toy.make" / "rays"
    rays.mkdir(parents=True)
    (rays / PICTURE).write_bytes(b"a PNG")
    picture = _saved_picture(options, tmp_path / "toy.rna")
    assert picture == tmp_path / "toy.disagreement.png"
    assert picture.read_bytes() == b"a PNG"


@pytest.mark.parametrize(("rays", "side"), [(64, 48), (4096, 101), (16384, 128)])
def test_the_picture_costs_no_more_than_a_render_of_view_rays(rays, side):
    assert picture_side(rays) == side


def test_a_ray_that_neither_meets_is_no_disagreement():
    scene = AssetScene([BALL])
    away = ViewRays(np.full((8, 3), 9.0, np.float32), np.tile(np.float32([0, 0, 1]), (8, 1)))
    check = SelfCheck(scene, SAMPLES, normals=True)
    rng = np.random.default_rng(0)
    check.add(TracedRays.of(scene, Cycles(scene), away, WI, SAMPLES, 0, rng, False))
    assert check.note() is None
    assert (check.rays, check.used_rays) == (8, 0)
