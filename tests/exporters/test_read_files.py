"""Files that travel with a source to another machine."""

import pytest

from tests.exporters.in_blender import answer_of

pytestmark = pytest.mark.blender

IMAGES = """
from rna_sources import read_files
folder = sys.argv[1]
tile = bpy.data.images.new("tile", 4, 4)
tiles = ["a.1001.png", "a.1012.png", "b.u1_v1.png", "b.u2_v2.png"]
for name in (*tiles, "s0001.png", "s0002.png", "s0002b.png", "t0003.png"):
    tile.filepath_raw, tile.file_format = os.path.join(folder, name), "PNG"
    tile.save()
bpy.data.images.remove(tile)
tiled = bpy.data.images.load(os.path.join(folder, "a.1001.png"))
tiled.source = "TILED"
tiled.tiles.new(1012)
mari = bpy.data.images.load(os.path.join(folder, "b.u1_v1.png"))
mari.source = "TILED"
mari.tiles.new(1012)
mari.filepath = os.path.join(folder, "b.<UVTILE>.png")
frames = bpy.data.images.load(os.path.join(folder, "s0001.png"))
frames.source = "SEQUENCE"
for image in (tiled, mari, frames):
    image.use_fake_user = True
blend = os.path.join(folder, "scene.blend")
bpy.ops.wm.save_as_mainfile(filepath=blend)
answer(read_files.files_of(blend)["travel"])
"""


def test_all_tiles_and_frames_of_images_travel(blender_python, tmp_path):
    travel = answer_of(blender_python, IMAGES, str(tmp_path))
    names = ["a.1001.png", "a.1012.png", "b.u1_v1.png", "b.u2_v2.png", "s0001.png", "s0002.png"]
    assert travel == [str(tmp_path / name) for name in names]
