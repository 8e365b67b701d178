"""Rays against the geometry of assets and meshes: what other packages than the renderer use."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
