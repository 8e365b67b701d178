"""Limits of the element's camera, in model-viewer's syntax."""

import json
from typing import Any

import pytest

from tests.web.in_node import ELEMENT_SOURCES, in_node


def views(settings: dict[str, str], *acts: str) -> list[dict[str, Any]]:
    """The camera in words, framed at first and after each act on `orbit`."""
    program = f"""
        import {{ cameraText, propertyOf, READERS }}
            from "{(ELEMENT_SOURCES / "attributes.js").as_uri()}";
        import {{ limitsOf, Orbit }} from "{(ELEMENT_SOURCES / "orbit.js").as_uri()}";
        const given = Object.entries({json.dumps(settings)}), own = {{}};
        for (const [name, text] of given) own[propertyOf(name)] = READERS[name](text);
        const orbit = new Orbit(), found = [];
        orbit.limits = limitsOf(own);
        const view = {{ target: own.cameraTarget, fov: own.fieldOfView }};
        orbit.place([own.cameraOrbit ?? {{}}, view], {{ min: [-1, 0, -1], max: [1, 1, 1] }}, 1.6);
        const tell = () => found.push({{ ...cameraText(orbit), framed: orbit.framed }});
        tell();
        for (const act of {json.dumps(acts)}) (new Function("orbit", act)(orbit), tell());
        console.log(JSON.stringify(found));
    """
    return in_node(program)


def numbers(view: dict[str, Any]) -> list[float]:
    """Numbers of cameraOrbit: degrees, degrees, metres."""
    return [float(word.rstrip("degm")) for word in view["cameraOrbit"].split()]


def test_people_stay_within_limits():
    limits = {"min-camera-orbit": "-20deg 45deg 3m", "max-camera-orbit": "90deg 80deg 150%"}
    first, *turned = views(
        limits,
        "orbit.turn(9, 0)",
        "orbit.turn(-9, 0)",
        "orbit.turn(0, 9)",
        "orbit.turn(0, -9)",
        "orbit.zoom(1e-3)",
        "orbit.zoom(1e3)",
    )
    assert [numbers(view)[0] for view in turned[:2]] == pytest.approx([90, -20])
    assert [numbers(view)[1] for view in turned[2:4]] == pytest.approx([45, 80])
    assert numbers(turned[4])[2] == 3
    assert numbers(turned[5])[2] == pytest.approx(1.5 * first["framed"], rel=1e-5)


def test_without_limits_people_go_anywhere():
    (_, turned) = views({}, "orbit.turn(9, 9), orbit.zoom(0.01)")
    azimuth, polar, distance = numbers(turned)
    assert azimuth == pytest.approx((0.6 + 9) * 57.29578 - 360 * 2, abs=1e-2)
    assert polar == pytest.approx(1) and distance < 0.1


def test_attributes_stay_within_limits():
    limits = {"max-camera-orbit": "auto 90deg 4m", "max-field-of-view": "40deg"}
    low = {"camera-orbit": "0deg 120deg 9m", "field-of-view": "60deg"}
    (view,) = views(limits | low)
    assert view["cameraOrbit"] == "0deg 90deg 4m" and view["fieldOfView"] == "40deg"
    (view,) = views({"min-field-of-view": "45deg"})
    assert view["fieldOfView"] == "45deg"
