"""Every kind of source file loads, and stands where its format says."""

import subprocess
from pathlib import Path

import numpy as np
import pytest
import trimesh

from rna_export.blender.rna_sources.source_formats import SOURCE_FORMATS
from rna_export.capture.blender_axes import to_blender
from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.orientation import rotation
from rna_sdk.errors import CaptureError
from tests.exporters.scenes import write_scene

pytestmark = pytest.mark.blender

# A tetrahedron that looks different from every side; +Y up.
VERTICES = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]])
FACES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


@pytest.fixture(scope="module")
def sources(tmp_path_factory, blender_python):
    """The tetrahedron in every format: suffix -> file."""
    folder = tmp_path_factory.mktemp("sources")
    up_is_y = trimesh.Trimesh(VERTICES, FACES, process=False)
    up_is_z = trimesh.Trimesh(to_blender(VERTICES), FACES, process=False)
    up_is_y.export(folder / "t.obj")
    up_is_y.export(folder / "t.glb")
    up_is_z.export(folder / "t.ply")  # PLY names no up axis: Blender's stands
    for name, data in trimesh.exchange.gltf.export_gltf(up_is_y.scene()).items():
        (folder / name.replace("model", "t")).write_bytes(data)
    body = f"add({up_is_z.vertices.tolist()!r}, {FACES.tolist()!r})\n"
    script = write_scene(folder, "t", body)
    save = f"bpy.ops.wm.save_as_mainfile(filepath={str(folder / 't.blend')!r})\n"
    save += f"bpy.ops.wm.alembic_export(filepath={str(folder / 't.abc')!r})\n"
    for suffix in ("usda", "usdc", "usdz", "usd"):
        save += f"bpy.ops.wm.usd_export(filepath={str(folder / f't.{suffix}')!r})\n"
    writer = write_scene(
        folder, "save", f"bpy.ops.wm.read_factory_settings(use_empty=True)\n{body}{save}"
    )
    subprocess.run([blender_python, writer], capture_output=True)  # bpy may complain on exit
    return {path.suffix: path for path in (script, *folder.glob("t.*"))}


@pytest.mark.parametrize(
    "suffix", [s for s, known in SOURCE_FORMATS.items() if known.options != "groom"]
)
def test_format(suffix, sources, open_worker):
    positions = open_worker(sources[suffix]).export_corners()["positions"]
    actual = np.unique(np.round(positions, 5) + 0.0, axis=0)
    assert np.allclose(actual, np.unique(VERTICES, axis=0), atol=1e-5)


@pytest.mark.parametrize(
    ("suffix", "axes"),
    [
        (".obj", {"up": "Z"}),
        (".obj", {"front": "-Z"}),
        (".glb", {"front": "X", "up": "-Y"}),
        (".ply", {"up": "Y"}),
        (".blend", {"front": "Y"}),
        (".usda", {"front": "Y"}),
        (".abc", {"front": "-X"}),
    ],
)
def test_front_and_up_are_axes_of_the_file(suffix, axes, sources, open_worker):
    """Whatever the file calls front and up is +Z and +Y afterwards."""
    up_is_z = suffix in (".ply", ".blend", ".usda")  # Blender writes USD with its own axes
    up = axes.get("up", "Z" if up_is_z else "Y")
    front = axes.get("front", "-Y" if up == "Z" else "Z")
    in_file = to_blender(VERTICES) if up_is_z else VERTICES
    positions = open_worker(sources[suffix], **axes).export_corners()["positions"]
    actual = np.unique(np.round(positions, 5) + 0.0, axis=0)
    assert np.allclose(actual, np.unique(in_file @ rotation(front, up), axis=0), atol=1e-5)


def test_front_and_up_along_one_axis_are_refused(sources, open_worker):
    with pytest.raises(CaptureError, match="front Y and up Y are along one axis: give --front"):
        open_worker(sources[".glb"], front="Y")


def test_a_script_gets_its_arguments(open_worker):
    script = "import sys\nadd(*square(float(sys.argv[1])))"
    positions = open_worker(script, "2.5").export_corners()["positions"]
    assert np.abs(positions).max() == 2.5


def test_a_script_that_fails_names_its_error(open_worker):
    with pytest.raises(CaptureError, match="ZeroDivisionError"):
        open_worker("1 / 0")


def test_an_empty_scene_is_refused(open_worker):
    with pytest.raises(CaptureError, match="no mesh"):
        open_worker("").export_corners()


@pytest.mark.parametrize("suffix", [".glb", ".abc", ".usda", ".usdc", ".usdz"])
def test_a_broken_file_is_refused(suffix, open_worker, tmp_path):
    broken = tmp_path / f"broken{suffix}"
    broken.write_bytes(b"glTF but not really")
    with pytest.raises(CaptureError, match=rf"^[^\n]*broken\{suffix}[^\n]*$"):
        open_worker(broken)


def test_an_interpreter_without_bpy_is_refused(tmp_path):
    import sys

    scene = write_scene(tmp_path, "scene", "add(CUBE, SIDES)")
    worker = BlenderWorker(Path(sys.executable), Source(scene), tmp_path, 1)
    with pytest.raises(CaptureError, match="ended without an answer"), worker:
        pass
