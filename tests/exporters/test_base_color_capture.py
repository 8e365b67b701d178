"""Base colours of materials: images as they are, on the samples as Cycles shows them."""

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from rna_export.capture.blender_process.capture_worker import scene_of
from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.capture_tasks import TrainingShard
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.geometry.blurred_textures import blurred_note
from rna_export.capture.geometry.exported_parts import ExportedParts, exported_parts
from tests.exporters.conftest import OpenWorker
from tests.exporters.synthetic import manifest_of

pytestmark = pytest.mark.blender

SIZE = 960, 384  # of the print, pixels
SHADERS = "ShaderNodeBsdfDiffuse", "ShaderNodeEmission"

PRINTED = """
# Squares, each with an image as its base colour, changed in its own way; `shown` gives the colour.
shader_of, changes_of = {shader!r}, {changes!r}
for k, changes in enumerate(changes_of):
    image = bpy.data.images.load({path!r}, check_existing=False)
    material = bpy.data.materials.new("label")
    material.use_nodes = True
    tree = material.node_tree
    of = tree.nodes.new("ShaderNodeTexImage")
    of.image, shown = image, of.outputs["Color"]
    mapping, uv = tree.nodes.new("ShaderNodeMapping"), tree.nodes.new("ShaderNodeUVMap")
    tree.links.new(uv.outputs[0], mapping.inputs["Vector"])
    tree.links.new(mapping.outputs[0], of.inputs["Vector"])
    exec(changes)
    shader = tree.nodes.new(shader_of)
    tree.links.new(shown, shader.inputs["Color"])
    tree.links.new(shader.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
    mesh = bpy.data.meshes.new("label")
    mesh.from_pydata([(x, y + 1.5 * k, 0) for x, y in ((0, 0), (2, 0), (2, 1), (0, 1))], [],
                     [(0, 1, 2), (0, 2, 3)])
    layer = mesh.uv_layers.new(name="UVMap")
    corners = [(0.2, 0.1), (0.9, 0.1), (0.9, 0.8), (0.2, 0.8)]
    layer.uv.foreach_set("vector", [x for c in (0, 1, 2, 0, 2, 3) for x in corners[c]])
    colours = mesh.color_attributes.new("Faded", "FLOAT_COLOR", "POINT")
    colours.data.foreach_set("color", [x for c in (1.0, 0.5, 0.5, 1.0) for x in (c, c, c, 1.0)])
    mesh.materials.append(material)
    bpy.context.scene.collection.objects.link(bpy.data.objects.new("label", mesh))
red = diffuse((0.8, 0.1, 0.2))
add([(0, 0, 0.5), (1, 0, 0.5), (0, 1, 0.5)], [(0, 1, 2)], red)
"""

PLAIN = ""
FLIPPED = 'mapping.inputs["Scale"].default_value = (1.0, -1.0, 1.0)'
TURNED = """
mapping.inputs["Rotation"].default_value = (0.0, 0.0, 0.4)
mapping.inputs["Scale"].default_value = (1.5, 0.7, 1.0)
mapping.inputs["Location"].default_value = (0.3, -0.2, 0.0)
"""
EXTENDED = f"{TURNED}\nof.extension = 'EXTEND'"
MIRRORED = f"{TURNED}\nof.extension = 'MIRROR'"
CLIPPED = f"{TURNED}\nof.extension = 'CLIP'"
TINTED = """
mix = tree.nodes.new("ShaderNodeMix")
mix.data_type, mix.blend_type = "RGBA", "MULTIPLY"
mix.inputs["Factor"].default_value = 0.75
mix.inputs["B"].default_value = (0.9, 0.3, 0.2, 1.0)
tree.links.new(shown, mix.inputs["A"])
shown = mix.outputs["Result"]
"""
LINEAR = 'image.colorspace_settings.name = "Non-Color"'
FLOAT = """
image = bpy.data.images.new("float", 960, 384, float_buffer=True)
image.pixels.foreach_set([x for k in range(960 * 384) for x in (k % 960 / 960, k // 8 % 2, 0.3, 1)])
image.pack()
of.image = image
"""
ALPHA = 'image.alpha_mode = "STRAIGHT"'
OF_VERTICES = """
faded, mix = tree.nodes.new("ShaderNodeVertexColor"), tree.nodes.new("ShaderNodeMix")
mix.data_type, mix.blend_type, faded.layer_name = "RGBA", "MULTIPLY", "Faded"
mix.inputs["Factor"].default_value = 1.0
tree.links.new(faded.outputs["Color"], mix.inputs["A"])
tree.links.new(shown, mix.inputs["B"])
shown = mix.outputs["Result"]
"""
UNALIKE = 'image.colorspace_settings.name = "ACEScg"'
IN_A_GROUP = """
group = bpy.data.node_groups.new("print", "ShaderNodeTree")
group.interface.new_socket("place", in_out="INPUT", socket_type="NodeSocketVector")
group.interface.new_socket("colour", in_out="OUTPUT", socket_type="NodeSocketColor")
of, begin = group.nodes.new("ShaderNodeTexImage"), group.nodes.new("NodeGroupInput")
of.image, end = image, group.nodes.new("NodeGroupOutput")
group.links.new(begin.outputs[0], of.inputs["Vector"])
group.links.new(of.outputs["Color"], end.inputs[0])
node = tree.nodes.new("ShaderNodeGroup")
node.node_tree = group
tree.links.new(mapping.outputs[0], node.inputs[0])
shown = node.outputs[0]
"""


def print_of(folder: Path, ending: str = "png", alpha: bool = False) -> Path:
    """A picture with edges and a ramp, which is the same neither upside down nor mirrored."""
    width, height = SIZE
    x, y = np.meshgrid(np.arange(width), np.arange(height))
    bars = 255 * (x // 8 % 2) * (y < height // 2)
    pixels = np.stack([bars, y * 255 // height, x * 255 // width], axis=-1).astype(np.uint8)
    if alpha:
        pixels = np.dstack([pixels, (255 * (x // 160 % 2)).astype(np.uint8)])
    path = folder / f"print.{ending}"
    Image.fromarray(pixels).save(path, **({"quality": 95} if ending == "jpg" else {}))
    return path


def sampled(
    open_worker: OpenWorker, folder: Path, diffuse: str, glowing: str
) -> tuple[ExportedParts, dict[str, np.ndarray], np.ndarray, np.ndarray]:
    """Exported parts of a scene, samples, Cycles' colours there, and which are on red.

    diffuse, glowing: scripts of the scene, which scatters or emits light of its colours.
    """
    worker = open_worker(diffuse)
    settings = CaptureSettings(lights=8, lights_per_shard=8, rays=4096, samples=1)
    exported = exported_parts(worker, settings)
    manifest = manifest_of(settings, parts=exported.captured())
    dataset = Dataset.create(folder / "rays", manifest, exported.geometries, exported.textures)
    TrainingShard(0).run(dataset, scene_of(dataset), worker)
    at = dataset.only.training_samples()
    origins = at["position"] + np.float32(0.01) * at["wo"]
    shown = open_worker(glowing).render_rays(origins, -at["wo"], None, 1, 0).radiance
    on_red = at["position"][:, 1] > 0.1
    assert np.allclose(at["base_color"][on_red], [0.8, 0.1, 0.2], atol=1e-3)
    return exported, at, np.clip(shown, 0.0, 1.0), on_red


def captured(
    open_worker: OpenWorker, folder: Path, path: Path, changes: list[str]
) -> tuple[ExportedParts, list[tuple[str, np.ndarray, np.ndarray]]]:
    """Exported parts; for each square the image's name, base colours, and Cycles' colours."""
    source = {"path": str(path), "changes": changes}
    scripts = [PRINTED.format(**source, shader=shader) for shader in SHADERS]
    exported, at, shown, on_red = sampled(open_worker, folder, *scripts)
    mesh, labels = exported.geometries["asset"], []
    for k in range(len(changes)):
        on = ~on_red & (np.abs(at["position"][:, 2] + 1.5 * k + 0.5) < 0.51)
        assert on.sum() > 100
        first = mesh.positions[mesh.triangles[:, 0]]
        (triangle, *_) = np.flatnonzero((first[:, 1] < 0.1) & (np.abs(first[:, 2] + 1.5 * k) < 0.1))
        (name,) = (
            r.image
            for r in exported.colors["asset"]
            if 0 <= triangle - r.triangles[0] < r.triangles[1]
        )
        labels.append((name, at["base_color"][on], shown[on]))
    return exported, labels


AS_FILES = {
    "plain": PLAIN,
    "flipped": FLIPPED,
    "turned": TURNED,
    "extend": EXTENDED,
    "mirror": MIRRORED,
    "tint": TINTED,
    "linear": LINEAR,
    "group": IN_A_GROUP,
}
AS_TEXELS = {"clip": CLIPPED, "float": FLOAT, "space": UNALIKE}


def test_samples_have_the_base_colour_that_cycles_shows(open_worker, tmp_path):
    path = print_of(tmp_path)
    changes = AS_FILES | AS_TEXELS
    exported, labels = captured(open_worker, tmp_path, path, list(changes.values()))
    assert exported.notes == []
    for key, (name, base, shown) in zip(changes, labels, strict=True):
        assert (exported.textures[name] == path.read_bytes()) == (key in AS_FILES), key
        # Cycles interpolates images of floats in linear colours, a package all in sRGB.
        assert np.abs(base - shown).mean() < (0.005 if key in AS_FILES else 0.01), key
        assert np.ptp(base[:, 1]) > 0.3, key


@pytest.mark.parametrize("ending", ["jpg", "webp"])
def test_a_file_stays_as_it_is(open_worker, tmp_path, ending):
    path = print_of(tmp_path, ending)
    exported, ((name, base, shown),) = captured(open_worker, tmp_path, path, [PLAIN])
    assert name.endswith(f".{ending}") and exported.textures[name] == path.read_bytes()
    assert np.abs(base - shown).mean() < 0.005


def test_a_file_whose_colours_alpha_changes_is_taken_as_cycles_shows_it(open_worker, tmp_path):
    path = print_of(tmp_path, alpha=True)
    exported, ((name, base, shown),) = captured(open_worker, tmp_path, path, [ALPHA])
    assert exported.textures[name] != path.read_bytes()
    assert np.abs(base - shown).mean() < 0.005


def test_an_image_times_colours_of_vertices_is_taken_over(open_worker, tmp_path):
    """They are learnt, with the light that the image is a factor of."""
    path = print_of(tmp_path)
    exported, ((name, base, shown),) = captured(open_worker, tmp_path, path, [OF_VERTICES])
    assert exported.notes == [] and exported.textures[name] == path.read_bytes()
    assert (shown < base + 0.01).all() and 0.6 < shown.sum() / base.sum() < 0.9


TWO_IMAGES = """
other = tree.nodes.new("ShaderNodeTexImage")
other.image = bpy.data.images.load(image.filepath)
other.image.colorspace_settings.name = "Non-Color"
tree.links.new(uv.outputs[0], other.inputs["Vector"])
mix = tree.nodes.new("ShaderNodeMix")
mix.data_type, mix.inputs["Factor"].default_value = "RGBA", 0.3
tree.links.new(shown, mix.inputs["A"])
tree.links.new(other.outputs["Color"], mix.inputs["B"])
shown = mix.outputs["Result"]
"""
NOISE = """
noise = tree.nodes.new("ShaderNodeTexNoise")
noise.inputs["Scale"].default_value = 150.0
tree.links.new(uv.outputs[0], noise.inputs["Vector"])
shown = noise.outputs["Color"]
"""
OF_THE_PLACE = """
noise, place = tree.nodes.new("ShaderNodeTexNoise"), tree.nodes.new("ShaderNodeTexCoord")
tree.links.new(place.outputs["Object"], noise.inputs["Vector"])
shown = noise.outputs["Color"]
"""


def test_what_nodes_make_of_uv_coordinates_is_baked(open_worker, tmp_path):
    path = print_of(tmp_path)
    exported, labels = captured(open_worker, tmp_path, path, [TWO_IMAGES, NOISE])
    assert exported.notes == []
    for _, base, shown in labels:
        assert np.abs(base - shown).mean() < 0.01


def test_images_that_are_baked_with_fewer_texels_are_told(open_worker, tmp_path):
    """Like UDIM tiles that together are larger than a baked image."""
    source = {"path": str(print_of(tmp_path)), "changes": [TWO_IMAGES]}
    worker = open_worker(PRINTED.format(**source, shader="ShaderNodeBsdfDiffuse"))
    (note,) = exported_parts(worker, CaptureSettings(texture_size=512)).notes
    assert note == (
        "material 'label' has a base colour of 674 x 272 texels, baked with 512 x 512; "
        "--texture-size takes more, up to 8192"
    )


def test_what_is_no_function_of_uv_coordinates_is_told(open_worker, tmp_path):
    source = {"path": str(print_of(tmp_path)), "changes": [OF_THE_PLACE]}
    worker = open_worker(PRINTED.format(**source, shader="ShaderNodeBsdfDiffuse"))
    exported = exported_parts(worker, CaptureSettings())
    assert exported.colors == {}
    (note,) = exported.notes
    assert "material 'label' has a base colour by the node 'Texture Coordinate'" in note


@pytest.mark.parametrize("other", [(0.1, 0.3, 0.8), (0.83, 0.12, 0.2), (0.8, 0.1, 0.2)])
def test_plain_colours_are_factors_where_they_differ(open_worker, other):
    """Planes would mix red and blue; they show two nearly equal reds as well as records do."""
    triangles = "".join(
        f"add([({k}, 0, 0), ({k} + 0.9, 0, 0), ({k}, 0.9, 0)], [(0, 1, 2)], diffuse({color}))\n"
        for k, color in enumerate([(0.8, 0.1, 0.2), other])
    )
    records = exported_parts(open_worker(triangles), CaptureSettings()).colors.get("asset", [])
    if other[2] < 0.5:
        assert records == []
        return
    factors = {tuple(record.factor): (record.triangles, record.image) for record in records}
    assert [*factors.values()] == [((0, 1), None), ((1, 1), None)]
    assert sorted(factors) == [pytest.approx(other), pytest.approx((0.8, 0.1, 0.2))]


def test_textures_that_planes_blur_are_told():
    """Details of 0.5 mm on a sheet of 1 m, where planes have 3.9 mm; coarse ones are not."""
    sheet = {
        "positions": np.float32([[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 0], [1, 0, 1], [0, 0, 1]]),
        "uvs": np.float32([[0, 0], [2, 0], [2, 2], [0, 0], [2, 2], [0, 2]]),
        "material": np.array(["paint", "paint"]),
    }
    fine = {"Roughness": 1024.0**2, "Metallic": 128.0**2}
    assert blurred_note("asset", sheet, {"paint": fine, "other": fine}) == (
        "part 'asset': texels of planes of 256 are 0.00391 m wide, and blur finer ones of 'paint' "
        "(Roughness: 0.000488 m)"
    )
    assert blurred_note("asset", sheet, {"paint": {"Metallic": 64.0**2}}) is None
