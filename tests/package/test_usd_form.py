"""The USD form that docs/decisions/format.md describes, opened by the USD of Blender's module."""

import pytest

from tests.conftest import REPOSITORY
from tests.exporters.in_blender import answer_of
from tests.package.builders import make_tiny_package

OPEN = """
from rna_sources.bundled import add_to_path
add_to_path()
from pxr import Usd, UsdGeom
stage = Usd.Stage.Open(sys.argv[1])
fox = stage.GetDefaultPrim()
meshes = [p for p in Usd.PrimRange(fox) if p.IsA(UsdGeom.Mesh)]
answer([
    fox.GetMetadata("apiSchemas").GetAppliedItems(), UsdGeom.GetStageUpAxis(stage),
    fox.GetAttribute("rna:package").Get().resolvedPath,
    [len(UsdGeom.Mesh(p).GetPointsAttr().Get()) for p in meshes],
])
"""
MESH = """#usda 1.0
(
    defaultPrim = "mesh"
)
def Xform "mesh"
{
    def Mesh "coat"
    {
        int[] faceVertexCounts = [3]
        int[] faceVertexIndices = [0, 1, 2]
        point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
    }
}
"""


@pytest.mark.blender
def test_a_usda_names_the_package_beside_the_mesh(tmp_path, blender_python):
    text = (REPOSITORY / "docs" / "decisions" / "format.md").read_text()
    (tmp_path / "fox.usda").write_text("#usda" + text.split("```\n#usda")[1].split("```")[0])
    (tmp_path / "fox-mesh.usda").write_text(MESH)
    package = make_tiny_package(tmp_path / "fox.rna")
    answer = answer_of(blender_python, OPEN, str(tmp_path / "fox.usda"))
    assert answer == [["RnaRelightableAssetAPI"], "Y", str(package), [3]]
