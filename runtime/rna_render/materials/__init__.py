"""Meshes that are not neural, and what they are made of; `models` has what a scene file says.

The names below are loaded at their first use, so that a scene file's models need no Embree.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
