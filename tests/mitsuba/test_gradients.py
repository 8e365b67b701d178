"""Derivatives of pictures by the light and by where the asset is, against finite differences."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from tests.conftest import REPOSITORY

TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"
SEED = 7


@pytest.fixture(scope="module")
def scene(llvm):
    import mitsuba as mi

    import rna_mitsuba

    film = {"type": "hdrfilm", "width": 48, "height": 32, "pixel_format": "rgb"}
    place = mi.ScalarTransform4f().look_at([1.42, 0.8, 0.78], [0.38, 0.17, -0.16], [0, 1, 0])
    return mi.load_dict(
        {
            "type": "scene",
            "integrator": {"type": "rna_path", "max_depth": 2},
            "toy": rna_mitsuba.asset(TOY),
            "sun": {
                "type": "directional",
                "direction": [-0.55, -0.75, -0.65],
                "irradiance": {"type": "rgb", "value": [2.5, 2.35, 2.1]},
            },
            "sensor": {
                "type": "perspective",
                "fov": 16,
                "to_world": place,
                "film": film | {"rfilter": {"type": "box"}},
            },
        }
    )


def derivative(scene: Any, key: str, value: Callable[[Any], Any]) -> np.ndarray:
    """Derivative of the image by x at 0, where the parameter is value(x); forward mode."""
    import drjit as dr
    import mitsuba as mi

    parameters = mi.traverse(scene)
    x = mi.Float(0)
    dr.enable_grad(x)
    parameters[key] = value(x)
    parameters.update()
    image = mi.render(scene, parameters, spp=1, seed=SEED + 1, seed_grad=SEED)
    dr.forward(x)
    result = np.array(dr.grad(image))
    parameters[key] = value(mi.Float(0))
    parameters.update()
    return result


def difference(scene: Any, key: str, value: Callable[[Any], Any], step: float) -> np.ndarray:
    """The gradient by a central difference, with the same random numbers.

    Opaque: a kernel with numbers in it would be compiled for each.
    """
    import drjit as dr
    import mitsuba as mi

    parameters, images = mi.traverse(scene), []
    for x in (step, -step):
        parameters[key] = value(dr.opaque(mi.Float, x))
        parameters.update()
        images.append(np.array(mi.render(scene, spp=1, seed=SEED)).astype(np.float64))
    parameters[key] = value(mi.Float(0))
    parameters.update()
    return (images[0] - images[1]) / (2 * step)


def test_by_the_light(scene):
    import mitsuba as mi

    def brighter(x: Any) -> Any:
        return mi.Color3f(2.5, 2.35, 2.1) * (1 + x)

    actual = derivative(scene, "sun.irradiance.value", brighter)
    expected = difference(scene, "sun.irradiance.value", brighter, 0.1)
    assert expected.max() > 0.1
    np.testing.assert_allclose(actual, expected, rtol=1e-3, atol=1e-5)


@pytest.mark.parametrize(("motion", "step"), [("turn", 0.02), ("move", 1e-4)])
def test_by_the_pose(scene, motion, step, monkeypatch):
    """Where no edge and no shadow crosses a sample: visibility and nearby light are held fixed."""
    import mitsuba as mi

    monkeypatch.setattr("rna_mitsuba.world.nearby_estimate", lambda *_: mi.Vector3f(0.5))

    def posed(x: Any) -> Any:
        if motion == "turn":
            return mi.Transform4f().rotate(mi.Vector3f(0, 1, 0), x)
        return mi.Transform4f().translate(mi.Vector3f(x, 0, 0))

    actual = derivative(scene, "toy.to_world", posed)
    wide, narrow = (difference(scene, "toy.to_world", posed, s) for s in (step, step / 2))
    scale = np.abs(narrow).mean()
    smooth = np.abs(wide - narrow) < 0.02 * (np.abs(narrow) + scale)
    assert np.mean(smooth & (narrow != 0)) > 0.3
    off = np.abs(actual - narrow)[smooth]
    # Elsewhere the step crosses a texel's edge, where features have a kink.
    assert np.mean(off < 0.05 * (np.abs(narrow[smooth]) + scale)) > 0.9
