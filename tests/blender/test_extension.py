"""The extension from its zip: import, render, scene files, and what it says of mistakes."""

import json
import re
import sys

import numpy as np
import pytest
import yaml

from rna_render.command.rna_run import main as rna_run
from rna_render.image.images import read_exr
from rna_sdk.motion import open_motion
from rna_sdk.package import Package
from tests.conftest import REPOSITORY

pytestmark = pytest.mark.blender

TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"
CURLS = REPOSITORY / "examples" / "fibers" / "curly_ball.rna"

STAGE = f"""
import mathutils
TOY, CURLS = {str(TOY)!r}, {str(CURLS)!r}

def aim(item, place, target):
    item.location = place
    direction = mathutils.Vector(target) - item.location
    item.rotation_euler = direction.to_track_quat("-Z", "Y").to_euler()

def add(name, data, place, target):
    item = bpy.data.objects.new(name, data)
    aim(item, place, target)
    scene.collection.objects.link(item)
    return item

scene.camera = add("camera", bpy.data.cameras.new("camera"), (1.9, -1.5, 1.1), (0.4, 0, 0.2))
sun = add("sun", bpy.data.lights.new("sun", "SUN"), (1, -1, 2), (0, 0, 0))
sun.data.energy = 3
render, layer = scene.render, scene.view_layers[0]
render.engine, render.resolution_x, render.resolution_y = "RNA", 64, 40
render.image_settings.file_format = "OPEN_EXR"
render.image_settings.color_depth, render.image_settings.color_mode = "32", "RGBA"
scene.rna_render.samples = 4

def write(name):
    render.filepath = os.path.abspath(name)
    bpy.ops.render.render(write_still=True)
"""


def test_an_imported_package_is_its_geometry(run_in_blender):
    printed = run_in_blender(
        STAGE
        + """
import json
import numpy as np
from bl_ext.user_default.rna_sdk.panels import tier_line
for path in (TOY, CURLS, TOY):
    bpy.ops.rna.import_package(filepath=path)
toy, curls, again = [item for item in scene.objects if item.type in ("MESH", "CURVES")]
def read(collection, name, width):
    values = np.empty(len(collection) * width, np.float32)
    collection.foreach_get(name, values)
    return values.reshape(-1, width)
co = read(toy.data.vertices, "co", 3)
points = read(curls.data.position_data, "vector", 3)
normals = read(toy.data.corner_normals, "vector", 3)
colours = read(toy.data.attributes["rna_color"].data, "color", 4)
print("FOUND", json.dumps({
    "shared": toy.data == again.data and toy.data.users == 2,
    "co": [co.min(axis=0).tolist(), co.max(axis=0).tolist()],
    "vertices": len(co), "triangles": len(toy.data.polygons),
    "outward": float(np.mean(np.sum(normals.reshape(-1, 3, 3).mean(axis=1)
                     * read(toy.data.polygons, "normal", 3), axis=1))),
    "strands": len(curls.data.curves), "points": len(points),
    "radius": curls.data.attributes["radius"].data[0].value,
    "colours": colours[:, :3].reshape(-1, 3).std(axis=0).tolist(),
    "tiers": [tier_line(tier) for tier in json.loads(toy.data.rna_package.info)["tiers"]],
}))
"""
    )
    actual = json.loads(printed.partition("FOUND ")[2].splitlines()[0])
    with Package.open(TOY) as toy, Package.open(CURLS) as curls:
        mesh, strands = toy.mesh(), curls.curves()
        (x0, y0, z0), (x1, y1, z1) = (corner.tolist() for corner in mesh.box())
        expected = [[x0, -z1, y0], [x1, -z0, y1]]
        assert actual["shared"]
        for line, name in zip(actual["tiers"], ["small", "hq-int8"], strict=True):
            assert re.match(rf"{name}: FLIP 0\.\d+ \([a-z ]+: .*\), \d+ ns/query$", line)
        np.testing.assert_allclose(actual["co"], expected, atol=1e-6)
        assert actual["vertices"] == len(mesh.positions)
        assert actual["triangles"] == len(mesh.triangles)
        assert actual["strands"] == len(strands.offsets) - 1
        assert actual["points"] == len(strands.points)
        assert actual["radius"] == pytest.approx(strands.radii[0])
    assert actual["outward"] > 0.9  # normals and winding agree
    assert min(actual["colours"]) > 0.1  # bricks of many colours


def test_the_engine_and_rna_run_give_one_picture(run_in_blender, tmp_path):
    """Instances, one mirrored, a mesh of another shape, a mirrored one, a material, the region."""
    printed = run_in_blender(
        STAGE
        + """
for path in (TOY, CURLS):
    bpy.ops.rna.import_package(filepath=path)
toy, curls = [item for item in scene.objects if item.type in ("MESH", "CURVES")]
curls.location, curls.scale, curls.rotation_euler = (0.9, 0.5, 0.2), (0.5,) * 3, (0.2, 0, 1)
group = bpy.data.collections.new("group")
group.objects.link(curls)
copy = add("copy", None, (-0.3, 0.5, 0), (0, 0, -9))
copy.instance_type, copy.instance_collection, copy.scale.x = "COLLECTION", group, -1
curls.scale = (0.5, 0.5, 0.5)
bpy.ops.mesh.primitive_plane_add(size=4)
bpy.ops.mesh.primitive_monkey_add(size=0.3, location=(0.2, -0.5, 0.2))
bpy.context.object.scale = (-1, 1.5, 1)
glossy = bpy.data.materials.new("glossy")
glossy.node_tree or setattr(glossy, "use_nodes", True)
shader = glossy.node_tree.nodes["Principled BSDF"]
shader.inputs["Base Color"].default_value = (0.8, 0.1, 0.05, 1)
shader.inputs["Metallic"].default_value, shader.inputs["Roughness"].default_value = 1, 0.3
shader.inputs["Subsurface Weight"].default_value = 0.5
bpy.context.object.data.materials.append(glossy)
bpy.ops.rna.export_scene(filepath=os.path.abspath("exported"))
write("whole.exr")
render.use_border = True
render.border_min_x, render.border_max_x, render.border_min_y, render.border_max_y = (
    0.25, 0.75, 0, 0.5)
render.use_crop_to_border = True
write("cut.exr")
"""
    )
    assert "Warning: 'glossy': subsurface scattering is left out" in printed
    scene = yaml.safe_load((tmp_path / "exported" / "scene.yaml").read_text())
    assert len(scene["assets"]) == 3 and len(scene["objects"]) == 2
    assert sum(asset["transform"]["scale"] < 0 for asset in scene["assets"]) == 1
    out = tmp_path / "direct.exr"
    assert rna_run([str(tmp_path / "exported" / "scene.yaml"), "--out", str(out)]) == 0
    direct, whole, cut = (read_exr(tmp_path / f"{n}.exr")[0] for n in ("direct", "whole", "cut"))
    assert direct["A"].max() == 1.0 and np.ptp(direct["R"]) > 0.1
    for channel in "RGBA":
        # Normals of the two evaluations may differ in their last digit, and a path by it.
        assert np.mean(whole[channel] == direct[channel]) > 0.99
        assert np.mean(cut[channel] == whole[channel][20:, 16:48]) > 0.99


def test_mistakes_are_one_line_in_blender(run_in_blender, tmp_path):
    (tmp_path / "broken.rna").write_bytes(b"no package")
    printed = run_in_blender(
        STAGE
        + """
refused(bpy.ops.rna.import_package, filepath=os.path.abspath("broken.rna"))
refused(bpy.ops.render.render)
bpy.ops.rna.import_package(filepath=TOY)
toy = bpy.context.object
toy.rna_instance.tier = "huge"
refused(bpy.ops.render.render)
toy.rna_instance.tier, toy.scale = "", (1, 1, 2)
scene.camera.data.dof.use_dof = True
bpy.ops.object.volume_add()
bpy.ops.render.render()
scene.camera.data.type = "ORTHO"
refused(bpy.ops.render.render)
scene.camera = None
refused(bpy.ops.rna.export_scene, filepath=os.path.abspath("exported"))
os.environ["RNA_SDK_PYTHON"] = "/nowhere/python"
refused(bpy.ops.rna.import_package, filepath=CURLS)
refused(bpy.ops.rna.bake)
"""
    )
    for line in (
        "refused: Error: broken.rna: ",
        "refused: Error: nothing to render: the scene has no assets and no meshes",
        "refused: Error: object 'toy': tier: no tier 'huge'; this package has: small, hq-int8",
        "Warning: 'toy': an asset has one scale: rendered with the mean of three",
        "Warning: 'camera': depth of field is left out: everything is sharp",
        "refused: Error: camera 'camera': found type ORTHO, expected PERSP",
        "refused: Error: the scene has no camera",
        "no Python of the RNA SDK: /nowhere/python is missing",
    ):
        assert line in printed, printed


def test_a_cancelled_render_keeps_what_it_has_and_leaves_no_process(run_in_blender, tmp_path):
    printed = run_in_blender(
        STAGE
        + """
import bl_ext.user_default.rna_sdk.engine as engine
shown, put = [], engine._View._put
def watched(self, channels):
    shown.append(channels.samples)
    put(self, channels)
engine._View._put = watched
engine.RnaEngine.is_cancelled = lambda self: len(shown) >= 2
engine._EVERY = 0.0
scene.rna_render.samples = 2000
bpy.ops.rna.import_package(filepath=TOY)
write("stopped.exr")
print("SHOWN", shown)
import subprocess
print("LEFT", "rna_render.command.rna_run" in subprocess.run(
    ["ps", "--ppid", str(os.getpid()), "-o", "args"], capture_output=True, text=True).stdout)
"""
    )
    shown = json.loads(printed.partition("SHOWN ")[2].splitlines()[0])
    assert len(shown) >= 2 and 1 <= shown[0] < shown[1] < 2000
    assert "LEFT False" in printed
    assert read_exr(tmp_path / "stopped.exr")[0]["A"].max() == 1.0


def test_frames_of_an_animation(run_in_blender, tmp_path):
    """Frames of an asset that moves to the right, posed by an armature."""
    printed = run_in_blender(
        STAGE
        + """
bpy.ops.rna.import_package(filepath=TOY)
toy = bpy.context.object
for frame, x in ((1, -0.5), (2, 0.5)):
    toy.location.x = x
    toy.keyframe_insert("location", frame=frame)
bones = bpy.data.armatures.new("bones")
rig = add("rig", bones, (0, 0, 0), (0, 0, -1))
rig.parent, rig.rotation_euler = toy, (0, 0, 0)
bpy.context.view_layer.objects.active = rig
bpy.ops.object.mode_set(mode="EDIT")
bone = bones.edit_bones.new("bone")
bone.head, bone.tail = (0, 0, 0), (0, 0, 1)
bpy.ops.object.mode_set(mode="OBJECT")
toy.modifiers.new("rig", "ARMATURE").object = rig
group = toy.vertex_groups.new(name="bone")
group.add(range(len(toy.data.vertices)), 1.0, "REPLACE")
rig.pose.bones["bone"].rotation_mode = "XYZ"
rig.pose.bones["bone"].rotation_euler.y = 0.6
bpy.ops.rna.export_scene(filepath=os.path.abspath("posed"))
twice = toy.modifiers.new("twice", "MIRROR")
bpy.ops.rna.export_scene(filepath=os.path.abspath("twice"))
toy.modifiers.remove(twice)
scene.frame_start, scene.frame_end = 1, 2
render.filepath = os.path.abspath("frame.")
bpy.ops.render.render(animation=True)
"""
    )
    assert "modifiers that change an asset's points or faces are left out" in printed
    (asset,) = yaml.safe_load((tmp_path / "posed" / "scene.yaml").read_text())["assets"]
    with Package.open(TOY) as package:
        mesh = package.mesh()
    motion = open_motion(tmp_path / "posed" / asset["motion"], [mesh])
    c, s = np.cos(0.6), np.sin(0.6)
    turned = mesh.positions @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]).T
    np.testing.assert_allclose(motion.positions(0)[0], turned, atol=1e-5)
    alphas = [read_exr(tmp_path / f"frame.{n:04d}.exr")[0]["A"] for n in (1, 2)]
    centres = [np.average(np.arange(64), weights=alpha.sum(axis=0)) for alpha in alphas]
    assert centres[1] > centres[0] + 10


def test_an_asset_is_shown_in_a_browser_and_written_as_a_page(
    run_in_blender, tmp_path, monkeypatch
):
    monkeypatch.setenv("BROWSER", "true")  # a program that does nothing
    printed = run_in_blender(
        STAGE
        + """
import urllib.request
import bl_ext.user_default.rna_sdk.web_page as web_page
bpy.ops.mesh.primitive_cube_add()
refused(bpy.ops.rna.show_in_browser)
bpy.ops.rna.import_package(filepath=TOY)
said = web_page._address
def read(command):
    line = said(command)
    print("READ", b"<rna-viewer" in urllib.request.urlopen(line.split()[-1]).read())
    return line
web_page._address = read
bpy.ops.rna.show_in_browser()
servers = [*web_page._shown.values()]
bpy.ops.rna.show_in_browser()
servers += web_page._shown.values()
web_page.unregister()
print("LEFT", [one.is_running() for one in servers])
web_page.register()
bpy.ops.rna.write_web_page(filepath=os.path.abspath("page"))
refused(bpy.ops.rna.write_web_page, filepath=os.path.abspath("."))
"""
    )
    assert printed.count("READ True") == 2 and "LEFT [False, False]" in printed
    assert "refused: Error: toy.rna: " in printed and "the folder holds other files" in printed
    assert (tmp_path / "page" / "index.html").is_file()


def test_the_zip_has_the_same_bytes_each_time(extension_zip, tmp_path):
    import subprocess

    again = tmp_path / "again.zip"
    script = REPOSITORY / "scripts" / "blender-extension"
    subprocess.run([sys.executable, script, again], check=True)
    assert again.read_bytes() == extension_zip.read_bytes()
