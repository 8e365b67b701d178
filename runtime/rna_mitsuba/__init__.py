"""Neural assets in Mitsuba 3: the shape `rna` and the integrator `rna_path`.

>>> import mitsuba as mi
>>> mi.set_variant("llvm_ad_rgb")
>>> import rna_mitsuba
>>> scene = mi.load_dict(
...     {
...         "type": "scene",
...         "integrator": {"type": "rna_path"},
...         "toy": rna_mitsuba.asset("toy.rna"),
...         "sky": {"type": "constant"},
...         "sensor": {"type": "perspective"},
...     }
... )
>>> image = mi.render(scene, spp=16)

Plug-ins of Mitsuba belong to a variant: set it before this module is imported, and keep it.
"""

from rna_mitsuba.variant import check_variant

check_variant()

from rna_mitsuba.integrator import RnaPath  # noqa: E402
from rna_mitsuba.shape import RnaShape, asset  # noqa: E402

__all__ = ["RnaPath", "RnaShape", "asset"]
