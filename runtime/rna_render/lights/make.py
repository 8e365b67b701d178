"""The light that a scene file describes, by the kind of its model."""

from __future__ import annotations

from collections.abc import Callable

from rna_render.lights.base import Light
from rna_render.lights.directional import directional_light
from rna_render.lights.disk import DiskLight
from rna_render.lights.environment import EnvironmentImageLight, EnvironmentLight
from rna_render.lights.files.environment_file import environment_image
from rna_render.lights.point import PointLight, SpotLight
from rna_render.lights.rectangle import RectangleLight
from rna_render.lights.sphere import SphereLight
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

_SHAPES: dict[type, Callable[..., Light]] = {
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
        return _SHAPES[type(model)](model)
    if model.path is None:
        return EnvironmentLight(model)
    return EnvironmentImageLight(model, environment_image(model.path))
