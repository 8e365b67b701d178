"""Strands and materials of Alembic and USD files: places, units, widths, splines, looks."""

import subprocess
from pathlib import Path

import numpy as np
import pytest

from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.capture.rays.view_rays import sample_view_rays
from rna_sdk.errors import CaptureError
from rna_sdk.package import Curves
from tests.exporters.conftest import OpenWorker
from tests.exporters.cycles import trace, unit
from tests.exporters.scenes import write_scene

pytestmark = pytest.mark.blender

HEADER = '#usda 1.0\n(\n    metersPerUnit = 0.01\n    upAxis = "Y"\n)\n'


def curves(body: str) -> str:
    return f'def BasisCurves "hair"\n{{\n{body}\n}}\n'


def widths(values: list[float], interpolation: str) -> str:
    return f'float[] widths = {values} ( interpolation = "{interpolation}" )\n'


# Two strands of 2 and 3 points, centimetres.
LINES = """
    int[] curveVertexCounts = [2, 3]
    point3f[] points = [(0, 0, 0), (0, 100, 0), (100, 0, 0), (100, 100, 0), (100, 100, 200)]
    uniform token type = "linear"
"""
SPLINE = """
    int[] curveVertexCounts = [5]
    point3f[] points = [(0, 0, 0), (0, 100, 0), (100, 0, 0), (100, 100, 0), (0, 0, 100)]
    uniform token type = "cubic"
    uniform token basis = "bspline"
"""
POINTS = np.array([[0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0], [1, 1, 2]])


def exported(
    open_worker: OpenWorker, folder: Path, text: str, *arguments: str, **how: int
) -> Curves:
    path = folder / "hair.usda"
    path.write_text(HEADER + text)
    return open_worker(path, *arguments, **how).export_curves()


def test_units_axes_and_constant_widths(open_worker, tmp_path):
    text = curves(LINES + widths([2.0], "constant"))
    actual = exported(open_worker, tmp_path, text)
    np.testing.assert_allclose(actual.points, POINTS, atol=1e-6)
    np.testing.assert_allclose(actual.radii, 0.01)
    assert actual.offsets.tolist() == [0, 2, 5]
    np.testing.assert_allclose(
        exported(open_worker, tmp_path, text, "--unit", "10").radii, 0.1, rtol=1e-6
    )


def test_hierarchies_and_instances(open_worker, tmp_path):
    """A prototype in a class that is shown twice, below a parent that moves and scales."""
    body = curves(LINES + widths([2.0, 4.0], "uniform"))
    moved = "double3 xformOp:translate = (0, 0, 50)\n"
    scaled = "float3 xformOp:scale = (2, 2, 2)\n"
    order = 'uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:scale"]\n'
    instance = 'def "{}" (\n    instanceable = true\n    references = </proto>\n)\n{{\n{}}}\n'
    text = (
        f'class Xform "proto"\n{{\n{body}}}\ndef Xform "root"\n{{\n{moved}{scaled}{order}'
        + instance.format("one", "")
        + instance.format("two", scaled + 'uniform token[] xformOpOrder = ["xformOp:scale"]\n')
        + "}\n"
    )
    actual = exported(open_worker, tmp_path, text)
    expected = [k * POINTS + [0, 0, 0.5] for k in (2, 4)]
    np.testing.assert_allclose(actual.points, np.concatenate(expected), atol=1e-5)
    radii = np.repeat([0.01, 0.02], [2, 3])
    np.testing.assert_allclose(actual.radii, np.concatenate([2 * radii, 4 * radii]), rtol=1e-5)


def test_pinned_splines_keep_their_ends(open_worker, tmp_path):
    text = curves(SPLINE + 'uniform token wrap = "pinned"\n' + widths([2, 2, 2, 2, 6], "vertex"))
    actual = exported(open_worker, tmp_path, text)
    np.testing.assert_allclose(actual.points[[0, -1]], [[0, 0, 0], [0, 0, 1]], atol=1e-6)
    np.testing.assert_allclose(actual.radii[[0, -1]], [0.01, 0.03], rtol=1e-5)
    assert actual.points[:, 1].max() < 0.7  # the points themselves are not on the strand


def test_strands_without_widths(open_worker, tmp_path):
    actual = exported(open_worker, tmp_path, curves(LINES))
    root = np.sqrt(1 + 1 + 4) / 2 / 2000
    np.testing.assert_allclose(actual.radii[[0, 1, 2, 4]], root * np.array([1, 0.3, 1, 0.3]))
    given = exported(open_worker, tmp_path, curves(LINES), "--radius", "0.01", "--tip", "1")
    np.testing.assert_allclose(given.radii, 0.01, rtol=1e-6)


def test_widths_that_do_not_fit_are_named(open_worker, tmp_path):
    text = curves(LINES + widths([1, 2, 3], "uniform"))
    with pytest.raises(CaptureError, match=r"hair\.usda: /hair: found 3 widths, expected 2"):
        exported(open_worker, tmp_path, text)


def test_a_frame_can_be_chosen(open_worker, tmp_path):
    points = LINES.splitlines()[2].split(" = ")[1]
    moved = points.replace("(0, 100, 0)", "(0, 300, 0)")
    samples = f"point3f[] points.timeSamples = {{ 1: {points}, 5: {moved} }}\n"
    body = LINES.replace(LINES.splitlines()[2], samples) + widths([2, 2], "uniform")
    assert exported(open_worker, tmp_path, curves(body)).points[:, 1].max() == pytest.approx(1.0)
    actual = exported(open_worker, tmp_path, curves(body), rest_frame=5)
    assert actual.points[:, 1].max() == pytest.approx(3.0)


ALEMBIC = """
bpy.ops.wm.read_factory_settings(use_empty=True)
data = bpy.data.hair_curves.new("hair")
data.add_curves([5])
data.position_data.foreach_set("vector", [0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, -1, 0])
radius = data.attributes.new("radius", "FLOAT", "POINT")
radius.data.foreach_set("value", [0.01] * 5)
data.set_types(type=TYPE)
item = bpy.data.objects.new("hair", data)
item.location, item.scale = (0, 0, 3), (2, 2, 2)
bpy.context.scene.collection.objects.link(item)
bpy.ops.wm.alembic_export(filepath=PATH)
"""


@pytest.mark.parametrize(("kind", "points"), [("POLY", 5), ("NURBS", 9)])
def test_alembic_strands(kind, points, open_worker, tmp_path, blender_python):
    path = tmp_path / "hair.abc"
    script = write_scene(tmp_path, "save", f"TYPE, PATH = {kind!r}, {str(path)!r}\n{ALEMBIC}")
    subprocess.run([blender_python, script], capture_output=True)  # bpy may complain on exit
    actual = open_worker(path).export_curves()
    assert len(actual.points) == points
    np.testing.assert_allclose(actual.radii, 0.02, rtol=1e-5)
    x, y, z = (actual.points - [0, 3, 0]).T / 2
    line = np.array([[0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0], [0, 0, 1]])
    first = line[0] if kind == "POLY" else (line[0] + 4 * line[1] + line[2]) / 6
    np.testing.assert_allclose([x[0], y[0], z[0]], first, atol=1e-5)


def brightness(worker: BlenderWorker) -> float:
    ours, wi = AssetScene([worker.export_curves()]), unit(1, 2, 3)
    rays = sample_view_rays(ours, wi, 1024, "sphere", np.random.default_rng(0))
    return float(worker.render_rays(rays.origins, rays.directions, wi, 4, 1).radiance.mean())


def test_strands_without_material_get_that_of_grooms(open_worker, tmp_path):
    path = tmp_path / "hair.usda"
    path.write_text(HEADER + curves(LINES + widths([4.0], "constant")))
    black, white = (brightness(open_worker(path, "--melanin", m)) for m in ("1", "0"))
    assert white > 3.0 * black > 0.0


PREVIEW = """
def Mesh "square" ( prepend apiSchemas = ["MaterialBindingAPI"] )
{
    int[] faceVertexCounts = [4]
    int[] faceVertexIndices = [0, 1, 2, 3]
    point3f[] points = [(-100, 0, 100), (100, 0, 100), (100, 0, -100), (-100, 0, -100)]
    rel material:binding = </red>
}
def Material "red"
{
    token outputs:surface.connect = </red/shader.outputs:surface>
    def Shader "shader"
    {
        uniform token info:id = "UsdPreviewSurface"
        color3f inputs:diffuseColor = (0.8, 0.1, 0.2)
        float inputs:roughness = 1
        token outputs:surface
    }
}
"""


POINTS_ABOVE = """
def Points "dust"
{
    point3f[] points = [(0, 50, 0), (10, 50, 0)]
    float[] widths = [60, 60]
}
"""


def test_points_are_hidden_and_shade_nothing(open_worker, tmp_path):
    path = tmp_path / "square.usda"
    header = HEADER.replace("upAxis", "timeCodesPerSecond = 12.5\n    upAxis")
    path.write_text(header + PREVIEW + POINTS_ABOVE)
    worker = open_worker(path)
    assert worker.frame_span()[2] == pytest.approx(12.5)
    assert worker.opened["notes"] == [
        "object 'dust' is a point cloud, which no package holds, and was hidden"
    ]
    traced = trace(worker, unit(0, 1, 0))
    assert traced.missed < 0.005 and np.all(traced.radiance[traced.front][:, 0] > 0.1)


def test_preview_surfaces_come_with_the_file(open_worker, tmp_path):
    path = tmp_path / "square.usda"
    path.write_text(HEADER + PREVIEW)
    traced = trace(open_worker(path), unit(0, 1, 0), samples=16)
    red, green, blue = traced.radiance[traced.front].mean(axis=0)
    assert red == pytest.approx(0.8 / np.pi, rel=0.1)
    assert 3.0 < red / green < 8.0 and 1.2 < blue / green < 2.0


TETRAHEDRON = """
def Mesh "%s"
{
    int[] faceVertexCounts = [3, 3, 3, 3]
    int[] faceVertexIndices = [0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2]
    point3f[] points = [(0, 0, 0), (100, 0, 0), (0, 100, 0), (0, 0, 50)]
    uniform token subdivisionScheme = "none"
    %s
}
"""
NORMALS = "normal3f[] normals = [(-1,0,0), (1,0,0), (0,1,0), (0,0,1)] ( interpolation = 'vertex' )"


def test_usd_meshes_without_normals_have_facets(open_worker, tmp_path):
    path = tmp_path / "two.usda"
    path.write_text(HEADER + TETRAHEDRON % ("flat", "") + TETRAHEDRON % ("smooth", NORMALS))
    worker = open_worker(path)
    assert [note for note in worker.opened["notes"] if "no normals" in note] == [
        "the file has no normals, so these meshes have facets, as in USD: 'flat'"
    ]
    corners = worker.export_corners(None, {})
    p = corners["positions"].reshape(-1, 3, 3)
    facing = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
    facing /= np.linalg.norm(facing, axis=1, keepdims=True)
    cosine = np.sum(corners["normals"].reshape(-1, 3, 3) * facing[:, None], axis=2).min(axis=1)
    assert sorted(cosine > 0.999) == [False] * 4 + [True] * 4
