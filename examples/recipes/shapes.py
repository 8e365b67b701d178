"""Meshes of the recipes, from arrays: nothing depends on how Blender numbers vertices."""

import math
from dataclasses import dataclass

import bpy
import numpy as np


@dataclass(frozen=True)
class Shape:
    """Points (p, 3), Blender's axes, metres; faces of point numbers; UVs of each face's corners."""

    points: np.ndarray
    faces: list
    uvs: list

    def placed(self, offset=(0.0, 0.0, 0.0), turn=None, scale=(1.0, 1.0, 1.0)):
        """The shape scaled, turned by a rotation matrix, then moved."""
        matrix = np.eye(3) if turn is None else np.asarray(turn)
        points = (self.points * np.asarray(scale)) @ matrix.T + np.asarray(offset)
        return Shape(points, self.faces, self.uvs)


def joined(shapes):
    """All shapes as one."""
    first = np.cumsum([0] + [len(shape.points) for shape in shapes])
    faces = [
        [int(start) + k for k in face]
        for start, shape in zip(first[:-1], shapes, strict=True)
        for face in shape.faces
    ]
    points = np.concatenate([shape.points for shape in shapes])
    return Shape(points, faces, [uv for shape in shapes for uv in shape.uvs])


def grid(points, closed=False):
    """Quads between rows and columns of points (r, c, 3), u along columns, v along rows.

    closed: the last column meets the first. Points that coincide become one, as at a pole.
    """
    rows, columns = points.shape[:2]
    flat = points.reshape(-1, 3)
    _, first, index = np.unique(flat.round(9), axis=0, return_index=True, return_inverse=True)
    index = index.reshape(rows, columns)
    faces, uvs = [], []
    for i in range(rows - 1):
        for j in range(columns if closed else columns - 1):
            after = (j + 1) % columns
            corners = [index[i, j], index[i, after], index[i + 1, after], index[i + 1, j]]
            u, v = j / (columns - (not closed)), i / (rows - 1)
            du, dv = 1.0 / (columns - (not closed)), 1.0 / (rows - 1)
            places = [(u, v), (u + du, v), (u + du, v + dv), (u, v + dv)]
            distinct = [k for k in range(4) if corners[k] != corners[k - 1]]
            if len(distinct) > 2:
                faces.append([int(corners[k]) for k in distinct])
                uvs.append([places[k] for k in distinct])
    return Shape(flat[first], faces, uvs)


def lathe(profile, around=48):
    """A surface of revolution about +Z; profile (n, 2): radius and height, upwards outside."""
    radius, height = np.asarray(profile, float).T
    angle = 2.0 * np.pi * np.arange(around) / around
    ring = [np.outer(radius, np.cos(angle)), np.outer(radius, np.sin(angle))]
    points = np.stack([*ring, np.repeat(height[:, None], around, axis=1)], axis=-1)
    return grid(points, closed=True)


def tube(path, radius, around=10, caps=True):
    """A round tube along a path (n, 3); radius (n,) or one for all."""
    path = np.asarray(path, float)
    radius = np.broadcast_to(np.asarray(radius, float), (len(path),))
    along = np.gradient(path, axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    side = np.cross(along[0], [0.0, 0.0, 1.0] if abs(along[0, 2]) < 0.9 else [1.0, 0.0, 0.0])
    angle = 2.0 * np.pi * np.arange(around) / around
    rings = []
    for point, direction, r in zip(path, along, radius, strict=True):
        side = side - direction * (side @ direction)  # carried along: no twist
        side /= np.linalg.norm(side)
        other = np.cross(direction, side)
        rings.append(point + r * (np.outer(np.cos(angle), side) + np.outer(np.sin(angle), other)))
    if caps:
        ends = (np.repeat(path[end][None], around, axis=0) for end in (0, -1))
        rings = [next(ends), *rings, next(ends)]
    return grid(np.stack(rings), closed=True)


def ball(radii=(1.0, 1.0, 1.0), around=32):
    """An ellipsoid about the origin."""
    angle = np.linspace(-0.5 * np.pi, 0.5 * np.pi, around // 2 + 1)
    profile = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    profile[[0, -1], 0] = 0.0
    return lathe(profile, around).placed(scale=radii)


def box(size, bevel):
    """A box about the origin, its edges cut off by `bevel`; each face has the whole image."""
    half = 0.5 * np.asarray(size, float)
    points, faces = [], []
    for axis in range(3):
        for sign in (-1.0, 1.0):
            a, b = (axis + 1) % 3, (axis + 2) % 3
            for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                point = np.zeros(3)
                point[axis] = sign * half[axis]
                point[a], point[b] = u * (half[a] - bevel), v * (half[b] - bevel)
                points.append(point)
            first = len(points) - 4
            faces.append([first + k for k in ((0, 1, 2, 3) if sign > 0 else (3, 2, 1, 0))])
    points = np.array(points)
    faces += _cut_edges(points, half)
    square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
    return Shape(points, faces, [square[: len(face)] for face in faces])


def _cut_edges(points, half):
    """Twelve quads and eight triangles between the six sides of a box."""
    faces = []
    corner = np.sign(points)
    for mask in np.ndindex(3, 3, 3):
        signs = np.array(mask) - 1
        if np.count_nonzero(signs) < 2:
            continue
        near = [
            k
            for k in range(len(points))
            if all(s == 0 or s == corner[k, a] for a, s in enumerate(signs))
            and any(s and np.isclose(abs(points[k, a]), half[a]) for a, s in enumerate(signs))
        ]
        middle = points[near].mean(axis=0)
        normal = signs / np.linalg.norm(signs)
        first = points[near[0]] - middle
        first -= normal * (first @ normal)
        other = np.cross(normal, first)
        turn = [
            math.atan2((points[k] - middle) @ other, (points[k] - middle) @ first) for k in near
        ]
        faces.append([near[k] for k in np.argsort(turn)])
    return faces


def add(shape, name, material, smooth_deg=40.0):
    """An object of the scene; edges sharper than `smooth_deg` stay sharp."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(shape.points.tolist(), [], shape.faces)
    layer = mesh.uv_layers.new(name="UVMap")
    corners = np.array([place for face in shape.uvs for place in face], np.float32)
    layer.uv.foreach_set("vector", corners.reshape(-1))
    mesh.shade_smooth()
    mesh.set_sharp_from_angle(angle=math.radians(smooth_deg))
    mesh.materials.append(material)
    item = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(item)
    return item


def rotation(axis, angle_deg):
    """The 3 x 3 matrix that turns about an axis (3,), counter-clockwise."""
    x, y, z = np.asarray(axis, float) / np.linalg.norm(axis)
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    angle = math.radians(angle_deg)
    return np.eye(3) + math.sin(angle) * cross + (1.0 - math.cos(angle)) * cross @ cross
