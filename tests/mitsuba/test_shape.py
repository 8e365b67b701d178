"""The plug-ins as users write them: in XML, in dictionaries, with mistakes; and the docs' code."""

import re
from typing import Any

import numpy as np
import pytest

from rna_sdk.errors import RnaError
from rna_sdk.package import Package
from rna_sdk.runtime.base_color import BaseColorMaps
from tests.conftest import REPOSITORY
from tests.package.builders import make_tiny_package
from tests.package.carriers import make_carrier
from tests.package.prints import make_variants

TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"


def load(**properties: Any) -> Any:
    import mitsuba as mi

    import rna_mitsuba  # noqa: F401

    return mi.load_dict({"type": "rna", **properties})


def test_it_can_be_written_in_xml(tmp_path):
    import mitsuba as mi

    from rna_mitsuba import RnaShape

    make_tiny_package(tmp_path / "tiny.rna")
    scene = mi.load_string(
        '<scene version="3.0.0"><integrator type="rna_path"/><shape type="rna" id="tiny">'
        f'<string name="filename" value="{tmp_path / "tiny.rna"}"/>'
        '<transform name="to_world"><scale value="2"/><translate x="3"/></transform>'
        "</shape></scene>"
    )
    (shape,) = scene.shapes()
    assert isinstance(shape, RnaShape) and "tiny.to_world" in mi.traverse(scene)
    low, high = shape.loaded.bounds * 2 + [3, 0, 0]
    np.testing.assert_allclose(scene.bbox().min, low, rtol=1e-5)
    np.testing.assert_allclose(scene.bbox().max, high, rtol=1e-5)


def test_a_carrier_has_the_same_pixels(tmp_path):
    import mitsuba as mi

    import rna_mitsuba  # noqa: F401

    package = make_tiny_package(tmp_path / "tiny.rna")
    carrier = make_carrier(package, tmp_path / "tiny.glb")
    pictures = []
    for path in (package, carrier):
        film = {"type": "hdrfilm", "width": 16, "height": 12, "rfilter": {"type": "box"}}
        camera = mi.ScalarTransform4f().look_at([2, 2, 3], [0, 0, 0], [0, 1, 0])
        scene = {
            "type": "scene",
            "integrator": {"type": "rna_path"},
            "sensor": {"type": "perspective", "to_world": camera, "film": film},
            "light": {"type": "constant"},
            "asset": {"type": "rna", "filename": str(path)},
        }
        pictures.append(np.array(mi.render(mi.load_dict(scene), spp=2, seed=1)))
    assert pictures[0].tobytes() == pictures[1].tobytes()
    assert len(np.unique(pictures[0][..., 0])) > 2


def test_instances_share_a_package():
    assert load(filename=str(TOY)).loaded is load(filename=str(TOY)).loaded


def test_a_variant_has_its_own_base_colour(tmp_path):
    import mitsuba as mi

    path = make_variants(tmp_path / "print.rna")
    with Package.open(path) as package:
        mesh, prints = package.mesh(), {v: package.base_color(0, v) for v in (None, "deep red")}
    rng = np.random.default_rng(0)
    triangle = rng.integers(0, len(mesh.triangles), 64).astype(np.uint32)
    u, v = (rng.random((2, 64)) / 2).astype(np.float32)
    for variant, records in prints.items():
        chosen = {} if variant is None else {"variant": variant}
        geometry = load(filename=str(path), **chosen).loaded.scene.geometries[0]
        at = mi.UInt32(triangle), mi.Float(u), mi.Float(v), mi.Float(0.0)
        expected = BaseColorMaps(mesh, records).at(triangle, u, v)
        np.testing.assert_allclose(np.array(geometry.base_color(*at)).T, expected, atol=1e-4)


@pytest.mark.parametrize(
    ("change", "actual"),
    [
        ({"variant": "Midnight"}, "found the variant 'Midnight'"),
        ({"filename": "nowhere.rna"}, "nowhere.rna: error FILE_UNREADABLE"),
        ({"tier": "huge"}, "no tier 'huge'"),
        ({"to_world": np.diag([1.0, 2.0, 1.0, 1.0])}, "transform: .*non-uniform scale"),
        ({"to_world": np.diag([0.0, 0.0, 0.0, 1.0])}, "transform: .*singular"),
    ],
)
def test_mistakes_are_told(change, actual):
    import rna_mitsuba

    arguments = {"filename": str(TOY)} | change
    path = arguments.pop("filename")
    with pytest.raises(RnaError, match=f"^{actual}"):
        rna_mitsuba.asset(path, **arguments)


def test_mistakes_in_scene_files_are_told():
    with pytest.raises(RuntimeError, match="no tier 'huge'"):
        load(filename=str(TOY), tier="huge")


def test_emitters_cannot_be_hidden():
    import mitsuba as mi

    import rna_mitsuba  # noqa: F401

    with pytest.raises(Exception, match="hide_emitters: found true, expected false"):
        mi.load_dict({"type": "rna_path", "hide_emitters": True})


def test_the_code_of_the_docs_runs(monkeypatch):
    monkeypatch.chdir(TOY.parent)
    page = (REPOSITORY / "docs" / "mitsuba.md").read_text()
    (code,) = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    names: dict[str, Any] = {}
    exec(code, names)
    image = np.array(names["image"])
    assert image.shape[:2] == (48, 64) and np.isfinite(image).all()
    assert image[..., :3].max() > 0.3
