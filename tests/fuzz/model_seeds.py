"""Valid models of each format that Blender opens, for `models.py` to mutate, and hostile ones."""

import json
import struct
from collections.abc import Iterator
from copy import deepcopy
from pathlib import Path
from typing import Any

from tests.exporters.in_blender import answer_of
from tests.fuzz.motion_files import GLTF_MOTIONS, write_motions
from tests.fuzz.scene_seeds import MESHES
from tests.fuzz.scene_seeds import write_seeds as write_scene_seeds

# A textured cube that moves, a cube that instances show, and strands; then each exporter. The
# blend file tells in a file `ran` if its scripts run, and has a cache on disk and a node that
# writes images.
_IN_BLENDER = """
import bpy, sys
folder = sys.argv[1]
bpy.ops.mesh.primitive_cube_add()
cube = bpy.context.object
image = bpy.data.images.new("image", 4, 4)
image.pack()
material = bpy.data.materials.new("textured")
material.use_nodes = True
nodes = material.node_tree.nodes
node = nodes.new("ShaderNodeTexImage")
node.image = image
material.node_tree.links.new(node.outputs[0], nodes["Principled BSDF"].inputs["Base Color"])
cube.data.materials.append(material)
cube.keyframe_insert("location", frame=1)
cube.location.x = 2
cube.keyframe_insert("location", frame=5)
other = bpy.data.objects.new("other", cube.data)
bpy.context.scene.collection.objects.link(other)
bpy.ops.wm.usd_export(filepath=folder + "/model.usda", export_animation=True)
bpy.ops.wm.usd_export(filepath=folder + "/model.usdc")
bpy.ops.wm.usd_export(filepath=folder + "/model.usdz")
bpy.ops.wm.alembic_export(filepath=folder + "/model.abc", start=1, end=3)
curves = bpy.data.hair_curves.new("hair")
curves.add_curves([3] * 20)
for k, point in enumerate(curves.points):
    point.position = k // 3 * 0.1, 0, k % 3
bpy.context.scene.collection.objects.link(bpy.data.objects.new("hair", curves))
bpy.ops.wm.save_as_mainfile(filepath=folder + "/model.blend", compress=False)
script = f"open({folder + '/ran'!r}, 'a').write('x')"
driver = other.driver_add("location", 0).driver
driver.expression = f"(exec({script!r}), 1.0)[1]"
text = bpy.data.texts.new("started.py")
text.write(script)
text.use_module = True
cloth = cube.modifiers.new("cloth", "CLOTH")
cloth.point_cache.use_disk_cache = True
bpy.ops.wm.save_as_mainfile(filepath=folder + "/scripts.blend", compress=False)
answer(None)
"""

BLEND, SCRIPTS = "model.blend", "scripts.blend"


def write_models(python: Path, folder: Path) -> dict[str, list[Path]]:
    """Writes the files; suffix -> paths."""
    folder.mkdir(exist_ok=True)
    answer_of(python, _IN_BLENDER, str(folder))
    written = [*write_scene_seeds(folder)[MESHES], *write_motions(folder)[GLTF_MOTIONS]]
    written += [folder / f"model.{kind}" for kind in ("usda", "usdc", "usdz", "abc", "blend")]
    seeds: dict[str, list[Path]] = {}
    for path in written:
        seeds.setdefault(path.suffix, []).append(path)
    return seeds


_REMOVED = object()

# What the tests of glTF-Validator and glTF-Asset-Generator are about, as changes to `arm.gltf`,
# which has a skin, an animation and a buffer inside. A place: keys with / between.
_GLTF: dict[str, dict[str, Any]] = {
    "version-1": {"asset/version": "1.0"},
    "version-3": {"asset/version": "3.0", "asset/minVersion": "3.0"},
    "no-asset": {"asset": _REMOVED},
    "asset-is-a-list": {"asset": []},
    "extension-required": {"extensionsRequired": ["EXT_none"], "extensionsUsed": ["EXT_none"]},
    "draco-without-data": {
        "extensionsRequired": ["KHR_draco_mesh_compression"],
        "extensionsUsed": ["KHR_draco_mesh_compression"],
        "meshes/0/primitives/0/extensions": {
            "KHR_draco_mesh_compression": {"bufferView": 0, "attributes": {"POSITION": 0}}
        },
    },
    "meshopt-without-data": {
        "extensionsRequired": ["EXT_meshopt_compression"],
        "bufferViews/0/extensions": {"EXT_meshopt_compression": {"buffer": 9}},
    },
    "scene-out-of-range": {"scene": 9},
    "scene-is-negative": {"scene": -1},
    "no-scenes": {"scenes": _REMOVED, "scene": _REMOVED},
    "no-nodes": {"nodes": []},
    "node-out-of-range": {"scenes/0/nodes": [99]},
    "node-is-its-own-child": {"nodes/0/children": [0]},
    "nodes-in-a-loop": {"nodes/0/children": [1], "nodes/1/children": [0]},
    "node-of-two-parents": {"nodes/0/children": [1, 1]},
    "node-of-no-mesh": {"nodes/0/mesh": 77},
    "node-of-a-text": {"nodes/0/mesh": "0"},
    "matrix-of-3": {"nodes/0/matrix": [1, 2, 3]},
    "matrix-of-zeros": {"nodes/0/matrix": [0] * 16},
    "matrix-of-huge-numbers": {"nodes/0/matrix": [1e38] * 16},
    "rotation-of-zeros": {"nodes/0/rotation": [0, 0, 0, 0]},
    "scale-of-zeros": {"nodes/0/scale": [0, 0, 0]},
    "name-of-a-path": {"nodes/0/name": "../../../../tmp/x", "meshes/0/name": "/etc/passwd"},
    "name-of-control-characters": {"nodes/0/name": "a\u0000b\n\u001b[31m", "meshes/0/name": ""},
    "name-is-long": {"nodes/0/name": 20_000 * "n", "meshes/0/name": 20_000 * "\u00fc"},
    "name-is-a-number": {"nodes/0/name": 7},
    "mesh-without-primitives": {"meshes/0/primitives": []},
    "no-positions": {"meshes/0/primitives/0/attributes": {}},
    "points": {"meshes/0/primitives/0/mode": 0},
    "lines": {"meshes/0/primitives/0/mode": 1},
    "strip": {"meshes/0/primitives/0/mode": 5},
    "mode-99": {"meshes/0/primitives/0/mode": 99},
    "indices-out-of-range": {"meshes/0/primitives/0/indices": 99},
    "indices-of-floats": {"meshes/0/primitives/0/indices": 0},
    "positions-of-scalars": {"accessors/0/type": "SCALAR"},
    "type-unknown": {"accessors/0/type": "VEC9"},
    "component-unknown": {"accessors/0/componentType": 5131},
    "component-of-bytes": {"accessors/0/componentType": 5121},
    "count-0": {"accessors/0/count": 0},
    "count-negative": {"accessors/0/count": -5},
    "count-beyond-its-view": {"accessors/0/count": 1_000_000},
    "count-of-a-terabyte": {"accessors/0/count": 10**11},
    "accessor-of-no-view": {"accessors/0/bufferView": 99},
    "accessor-without-view": {"accessors/0/bufferView": _REMOVED},
    "accessor-offset": {"accessors/0/byteOffset": 10**6},
    "accessor-misaligned": {"accessors/0/byteOffset": 1},
    "sparse-beyond": {
        "accessors/0/sparse": {
            "count": 3,
            "indices": {"bufferView": 0, "componentType": 5125},
            "values": {"bufferView": 1},
        }
    },
    "sparse-of-nothing": {"accessors/0/sparse": {}},
    "view-beyond-its-buffer": {"bufferViews/0/byteLength": 10**8},
    "view-of-no-buffer": {"bufferViews/0/buffer": 4},
    "view-offset-negative": {"bufferViews/0/byteOffset": -4},
    "stride-1": {"bufferViews/0/byteStride": 1},
    "stride-of-a-gigabyte": {"bufferViews/0/byteStride": 2**30},
    "buffer-is-short": {"buffers/0/byteLength": 10**8},
    "buffer-is-gone": {"buffers/0/uri": "gone.bin"},
    "buffer-without-uri": {"buffers/0/uri": _REMOVED},
    "buffer-of-no-base64": {"buffers/0/uri": "data:application/octet-stream;base64,@@@@"},
    "buffer-of-a-device": {"buffers/0/uri": "/dev/zero"},
    "buffer-above": {"buffers/0/uri": "../../../../../../etc/hostname"},
    "buffer-in-the-net": {"buffers/0/uri": "http://127.0.0.1:9/x.bin"},
    "buffer-by-file-uri": {"buffers/0/uri": "file:///etc/hostname"},
    "skin-without-joints": {"skins/0/joints": []},
    "skin-of-no-node": {"skins/0/joints": [88, 89]},
    "skin-of-few-matrices": {"skins/0/inverseBindMatrices": 0},
    "skin-is-gone": {"skins": []},
    "animation-of-no-sampler": {"animations/0/channels/0/sampler": 9},
    "animation-of-no-node": {"animations/0/channels/0/target/node": 55},
    "animation-path-unknown": {"animations/0/channels/0/target/path": "colour"},
    "animation-of-a-pointer": {"animations/0/channels/0/target/path": "pointer"},
    "animation-input-of-vectors": {"animations/0/samplers/0/input": 0},
    "animation-of-one-key": {"animations/0/samplers/0/output": 0},
    "interpolation-unknown": {"animations/0/samplers/0/interpolation": "SPLASH"},
    "material-out-of-range": {"meshes/0/primitives/0/material": 5},
    "texture-out-of-range": {
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 7}}}],
        "meshes/0/primitives/0/material": 0,
    },
    "texture-of-no-image": {
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
        "textures": [{"source": 3}],
        "meshes/0/primitives/0/material": 0,
    },
    "image-of-no-image": {
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
        "textures": [{"source": 0}],
        "images": [{"bufferView": 0, "mimeType": "image/png"}],
        "meshes/0/primitives/0/material": 0,
    },
    "image-above": {
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
        "textures": [{"source": 0}],
        "images": [{"uri": "../../../../../../etc/passwd", "name": "../../x"}],
        "meshes/0/primitives/0/material": 0,
    },
    "alpha-unknown": {
        "materials": [{"alphaMode": "SEETHROUGH", "alphaCutoff": -3}],
        "meshes/0/primitives/0/material": 0,
    },
    "colour-of-texts": {
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": ["1", None, [], 1]}}],
        "meshes/0/primitives/0/material": 0,
    },
    "extensions-are-a-list": {
        "materials": [{"extensions": [1]}],
        "meshes/0/primitives/0/material": 0,
    },
    "colour-beyond-floats": {
        "materials": [{"emissiveFactor": [1e300, 1e300, 1e300]}],
        "meshes/0/primitives/0/material": 0,
    },
    "targets-of-nothing": {"meshes/0/primitives/0/targets": [{"POSITION": 99}]},
    "lights-without-list": {"nodes/0/extensions": {"KHR_lights_punctual": {"light": 0}}},
    "camera-of-nothing": {"nodes/0/camera": 3},
    "variants-of-nothing": {
        "extensionsUsed": ["KHR_materials_variants"],
        "extensions": {"KHR_materials_variants": {"variants": 3}},
    },
    "instances-of-nothing": {
        "extensionsUsed": ["EXT_mesh_gpu_instancing"],
        "nodes/0/extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 99}}},
    },
}

_USDA = "#usda 1.0\n"
_MESH = """(
    int[] faceVertexCounts = [3]
    int[] faceVertexIndices = [0, 1, 2]
    point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
)""".replace("(\n", "{\n", 1).replace("\n)", "\n}")
_OBJ = b"v 0 0 0\nv 1 0 0\nv 0 1 0\n"
_PLY = "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
_PLY += "property float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n"

_OTHERS: dict[str, bytes | str] = {
    "empty.usda": "",
    "header.usda": _USDA,
    "references-itself.usda": _USDA + 'def "a" (references = </a>) {}\n',
    "layers-in-a-loop.usda": "#usda 1.0\n(subLayers = [@layers-in-a-loop.usda@])\n",
    "layer-is-gone.usda": "#usda 1.0\n(subLayers = [@/gone.usda@, @http://127.0.0.1:9/x@])\n",
    "layer-of-a-device.usda": '#usda 1.0\ndef "a" (references = @/dev/zero@) {}\n',
    "indices-beyond.usda": _USDA + f'def Mesh "m" {_MESH.replace("[0, 1, 2]", "[0, 1, 999999]")}\n',
    "indices-negative.usda": _USDA + f'def Mesh "m" {_MESH.replace("[0, 1, 2]", "[0, 1, -7]")}\n',
    "counts-negative.usda": _USDA + f'def Mesh "m" {_MESH.replace("[3]", "[-3]")}\n',
    "counts-huge.usda": _USDA + f'def Mesh "m" {_MESH.replace("[3]", "[2000000000]")}\n',
    "points-of-nan.usda": _USDA + f'def Mesh "m" {_MESH.replace("(1, 0, 0)", "(nan, inf, 0)")}\n',
    "instances-of-nothing.usda": _USDA
    + 'def PointInstancer "p" { rel prototypes = </none>\n int[] protoIndices = [0, 7, -1] }\n',
    "curves-beyond.usda": _USDA
    + 'def BasisCurves "c" { int[] curveVertexCounts = [9]\n point3f[] points = [(0, 0, 0)] }\n',
    "deep.usda": _USDA + 500 * 'def "a" {\n' + 500 * "}\n",
    "zip-of-nothing.usdz": b"PK\x05\x06" + 18 * b"\0",
    "no-zip.usdz": b"no zip",
    "crate-of-nothing.usdc": b"PXR-USDC" + 80 * b"\xff",
    "empty.abc": b"",
    "ogawa-of-nothing.abc": b"Ogawa\xff\0\1" + 8 * b"\xff",
    "hdf5.abc": b"\x89HDF\r\n\x1a\n" + 100 * b"\0",
    "empty.blend": b"",
    "header.blend": b"BLENDER-v500",
    "zstd-of-nothing.blend": b"\x28\xb5\x2f\xfd" + 40 * b"\0",
    "gzip-of-nothing.blend": b"\x1f\x8b\x08" + 40 * b"\0",
    "old.blend": b"BLENDER_v100" + 200 * b"\0",
    "empty.glb": b"",
    "magic.glb": b"glTF",
    "length-beyond.glb": struct.pack("<4sIIII", b"glTF", 2, 2**31, 2**31 - 20, 0x4E4F534A),
    "version-9.glb": struct.pack("<4sII", b"glTF", 9, 12),
    "empty.gltf": b"",
    "list.gltf": "[]",
    "null.gltf": "null",
    "deep.gltf": 100_000 * "[",
    "no-utf8.gltf": b'{"asset": {"version": "\xff\xfe"}}',
    "twice.gltf": '{"asset": {"version": "2.0"}, "asset": 3}',
    "empty.obj": b"",
    "indices-beyond.obj": _OBJ + b"f 1 2 2000000000\n",
    "indices-negative.obj": _OBJ + b"f -9 -8 -7\n",
    "index-0.obj": _OBJ + b"f 0 1 2\n",
    "numbers-odd.obj": b"v nan inf 1e999\n" + _OBJ + b"f 1 2 3\n",
    "long-line.obj": _OBJ + b"f" + 100_000 * b" 1" + b"\n",
    "library-above.obj": b"mtllib ../../../../etc/passwd\nusemtl x\n" + _OBJ + b"f 1 2 3\n",
    "curve.obj": _OBJ + b"cstype bspline\ndeg 3\ncurv 0 1 1 2 3\nparm u 0 0 1\nend\n",
    "library-is-itself.obj": b"mtllib library-is-itself.obj\n" + _OBJ + b"f 1 2 3\n",
    "empty.ply": b"",
    "faces-beyond.ply": _PLY.format(3, 1) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 99\n",
    "count-beyond.ply": _PLY.format(2_000_000_000, 1) + "0 0 0\n",
    "count-negative.ply": _PLY.format(-3, 1) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
    "face-of-200.ply": _PLY.format(3, 1) + "0 0 0\n1 0 0\n0 1 0\n200 0 1 2\n",
    "no-end.ply": "ply\nformat ascii 1.0\nelement vertex 3\n",
    "property-unknown.ply": "ply\nformat ascii 1.0\nelement vertex 1\nproperty odd x\nend_header\n",
}  # fmt: skip


def write_hostile(folder: Path) -> list[Path]:
    """Writes hostile files, beside those of `write_models`; returns them."""
    arm = json.loads((folder / "arm.gltf").read_bytes())
    texts = {f"{name}.gltf": json.dumps(_changed(arm, how)) for name, how in _GLTF.items()}
    paths = [folder / SCRIPTS]
    for name, data in (texts | _OTHERS).items():
        paths.append(folder / name)
        paths[-1].write_bytes(data if isinstance(data, bytes) else data.encode())
    return paths


def _changed(document: Any, changes: dict[str, Any]) -> Any:
    """A copy with other values at some places."""
    result = deepcopy(document)
    for place, value in changes.items():
        parent, key = _place(result, place)
        if value is _REMOVED:
            parent.pop(key, None)
        else:
            parent[key] = value
    return result


def _place(document: Any, place: str) -> tuple[Any, Any]:
    """The container of a place, and its key there."""
    *above, last = _keys(place)
    for key in above:
        document = document[key]
    return document, last


def _keys(place: str) -> Iterator[str | int]:
    for key in place.split("/"):
        yield int(key) if key.isdigit() else key
