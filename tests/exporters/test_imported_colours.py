"""Colours by point, face or strand of PLY, OBJ and USD files are base colours."""

import numpy as np
import pytest

from tests.exporters.cycles import unit
from tests.exporters.in_blender import answer_of

pytestmark = pytest.mark.blender

PLY = """ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
property uchar red
property uchar green
property uchar blue
element face 1
property list uchar int vertex_indices
end_header
0 0 0 255 0 0
1 0 0 255 0 0
1 1 0 0 0 255
0 1 0 0 0 255
4 0 1 2 3
"""
OBJ = "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 0 -1 0 0 1\nv 0 0 -1 0 0 1\nf 1 2 3 4\n"
USD = """#usda 1.0
( metersPerUnit = 1
  upAxis = "Y" )
def Mesh "m"
{
    uniform token subdivisionScheme = "none"
    int[] faceVertexCounts = [4]
    int[] faceVertexIndices = [0, 1, 2, 3]
    point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 0, -1), (0, 0, -1)]
    color3f[] primvars:displayColor = [(1, 0, 0), (1, 0, 0), (0, 0, 1), (0, 0, 1)] (
        interpolation = "vertex" )
}
"""
STRANDS = """#usda 1.0
( metersPerUnit = 1
  upAxis = "Y" )
def BasisCurves "h"
{
    uniform token type = "linear"
    int[] curveVertexCounts = [2, 2]
    point3f[] points = [(0, 0, 0), (0, 1, 0), (1, 0, 0), (1, 1, 0)]
    float[] widths = [0.01] ( interpolation = "constant" )
    color3f[] primvars:displayColor = [(1, 0, 0), (0, 0, 1)] ( interpolation = "uniform" )
}
"""
_SHOWN = """
from rna_sources import source_scene
notes = source_scene.load(sys.argv[1], sys.argv[2:], None, None, None)
item = next(iter(bpy.data.objects))
material = item.data.materials[0]
shader = next(n for n in material.node_tree.nodes if n.type.startswith("BSDF"))
links = [link.from_node.attribute_name for s in shader.inputs for link in s.links]
answer([links, [list(d.color)[:3] for d in item.data.attributes[links[0]].data] if links else [],
        notes])
"""


@pytest.mark.parametrize(
    ("name", "text"), [("a.ply", PLY), ("a.obj", OBJ), ("a.usda", USD)], ids=["ply", "obj", "usd"]
)
def test_a_mesh_shows_the_colours_of_its_file(open_worker, tmp_path, name, text):
    path = tmp_path / name
    path.write_text(text)
    worker = open_worker(path, up="Z" if name == "a.ply" else None)
    above = np.repeat(np.float32([[0.5, 1.0, -0.1], [0.5, 1.0, -0.9]]), 32, axis=0)
    down = np.tile(np.float32([0.0, -1.0, 0.0]), (64, 1))
    shown = worker.render_rays(above, down, unit(0.1, 1.0, 0.1), 16, 0).radiance
    (red, _, no_blue), (no_red, _, blue) = shown[:32].mean(axis=0), shown[32:].mean(axis=0)
    assert red > 3 * no_blue and blue > 3 * no_red


def test_strands_show_the_colours_of_their_file(blender_python, tmp_path):
    path = tmp_path / "h.usda"
    path.write_text(STRANDS)
    links, colours, notes = answer_of(blender_python, _SHOWN, str(path))
    assert links == ["displayColor"] and colours == [[1, 0, 0], [0, 0, 1]] and notes == []
    links, _, notes = answer_of(blender_python, _SHOWN, str(path), "--colour", "1", "1", "1")
    assert links == [] and notes == []
    links, _, (note,) = answer_of(blender_python, _SHOWN, str(path), "--strands", "2")
    assert links == []
    assert note == "strands 'h' lose their displayColor by --radius, --tip, --points or --strands"
