"""The bake: what it writes for the capture, and how its process is started, stopped and resumed."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from tests.blender.conftest import RunInBlender
from tests.conftest import REPOSITORY

pytestmark = pytest.mark.blender

TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"

# In place of the SDK's Python: a bake that hangs at first, and then is finished at once. All other
# scripts run in the real one.
STAND_IN = f"""#!{sys.executable}
import json, os, pathlib, shutil, sys, time
if not sys.argv[1].endswith("bake.py"):
    os.execv({sys.executable!r}, [{sys.executable!r}, *sys.argv[1:]])
job = json.loads(pathlib.Path(sys.argv[2]).read_text())
begun = pathlib.Path(job["folder"], "begun")
if begun.exists():
    shutil.copy({str(TOY)!r}, job["out"])
    print("bake finished", flush=True)
    sys.exit()
begun.touch()
print("round 1: rays:  10%|#   | 00:01\\rround 1: rays:  42%|##  | 00:02", end="", flush=True)
try:
    time.sleep(100)
except KeyboardInterrupt:
    print("\\nstopped; run the same command again to continue", flush=True)
    sys.exit(130)
"""

SCRIPT = """
import json, time
import mathutils
import bl_ext.user_default.rna_sdk.bake.operators as operators

bpy.ops.mesh.primitive_cube_add(size=2)
body = bpy.context.object
body.location, body.rotation_euler, body.scale = (5, 6, 7), (0, 0, 1.5707963), (1, 2, 1)
bpy.ops.mesh.primitive_cube_add(size=2)
hat = bpy.context.object
hat.parent, hat.location, hat.scale = body, (0, 0, 1.5), (0.5, 0.5, 0.5)
bpy.ops.mesh.primitive_plane_add(size=50)
bpy.context.view_layer.update()
for item in scene.objects:
    item.select_set(item == body)
bpy.context.view_layer.objects.active = body
body.rna_bake.out, body.rna_bake.min_psnr = os.path.abspath("cubes.rna"), 30
names = {item.name for item in bpy.data.objects}, {one.name for one in bpy.data.scenes}

wait = operators.Job.wait
def until_it_says_something(job):
    while job.status().share == 0:
        time.sleep(0.05)
operators.Job.wait = until_it_says_something
refused(bpy.ops.rna.bake)
operators.Job.wait = wait
job = operators.job_of(body)
seen = [job.status()]
refused(bpy.ops.rna.bake)
bpy.ops.rna.stop_bake()
wait(job)
seen.append(job.status())
print("BAKE", bpy.ops.rna.bake())
seen.append(job.status())
print("STATES", json.dumps([(one.state, one.share) for one in seen]))
print("KEPT", names == ({i.name for i in bpy.data.objects}, {o.name for o in bpy.data.scenes}))
print("REPLACE", bpy.ops.rna.replace())
toy = bpy.context.object
print("HIDDEN", body.hide_render and hat.hide_render, (toy.location - body.location).length < 1e-5)
print("TURNED", toy.scale.length, toy.rotation_euler.z)
bpy.ops.wm.open_mainfile(filepath=str(job.source))
corners = [
    item.matrix_world @ mathutils.Vector(corner)
    for item in bpy.context.scene.objects
    for corner in item.bound_box
]
print("BOX", json.dumps([[f(c[k] for c in corners) for k in range(3)] for f in (min, max)]))
print("OBJECTS", len(bpy.context.scene.objects))
"""


def told(printed: str, word: str) -> str:
    """The rest of the line that begins with the word."""
    return printed.partition(f"\n{word} ")[2].splitlines()[0]


def test_a_bake_is_started_stopped_continued_and_replaces_its_original(
    run_in_blender: RunInBlender, tmp_path: Path
) -> None:
    stand_in = tmp_path / "python"
    stand_in.write_text(STAND_IN)
    stand_in.chmod(0o755)
    printed = run_in_blender(SCRIPT, python=str(stand_in))
    assert "refused: Error: bake running: round 1: rays" in printed
    assert "refused: Error: the bake is running" in printed
    assert told(printed, "BAKE") == "{'FINISHED'}"
    states = [("running", 0.42), ("stopped", 0.0), ("finished", 1.0)]
    assert json.loads(told(printed, "STATES")) == [list(state) for state in states]
    assert told(printed, "KEPT") == "True"  # no copies are left in the file
    job = json.loads((tmp_path / "cubes.bake" / "job.json").read_text())
    assert job["options"][:4] == ["--presets", "small", "--minutes", "20"]
    assert job["options"][4:] == ["--min-psnr", "30"]
    # The source is what was selected, and what is below it, without place and turn.
    assert told(printed, "OBJECTS") == "2"
    low, high = json.loads(told(printed, "BOX"))
    assert low == pytest.approx([-1, -2, -1], abs=1e-5)
    assert high == pytest.approx([1, 2, 2], abs=1e-5)
    assert told(printed, "HIDDEN") == "True True"
    scale, turn = map(float, told(printed, "TURNED").split())
    assert (scale, turn) == pytest.approx((3**0.5, 1.5707963), abs=1e-5)
