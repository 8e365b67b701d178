"""Pictures of the GPU do not change with the size of a scene, its place, or what lies far away."""

from pathlib import Path

import numpy as np

from rna_gpu import Device
from rna_render import load_world
from tests.gpu.scenes import on_gpu
from tests.render.far_scenes import VARIANTS, assert_same_picture, scene


def picture(device: Device, folder: Path, **arguments: object) -> dict[str, np.ndarray]:
    file = scene(folder, **arguments)
    return on_gpu(file, load_world(file), lambda: device).channels()


def test_a_picture_is_the_same_at_any_scale(device, tmp_path):
    expected = picture(device, tmp_path)
    for arguments in VARIANTS.values():
        assert_same_picture(picture(device, tmp_path, **arguments), expected)
