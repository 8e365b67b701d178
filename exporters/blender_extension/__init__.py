"""Relightable neural assets in Blender: import, render, bake."""

from . import (
    engine,
    export_scene,
    import_package,
    panels,
    preferences,
    properties,
    set_up,
    web_page,
)
from .bake import operators

_MODULES = (
    properties,
    set_up,
    preferences,
    import_package,
    export_scene,
    web_page,
    operators,
    engine,
    panels,
)


def register():
    for module in _MODULES:
        module.register()


def unregister():
    for module in reversed(_MODULES):
        module.unregister()
