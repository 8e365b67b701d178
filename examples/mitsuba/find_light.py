"""Find the sun of a picture: its direction and colour, from how it lights a neural asset.

    python examples/mitsuba/find_light.py

The picture is rendered under a sun that the search does not know, with noise and rounded to 8 bits
as a photograph is. The search starts with a white sun from elsewhere and follows the derivatives of
rna_mitsuba's pictures.
"""

import argparse
from pathlib import Path

import drjit as dr
import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_rgb")

import rna_mitsuba  # noqa: E402

TOY = Path(__file__).parents[1] / "quickstart" / "toy.rna"
TRUE_ANGLES, TRUE_COLOUR = (0.70, 0.72), (2.5, 2.2, 1.7)  # azimuth, height; radians
START_ANGLES, START_COLOUR = (0.2, 1.1), (1.5, 1.5, 1.5)


def make_scene() -> mi.Scene:
    """The toy under one sun."""
    place = mi.ScalarTransform4f().look_at([1.42, 0.8, 0.78], [0.38, 0.17, -0.16], [0, 1, 0])
    film = {"type": "hdrfilm", "width": 48, "height": 32, "pixel_format": "rgb"}
    return mi.load_dict(
        {
            "type": "scene",
            "integrator": {"type": "rna_path", "max_depth": 2},
            "toy": rna_mitsuba.asset(TOY),
            "sun": {"type": "directional", "irradiance": {"type": "rgb", "value": [1, 1, 1]}},
            "sensor": {"type": "perspective", "fov": 34, "to_world": place, "film": film},
        }
    )


def set_sun(parameters: mi.SceneParameters, angles: mi.Point2f, colour: mi.Color3f) -> None:
    """angles: azimuth from +z towards +x, and height, of where the light comes from.

    Mitsuba's light goes along +z, so it is turned around first.
    """
    degrees = 180 / dr.pi
    turned = mi.Transform4f().rotate(mi.Vector3f(0, 1, 0), angles.x * degrees)
    raised = mi.Transform4f().rotate(mi.Vector3f(1, 0, 0), 180 + angles.y * degrees)
    parameters["sun.to_world"] = turned @ raised
    parameters["sun.irradiance.value"] = colour
    parameters.update()


def photograph(scene: mi.Scene) -> mi.TensorXf:
    """The picture to explain, linear."""
    parameters = mi.traverse(scene)
    set_sun(parameters, mi.Point2f(*TRUE_ANGLES), mi.Color3f(*TRUE_COLOUR))
    image = np.array(mi.render(scene, spp=64, seed=99))
    image += np.random.default_rng(0).normal(0, 0.01, image.shape)
    srgb = np.round(255 * np.clip(image, 0, 1) ** (1 / 2.2))
    return mi.TensorXf(((srgb / 255) ** 2.2).astype(np.float32))


def find(scene: mi.Scene, target: mi.TensorXf, steps: int) -> tuple[mi.Point2f, mi.Color3f]:
    """The sun's angles and colour."""
    search = mi.ad.Adam(lr=0.06)
    search["angles"], search["colour"] = mi.Point2f(*START_ANGLES), mi.Color3f(*START_COLOUR)
    parameters = mi.traverse(scene)
    for step in range(steps):
        set_sun(parameters, search["angles"], search["colour"])
        image = mi.render(scene, parameters, spp=4, seed=2 * step, seed_grad=2 * step + 1)
        off = dr.minimum(image, 1) - target
        loss = dr.mean(off * off, axis=None)
        dr.backward(loss)
        search.step()
        if step % 10 == 0:
            print(f"step {step:3d}: loss {float(loss.array[0]):.5f}", flush=True)
    return search["angles"], search["colour"]


def main() -> None:
    """Find the sun and print it beside the true one."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--steps", type=int, default=80, help="of the search (default: 80)")
    options = parser.parse_args()
    scene = make_scene()
    angles, colour = find(scene, photograph(scene), options.steps)
    result = [*(float(angles[k][0]) for k in range(2)), *(float(colour[k][0]) for k in range(3))]
    names = ("azimuth", "height", "red", "green", "blue")
    for name, value, true in zip(names, result, (*TRUE_ANGLES, *TRUE_COLOUR), strict=True):
        print(f"{name:8} found {value:6.3f}, true {true:6.3f}")


if __name__ == "__main__":
    main()
