"""Writes robot.glb, a robot of boxes and spheres: a plain glTF model to stand beside a neural one.

python examples/web/robot.py robot.glb
"""

import sys

import numpy as np
import trimesh
from trimesh.visual.material import PBRMaterial

METAL = PBRMaterial(baseColorFactor=[150, 160, 175, 255], metallicFactor=0.6, roughnessFactor=0.35)
BLUE = PBRMaterial(baseColorFactor=[40, 90, 170, 255], metallicFactor=0.0, roughnessFactor=0.5)
BOXES = [  # size, centre, material; metres, y up
    ([0.14, 0.16, 0.09], [0.0, 0.23, 0.0], BLUE),
    ([0.1, 0.09, 0.08], [0.0, 0.37, 0.0], METAL),
    ([0.035, 0.15, 0.04], [-0.095, 0.23, 0.0], METAL),
    ([0.035, 0.15, 0.04], [0.095, 0.23, 0.0], METAL),
    ([0.045, 0.15, 0.06], [-0.04, 0.075, 0.0], METAL),
    ([0.045, 0.15, 0.06], [0.04, 0.075, 0.0], METAL),
]
EYES = [[-0.025, 0.38, 0.04], [0.025, 0.38, 0.04]]


def robot() -> trimesh.Scene:
    """The parts, each with its material."""
    scene = trimesh.Scene()
    for size, centre, material in BOXES:
        box = trimesh.creation.box(
            size, transform=trimesh.transformations.translation_matrix(centre)
        )
        box.unmerge_vertices()  # flat faces
        box.visual = trimesh.visual.TextureVisuals(material=material)
        scene.add_geometry(box)
    for centre in EYES:
        eye = trimesh.creation.icosphere(subdivisions=2, radius=0.014)
        eye.apply_translation(np.array(centre))
        eye.visual = trimesh.visual.TextureVisuals(material=BLUE)
        scene.add_geometry(eye)
    return scene


if __name__ == "__main__":
    robot().export(sys.argv[1], include_normals=True)
