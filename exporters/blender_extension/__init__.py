"""Relightable neural assets in Blender: import, render, bake."""

from . import engine, import_package, preferences, properties

_MODULES = (properties, preferences, import_package, engine)


def register():
    for module in _MODULES:
        module.register()


def unregister():
    for module in reversed(_MODULES):
        module.unregister()
