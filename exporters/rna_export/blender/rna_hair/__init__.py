"""Hair and fur for capture: reads grooms, grows strands between guides, puts them in the scene.

A script for `rna-capture` can `import rna_hair`. `rna_hair.objects` needs Blender's `bpy` and is
imported by name; the rest is plain numpy.
"""

from .files import read_hair, read_tfx, write_hair
from .growth import interpolate
from .strands import Strands, fit, join, of_equal_length, resample, taper

__all__ = [
    "Strands",
    "fit",
    "interpolate",
    "join",
    "of_equal_length",
    "read_hair",
    "read_tfx",
    "resample",
    "taper",
    "write_hair",
]
