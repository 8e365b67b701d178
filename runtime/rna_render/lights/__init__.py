"""Lights, as the integrator sees them.

The names below are loaded at their first use, so that a scene file's models need no Embree.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
