"""Before the first ray each material is named: what it is, how well it is learnt, what to do."""

import re
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.capture_run import no_gain, without_relief
from rna_export.capture.geometry.followed_source import captured_poses
from rna_export.capture.opened_source import OpenedSource
from rna_export.capture.preflight.material_record import Detail, MaterialFacts, Visible
from rna_export.capture.preflight.sharpest import sharpest_of
from rna_export.capture.preflight.verdicts import length, preflight_lines, verdicts
from rna_render import MeshObject, read_mesh_object
from rna_render.materials.material import Inside
from rna_sdk.errors import CaptureError
from tests.conftest import REPOSITORY
from tests.exporters.in_blender import answer_of
from tests.exporters.scenes import fur, write_scene

RECIPES = REPOSITORY / "examples" / "recipes"
RECIPE = RECIPES / "materials.py"
TEXEL = 0.4e-3

VERDICTS = {
    "paint": ("not", r"metal, clear coat, mirror-like \(roughness 0.03\), relief by 'Flakes'"),
    "brushed": ("roughly", r"metal, brushed \(anisotropic\), gloss by 'Grain'"),
    "wax": ("well", "light scatters inside"),
    "velvet": ("well", "velvet"),
    "leaf": ("well", "thin, lit from behind, holes or thin panes"),
    "marble": ("well", "light scatters inside"),
    "neon": ("well", "emissive"),
    "hair": ("well", "hair"),
    "skin": ("well", "opaque"),
    "glass": ("left to the host", r"smooth glass \(index 1.5\)"),
}


def facts(**members: object) -> MaterialFacts:
    usual = {"name": "m", "full_name": "m", "kinds": ["opaque"], "roughness": 0.5, "details": []}
    return MaterialFacts(**{**usual, **members})  # type: ignore[arg-type]


@pytest.mark.blender
def test_ten_materials_in_one_scene(open_worker, tmp_path):
    opened = OpenedSource.of(open_worker(RECIPE, "all"), {}, "x", None)
    actual = {each.name: each for each in opened.materials}
    for name, (learnt, words) in VERDICTS.items():
        assert actual[name].learnt == learnt, actual[name].lines
        assert re.fullmatch(words, actual[name].is_)
    assert opened.settings.sharpest == pytest.approx(0.035)
    assert "the highlights of 'paint', of roughness 0.035" in opened.preflight[-1]
    assert no_gain(opened) is None  # one of ten that are seen
    assert re.search(
        r"learnt without its relief \(\d% of the visible surface\)$", actual["paint"].lines[0]
    )
    assert sum(each.share for each in opened.materials if each.name != "glass") == pytest.approx(1)
    numbers = opened.exported.material_numbers([each.full_name for each in opened.materials])
    names = {opened.materials[k].name for of_part in numbers.values() for k in np.unique(of_part)}
    shown = {name for name in names if not name.startswith("foot of ")}
    assert shown == VERDICTS.keys() - {"hair", "glass"}
    # What is left to the host is in the one file and not in the other.
    assert set(opened.worker.export_corners(of_hosts=True)["material"]) == {"glass"}
    assert "glass" not in opened.worker.export_corners()["material"]
    assert "'glass'" not in " ".join(opened.exported.notes)
    ball = written(opened.exported.glass, tmp_path)
    assert ball.materials[0].inside == Inside(1.5, (0.0, 0.0, 0.0))
    assert np.ptp(ball.positions, axis=0) == pytest.approx(0.1, rel=1e-3)


@pytest.mark.blender
@pytest.mark.parametrize("thing", ["leaf", "bark", "knit", "leather"])
def test_reliefs_over_uvs_are_mapped(open_worker, thing):
    opened = OpenedSource.of(open_worker(RECIPES / "relief.py", thing), {}, "x", None)
    assert opened.exported.mapped == (thing,)
    (verdict,) = (each for each in opened.materials if each.name == thing)
    assert verdict.learnt == "well" and "relief by" in verdict.is_


@pytest.mark.blender
def test_a_pane_that_mirrors_is_no_metal(open_worker):
    opened = OpenedSource.of(open_worker(RECIPES / "things.py", "blister"), {}, "x", None)
    (pane,) = (each for each in opened.materials if each.name == "clear plastic")
    assert pane.is_ == "glossy, holes or thin panes"
    assert pane.learnt == "roughly" and "mirrors the asset itself on 6" in pane.reasons[0]


@pytest.mark.parametrize(
    ("members", "learnt"),
    [
        ({"kinds": ["metal"], "roughness": 0.2}, "roughly"),
        ({"kinds": ["metal"], "roughness": 0.28}, "well"),
        ({"kinds": ["metal", "brushed"], "roughness": 0.28}, "roughly"),
        ({"kinds": ["glossy", "see-through"], "roughness": 0.4}, "roughly"),
        ({"kinds": ["coat"], "roughness": 0.05}, "well"),
    ],
)
def test_narrow_highlights_that_show_the_asset_itself_are_learnt_roughly(members, learnt):
    materials = [facts(**members)]
    for mirroring, expected in ((0.0, "well"), (0.15, learnt)):
        (verdict,) = verdicts(materials, [], TEXEL, [], [], visible={"m": Visible(0.4, mirroring)})
        assert (verdict.learnt, verdict.share) == (expected, 0.4)


def written(glb: bytes | None, folder: Path) -> MeshObject:
    """The glass that a renderer reads."""
    assert glb is not None
    path = folder / "it.glass.glb"
    path.write_bytes(glb)
    return read_mesh_object(path)


MOVING = """
def image_of(source):
    image = bpy.data.images.new(source, 4, 4)
    image.source = source
    material = principled()
    node = material.node_tree.nodes.new("ShaderNodeTexImage")
    node.image = image
    material.node_tree.links.new(
        node.outputs[0], material.node_tree.nodes["Principled BSDF"].inputs["Base Color"])
    return material
add(*square(1.0), image_of("SEQUENCE"))
add(*square(1.0, z=1.0), image_of("GENERATED"))
pulsing = principled(Emission_Strength=1.0)
strength = pulsing.node_tree.nodes["Principled BSDF"].inputs["Emission Strength"]
strength.keyframe_insert("default_value", frame=1)
add(*square(1.0, z=2.0), pulsing)
material = bpy.data.materials["hair"]
info = material.node_tree.nodes.new("ShaderNodeHairInfo")
shader = next(n for n in material.node_tree.nodes if n.type == "BSDF_HAIR_PRINCIPLED")
material.node_tree.links.new(info.outputs["Random"], shader.inputs["Melanin"])
"""


@pytest.mark.blender
def test_what_changes_with_the_frame_or_the_strand_is_said(open_worker):
    opened = open_worker(fur(20, 0.1, 1e-3, 1e-4, 0.5) + MOVING).opened
    assert opened["changing"] == [
        "material 'principled' plays the image 'SEQUENCE'",
        "material 'principled.002' is animated",
    ]
    (hair,) = (each for each in opened["materials"] if "hair" in each["kinds"])
    assert hair["kinds"] == ["hair", "varied"]
    (verdict,) = verdicts([MaterialFacts(**hair)], [], TEXEL, [], [])
    assert (verdict.learnt, verdict.is_) == ("roughly", "hair, each strand different")
    assert "strands that lie together come out in their mean" in verdict.reasons[0]


def test_poses_of_a_material_that_changes_are_refused():
    opened = {"frame": 1, "changing": ["material 'screen' plays the image 'clip.mp4'"]}
    worker: Any = SimpleNamespace(source=Source(Path("tv.blend")), opened=opened)
    assert dict(captured_poses(worker, {}, {}, [])) == {}
    with pytest.raises(CaptureError, match=r"tv.blend: material 'screen' plays the image.*no --p"):
        dict(captured_poses(worker, {}, {}, [9]))


BOTTLE = """
liquid = principled(Transmission_Weight=1.0, Roughness=0.02, IOR=1.33)
tree = liquid.node_tree
volume = tree.nodes.new("ShaderNodeVolumeAbsorption")
volume.inputs["Color"].default_value, volume.inputs["Density"].default_value = (1, 0.5, 0, 1), 4.0
tree.links.new(volume.outputs[0], tree.nodes["Material Output"].inputs["Volume"])
both = add(CUBE, SIDES, diffuse((1, 1, 1)))
both.data.materials.append(liquid)
both.data.polygons.foreach_set("material_index", [0, 0, 1, 1, 1, 1])
"""


@pytest.mark.blender
@pytest.mark.parametrize("glass", ["leave", "keep"])
def test_one_object_of_glass_and_something_else(glass, blender_python, tmp_path):
    """Rays pass its glass, on which the rest's light depends if it is kept."""
    source = Source(write_scene(tmp_path, "both", BOTTLE), glass=glass)
    with BlenderWorker(blender_python, source, tmp_path / "scratch", 1) as worker:
        opened = OpenedSource.of(worker, {}, "x", None)
        check, _ = opened.checked(opened.scene, lambda: None)
        # From inside the box, through the glass, onto the white side at x = -1.
        at = np.float32([[0.0, 0.0, 0.0]]), np.float32([[-1.0, 0.0, 0.0]])
        lit = worker.render_rays(*at, np.array([0.0, 0.8, 0.6]), 64, seed=1)
    assert len(opened.exported.geometries["asset"].triangles) == 4
    assert check.note() is None and check.used_rays == check.rays
    assert lit.alpha == pytest.approx(1.0)
    read = written(opened.exported.glass, tmp_path)
    assert len(read.triangles) == 8
    assert read.materials[0].roughness == pytest.approx(0.02)
    assert read.materials[0].inside.ior == pytest.approx(1.33)
    assert read.materials[0].inside.absorption == pytest.approx((0.0, 2.0, 4.0), abs=1e-5)


@pytest.mark.blender
def test_a_given_sharpest_is_kept(open_worker):
    opened = OpenedSource.of(open_worker(RECIPE, "paint"), {"sharpest": 0.1}, "x", None)
    assert opened.settings.sharpest == 0.1
    assert not any("views look for" in line for line in opened.preflight)
    assert no_gain(opened) is None
    said = "the gain is for the asset without the relief of 'paint' (81% of the visible surface)"
    assert without_relief(opened) == [said]


@pytest.mark.blender
@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("volume", "material 'volume' is a volume without a surface.*hide its objects"),
        ("glass", "all of it is smooth glass .'principled'., which is left to the host"),
    ],
)
def test_what_holds_nothing_to_learn_is_refused(name, said, open_worker):
    ball = "add(*BALL, principled(Transmission_Weight=1.0, Roughness=0.0))"
    source = RECIPE if name == "volume" else ball
    with pytest.raises(CaptureError, match=said):
        open_worker(source, *([name] if name == "volume" else []))


@pytest.mark.parametrize(
    ("of", "size", "mapped", "learnt"),
    [
        ("relief", 0.39e-3, False, "not"),
        ("relief", 0.79e-3, False, "roughly"),
        ("relief", 0.81e-3, False, "well"),
        ("relief", 0.1e-3, True, "well"),
        ("relief", None, False, "well"),
        ("gloss", 0.1e-3, False, "roughly"),
        ("emission", 0.1e-3, False, "roughly"),
        ("colour", 0.1e-3, True, "well"),
        ("colour", 0.1e-3, False, "roughly"),
    ],
)
def test_details_are_compared_with_planes(of, size, mapped, learnt):
    material = facts(details=[Detail(of=of, node="Grain", size=size)])  # type: ignore[arg-type]
    (actual,) = verdicts([material], [], TEXEL, *2 * [["m"] if mapped else []])
    assert actual.learnt == learnt
    assert bool(actual.reasons) == (learnt != "well")
    assert all("'Grain'" in reason for reason in actual.reasons)


@pytest.mark.parametrize(
    ("kinds", "learnt"),
    [(["glass"], "not"), (["refracting"], "roughly"), (["volume"], "roughly"), (["hair"], "well")],
)
def test_kinds(kinds, learnt):
    (actual,) = verdicts([facts(kinds=kinds)], [], TEXEL, [], [])
    assert actual.learnt == learnt


def test_lines_begin_with_the_worst_and_end_with_what_is_learnt_well():
    materials = [facts(name=f"stone {k}") for k in range(5)]
    fine = Detail(of="relief", node="Grain", size=1e-4)
    lines = preflight_lines(verdicts([*materials, facts(details=[fine])], [], TEXEL, [], []))
    assert lines[1] == "  'm': opaque, relief by 'Grain': learnt without its relief"
    assert "(0.1 mm from one detail to the next; the planes hold 0.8 mm)" in lines[2]
    assert lines[-1] == "  learnt well: 'stone 0', 'stone 1', 'stone 2' and 2 more (opaque)"
    assert preflight_lines([]) == []


@pytest.mark.parametrize(
    ("roughness", "sharpest", "named"),
    [(0.05, 0.05, "m"), (0.0, 0.035, "m"), (0.3, 0.14, None), (None, 0.14, None)],
)
def test_highlights_are_looked_for_as_narrow_as_the_smoothest_material(roughness, sharpest, named):
    assert sharpest_of([facts(roughness=roughness)]) == (sharpest, named)


def test_what_keeps_a_detail_from_being_a_texture_is_named():
    fine = [Detail(of=of, node="Veins", size=1e-4) for of in ("relief", "colour")]
    why = {"relief": {"m": "the limit"}, "colour": {"m": "the node 'Object Info'"}}
    (actual,) = verdicts([facts(details=fine)], [], TEXEL, ["m"], ["m"], why)
    relief, colour = actual.reasons
    assert "the limit keeps it from being a normal map: bake it" in relief
    assert "the node 'Object Info' keeps it from being an image: bake it" in colour


@pytest.mark.blender
def test_maps_that_are_switched_off_are_named_as_the_obstacle(open_worker):
    worker = open_worker(RECIPES / "relief.py", "knit")
    opened = OpenedSource.of(worker, {"normal_texels": 0}, "x", None)
    (knit,) = opened.materials
    limit = "the limit of 0 texels (--normal-texels) keeps it from being a normal map: raise it, "
    assert (knit.learnt, knit.loses) == ("not", "relief") and limit in knit.reasons[0]


@pytest.mark.parametrize(("share", "promised"), [(0.02, True), (0.3, False)])
def test_a_small_part_of_what_is_seen_withholds_no_gain(share, promised):
    glass = facts(kinds=["glass"])
    (verdict,) = materials = verdicts([glass], [], TEXEL, [], [], None, {"m": Visible(share)})
    said = no_gain(SimpleNamespace(materials=materials))  # type: ignore[arg-type]
    assert (said is None) == promised
    assert promised or said == (
        "gain: none is promised, since 'm' (30% of the visible surface) will not be learnt"
    )
    assert f"not learnt ({share:.0%} of the visible surface)" in verdict.lines[0]


@pytest.mark.parametrize("share", [0.02, 0.3])
def test_a_gain_of_an_asset_that_loses_relief_says_so(share):
    fine = Detail(of="relief", node="Grain", size=1e-4)
    (verdict,) = materials = verdicts(
        [facts(details=[fine])], [], TEXEL, [], [], None, {"m": Visible(share)}
    )
    opened: Any = SimpleNamespace(materials=materials)
    assert no_gain(opened) is None and verdict.learnt == "not"
    assert f"learnt without its relief ({share:.0%} of the visible surface)" in verdict.lines[0]
    said = "the gain is for the asset without the relief of 'm' (30% of the visible surface)"
    assert without_relief(opened) == ([said] if share == 0.3 else [])


def test_glass_whose_relief_is_lost_too_is_not_learnt():
    fine = Detail(of="relief", node="Grain", size=1e-4)
    (verdict,) = verdicts([facts(kinds=["glass"], details=[fine])], [], TEXEL, [], [])
    assert (verdict.loses, verdict.promise) == (None, "not learnt")


DETAILS = """
import numpy as np
from rna_preflight.image_detail import finest, period
y, x = np.mgrid[:512, :512] / 512.0
waves, noise = 0.5 + 0.4 * np.sin(2.0 * np.pi * 16 * x), np.random.default_rng(0).random(x.shape)
veins = np.exp(-((x - 0.5) / 0.02) ** 2)
image = bpy.data.images.new("print", 512, 256)
image.pixels.foreach_set(np.dstack([waves[:256]] * 4).astype(np.float32).ravel())
answer({
    "waves": finest(waves, False),
    "their slopes": finest(waves, True),
    "waves with grain": finest(waves + 0.04 * noise, False),
    "stripes": finest(np.floor(16 * x) % 2, False),
    "noise": finest(noise, False),
    "veins": finest(veins, True),
    "nothing": finest(0.0 * x, True) == np.inf,
    "an image": period(image, False),
})
"""


@pytest.mark.blender
def test_details_are_as_fine_as_most_of_an_image(blender_python):
    """And not as its texels: a smooth one of many texels has large details."""
    found = answer_of(blender_python, DETAILS)
    for name in ("waves", "their slopes", "waves with grain", "an image"):
        assert 0.8 / 16 < found[name] < 1.2 / 16, name
    assert 0.3 / 8 < found["stripes"] < 1.1 / 8
    assert 1.4 / 512 < found["noise"] < 2.2 / 512
    assert 0.02 < found["veins"] < 0.12
    assert found["nothing"]


def test_lengths():
    assert [length(x) for x in (4e-4, 0.012, 1.25)] == ["0.4 mm", "12 mm", "1.2 m"]
