"""Variants of a glTF file: kept where base colour alone differs, shown in turn, told where not."""

import base64
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from rna_export.capture.blender_process.capture_worker import scene_of
from rna_export.capture.capture_plan import plan_lines
from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.capture_tasks import TrainingShard
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.geometry.exported_parts import exported_parts
from rna_export.export.extras import variants_of
from tests.exporters.synthetic import manifest_of

pytestmark = pytest.mark.blender

KHR = "KHR_materials_variants"
RED, BLUE = (0.8, 0.1, 0.1), (0.1, 0.1, 0.8)


def material(
    name: str, factor: tuple[float, ...], image: int | None, **more: Any
) -> dict[str, Any]:
    of = {} if image is None else {"baseColorTexture": {"index": image}}
    rough = {"metallicFactor": 0.0, "roughnessFactor": 1.0, "baseColorFactor": [*factor, 1.0]}
    return {"name": name, "pbrMetallicRoughness": {**rough, **of, **more}}


def write_gltf(folder: Path) -> Path:
    """A label with an image beside a plain square, in the variants of `variants`."""
    corners = np.float32([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)])
    uvs = np.float32([(0, 1), (1, 1), (1, 0), (0, 0)])
    indices = np.uint16([0, 1, 2, 0, 2, 3])
    pieces = [corners + np.float32([1.5, 0, 0]), corners, uvs, indices]
    data, views = b"", []
    for piece in pieces:
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": piece.nbytes})
        data += piece.tobytes()
    for k, color in enumerate(((200, 200, 200), (40, 90, 40))):
        pixels = np.full((16, 16, 3), color, np.uint8)
        pixels[::2, ::3] = 255 - pixels[::2, ::3]
        Image.fromarray(pixels).save(folder / f"{k}.png")

    def square(place: int, default: int, chosen: dict[int, list[int]]) -> dict[str, Any]:
        mappings = [{"material": m, "variants": of} for m, of in chosen.items()]
        attributes = {"POSITION": place, "TEXCOORD_0": 2}
        extension = {KHR: {"mappings": mappings}}
        return {
            "attributes": attributes,
            "indices": 3,
            "material": default,
            "extensions": extension,
        }

    box = {"min": [0, 0, 0], "max": [2.5, 1, 0]}
    vectors = [{"bufferView": k, "componentType": 5126, "count": 4} for k in range(3)]
    shiny = material("shiny", RED, None, roughnessFactor=0.2)
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "extensionsUsed": [KHR],
        "extensions": {KHR: {"variants": [{"name": n} for n in ("usual", "night", "polished")]}},
        "meshes": [
            {"primitives": [square(0, 0, {0: [0], 1: [1]}), square(1, 2, {3: [1], 4: [2]})]}
        ],
        "materials": [
            material("label", (1.0, 1.0, 1.0), 0),
            material("label at night", (0.5, 1.0, 1.0), 1),
            material("body", RED, None),
            material("body at night", BLUE, None),
            shiny,
        ],
        "textures": [{"source": 0}, {"source": 1}],
        "images": [{"uri": "0.png"}, {"uri": "1.png"}],
        "accessors": [
            {**vectors[0], **box, "type": "VEC3"},
            {**vectors[1], **box, "type": "VEC3"},
            {**vectors[2], "type": "VEC2"},
            {"bufferView": 3, "componentType": 5123, "count": 6, "type": "SCALAR"},
        ],
        "bufferViews": views,
        "buffers": [
            {
                "byteLength": len(data),
                "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode(),
            }
        ],
    }
    path = folder / "box.gltf"
    path.write_text(json.dumps(document))
    return path


def test_variants_are_captured_in_turn(open_worker, tmp_path):
    worker = open_worker(write_gltf(tmp_path))
    (note,) = (note for note in worker.opened["notes"] if "variant" in note)
    assert note == (
        "variant 'polished' is left out: material 'shiny' differs from 'body' by roughnessFactor, "
        "where base colour alone may"
    )
    settings = CaptureSettings(lights=8, lights_per_shard=8, rays=1024, samples=4)
    exported = exported_parts(worker, settings)
    assert exported.notes == []
    manifest = manifest_of(settings, parts=exported.captured(), variants=tuple(exported.variants))
    assert (manifest.variants, manifest.prints) == (("usual", "night"), (None, 1))
    dataset = Dataset.create(tmp_path / "rays", manifest, exported.geometries, exported.textures)
    said = plan_lines(dataset, exported.geometries, 1e6)
    assert "lights take turns at 2 prints: the source's own, 'night'\n" in said
    TrainingShard(0).run(dataset, scene_of(dataset), worker)
    at = dataset.only.training_samples()
    body = (at["position"][:, 0] < 1.1) & (at["radiance"].mean(axis=1) > 1e-3)
    for color, channel in ((RED, 0), (BLUE, 2)):
        of_color = body & np.isclose(at["base_color"], color, atol=1e-3).all(axis=1)
        assert 0.3 * body.sum() < of_color.sum()
        light = at["radiance"][of_color].sum(axis=0)
        assert light.argmax() == channel and light[channel] > 2 * np.delete(light, channel).max()

    variants, files = variants_of(dataset)
    usual, night = variants.variants
    assert (usual.name, usual.parts, night.name) == ("usual", (None,), "night")
    assert night.parts[0] is not None
    label, plain = sorted(night.parts[0], key=lambda one: one.image is None)
    assert files == {label.image: (tmp_path / "1.png").read_bytes()}
    assert label.image == "extensions/RNA_variants/label-at-night.png"
    np.testing.assert_allclose([label.factor, plain.factor], [(0.5, 1.0, 1.0), BLUE], atol=1e-6)
