"""The recipes build in Blender, and have what their documents say."""

import json
import subprocess
from pathlib import Path

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
    triangles, digest = 0, hashlib.sha256()
    for item in bpy.data.objects:
        item.data.calc_loop_triangles()
        triangles += len(item.data.loop_triangles)
        place = np.empty(3 * len(item.data.vertices), np.float32)
        item.data.vertices.foreach_get("co", place)
        digest.update(place.tobytes())
    materials = {{
        m.name: sorted({{n.type for n in m.node_tree.nodes}}) for m in bpy.data.materials
    }}
    return {{"triangles": triangles, "materials": materials,
             "digest": digest.hexdigest(), "images": [i.size[:] for i in bpy.data.images]}}

found = [census(*call) for call in calls]
with open(out, "w") as file:
    json.dump(found, file)
os._exit(0)  # bpy may crash while it unloads
"""

Call = tuple[str, ...]  # a recipe and its arguments


def census(python: Path, folder: Path, *calls: Call) -> list[dict]:
    """What recipes leave in the scene."""
    out = folder / "census.json"
    script = _CENSUS.format(blender=str(REPOSITORY / "exporters" / "rna_export" / "blender"))
    request = json.dumps([(str(RECIPES / recipe), *arguments) for recipe, *arguments in calls])
    command = [str(python), "-c", script, str(out), request]
    ended = subprocess.run(command, capture_output=True, text=True, timeout=900)
    assert ended.returncode == 0, ended.stderr
    return json.loads(out.read_text())


WITH = {  # materials
    ("lamp.py",): {"brass", "bulb", "paper"},
    ("branch.py",): {"bark", "leaf"},
    ("lantern.py", "--lit"): {"amber glass", "brass", "flame", "iron", "wax"},
    ("bottle.py",): {"cork", "glass", "label"},
    ("print.py",): {"checks", "paper"},
    ("relief.py", "knit"): {"knit"},
}
UNLIT = ("lantern.py",)
BRANCH, LESS = (("branch.py", "--leaves", n) for n in ("40", "30"))


@pytest.fixture(scope="module")
def censuses(blender_python, tmp_path_factory):
    calls = [*WITH, UNLIT, BRANCH, LESS]
    folder = tmp_path_factory.mktemp("census")
    return dict(zip(calls, census(blender_python, folder, *calls), strict=True))


@pytest.mark.parametrize("call", WITH, ids="-".join)
def test_a_recipe_has_what_it_says(call, censuses):
    assert 3000 <= censuses[call]["triangles"] <= 30_000
    assert WITH[call] <= set(censuses[call]["materials"])


def test_the_same_seed_makes_the_same_branch(blender_python, tmp_path, censuses):
    one, less = censuses[BRANCH], censuses[LESS]
    assert census(blender_python, tmp_path, BRANCH) == [one]
    assert one["digest"] != less["digest"]
    assert one["triangles"] - less["triangles"] == 10 * 16  # cards of 4 x 2 quads
    assert {"MATH", "BSDF_TRANSPARENT", "BSDF_TRANSLUCENT"} <= set(one["materials"]["leaf"])
    assert [1024, 1024] in one["images"]


def test_panes_are_mixes_of_clear_and_mirror_by_fresnel(censuses):
    lantern = censuses[UNLIT]
    assert "flame" not in lantern["materials"]
    nodes = set(lantern["materials"]["sea glass"])
    assert nodes >= {"FRESNEL", "MIX_SHADER", "BSDF_TRANSPARENT", "BSDF_GLOSSY"}
    assert "BSDF_PRINCIPLED" not in nodes


def test_help_of_a_recipe_with_modules_beside_it(blender_python, capfd):
    source_help.show(RECIPES / "lamp.py")
    assert "--strength" in capfd.readouterr().out
