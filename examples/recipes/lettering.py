"""Text of the recipes as masks, in Blender's own font."""

import bpy
import numpy as np

_SAMPLES = 4  # along a pixel's side


def text_mask(text, size, left, bottom, height):
    """(size, size) coverage from 0 to 1 of a line of text; row 0 is the lowest.

    left, bottom: of its first letter, pixels. height: of a capital letter, pixels.
    """
    triangles = _triangles(text) * (height / _capital())
    fine = np.zeros((size * _SAMPLES, size * _SAMPLES), bool)
    for corners in (triangles + np.array([left, bottom])) * _SAMPLES:
        _fill(fine, corners)
    return fine.reshape(size, _SAMPLES, size, _SAMPLES).mean(axis=(1, 3))


def _triangles(text):
    """(t, 3, 2) of a line of text, its first letter on the origin."""
    curve = bpy.data.curves.new("text", "FONT")
    curve.body = text
    item = bpy.data.objects.new("text", curve)
    bpy.context.scene.collection.objects.link(item)
    bpy.context.view_layer.update()
    mesh = item.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    mesh.calc_loop_triangles()
    points = np.array([vertex.co[:2] for vertex in mesh.vertices])
    corners = points[[triangle.vertices[:] for triangle in mesh.loop_triangles]]
    bpy.data.objects.remove(item)
    bpy.data.curves.remove(curve)
    return corners


def _capital():
    return float(_triangles("H")[..., 1].max())


def _fill(mask, corners):
    """Set the pixels of a mask whose centres lie in a triangle (3, 2), of either orientation."""
    low = np.maximum(np.floor(corners.min(axis=0)).astype(int), 0)
    high = np.minimum(np.ceil(corners.max(axis=0)).astype(int) + 1, mask.shape[::-1])
    if (low >= high).any():
        return
    x, y = np.meshgrid(np.arange(low[0], high[0]) + 0.5, np.arange(low[1], high[1]) + 0.5)
    sides = []
    for k in range(3):
        (ax, ay), (bx, by) = corners[k], corners[(k + 1) % 3]
        sides.append((bx - ax) * (y - ay) - (by - ay) * (x - ax))
    sides = np.stack(sides)
    inside = (sides >= 0.0).all(axis=0) | (sides <= 0.0).all(axis=0)
    mask[low[1] : high[1], low[0] : high[0]] |= inside
