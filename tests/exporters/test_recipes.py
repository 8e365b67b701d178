"""The recipes build in Blender, and have what their documents say."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import numpy as np
import pytest

from rna_export.capture.blender_process import source_help
from tests.conftest import REPOSITORY

pytestmark = pytest.mark.blender

RECIPES = REPOSITORY / "examples" / "recipes"

_CENSUS = """
import hashlib, json, os, sys
sys.path.insert(0, {blender!r})
import bpy, numpy as np
from rna_sources import source_scene
out, calls = sys.argv[1], json.loads(sys.argv[2])

def census(source, *arguments):
    source_scene.load(source, arguments, None, None, None)
    triangles, strands, digest = 0, 0, hashlib.sha256()
    for item in bpy.data.objects:
        if item.type == "MESH":
            item.data.calc_loop_triangles()
            triangles += len(item.data.loop_triangles)
            points = item.data.vertices
        else:
            strands += len(item.data.curves)
            points = item.data.points
        place = np.empty(3 * len(points), np.float32)
        points.foreach_get("position" if item.type == "CURVES" else "co", place)
        digest.update(place.tobytes())
        if item.type == "CURVES":
            np.save(out + ".npy", place.reshape(-1, 3))
    materials = {{
        m.name: sorted({{n.type for n in m.node_tree.nodes}}) for m in bpy.data.materials
    }}
    return {{"triangles": triangles, "strands": strands, "materials": materials,
             "digest": digest.hexdigest(), "images": [i.size[:] for i in bpy.data.images]}}

found = [census(*call) for call in calls]
with open(out, "w") as file:
    json.dump(found, file)
os._exit(0)  # bpy may crash while it unloads
"""

Call = tuple[str, ...]  # a recipe and its arguments


def census(python: Path, folder: Path, *calls: Call) -> list[dict]:
    """What recipes leave in the scene; the points of the last strands are in `folder`."""
    out = folder / "census.json"
    script = _CENSUS.format(blender=str(REPOSITORY / "exporters" / "rna_export" / "blender"))
    request = json.dumps([(str(RECIPES / recipe), *arguments) for recipe, *arguments in calls])
    command = [str(python), "-c", script, str(out), request]
    ended = subprocess.run(command, capture_output=True, text=True, timeout=900)
    assert ended.returncode == 0, ended.stderr
    return json.loads(out.read_text())


WITH = {  # strands and materials
    ("lamp.py",): (0, {"brass", "bulb", "paper"}),
    ("branch.py",): (0, {"bark", "leaf"}),
    ("lantern.py", "--lit"): (0, {"amber glass", "brass", "flame", "iron", "wax"}),
    ("bottle.py",): (0, {"cork", "glass", "label"}),
    ("print.py",): (0, {"checks", "paper"}),
    ("hair_card.py",): (0, {"hair", "mannequin"}),
    ("furry_toy.py", "--strands", "1200"): (1200, {"mane", "yellow", "eyes"}),
}
UNLIT = ("lantern.py",)
BRANCH, LESS = (("branch.py", "--leaves", n) for n in ("40", "30"))


@pytest.fixture(scope="module")
def censuses(blender_python: Path, tmp_path_factory: pytest.TempPathFactory) -> dict[Call, dict]:
    calls = [*WITH, UNLIT, BRANCH, LESS]
    folder = tmp_path_factory.mktemp("census")
    return dict(zip(calls, census(blender_python, folder, *calls), strict=True))


@pytest.mark.parametrize("call", WITH, ids="-".join)
def test_a_recipe_has_what_it_says(call: Call, censuses: dict[Call, dict]) -> None:
    strands, materials = WITH[call]
    assert 3000 <= censuses[call]["triangles"] <= 30_000
    assert censuses[call]["strands"] == strands
    assert materials <= set(censuses[call]["materials"])


def test_the_same_seed_makes_the_same_branch(
    blender_python: Path, tmp_path: Path, censuses: dict[Call, dict]
) -> None:
    one, less = censuses[BRANCH], censuses[LESS]
    assert census(blender_python, tmp_path, BRANCH) == [one]
    assert one["digest"] != less["digest"]
    assert one["triangles"] - less["triangles"] == 10 * 16  # cards of 4 x 2 quads
    assert {"MATH", "BSDF_TRANSPARENT", "BSDF_TRANSLUCENT"} <= set(one["materials"]["leaf"])
    assert [1024, 1024] in one["images"]


def test_panes_are_mixes_of_clear_and_mirror_by_fresnel(censuses: dict[Call, dict]) -> None:
    lantern = censuses[UNLIT]
    assert "flame" not in lantern["materials"]
    nodes = set(lantern["materials"]["sea glass"])
    assert nodes >= {"FRESNEL", "MIX_SHADER", "BSDF_TRANSPARENT", "BSDF_GLOSSY"}
    assert "BSDF_PRINCIPLED" not in nodes


@pytest.mark.data
def test_the_hair_of_the_head_leaves_the_face_free(
    blender_python: Path, data_folder: Path, tmp_path: Path
) -> None:
    scan = str(data_folder / "mesh" / "LeePerrySmith")
    call = ("haired_head.py", scan, "--strands", "1500")
    (actual,) = census(blender_python, tmp_path, call)
    assert actual["strands"] == 1500 and actual["triangles"] == 17_684
    assert {"skin", "brown"} == set(actual["materials"])
    x, back, y = np.load(tmp_path / "census.json.npy").T  # the face looks along +y of Blender
    face = (abs(x) < 0.06) & (y > 0.2) & (y < 0.36) & (back > 0.1)
    assert not face.any()
    assert y.min() > 0.15 and y.max() < 0.46


def test_help_of_a_recipe_with_modules_beside_it(
    blender_python: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    source_help.show(RECIPES / "lamp.py")
    assert "--strength" in capfd.readouterr().out
