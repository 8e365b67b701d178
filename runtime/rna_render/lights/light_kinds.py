"""The kinds of lights: every file in `kinds`, found there by its name.

A light that a scene file may have is in the file that is named as its `type`; `make` makes it.
"""

from functools import cache
from importlib import import_module
from pkgutil import iter_modules
from typing import Any

import numpy as np

from rna_render.lights import kinds
from rna_render.lights.base import Light
from rna_render.scene.light_models import LightModel


def make_light(model: LightModel) -> Light:
    """The light that a scene file describes.

    Raises SceneError for an environment whose image cannot be used.
    """
    light: Light = import_module(f"{kinds.__name__}.{model.type}").make(model)
    return light


@cache
def kinds_of_lights() -> dict[str, np.dtype[Any]]:
    """Names in WGSL, in order, and the numbers of lights of that kind; a kind's number there is its
    place here."""
    modules = [import_module(f"{kinds.__name__}.{m.name}") for m in iter_modules(kinds.__path__)]
    values = [value for module in modules for value in vars(module).values()]
    lights = [value for value in values if isinstance(value, type) and issubclass(value, Light)]
    found = {light.kind: light.NUMBERS for light in lights if "NUMBERS" in vars(light)}
    return dict(sorted(found.items()))


def number_places(numbers: np.dtype[Any]) -> dict[str, int]:
    """Where each member begins among the numbers."""
    assert numbers.fields is not None
    return {name: numbers.fields[name][1] // 8 for name in numbers.names or ()}
