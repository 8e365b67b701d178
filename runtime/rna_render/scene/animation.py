"""The scene of one frame of a sequence."""

import numpy as np

from rna_render.scene.light_models import DirectionalModel, EnvironmentModel, LightModel
from rna_render.scene.limits import MAX_SEED
from rna_render.scene.model_base import Vector
from rna_render.scene.scene_model import AssetModel, CameraModel, Scene


def frame_scene(scene: Scene, number: float) -> Scene:
    """The scene at frame `number` of its animation, which it then has no more.

    Motions of assets start there; the number may lie between two frames. A turn by d degrees has
    come to d * number / frames: after a whole turn the last frame is one step before the first, and
    the sequence can be shown in a loop. Each frame has a seed of its own unless the seed is fixed.
    """
    animation = scene.animation
    if animation is None:
        return scene
    camera, lights = scene.camera, scene.lights
    if animation.turntable is not None:
        camera = _turned_camera(camera, animation.turntable.degrees * number / animation.frames)
    if animation.light_sweep is not None:
        angle = animation.light_sweep.degrees * number / animation.frames
        lights = tuple(_turned_light(light, angle) for light in lights)
    assets = tuple(_moved(asset, number) for asset in scene.assets)
    seed = scene.seed if animation.fixed_seed else (scene.seed + int(number)) % (MAX_SEED + 1)
    changes = {"assets": assets, "camera": camera, "lights": lights, "seed": seed}
    return scene.model_copy(update={**changes, "animation": None})


def _moved(asset: AssetModel, number: float) -> AssetModel:
    if asset.motion is None:
        return asset
    motion = asset.motion.model_copy(update={"start": asset.motion.start + number})
    return asset.model_copy(update={"motion": motion})


def _turned_camera(camera: CameraModel, angle_deg: float) -> CameraModel:
    arm = np.subtract(camera.position, camera.look_at)
    position = np.add(camera.look_at, _turned(arm, angle_deg))
    return camera.model_copy(
        update={"position": _vector(position), "up": _vector(_turned(camera.up, angle_deg))}
    )


def _turned_light(light: LightModel, angle_deg: float) -> LightModel:
    if isinstance(light, DirectionalModel):
        direction = _vector(_turned(light.direction, angle_deg))
        return light.model_copy(update={"direction": direction})
    if isinstance(light, EnvironmentModel):
        return light.model_copy(update={"rotation_deg": light.rotation_deg + angle_deg})
    return light


def _turned(vector: Vector | np.ndarray, angle_deg: float) -> np.ndarray:
    """About +y, counter-clockwise seen from above."""
    x, y, z = vector
    c, s = np.cos(np.radians(angle_deg)), np.sin(np.radians(angle_deg))
    return np.array([c * x + s * z, y, c * z - s * x])


def _vector(values: np.ndarray) -> Vector:
    x, y, z = (float(value) for value in values)
    return x, y, z
