"""A GPU for the tests: a real one, or the software driver of Mesa."""

import pytest

from rna_gpu import GpuError, open_device
from rna_render.paths.world_in_time import load_world
from rna_render.scene.scene_file import SceneFile, read_scene
from rna_render.world.world import World


@pytest.fixture(scope="session")
def device():
    try:
        return open_device()
    except GpuError as error:
        pytest.skip(str(error))


@pytest.fixture
def scene(tmp_path):
    def read(text: str, **changes: object) -> tuple[SceneFile, World]:
        (tmp_path / "scene.yaml").write_text(text)
        scene_file = read_scene(tmp_path / "scene.yaml").with_changes(**changes)
        return scene_file, load_world(scene_file)

    return read
