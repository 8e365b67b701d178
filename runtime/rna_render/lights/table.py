"""How each kind of light is made, and for compiled code sampled and evaluated: by its row.

A sample is (wi, distance, radiance, pdf, place): three float64, in the world; a float64; red, green
and blue; a float64, 0 where nothing arrives; and for triangles, whose radiance is asked of
`Light.sent`, triangle and barycentrics of the point, where the radiance is 1.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from rna_render.lights.base import Light
from rna_render.lights.directional import (
    directional_light,
    look_up_sun,
    sample_directional,
    sample_sun,
)
from rna_render.lights.disk import DiskLight, disk_density, sample_disk
from rna_render.lights.environment import (
    EnvironmentImageLight,
    EnvironmentLight,
    look_up_image_light,
    look_up_uniform,
    sample_image_light,
    sample_uniform,
)
from rna_render.lights.files.environment_file import environment_image
from rna_render.lights.kinds import (
    DIRECTIONAL,
    DISK,
    IMAGE,
    POINT,
    RECTANGLE,
    SPHERE,
    SUN,
    TRIANGLES,
    UNIFORM,
)
from rna_render.lights.mesh import sample_triangles
from rna_render.lights.point import PointLight, SpotLight, sample_point_light
from rna_render.lights.rectangle import RectangleLight, rectangle_density, sample_rectangle
from rna_render.lights.sphere import SphereLight, sample_sphere, sphere_density
from rna_render.scene.light_models import (
    DirectionalModel,
    DiskModel,
    EnvironmentModel,
    LightModel,
    PointModel,
    RectangleModel,
    SphereModel,
    SpotModel,
)
from rna_sdk.compiled import compiled
from rna_trace.vectors import Vector, vector_at

_MADE_OF: dict[type, Callable[..., Light]] = {
    DirectionalModel: directional_light,
    PointModel: PointLight,
    SpotModel: SpotLight,
    RectangleModel: RectangleLight,
    DiskModel: DiskLight,
    SphereModel: SphereLight,
}


def make_light(model: LightModel) -> Light:
    """The light that a scene file describes.

    Raises SceneError for an environment whose image cannot be used.
    """
    if not isinstance(model, EnvironmentModel):
        return _MADE_OF[type(model)](model)
    if model.path is None:
        return EnvironmentLight(model)
    return EnvironmentImageLight(model, environment_image(model.path))


@compiled(fastmath=())
def sample_light(
    kind: int, numbers: np.ndarray, words: np.ndarray, x: Vector, u1: float, u2: float
) -> tuple[Vector, float, Vector, float, Vector]:
    """A sample of a light at x, three float64; of images see `sample_batch`."""
    no_place = (0.0, 0.0, 0.0)
    if kind == UNIFORM:
        wi, radiance, pdf = sample_uniform(numbers, u1, u2)
        return wi, np.inf, radiance, pdf, no_place
    if kind == SUN:
        wi, radiance, pdf = sample_sun(numbers, u1, u2)
        return wi, np.inf, radiance, pdf, no_place
    if kind == DIRECTIONAL:
        wi, radiance = sample_directional(numbers)
        return wi, np.inf, radiance, 1.0, no_place
    if kind == POINT:
        wi, distance, radiance, pdf = sample_point_light(numbers, x)
        return wi, distance, radiance, pdf, no_place
    if kind == TRIANGLES:
        wi, distance, pdf, place = sample_triangles(numbers, words, x, u1, u2)
        return wi, distance, (1.0, 1.0, 1.0), pdf, place
    if kind == RECTANGLE:
        wi, distance, pdf = sample_rectangle(numbers, x, u1, u2)
    elif kind == DISK:
        wi, distance, pdf = sample_disk(numbers, x, u1, u2)
    else:
        wi, distance, pdf = sample_sphere(numbers, x, u1, u2)
    return wi, distance, _where_seen(numbers, pdf), pdf, no_place


@compiled(fastmath=())
def eval_environment_light(kind: int, numbers: np.ndarray, d: Vector) -> tuple[Vector, float]:
    """Radiance, and density of `sample_light`, of a ray along d that leaves the scene; of images
    see `eval_environment_batch`."""
    if kind == UNIFORM:
        return look_up_uniform(numbers)
    if kind == SUN:
        return look_up_sun(numbers, d)
    return (0.0, 0.0, 0.0), 0.0


@compiled(fastmath=())
def eval_hit_light(kind: int, numbers: np.ndarray, x: Vector, d: Vector) -> tuple[Vector, float]:
    """Radiance and density of a ray from x along d to a light of one shape and one radiance."""
    pdf = 0.0
    if kind == RECTANGLE:
        pdf = rectangle_density(numbers, x, d)
    elif kind == DISK:
        pdf = disk_density(numbers, x, d)
    elif kind == SPHERE:
        pdf = sphere_density(numbers, x)
    return _where_seen(numbers, pdf), pdf


@compiled(fastmath=())
def _where_seen(numbers: np.ndarray, pdf: float) -> Vector:
    return (numbers[0], numbers[1], numbers[2]) if pdf > 0.0 else (0.0, 0.0, 0.0)


@compiled(fastmath=())
def sample_batch(
    kind: int,
    numbers: np.ndarray,
    words: np.ndarray,
    x_world: np.ndarray,
    u: np.ndarray,
    wi_world: np.ndarray,
    distance: np.ndarray,
    radiance: np.ndarray,
    pdf: np.ndarray,
    place: np.ndarray,
) -> None:
    if kind == IMAGE:
        sample_image_light(numbers, words, u, wi_world, radiance, pdf)
        distance[:] = np.inf
        return
    for i in range(len(x_world)):
        sample = sample_light(kind, numbers, words, vector_at(x_world, i), u[i, 0], u[i, 1])
        distance[i], pdf[i] = sample[1], sample[3]
        for axis in range(3):
            wi_world[i, axis], radiance[i, axis] = sample[0][axis], sample[2][axis]
            place[i, axis] = sample[4][axis]


@compiled(fastmath=())
def eval_environment_batch(
    kind: int,
    numbers: np.ndarray,
    words: np.ndarray,
    d_world: np.ndarray,
    radiance: np.ndarray,
    pdf: np.ndarray,
) -> None:
    if kind == IMAGE:
        look_up_image_light(numbers, words, d_world, radiance, pdf)
        return
    for i in range(len(d_world)):
        found, pdf[i] = eval_environment_light(kind, numbers, vector_at(d_world, i))
        radiance[i, 0], radiance[i, 1], radiance[i, 2] = found


@compiled(fastmath=())
def eval_hit_batch(
    kind: int,
    numbers: np.ndarray,
    x_world: np.ndarray,
    d_world: np.ndarray,
    radiance: np.ndarray,
    pdf: np.ndarray,
) -> None:
    for i in range(len(d_world)):
        at = vector_at(x_world, i), vector_at(d_world, i)
        found, pdf[i] = eval_hit_light(kind, numbers, at[0], at[1])
        radiance[i, 0], radiance[i, 1], radiance[i, 2] = found
