"""Kinds of points that the camera sees, which differ in how light is looked for there."""

from __future__ import annotations

import numpy as np

from rna_render.world.world import Vertices

# Flags of a kind.
STRAND = 1
LOBED = 2
KINDS = 4


def point_kinds(vertices: Vertices, by_lobes: bool) -> np.ndarray:
    """The kind of each vertex: (m,) int8, STRAND and LOBED added. by_lobes: whether lobes count."""
    kinds = np.zeros(len(vertices), np.int8)
    for rows, points in vertices.parts:
        kinds[rows] = STRAND * points.on_strands + LOBED * (by_lobes and points.gives_lobes)
    return kinds
