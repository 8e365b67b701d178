"""A kind that one table knows, all others know: lights, materials, input blocks, precisions."""

import re
from pkgutil import iter_modules
from typing import Any, get_args

from rna_gpu.records.part import PRECISIONS
from rna_render.lights import kinds, kinds_of_lights
from rna_render.materials.material import make_material
from rna_render.scene.light_models import LightModel
from rna_render.scene.material_models import MaterialModel
from rna_sdk.package.blocks import INPUT_BLOCKS
from rna_sdk.package.manifest.manifest_fields import DecoderPrecision, PlanePrecision
from tests.conformance.kit.plans import PLANS
from tests.conftest import REPOSITORY

SHADER = (REPOSITORY / "runtime" / "rna_gpu" / "wgsl" / "render" / "lights.wgsl").read_text()
TIERS = [tier for plan in PLANS for part in plan.parts for tier in part.tiers]
NO_TYPE = {"asset", "mesh"}
"""Kinds that objects of a scene have, and not its `lights`."""


def types(union: Any) -> dict[str, Any]:
    """Values of `type` of the models of a union, and the models."""
    models = get_args(get_args(union)[0])
    return {get_args(model.model_fields["type"].annotation)[0]: model for model in models}


def branches(function: str) -> set[str]:
    """Kinds that a function of the shader has a branch for."""
    body = re.search(rf"^fn {function}\(.*?^}}", SHADER, re.MULTILINE | re.DOTALL)
    assert body is not None, function
    return set(re.findall(r"\bkind == ([A-Z]+)\b", body[0]))


def test_each_light_of_a_scene_has_a_file_that_makes_it():
    assert {module.name for module in iter_modules(kinds.__path__)} - NO_TYPE == set(
        types(LightModel)
    )


def test_each_kind_of_light_has_a_branch_in_the_shader():
    """An unknown kind would be taken for a sphere, and be black."""
    shapes = branches("shape_pdf") & branches("shape_point")
    assert branches("sample_light") | shapes | {"SPHERE"} == {k.upper() for k in kinds_of_lights()}


def test_each_material_is_made():
    """A kind that `make_material` does not know is an error of mypy, too."""
    made = [make_material(model(type=name)) for name, model in types(MaterialModel).items()]
    assert len(made) == 4


def test_each_input_block_is_in_the_conformance_kit():
    """All readers are compared with the kit, so none can lack a block."""
    assert {name for tier in TIERS for name in tier.inputs} == set(INPUT_BLOCKS)


def test_each_precision_is_known_to_every_reader():
    assert set(get_args(PlanePrecision)) == set(PRECISIONS) == {tier.planes for tier in TIERS}
    used = {"int8" if tier.int8 else "float32" for tier in TIERS}
    assert used == set(get_args(DecoderPrecision))
