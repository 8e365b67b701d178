"""Geometry of a package, and rest points of deformed shapes, as code: numpy alone, float64.

    python examples/hosts/deformed.py geometry PACKAGE PART RESULTS
    python examples/hosts/deformed.py deformed PACKAGE PART SHAPE HITS RESULTS

Numbers in comments are the sections of spec/RNA.md. Like minimal.py, it trusts its file.
"""

import json
import sys
import zipfile

import numpy as np


def read_geometry(path, number):
    """Arrays of a part's mesh or curves by name."""
    with zipfile.ZipFile(path) as archive:
        part = json.loads(archive.read("manifest.json"))["parts"][number]
        data = archive.read(part["geometry"])
    return read_mesh(data) if part["kind"] == "surface" else read_curves(data)


def read_mesh(data):
    """4.1: a header, a chunk of JSON, one of bytes; positions are steps if the node has a scale."""
    size = int.from_bytes(data[12:16], "little")
    document, binary = json.loads(data[20 : 20 + size]), data[28 + size :]
    primitive, node = document["meshes"][0]["primitives"][0], document["nodes"][0]
    arrays = {n: values(document, binary, k) for n, k in primitive["attributes"].items()}
    p, n = arrays["POSITION"].astype(float), arrays["NORMAL"].astype(float)
    uv = arrays.get("TEXCOORD_0", np.zeros((len(p), 2)))
    if "scale" in node:
        p = rounded(np.array(node["translation"]) + node["scale"][0] * p)
        n = unit(np.maximum(n / 32767, -1))
    if uv.dtype == np.uint16:
        uv = rounded(uv / 65535.0)
    triangles = values(document, binary, primitive["indices"]).astype(int).reshape(-1, 3)
    return {"positions": p, "normals": n, "uvs": uv, "triangles": triangles}


def values(document, binary, number):
    """(count, width) of an accessor."""
    accessor = document["accessors"][number]
    view = document["bufferViews"][accessor["bufferView"]]
    kinds = {5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
    dtype = np.dtype(kinds[accessor["componentType"]])
    width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}[accessor["type"]]
    start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    strides = view.get("byteStride", width * dtype.itemsize), dtype.itemsize
    return np.ndarray((accessor["count"], width), dtype, binary, start, strides)


def read_curves(data):
    """4.2: tensors; points are steps from the one before them if there are scales."""
    size = int.from_bytes(data[:8], "little")
    curves = {}
    for name, tensor in json.loads(data[8 : 8 + size]).items():
        if name != "__metadata__":
            first, last = tensor["data_offsets"]
            kinds = {
                "F32": "<f4",
                "U32": "<u4",
                "I32": "<i4",
                "I16": "<i2",
                "U16": "<u2",
                "U8": "u1",
            }
            found = np.frombuffer(data[8 + size + first : 8 + size + last], kinds[tensor["dtype"]])
            curves[name] = found.reshape(tensor["shape"]).astype(float)
    curves["offsets"] = offsets = curves["offsets"].astype(int)
    if "scales" in curves:
        step, unit_of_radii = curves["scales"]
        points = []
        for k, origin in enumerate(curves["origins"]):
            steps = curves["steps"][offsets[k] - k : offsets[k + 1] - k - 1]
            points.append(origin + step * np.cumsum(np.vstack([np.zeros(3), steps]), axis=0))
        curves["points"] = rounded(np.vstack(points))
        curves["radii"] = rounded(unit_of_radii * curves["radii"])
    return curves


def rest_of_mesh(mesh, shape, triangle, b1, b2):
    """8.3, of hits on triangles of the shape (v, 3): x and n at rest, (n, 3), and Q (n, 3, 3)."""
    corners, b = mesh["triangles"][triangle], np.stack([1 - b1 - b2, b1, b2], axis=1)[:, :, None]
    x, n = (np.sum(b * mesh[name][corners], axis=1) for name in ("positions", "normals"))
    rotations, whole = triangle_rotations(mesh, shape)
    deformed_n = np.sum(b * deformed_normals(mesh, rotations, whole)[corners], axis=1)
    back = rotations[triangle].transpose(0, 2, 1)
    near = np.einsum("nij,nj->ni", back, unit(deformed_n))
    return x, unit(n), smallest_rotations(near, unit(n)) @ back


def triangle_rotations(mesh, shape):
    """(t, 3, 3) from rest to deformed, and whether each triangle has area at rest and deformed."""
    triangles, frames = mesh["triangles"], []
    whole = np.ones(len(triangles), bool)
    for p in (mesh["positions"][triangles], shape[triangles]):
        e1, e2 = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]
        across, longest = np.cross(e1, e2), np.maximum(length(e1), length(e2))
        whole &= (length(across) > 1e-6 * longest**2)[:, 0]
        frames.append(np.stack([e1, e2, unit(across)], axis=2))
    rotations = np.tile(np.eye(3), (len(triangles), 1, 1))
    left, _, right = np.linalg.svd(frames[1][whole] @ np.linalg.inv(frames[0][whole]))
    rotations[whole] = left @ right  # of the polar decomposition
    return rotations, whole


def deformed_normals(mesh, rotations, whole):
    """(v, 3): of each vertex the mean of R n, by the angles of its triangles at rest."""
    p, n, triangles = mesh["positions"], mesh["normals"], mesh["triangles"][whole]
    _, same = np.unique(np.hstack([p, n]), axis=0, return_inverse=True)  # one place, one normal
    same, sums = same.reshape(-1), np.zeros((len(p), 3))
    for k in range(3):
        corner, after, before = (triangles[:, (k + step) % 3] for step in (0, 1, 2))
        a, b = unit(p[after] - p[corner]), unit(p[before] - p[corner])
        angle = np.arccos(np.clip(np.sum(a * b, axis=1, keepdims=True), -1, 1))
        turned = np.einsum("nij,nj->ni", rotations[whole], n[corner])
        np.add.at(sums, same[corner], angle * turned)
    return np.where(length(sums[same]) > 0, unit(sums[same]), n)


def rest_of_curves(curves, shape, segment, u, normal):
    """8.3, of hits on segments of the shape (p, 3): x and t at rest, (n, 3), and Q (n, 3, 3)."""
    p, radii, offsets = curves["points"], curves["radii"], curves["offsets"]
    strands = [strand_rotations(p, shape, offsets, k) for k in range(len(offsets) - 1)]
    back = np.concatenate(strands).transpose(0, 2, 1)[segment]
    first = np.delete(np.arange(len(p)), offsets[1:] - 1)[segment]
    u, n = u[:, None], np.einsum("nij,nj->ni", back, normal)
    radius = (1 - u) * radii[first, None] + u * radii[first + 1, None]
    x = (1 - u) * p[first] + u * p[first + 1] + radius * n
    return x, unit(p[first + 1] - p[first]), back


def strand_rotations(p, shape, offsets, strand):
    """(m, 3, 3), from rest to deformed, of the segments of a strand."""
    rotation, result = root_rotation(p, shape, offsets, strand), []
    for k in range(offsets[strand], offsets[strand + 1] - 1):
        t, deformed_t = unit(p[k + 1] - p[k]), unit(shape[k + 1] - shape[k])
        rotation = smallest_rotations((rotation @ t)[None], deformed_t[None])[0] @ rotation
        result.append(rotation)
    return result


def root_rotation(p, shape, offsets, strand):
    """The rotation that fits the first segments and the ways to the roots near this one best."""
    root, tip, roots = offsets[strand], offsets[strand + 1] - 1, offsets[:-1]
    far = length(p[roots] - p[root])[:, 0]
    near = np.argsort(far, kind="stable")[:13]  # the strand itself, and a dozen
    nearest = np.min(far[far > 0], initial=np.inf)
    ways = [(root, (root + tip + 1) // 2, 0.001), (root, tip, 0.001)]
    for other in near:
        w = (nearest / far[other]) ** 2 if far[other] > 0 else 1
        ways += [(roots[other], roots[other] + 1, w), (root, roots[other], w)]
    c = 1e-9 * np.eye(3)  # of several rotations that fit as well the smallest
    for a, b, w in ways:
        d, deformed_d = p[b] - p[a], shape[b] - shape[a]
        if d.any():
            c += w * np.outer(deformed_d, d) / (d @ d)
    left, _, right = np.linalg.svd(c)
    return left @ np.diag([1, 1, np.linalg.det(left @ right)]) @ right


def smallest_rotations(a, b):
    """(n, 3, 3), from unit vectors a to b, (n, 3) each."""
    x, y, z = np.cross(a, b).T
    k = np.moveaxis(np.array([[0 * x, -z, y], [z, 0 * x, -x], [-y, x, 0 * x]]), 2, 0)
    return np.eye(3) + k + k @ k / (1 + np.sum(a * b, axis=1))[:, None, None]


def length(v):
    return np.linalg.norm(v, axis=-1, keepdims=True)


def unit(v):
    return v / np.where(length(v) > 0, length(v), 1)


def rounded(v):
    return v.astype(np.float32).astype(float)


def geometry(path, number):
    """(v, 8) position, normal and texture coordinate of vertices; or (p, 4) point and radius."""
    g = read_geometry(path, number)
    names = ("positions", "normals", "uvs") if "triangles" in g else ("points", "radii")
    return np.column_stack([g[name] for name in names])


def deformed(path, number, shape, records):
    """(n, 15) x, n or t, and Q by rows, of hit records."""
    words, g = np.frombuffer(records, "<u4").reshape(-1, 8), read_geometry(path, number)
    primitive, place = words[:, 0].astype(int), words.view("<f4")[:, 1:6].astype(float)
    if "triangles" in g:
        x, axis, q = rest_of_mesh(g, shape, primitive, place[:, 0], place[:, 1])
    else:
        x, axis, q = rest_of_curves(g, shape, primitive, place[:, 0], place[:, 1:4])
    return np.hstack([x, axis, q.reshape(-1, 9)])


if __name__ == "__main__":  # the protocol of spec/conformance/README.md
    if sys.argv[1:] == ["levels"]:
        print("geometry\ndeformed")
    elif sys.argv[1:2] == ["geometry"] and len(sys.argv) == 5:
        geometry(sys.argv[2], int(sys.argv[3])).astype("<f4").tofile(sys.argv[4])
    elif sys.argv[1:2] == ["deformed"] and len(sys.argv) == 7:
        package, part, positions, hits, results = sys.argv[2:]
        shape, records = np.fromfile(positions, "<f4"), np.fromfile(hits, "u1").tobytes()
        rows = deformed(package, int(part), shape.reshape(-1, 3).astype(float), records)
        rows.astype("<f4").tofile(results)
    else:
        sys.exit(__doc__)
