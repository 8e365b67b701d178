"""Rays against the geometry of assets and meshes, for the renderer and other packages."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
