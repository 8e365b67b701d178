"""Four scenes, each for rna-run and for Mitsuba with rna_mitsuba: what the two have to agree on."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np
import yaml

import rna_mitsuba
from rna_render import load_world, make_integrator, render, write_exr
from rna_render.scene import read_scene
from tests.conftest import REPOSITORY

TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"
CURLS = REPOSITORY / "examples" / "fibers" / "curly_ball.rna"

T = mi.ScalarTransform4f


@dataclass(frozen=True)
class Pair:
    """One scene twice.

    ours: keys of a scene file except camera and size. theirs: entries of Mitsuba's scene.
    max_depth: of rna-run; Mitsuba counts one more.
    """

    ours: dict[str, Any]
    theirs: dict[str, Any]
    camera: dict[str, Any]
    max_depth: int


def rgb(value: Any) -> dict[str, Any]:
    return {"type": "rgb", "value": [float(x) for x in np.broadcast_to(value, 3)]}


def diffuse(color: Any) -> dict[str, Any]:
    return {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": rgb(color)}}


def ground(color: Any) -> dict[str, Any]:
    """A square of 20 m at height 0."""
    return {
        "type": "rectangle",
        "to_world": T().rotate([1, 0, 0], -90).scale(10),
        "bsdf": diffuse(color),
    }


def sun(direction: Any, irradiance: Any) -> dict[str, Any]:
    """direction: towards it."""
    away = [-float(x) for x in direction]
    return {"type": "directional", "direction": away, "irradiance": rgb(irradiance)}


def pairs(folder: Path) -> dict[str, Pair]:
    """The scenes by name; the environment image is written to `folder`."""
    toy_camera = {
        "position": (1.42, 0.80, 0.78),
        "look_at": (0.38, 0.17, -0.16),
        "vertical_fov_deg": 26,
    }
    far_camera = {"position": (1.7, 1.0, 1.3), "look_at": (0.3, 0.1, -0.1), "vertical_fov_deg": 30}
    direction, irradiance = (0.55, 0.75, 0.65), (2.5, 2.35, 2.1)
    key, back = ((0.8, 0.55, 0.5), (3.6, 3.4, 3.1)), ((-0.65, 0.4, -0.75), (2.2, 2.5, 3.0))
    grey = (0.5, 0.48, 0.45)
    sky = folder / "sky.exr"
    _write_sky(sky)
    return {
        "sun": Pair(
            {"assets": [{"path": str(TOY)}], "lights": [
                {"type": "directional", "direction": direction, "irradiance": irradiance}
            ]},
            {"toy": rna_mitsuba.asset(TOY), "sun": sun(direction, irradiance)},
            toy_camera,
            1,
        ),
        "environment and ground": Pair(
            {
                "assets": [{"path": str(TOY)}],
                "ground": {"size": 20, "material": {"type": "diffuse", "color": grey}},
                "lights": [{"type": "environment", "path": str(sky)}],
            },
            {
                "toy": rna_mitsuba.asset(TOY),
                "ground": ground(grey),
                "sky": {"type": "envmap", "bitmap": mi.Bitmap(_sky(_mitsuba_directions(128)))},
            },
            far_camera,
            3,
        ),
        "lamp and red wall": _lamp_and_wall(folder, grey, far_camera),
        "curls": Pair(
            {
                "assets": [{"path": str(CURLS)}],
                "lights": [
                    {"type": "directional", "direction": key[0], "irradiance": key[1]},
                    {"type": "directional", "direction": back[0], "irradiance": back[1]},
                ],
            },
            {
                "ball": rna_mitsuba.asset(CURLS),
                "key": sun(*key),
                "back": sun(*back),
            },
            {"position": (0.75, 0.45, 1.1), "look_at": (0, 0, 0), "vertical_fov_deg": 32},
            1,
        ),
    }  # fmt: skip


def _lamp_and_wall(folder: Path, grey: Any, camera: dict[str, Any]) -> Pair:
    """A square lamp over two assets before a red wall, with all light between them."""
    red, lamp = (0.7, 0.09, 0.06), {"position": (1.0, 1.4, 0.8), "look_at": (0.3, 0.1, 0.0)}
    bright = (16.0, 14.5, 12.5)
    wall = folder / "wall.ply"
    corners = [(-0.9, 0.0, -0.75), (1.8, 0.0, -0.75), (1.8, 1.2, -0.75), (-0.9, 1.2, -0.75)]
    lines = ["ply", "format ascii 1.0", "element vertex 4"]
    lines += [f"property float {axis}" for axis in "xyz"]
    lines += ["element face 2", "property list uchar int vertex_indices", "end_header"]
    lines += [" ".join(map(str, corner)) for corner in corners]
    wall.write_text("\n".join([*lines, "3 0 1 2", "3 0 2 3", ""]))
    ball = {"translation": (0.75, 0.2, 0.45), "scale": -0.4}
    return Pair(
        {
            "assets": [{"path": str(TOY)}, {"path": str(CURLS), "transform": ball}],
            "objects": [{"path": str(wall), "material": {"type": "diffuse", "color": red}}],
            "ground": {"size": 20, "material": {"type": "diffuse", "color": grey}},
            "lights": [{"type": "rectangle", **lamp, "size": (0.6, 0.6), "radiance": bright}],
        },
        {
            "toy": rna_mitsuba.asset(TOY),
            "ball": rna_mitsuba.asset(CURLS, to_world=T().translate([0.75, 0.2, 0.45]).scale(-0.4)),
            "wall": {"type": "ply", "filename": str(wall), "bsdf": diffuse(red)},
            "ground": ground(grey),
            "lamp": {
                "type": "rectangle",
                "to_world": T().look_at(*map(list, lamp.values()), [0, 1, 0]).scale(0.3),
                "emitter": {"type": "area", "radiance": rgb(bright)},
                "bsdf": diffuse(0),
            },
        },
        camera,
        4,
    )  # fmt: skip


def _sky(d: np.ndarray) -> np.ndarray:
    """Radiance (..., 3) float32 of unit directions (..., 3): a smooth sky with a bright side."""
    glow = np.exp(3.0 * (d @ np.array([0.5, 0.6, 0.62]) - 1.0))[..., None]
    up = 0.5 + 0.5 * d[..., 1:2]
    return (0.1 + up * np.array([0.2, 0.3, 0.5]) + glow * np.array([2.5, 2.0, 1.4])).astype(
        np.float32
    )


def _write_sky(path: Path) -> None:
    """Writes a sky in rna-run's layout: the middle is -z, the upper edge +y, the right half +x."""
    height = 128
    theta = np.pi * (np.arange(height) + 0.5) / height
    phi = 2 * np.pi * ((np.arange(2 * height) + 0.5) / (2 * height) - 0.5)
    theta, phi = np.meshgrid(theta, phi, indexing="ij")
    d = np.stack(
        [np.sin(theta) * np.sin(phi), np.cos(theta), -np.sin(theta) * np.cos(phi)], axis=-1
    )
    image = _sky(d)
    write_exr(path, {c: image[..., k].copy() for k, c in enumerate("RGB")}, {})


def _mitsuba_directions(height: int) -> np.ndarray:
    """Directions of Mitsuba's texels; its rows reach from pole to pole."""
    theta = np.pi * np.arange(height) / (height - 1)
    phi = 2 * np.pi * (np.arange(2 * height) + 0.5) / (2 * height)
    theta, phi = np.meshgrid(theta, phi, indexing="ij")
    return np.stack(
        [np.sin(theta) * np.sin(phi), np.cos(theta), -np.sin(theta) * np.cos(phi)], axis=-1
    )


class Ours:
    """rna-run of a scene, as an object to call: (height, width, 3) float64."""

    def __init__(self, folder: Path, pair: Pair, size: tuple[int, int], samples: int) -> None:
        path = folder / "scene.yaml"
        scene = pair.ours | {"camera": pair.camera, "resolution": size, "samples": samples}
        scene |= {"max_depth": pair.max_depth, "clamp_indirect": None}  # Mitsuba has no clamp
        path.write_text(yaml.safe_dump(_plain(scene)))
        self._file = read_scene(path)
        world = load_world(self._file)
        self._integrator = make_integrator(self._file.resolved, world)

    def __call__(self, seed: int) -> np.ndarray:
        channels = render(
            self._file.scene.model_copy(update={"seed": seed}), self._integrator
        ).channels()
        return np.stack([channels[c] for c in "RGB"], axis=-1).astype(np.float64)


class Theirs:
    """Mitsuba of a scene, likewise."""

    def __init__(self, pair: Pair, size: tuple[int, int], samples: int) -> None:
        self._samples = samples
        up = [0, 1, 0]
        film = {
            "type": "hdrfilm",
            "width": size[0],
            "height": size[1],
            "rfilter": {"type": "box"},
            "pixel_format": "rgb",
            "component_format": "float32",
        }
        place = T().look_at(list(pair.camera["position"]), list(pair.camera["look_at"]), up)
        sensor = {
            "type": "perspective",
            "fov": pair.camera["vertical_fov_deg"],
            "fov_axis": "y",
            "near_clip": 1e-3,
            "to_world": place,
            "film": film,
        }
        integrator = {"type": "rna_path", "max_depth": pair.max_depth + 1, "rr_depth": 3}
        self.scene = mi.load_dict(
            {"type": "scene", "integrator": integrator, "sensor": sensor, **pair.theirs}
        )

    def __call__(self, seed: int) -> np.ndarray:
        image = mi.render(self.scene, spp=self._samples, seed=mi.UInt32(seed))
        return np.array(image).astype(np.float64)


def _plain(value: Any) -> Any:
    """Converts tuples and mappings to types that YAML can write."""
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    return value
