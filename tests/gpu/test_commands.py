"""`rna-run --device gpu`: stills, sequences, pieces of an image, and refusals."""

from importlib.metadata import EntryPoint

import numpy as np
import pytest

from rna_render.command import rna_run as cli
from rna_render.command.finished_pieces import Piece
from rna_render.command.pieces import render_pieces
from rna_render.image.images import read_exr
from rna_render.image.output import Output
from rna_render.paths import integrator_factory as devices
from rna_render.paths.world_in_time import load_world
from rna_render.scene.scene_file import read_scene
from rna_sdk.errors import WorkError
from rna_work.cluster import ray_cluster as cluster
from rna_work.executors import this_machine
from tests.conformance.conftest import KIT
from tests.gpu.scenes import on_gpu

SCENE = f"""
assets: [{{path: {KIT / "packages" / "surface-glow.rna"}}}]
camera: {{position: [1.4, 1.6, 2.6], look_at: [0, 0.2, 0], vertical_fov_deg: 30}}
lights: [{{type: point, position: [1, 2, 1], intensity: [1, 1, 1]}}]
resolution: [12, 8]
samples: 2
max_depth: 1
"""


@pytest.fixture(autouse=True)
def offered(monkeypatch):
    gpu = EntryPoint("gpu", "rna_gpu.scene.rendering:GpuRenderer", devices.GROUP)
    broken = EntryPoint("tpu", "rna_tpu.rendering:Renderer", devices.GROUP)
    monkeypatch.setattr(devices, "entry_points", lambda group: [gpu, broken])


@pytest.fixture
def scene(tmp_path):
    path = tmp_path / "scene.yaml"
    path.write_text(SCENE)
    return path


def test_a_still(scene, device, monkeypatch):
    """With the image so far, and within a time."""
    written: list[int] = []
    monkeypatch.setattr(Output, "write_so_far", lambda _, scene, film: written.append(film.samples))
    scene.write_text(SCENE + "quality: {seconds: 100}\n")
    out = scene.parent / "out.exr"
    usual = [str(scene), "--out", str(out), "--device", "gpu"]
    assert cli.main([*usual, "--every", "0"]) == 0
    assert out.is_file() and written == [1]


def test_frames(scene, device, capsys):
    scene.write_text(SCENE + "animation: {frames: 4, turntable: {degrees: 90}}\n")
    out = scene.parent / "frame.%d.exr"
    usual = [str(scene), "--out", str(out), "--device", "gpu", "--frames", "0-1"]
    assert cli.main(usual) == 0
    first, second = (read_exr(scene.parent / f"frame.{k}.exr")[0] for k in range(2))
    assert not np.array_equal(first["R"], second["R"])
    capsys.readouterr()
    assert cli.main(usual) == 0
    assert capsys.readouterr().out.count("is there already") == 2


def test_pieces_are_the_whole_and_are_kept(scene, device):
    scene_file = read_scene(scene)
    folder = scene.parent / "pieces"
    film, finished = render_pieces(scene_file, this_machine(), 1, folder, "gpu")
    whole = on_gpu(scene_file, load_world(scene_file), lambda: device)
    for name, values in whole.channels().items():
        assert np.array_equal(values, film.channels()[name]), name
    assert [piece for piece, _ in finished.saved()] == [Piece(0, 96)]
    again, _ = render_pieces(scene_file, this_machine(), 1, folder, "gpu")
    assert np.array_equal(again.channels()["R"], film.channels()["R"])
    render_pieces(scene_file, this_machine(), 1, folder, "cpu")  # pieces of its own
    assert [piece for piece, _ in finished.saved()] == []


def test_machines_of_a_cluster_that_have_a_gpu(monkeypatch):
    nodes = [{"Resources": {"CPU": 8.0}}, {"Resources": {"CPU": 16.0, "GPU": 2.0}}]
    monkeypatch.setattr(cluster, "alive_nodes", lambda: nodes)
    workers, threads = cluster.RayCluster().whole_machines(None, needs_gpu=True)
    assert (threads, workers.needs.gpus) == (16, 1.0)
    assert cluster.RayCluster().whole_machines(None)[1] == 8
    del nodes[1]
    with pytest.raises(WorkError, match="no node of the cluster has a GPU resource"):
        cluster.RayCluster().whole_machines(None, needs_gpu=True)


def test_what_is_refused(scene, capsys):
    usual = [str(scene), "--out", str(scene.parent / "out.exr")]
    assert cli.main([*usual, "--device", "moon"]) == 1
    assert "--device moon: no such device; there are: cpu, gpu, tpu" in capsys.readouterr().err
    assert cli.main([*usual, "--device", "tpu"]) == 1
    assert "rna_tpu is not installed: pip install -e '.[tpu]'" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        cli.main([str(scene), "--preview", "--device", "gpu"])
    assert "--preview is not for --device gpu" in capsys.readouterr().err
