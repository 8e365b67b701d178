"""Small valid files of every kind that a scene reads, for `scenes.py` to mutate."""

import base64
import io
import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from tests.render.environment_files import cases

MESHES, ENVIRONMENTS, TEXTURES, SCENES = "meshes", "environments", "textures", "scenes"

_CORNERS = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], np.float32)
_UVS = np.array([[0, 1], [2, 1], [2, -1], [0, -1]], np.float32)
_FACES = np.array([0, 1, 2, 0, 2, 3], np.uint16)
_WRAPS = (10497, 33071, 33648)


def write_seeds(folder: Path) -> dict[str, list[Path]]:
    """Writes the files; kind -> paths. What they refer to lies beside them."""
    return {
        MESHES: [*_gltf_files(folder), *_obj_files(folder), *_ply_files(folder)],
        ENVIRONMENTS: [case.path for case in cases(folder) if case.texels is not None],
        TEXTURES: _texture_files(folder),
        SCENES: _scene_files(folder),
    }


def _image(mode: str) -> Image.Image:
    rng = np.random.default_rng(0)
    bands = len(Image.new(mode, (1, 1)).getbands())
    shape = (6, 5) if bands == 1 else (6, 5, bands)
    return Image.fromarray(rng.integers(0, 256, shape, np.uint8))


def _texture_files(folder: Path) -> list[Path]:
    paths = []
    for mode, suffix in [
        ("RGB", "png"), ("RGBA", "png"), ("L", "png"), ("RGB", "jpg"), ("RGB", "bmp"),
        ("RGB", "tga"), ("RGB", "tif"), ("RGB", "gif"), ("RGBA", "webp"), ("RGB", "ppm"),
        ("RGB", "jp2"), ("RGBA", "dds"),
    ]:  # fmt: skip
        paths.append(folder / f"texture-{mode}.{suffix}")
        _image(mode).save(paths[-1])
    paths.append(folder / "grey16.png")
    Image.fromarray(np.arange(30, dtype=np.uint16).reshape(6, 5) * 2000).save(paths[-1])
    return paths


class _Gltf:
    """A glTF document with all its data inside."""

    def __init__(self) -> None:
        self.blob = b""
        self.json: dict[str, Any] = {"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}]}
        self.json |= {name: [] for name in ("nodes", "meshes", "accessors", "bufferViews")}

    def view(self, data: bytes, **more: int) -> int:
        self.blob += bytes(-len(self.blob) % 4)
        place = {"buffer": 0, "byteOffset": len(self.blob), "byteLength": len(data)}
        self.json["bufferViews"].append(place | more)
        self.blob += data
        return len(self.json["bufferViews"]) - 1

    def accessor(self, values: np.ndarray, **more: Any) -> int:
        codes = {"int8": 5120, "uint8": 5121, "int16": 5122, "uint16": 5123, "float32": 5126}
        kind = "SCALAR" if values.ndim == 1 else f"VEC{values.shape[1]}"
        entry = {"count": len(values), "type": kind, "componentType": codes[values.dtype.name]}
        view = {"bufferView": self.view(np.ascontiguousarray(values).tobytes())}
        self.json["accessors"].append(view | entry | more)
        return len(self.json["accessors"]) - 1

    def mesh(self, more: dict[str, int] | None = None, **primitive: Any) -> None:
        attributes = {"POSITION": self.accessor(_CORNERS), "TEXCOORD_0": self.accessor(_UVS)}
        attributes |= more or {}
        entry = {"attributes": attributes, "indices": self.accessor(_FACES)} | primitive
        self.json["meshes"].append({"primitives": [entry]})
        self.json["nodes"].append({"mesh": len(self.json["meshes"]) - 1})

    def textured(self, material: dict[str, Any], wrap: int = 10497) -> None:
        """Materials of one image; a material's textures have index 0."""
        file = io.BytesIO()
        _image("RGBA").save(file, "png")
        self.json["images"] = [{"bufferView": self.view(file.getvalue()), "mimeType": "image/png"}]
        self.json["samplers"] = [{"wrapS": wrap, "wrapT": wrap}]
        self.json["textures"] = [{"source": 0, "sampler": 0}]
        self.json["materials"] = [material]

    def gltf(self) -> bytes:
        uri = f"data:application/octet-stream;base64,{base64.b64encode(self.blob).decode()}"
        buffers = [{"byteLength": len(self.blob), "uri": uri}]
        return json.dumps(self.json | {"buffers": buffers}).encode()

    def glb(self) -> bytes:
        text = json.dumps(self.json | {"buffers": [{"byteLength": len(self.blob)}]}).encode()
        text += b" " * (-len(text) % 4)
        blob = self.blob + bytes(-len(self.blob) % 4)
        size = 12 + 8 + len(text) + 8 + len(blob)
        start = struct.pack("<4sIII4s", b"glTF", 2, size, len(text), b"JSON") + text
        return start + struct.pack("<I4s", len(blob), b"BIN\0") + blob


def _gltf_files(folder: Path) -> list[Path]:
    files: dict[str, bytes] = {}
    for wrap in _WRAPS:
        transform = {"offset": [0.1, 0.2], "scale": [2, -3], "rotation": 0.3}
        info = {"index": 0, "extensions": {"KHR_texture_transform": transform}}
        gltf = _Gltf()
        gltf.mesh(material=0)
        base = {"baseColorTexture": info, "metallicRoughnessTexture": {"index": 0}}
        mask = {"alphaMode": "MASK", "alphaCutoff": 0.5, "normalTexture": {"index": 0, "scale": 2}}
        emission = {"emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 0}}
        gltf.textured({"pbrMetallicRoughness": base, **mask, **emission}, wrap)
        gltf.json["nodes"][0] |= {"rotation": [0, 0.6, 0, 0.8], "scale": [1, -2, 1]}
        files[f"textured-{wrap}.gltf"] = gltf.gltf()
    gltf = _Gltf()
    tangents = np.array(np.tile([1, 0, 0, -1], (4, 1)), np.float32)
    normals = np.array(np.tile([0, 0, 1], (4, 1)), np.float32)
    more = {"TANGENT": gltf.accessor(tangents), "NORMAL": gltf.accessor(normals)}
    more |= {"TEXCOORD_1": gltf.accessor(np.array(_UVS * 0 + 9, np.uint16), normalized=True)}
    more |= {"COLOR_0": gltf.accessor(np.array(normals, np.float32))}
    gltf.mesh(more, material=0)
    second = {"index": 0, "texCoord": 1}
    layers = {
        "KHR_materials_ior": {"ior": 1.4},
        "KHR_materials_specular": {"specularFactor": 0.5, "specularTexture": second},
        "KHR_materials_clearcoat": {"clearcoatFactor": 0.7, "clearcoatTexture": second},
        "KHR_materials_emissive_strength": {"emissiveStrength": 5},
    }
    opacity = {"alphaMode": "BLEND", "normalTexture": {"index": 0}}
    gltf.textured({"extensions": layers, **opacity})
    files["layers.glb"] = gltf.glb()
    gltf = _Gltf()
    gltf.mesh(material=0)
    glass = {"KHR_materials_transmission": {"transmissionFactor": 0.9}}
    tint = {"baseColorTexture": {"index": 0}, "roughnessFactor": 0, "metallicFactor": 0}
    gltf.textured({"extensions": glass, "pbrMetallicRoughness": tint})
    files["glass.gltf"] = gltf.gltf()
    gltf = _Gltf()
    gltf.mesh(mode=5, indices=gltf.accessor(np.array([0, 1, 3, 2], np.uint8)))
    gltf.mesh(mode=6, indices=gltf.accessor(np.array([0, 1, 2, 3], np.uint16)))
    rows = gltf.view(np.array([1, 3], np.uint8).tobytes())
    values = gltf.view(_CORNERS[:2].tobytes())
    gltf.json["accessors"][0]["sparse"] = {
        "count": 2,
        "indices": {"bufferView": rows, "componentType": 5121},
        "values": {"bufferView": values},
    }
    gltf.json["nodes"] = [{"children": [1, 2], "matrix": np.eye(4).ravel().tolist()}]
    gltf.json["nodes"] += [{"mesh": 0, "translation": [1, 2, 3]}, {"mesh": 1}]
    files["hierarchy.gltf"] = gltf.gltf()
    return _written(folder, files)


def _obj_files(folder: Path) -> list[Path]:
    cube = "".join(f"v {x} {y} {z}\n" for x in (0, 1) for y in (0, 1) for z in (0, 1))
    faces = "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\n"
    shaded = "mtllib m.mtl\n" + cube + "vt 0 0\nvt 1 0.5\nvt 0.5 1\nvn 0 0 1\n"
    shaded += "usemtl red\nf 1/1/1 2/2/1 4/3/1\nusemtl lamp\nf 5/1/1 7/2/1 8/3/1\n"
    (folder / "m.mtl").write_text(
        "newmtl red\nKd 1 0.2 0.2\nmap_Kd texture-RGB.png\nPr 0.4\nPm 0.1\nNi 1.4\n"
        "newmtl lamp\nKe 4 4 4\nd 0.5\n"
    )
    return _written(folder, {"cube.obj": (cube + faces).encode(), "shaded.obj": shaded.encode()})


def _ply_files(folder: Path) -> list[Path]:
    def header(kind: str, properties: str, comment: str = "") -> bytes:
        return (
            f"ply\nformat {kind} 1.0\n{comment}element vertex 4\n{properties}"
            "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
        ).encode()

    places = "property float x\nproperty float y\nproperty float z\n"
    text = "".join(f"{x} {y} {z}\n" for x, y, z in _CORNERS) + "3 0 1 2\n3 0 2 3\n"
    rows = np.hstack([_CORNERS, _UVS])
    faces = b"".join(struct.pack("<B3i", 3, *_FACES[k : k + 3]) for k in (0, 3))
    uvs = places + "property float s\nproperty float t\n"
    image = "comment TextureFile texture-RGB.png\n"
    return _written(
        folder,
        {
            "text.ply": header("ascii", places) + text.encode(),
            "binary.ply": header("binary_little_endian", uvs, image) + rows.tobytes() + faces,
        },
    )


def _scene_files(folder: Path) -> list[Path]:
    everything = """\
objects:
  - {path: cube.obj, transform: {translation: [0, 1, 0], rotation_deg: [0, 45, 0], scale: 0.5}}
  - path: text.ply
    material: {type: coated, color: [0.4, 0.3, 0.2], roughness: 0.4, ior: 1.5}
ground: {height: -1, size: 20, material: {type: diffuse, color: [0.5, 0.5, 0.5]}}
camera: {position: [0, 1, 4], look_at: [0, 0.4, 0], vertical_fov_deg: 35, up: [0, 1, 0]}
lights:
  - {type: environment, path: plain.hdr, rotation_deg: 40, radiance: [1, 1, 1]}
  - {type: directional, direction: [0, 1, 0.5], irradiance: [2, 2, 2], angular_diameter_deg: 0.5}
  - {type: rectangle, position: [-1, 2, 1], look_at: [0, 0, 0], size: [1, 1], radiance: [9, 9, 9]}
  - {type: sphere, position: [1, 2, 1], radius: 0.2, radiance: [5, 5, 5], group: key}
  - {type: spot, position: [0, 3, 0], look_at: [0, 0, 0], intensity: [5, 5, 5], outer_angle_deg: 40}
resolution: [4, 3]
samples: 1
max_depth: 3
seed: 7
animation: {frames: 4, turntable: {degrees: 90}}
"""
    short = "ground: {}\ncamera: &c {position: [0, 1, 4], look_at: [0, 0, 0]}\nsamples: 1\n"
    return _written(folder, {"all.yaml": everything.encode(), "short.yaml": short.encode()})


def _written(folder: Path, files: dict[str, bytes]) -> list[Path]:
    for name, content in files.items():
        (folder / name).write_bytes(content)
    return [folder / name for name in files]
