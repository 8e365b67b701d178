"""An asset in motion: the toy, bent by hand, in a host of one page (spec/RNA.md, 8.3).

python examples/hosts/motion.py bent.png
"""

import sys

import numpy as np
import trimesh
from PIL import Image

from rna_sdk.runtime import load

asset = load("examples/quickstart/toy.rna")
p = asset.mesh.positions.astype(float)
middle = p.mean(axis=0)
x, y, z = (p - middle).T
angle = 1.2 * x  # radians about z, in 1 m; the further right, the more: a bend
x, y = np.sin(angle) / 1.2 - y * np.sin(angle), (np.cos(angle) - 1) / 1.2 + y * np.cos(angle)
bent = middle + np.stack([x, y, z], axis=1)
shape = asset.deformed(np.float32(bent))  # once a frame

# Rays are traced against the deformed shape, here from the front.
j, i = np.mgrid[0:240, 0:320]
directions = trimesh.unitize(np.stack([i - 160, 120 - j, i * 0 - 600], 2).reshape(-1, 3))
eye = middle + np.array([0, 0, 2])
rays = trimesh.Trimesh(shape.mesh.positions, shape.mesh.triangles, process=False).ray
hits, pixel, triangle = rays.intersects_location([eye] * len(directions), directions, False)
corners = shape.mesh.positions[shape.mesh.triangles[triangle]].astype(float)
b = np.float32(trimesh.triangles.points_to_barycentric(corners, hits))

# Each hit asks the decoder at its rest point, with directions turned to rest.
rest = shape.rest_points(triangle, b[:, 1], b[:, 2])
wo = np.float32(-directions[pixel])
wi = np.tile(np.float32(trimesh.unitize([0.5, 0.8, 0.6])), (len(wo), 1))  # a sun
color = asset.base_color_at(triangle, b[:, 1], b[:, 2])
at_rest = rest.positions, rest.axes, rest.to_rest(wo), rest.to_rest(wi)
visible, shadowed = asset.evaluate(*at_rest, color)

# Its own shadow falls from the deformed shape; a step off the triangle, towards the light.
n = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
step = 1e-5 * trimesh.unitize(n) * np.where(np.sum(n * wi, axis=1) < 0, -1, 1)[:, None]
blocked = rays.intersects_any(hits + step, wi)
image = np.zeros((240 * 320, 3))
image[pixel] = 3 * np.where(blocked[:, None], shadowed, visible)
encoded = 255 * np.clip(image, 0, 1) ** (1 / 2.2) + 0.5
Image.fromarray(np.uint8(encoded).reshape(240, 320, 3)).save(sys.argv[1])
