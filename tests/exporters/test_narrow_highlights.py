"""Highlights that are narrower than what views look for are named before a capture."""

from __future__ import annotations

import re

import pytest

from rna_export.capture.geometry.source_notes import narrow_highlights
from tests.exporters.conftest import OpenWorker

MATERIAL = """
material = principled()
tree = material.node_tree
new, join = tree.nodes.new, tree.links.new
shader, output = tree.nodes["Principled BSDF"], tree.nodes["Material Output"]
inputs = shader.inputs
inputs["Roughness"].default_value = 0.3
item = add(*square(1), material)
"""
GLOSSY = """
glossy = new("ShaderNodeBsdfGlossy")
glossy.inputs["Roughness"].default_value = 0.04
"""


@pytest.mark.blender
@pytest.mark.parametrize(
    ("body", "roughness"),
    [
        ("", 0.3),
        ("inputs['Coat Roughness'].default_value = 0.05", 0.3),  # the coat has no weight
        (
            "inputs['Coat Weight'].default_value, inputs['Coat Roughness'].default_value = 1, 0.05",
            0.05,
        ),
        (GLOSSY, 0.3),  # not connected
        (GLOSSY + "join(glossy.outputs[0], output.inputs['Surface'])", 0.04),
        ("join(new('ShaderNodeValue').outputs[0], inputs['Roughness'])", None),
        ("inputs['Specular IOR Level'].default_value = 0", None),
        ("item.hide_render = True", None),
    ],
)
def test_the_smoothest_material(
    body: str, roughness: float | None, open_worker: OpenWorker
) -> None:
    actual = open_worker(MATERIAL + body).opened["smoothest"]
    if roughness is None:
        assert actual is None
    else:
        assert actual[1] == pytest.approx(roughness)


@pytest.mark.parametrize(
    ("smoothest", "sharpest", "named"),
    [
        (("varnish", 0.05), 0.14, "'varnish' .* roughness 0.05, .* --sharpest 0.14 .* 0.05 looks"),
        (("mirror", 0.0), 0.14, "'mirror' .* roughness 0, .* --sharpest 0.02 looks"),
        (("varnish", 0.1), 0.14, None),
        (("varnish", 0.05), 0.05, None),
        (("mirror", 0.0), 0.02, None),
        (None, 0.14, None),
    ],
)
def test_a_note(smoothest: tuple[str, float] | None, sharpest: float, named: str | None) -> None:
    notes = narrow_highlights(smoothest, sharpest)
    assert len(notes) == (named is not None)
    if named is not None:
        assert re.search(named, notes[0])
