"""The bake: what it writes for the capture, and how its process is started, stopped and resumed."""

import json
import runpy
import sys

import pytest

from rna_sdk.commands.error_words import error_in_words
from tests.conftest import REPOSITORY

pytestmark = pytest.mark.blender

TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"

# In place of the SDK's Python: a bake that hangs at first, and then is finished at once. All other
# scripts run in the real one.
STAND_IN = f"""#!{sys.executable}
import os, pathlib, shutil, sys, time
if not sys.argv[1].endswith("bake.py"):
    os.execv({sys.executable!r}, [{sys.executable!r}, *sys.argv[1:]])
out, folder = sys.argv[3:5]
begun = pathlib.Path(folder, "make", "begun")
if begun.exists():
    shutil.copy({str(TOY)!r}, out)
    print("bake finished", flush=True)
    sys.exit()
begun.parent.mkdir()
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
body.rna_bake.out, body.rna_bake.goal = os.path.abspath("cubes.rna"), "0.07"
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
body.rna_bake.minutes = 5
refused(bpy.ops.rna.bake)
body.rna_bake.minutes = 20
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
goals = operators.RnaBake.bl_rna.properties["goal"].enum_items
print("GOALS", json.dumps([(goal.identifier, goal.name) for goal in goals]))
"""


def printed_value(printed: str, word: str) -> str:
    """The rest of the line that begins with the word."""
    return printed.partition(f"\n{word} ")[2].splitlines()[0]


def test_a_bake_is_started_stopped_continued_and_replaces_its_original(run_in_blender, tmp_path):
    stand_in = tmp_path / "python"
    stand_in.write_text(STAND_IN)
    stand_in.chmod(0o755)
    printed = run_in_blender(SCRIPT, python=str(stand_in))
    assert "refused: Error: bake running: round 1: rays" in printed
    assert "refused: Error: the bake is running" in printed
    assert "refused: Error: the bake was begun with options --presets small --minutes=20" in printed
    assert printed_value(printed, "BAKE") == "{'FINISHED'}"
    states = [("running", 0.42), ("stopped", 0.0), ("finished", 1.0)]
    assert json.loads(printed_value(printed, "STATES")) == [list(state) for state in states]
    assert printed_value(printed, "KEPT") == "True"  # no copies are left in the file
    job = json.loads((tmp_path / "cubes.bake" / "job.json").read_text())
    assert job["options"] == ["--presets", "small", "--minutes=20", "--max-error=0.07"]
    assert job["source"] == "untitled.blend"  # the package records the name of the user's file
    # The source is what was selected, and what is below it, without place and turn.
    assert printed_value(printed, "OBJECTS") == "2"
    low, high = json.loads(printed_value(printed, "BOX"))
    assert low == pytest.approx([-1, -2, -1], abs=1e-5)
    assert high == pytest.approx([1, 2, 2], abs=1e-5)
    assert printed_value(printed, "HIDDEN") == "True True"
    _, *goals = json.loads(printed_value(printed, "GOALS"))
    for flip, name in goals:
        assert error_in_words(float(flip) - 0.001).startswith(f"{name.lower()}: ")
    scale, turn = map(float, printed_value(printed, "TURNED").split())
    assert (scale, turn) == pytest.approx((3**0.5, 1.5707963), abs=1e-5)


# In place of the SDK's Python: a bake that is finished at once, but hangs when it is first to go
# on. It writes its options to a file.
GOES_ON = f"""#!{sys.executable}
import os, pathlib, shutil, sys, time
if not sys.argv[1].endswith("bake.py"):
    os.execv({sys.executable!r}, [{sys.executable!r}, *sys.argv[1:]])
out, folder, *options = sys.argv[3:]
folder = pathlib.Path(folder)
with open("options", "a", encoding="utf-8") as file:
    print(*options, sep="|", file=file)
more, hung = any(option.startswith("--more") for option in options), folder / "make" / "hung"
if more and not (folder / "made").exists() and not hung.exists():
    hung.touch()
    print("last training:  50%|##  | 00:02", end="", flush=True)
    try:
        time.sleep(100)
    except KeyboardInterrupt:
        print("\\nstopped; run the same command again to continue", flush=True)
        sys.exit(130)
(folder / "make" / "rays").mkdir(parents=True, exist_ok=True)
for name in ("make/make.json", "make/rays/manifest.json", "made"):
    (folder / name).touch()
shutil.copy({str(TOY)!r}, out)
print("bake finished", flush=True)
"""

MORE = """
import pathlib, shutil, time
import bl_ext.user_default.rna_sdk.bake.operators as operators

here = pathlib.Path.cwd()
bpy.ops.mesh.primitive_cube_add()
chair = bpy.context.object
chair.name = "Stühle/rot\\n.001"
bpy.ops.mesh.primitive_cube_add()
chair.select_set(True)
bpy.context.view_layer.objects.active = chair
bpy.ops.wm.save_as_mainfile(filepath=str(here / "Zimmer.blend"))
chair, other = (bpy.data.objects[name] for name in (chair.name, "Cube"))
chair.rna_bake.goal, chair.rna_bake.options = "0.07", "--lights 8 --seed 3"
print("FIRST", bpy.ops.rna.bake())
job = operators.job_of(chair)
print("NAMES", job.out.name, job.source.name)
chair.name = "renamed"

chair.rna_bake.presets = "hq"
refused(bpy.ops.rna.bake_more)
chair.rna_bake.presets = "small"
bpy.context.view_layer.objects.active = other
other.rna_bake.out = chair.rna_bake.out
other.rna_bake.options = chair.rna_bake.options
refused(bpy.ops.rna.bake_more)
bpy.context.view_layer.objects.active = chair

chair.rna_bake.minutes, chair.rna_bake.more, chair.rna_bake.goal = 5, 2.5, "NONE"
wait = operators.Job.wait
def until_it_says_something(job):
    while job.status().share == 0:
        time.sleep(0.05)
operators.Job.wait = until_it_says_something
refused(bpy.ops.rna.bake_more)
operators.Job.wait = wait
refused(bpy.ops.rna.bake_more)
bpy.ops.rna.stop_bake()
wait(job)
print("STATE", job.status().state)
refused(bpy.ops.rna.bake_more)
print("CONTINUED", bpy.ops.rna.bake(), job.status().state)
print("AGAIN", bpy.ops.rna.bake_more())
shutil.rmtree(job.folder / "make" / "rays")
refused(bpy.ops.rna.bake_more)
job.remove()
print("LEFT", job.folder.exists())
"""


def test_a_finished_bake_goes_on_for_more_minutes(run_in_blender, tmp_path):
    stand_in = tmp_path / "python"
    stand_in.write_text(GOES_ON)
    stand_in.chmod(0o755)
    printed = run_in_blender(MORE, python=str(stand_in))
    for word in ("FIRST", "AGAIN"):
        assert printed_value(printed, word) == "{'FINISHED'}"
    assert printed_value(printed, "CONTINUED") == "{'FINISHED'} finished"
    assert printed_value(printed, "STATE") == "stopped"
    assert printed_value(printed, "LEFT") == "False"
    refusals = [line for line in printed.splitlines() if line.startswith("refused: ")]
    for refusal, expected in zip(
        refusals,
        (
            "with options --presets small --seed=3, found --presets hq --seed=3: set that back",
            "Stühle_rot__001.rna was baked from another object: select that",
            "bake running: last training",
            "the bake is running",
            "the bake is not finished: Continue",
            "found no rays to continue with, expected rays of the bake; Bake Anew captures them",
        ),
        strict=True,
    ):
        assert expected in refusal
    # The asset is named for the object, its source for the file; lengths are those of each run.
    assert printed_value(printed, "NAMES") == "Stühle_rot__001.rna Zimmer.blend"
    first, *more = (tmp_path / "options").read_text(encoding="utf-8").splitlines()
    lasting = "--name=Stühle/rot .001|--presets|small"
    lengths = "--minutes=20|--max-error=0.07|--lights=8"
    assert first == f"{lasting}|{lengths}|--seed=3"
    assert more == [f"{lasting}|--seed=3|--more=2.5"] * 3


# A file that a stranger sends: data alone. Its properties, and the files that came with it, are all
# that the stranger chose; the user presses buttons.
OPTIONS = [
    *["--work /", "--out x.rna", "--wor=x", "--cluster local", "--for x.yaml", "-- evil.py"],
    *["evil.py", "--domain hemisphere evil.py", "--lights", "--store file:///x", "--debug"],
]
STRANGER = (
    f"""
OPTIONS = {OPTIONS}"""
    + """
import json, pathlib
here = pathlib.Path.cwd()
bpy.ops.mesh.primitive_cube_add()
chair = bpy.context.object
chair.name = "chair"
bpy.ops.wm.save_as_mainfile(filepath=str(here / "chair.blend"))
folder = here / "chair.bake"

def press(anew=False, options=""):
    item = bpy.data.objects["chair"]
    item.rna_bake.options = options
    refused(bpy.ops.rna.bake, anew=anew)

# Files of the user where the bake's folder would be, whatever a property says of the folder.
(folder / "photos").mkdir(parents=True)
(folder / "photos" / "1.jpg").write_text("dear")
try:
    chair.rna_bake.folder = str(folder)
except AttributeError:
    pass
press(anew=True)
press()
print("KEPT", (folder / "photos" / "1.jpg").is_file())

# A job that came along, with a source that is a script.
(folder / "photos" / "1.jpg").unlink()
(folder / "photos").rmdir()
(folder / "evil.py").write_text("open(%r, 'w').write('ran')" % str(here / "RAN"))
job = {"source": str(folder / "evil.py"), "out": str(here / "chair.rna"), "folder": str(folder)}
for seal in ("", "0" * 64, None, 1):
    record = {**job, "options": ["--presets", "small", "--minutes=20"], "seal": seal}
    (folder / "job.json").write_text(json.dumps(record))
    press()
    press(anew=True)
print("JOBS", sorted(path.name for path in folder.iterdir()))

# A link in place of the folder.
for path in list(folder.iterdir()):
    path.unlink()
folder.rmdir()
(here / "elsewhere").mkdir()
folder.symlink_to(here / "elsewhere")
press()
folder.unlink()

# Without a name the package is beside the file, and found there after the object is renamed.
item = bpy.data.objects["chair"]
refused(bpy.ops.rna.bake)
item.name = "stool"
import bl_ext.user_default.rna_sdk.bake.operators as operators
print("FOUND", item.rna_bake.out, operators.job_of(item).is_begun())
print("SOURCE", operators.job_of(item).source.name)
item.name = "chair"
operators.job_of(item).remove()

# Options that name files, machines and more.
for options in OPTIONS:
    press(options=options)
print("NOTHING", not folder.exists(), not (here / "RAN").exists())
"""
)


def test_a_strangers_file_chooses_neither_folders_nor_sources_nor_commands(
    run_in_blender, tmp_path
):
    stand_in = tmp_path / "python"
    stand_in.write_text("#!/bin/sh\nexit 1\n")
    stand_in.chmod(0o755)
    printed = run_in_blender(STRANGER, python=str(stand_in))
    assert printed_value(printed, "KEPT") == "True"
    assert printed_value(printed, "JOBS") == "['evil.py', 'job.json']"
    assert printed_value(printed, "FOUND") == "chair.rna True"
    assert printed_value(printed, "SOURCE") == "chair.blend"
    assert printed_value(printed, "NOTHING") == "True True"
    refusals = [line for line in printed.splitlines() if line.startswith("refused: ")]
    assert len(refusals) == 2 + 8 + 1 + 1 + 11
    assert sum("not written by a bake of yours" in line for line in refusals) == 10
    assert sum("Options: " in line for line in refusals) == 11


AUTORUN = """
import pathlib, sys
sys.path.append({folder!r})
from rna_sources import source_scene
text = bpy.data.texts.new("evil.py")
text.use_module = True
text.write("open('RAN', 'w').write('ran')")
bpy.ops.mesh.primitive_cube_add()
driver = bpy.context.object.driver_add("location", 0).driver
driver.expression = "__import__('pathlib').Path('RAN').touch() or 0.0"
bpy.ops.wm.save_as_mainfile(filepath=str(pathlib.Path.cwd() / "evil.blend"))
pathlib.Path("RAN").unlink(missing_ok=True)
bpy.context.preferences.filepaths.use_scripts_auto_execute = True
source_scene.load(str(pathlib.Path.cwd() / "evil.blend"), [], None, None, None)
bpy.context.view_layer.update()
print("SAFE", not pathlib.Path("RAN").exists(), len(bpy.context.scene.objects))
"""


def test_a_capture_runs_no_script_of_a_blend_file(run_in_blender):
    """Whatever the user's preferences for files that the user opens."""
    folder = str(REPOSITORY / "exporters" / "rna_export" / "blender")
    assert printed_value(run_in_blender(AUTORUN.format(folder=folder)), "SAFE") == "True 1"


def test_the_options_of_a_bake_are_of_rna_make():
    from rna_export.make.rna_make import parser

    path = REPOSITORY / "exporters" / "blender_extension" / "bake" / "options.py"
    options = runpy.run_path(str(path))
    known = {name: action for action in parser()._actions for name in action.option_strings}
    for names, takes in (("FLAGS", 0), ("LISTS", "+"), ("VALUES", None)):
        assert {name: known[name].nargs for name in options[names]} == dict.fromkeys(
            options[names], takes
        )
    line = "--domain hemisphere --seed=3 --precision int8 small=float32 --front -Y --exact-geometry"
    assert options["parsed"](line) == [
        "--domain=hemisphere",
        "--seed=3",
        *["--precision", "int8", "small=float32"],
        "--front=-Y",
        "--exact-geometry",
    ]
