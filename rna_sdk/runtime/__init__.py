"""Evaluate the neural assets of `.rna` packages in batches.

Examples:
    A surface:

    >>> asset = load("toy.rna")
    >>> color = asset.base_color_at(triangles, u, v)
    >>> visible, shadowed = asset.evaluate(positions, normals, wo, wi, color)

    Fibers:

    >>> hair = load("hair.rna")
    >>> h = offset_across(normals, tangents, wo)
    >>> visible, shadowed = hair.evaluate(positions, tangents, h, wo, wi)

An asset of several parts is evaluated part by part: `for part in asset.parts: part.evaluate(...)`.
An asset of one part is its own only part.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
