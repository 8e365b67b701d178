"""Materials that only glTF files have, against Mitsuba 3; see test_second_opinion."""

import io
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

pytest.importorskip("mitsuba", reason="mitsuba is not installed: pip install mitsuba")
from tests.render import mitsuba_scenes as twin
from tests.render.test_mesh_files import Gltf
from tests.render.test_second_opinion import compare

CAMERA = {"position": (0.6, 1.2, 5), "look_at": (0, 0.8, 0), "vertical_fov_deg": 32}
GREY = (0.5, 0.5, 0.5)
GROUND = {"size": 12, "material": {"type": "diffuse", "color": GREY}}
# Mitsuba takes a step through a hole for one of the path; with so many, it does not matter.
DEEP = {"max_depth": 24}


def card(path: Path, image: np.ndarray, material: dict[str, Any]) -> None:
    """A Lambertian square of one image."""
    gltf = Gltf()
    gltf.square(material=0).node(mesh=0)
    file = io.BytesIO()
    Image.fromarray(image).save(file, "png")
    gltf.json["images"] = [{"bufferView": gltf.view(file.getvalue()), "mimeType": "image/png"}]
    gltf.json["textures"] = [{"source": 0, "sampler": 0}]
    gltf.json["samplers"] = [{"wrapS": 33071, "wrapT": 33071}]
    matt = {"KHR_materials_specular": {"specularFactor": 0}}
    gltf.json["materials"] = [{"extensions": matt} | material]
    gltf.write(path)


def bitmap(values: np.ndarray) -> dict[str, Any]:
    image = twin.mi.Bitmap(np.ascontiguousarray(values, np.float32))
    return {"type": "bitmap", "bitmap": image, "raw": True, "wrap_mode": "clamp"}


def placed(turn: float) -> tuple[dict[str, Any], Any]:
    """The card, two metres wide, over the ground: our transform and Mitsuba's."""
    ours = {"translation": (-1, 0.1, 0.3), "rotation_deg": (turn, 0, 0), "scale": 2}
    theirs = twin.T().translate([-1, 0.1, 0.3]).rotate([1, 0, 0], turn)
    return ours, theirs.scale(2).translate([0.5, 0.5, 0]).scale(0.5)


LAMP = {"position": (0.5, 3, -2), "look_at": (0, 0.5, 0), "size": (1.5, 1.5), "radiance": (6, 5, 4)}


def lamp() -> dict[str, Any]:
    to_world = twin.facing(LAMP["position"], LAMP["look_at"], (0, 1, 0), (0.75, 0.75, 1))
    emitter = twin.emitter(LAMP["radiance"])
    return {"type": "rectangle", "to_world": to_world, "emitter": emitter, "bsdf": twin.diffuse(0)}


def test_a_card_that_is_there_in_part(tmp_path):
    """Behind it the sky and a lamp; what it keeps of both falls on the ground."""
    alpha = np.array([255, 60, 200, 0, 120, 30], np.uint8)
    image = np.empty((4, 6, 4), np.uint8)
    image[..., :3], image[..., 3] = 255, alpha
    color = (0.8, 0.4, 0.2)
    base = {"baseColorTexture": {"index": 0}, "baseColorFactor": [*color, 0.9], "metallicFactor": 0}
    card(tmp_path / "card.gltf", image, {"pbrMetallicRoughness": base, "alphaMode": "BLEND"})
    ours, theirs = placed(-30)
    opacity = np.rint(255 - (255 - 0.9 * image[..., 3:].astype(float)))
    mask = {"type": "mask", "opacity": bitmap(opacity / 255), "bsdf": twin.diffuse(color)}
    scene = {
        "objects": [{"path": "card.gltf", "transform": ours}],
        "ground": GROUND,
        "camera": CAMERA,
        "lights": [{"type": "rectangle", **LAMP}, {"type": "environment", "radiance": (1, 1, 1)}],
    }
    shapes = {
        "card": {"type": "rectangle", "to_world": theirs, "bsdf": mask},
        "ground": twin.ground(12, 0, twin.diffuse(0.5)),
        "lamp": lamp(),
        "sky": {"type": "constant", "radiance": twin.rgb(1)},
    }
    compare(tmp_path, scene | DEEP, shapes)


def test_a_card_with_relief(tmp_path):
    rng = np.random.default_rng(5)
    normals = rng.uniform(-0.15, 0.15, (1, 8, 3)) + np.array([0, 0, 1])
    normals /= np.linalg.norm(normals, axis=2, keepdims=True)
    image = np.rint((normals + 1) * 127.5).astype(np.uint8)
    base = {"baseColorFactor": [0.7, 0.7, 0.7, 1], "metallicFactor": 0}
    relief = {"normalTexture": {"index": 0}, "pbrMetallicRoughness": base}
    card(tmp_path / "card.gltf", image, relief)
    ours, theirs = placed(-20)
    bsdf = {
        "type": "normalmap",
        "normalmap": bitmap(image / 255),
        "bsdf": twin.diffuse(0.7)["bsdf"],
    }
    side = {"position": (2, 2.5, 2.5), "look_at": (0, 0.8, 0), "size": (1.5, 1.5)}
    side["radiance"] = (6, 5, 4)
    to_world = twin.facing(side["position"], side["look_at"], (0, 1, 0), (0.75, 0.75, 1))
    scene = {
        "objects": [{"path": "card.gltf", "transform": ours}],
        "ground": GROUND,
        "camera": CAMERA,
        "lights": [{"type": "rectangle", **side}],
    }
    shapes = {
        "card": {
            "type": "rectangle",
            "to_world": theirs,
            "bsdf": {"type": "twosided", "bsdf": bsdf},
        },
        "ground": twin.ground(12, 0, twin.diffuse(0.5)),
        "lamp": lamp() | {"to_world": to_world, "emitter": twin.emitter(side["radiance"])},
    }
    compare(tmp_path, scene, shapes)
