"""The RNA format as code: read a package, evaluate its transport and emission, in numpy alone.

    python examples/hosts/minimal.py evaluate PACKAGE TIER PART QUERIES RESULTS
    python examples/hosts/minimal.py emission PACKAGE TIER PART QUERIES RESULTS
    python examples/hosts/minimal.py nearby PACKAGE TIER PART QUERIES RESULTS

Numbers in comments are the sections of spec/RNA.md. This reader trusts its file: a host that
takes packages from anywhere makes the checks of section 10 first.
"""

import json
import sys
import zipfile

import numpy as np


def evaluate(path, tier_name, part, x, axis, h, wo, wi, base_color, nearby=None):
    """(n, 6) colours: light from x towards wo under irradiance 1 from wi, visible and shadowed.

    axis: the normal of a surface, or the tangent of a fiber, with h the offset across it.
    base_color: of the surface (4.6); tiers that do not use it do not look at it. nearby: (n, 3)
    nearby light (7.3), which tiers that count it need.
    """
    return answer("transport", path, tier_name, part, x, axis, h, wo, wi, base_color, nearby)


def emission(path, tier_name, part, x, axis, h, wo):
    """(n, 3) colours: light from x towards wo where nothing lights the asset (7.2)."""
    return answer("emission", path, tier_name, part, x, axis, h, wo, wo)  # no block reads wi


@np.errstate(all="ignore")  # blocks that the decoder does not take may be NaN
def answer(output, path, tier_name, number, x, axis, h, wo, wi, base_color=None, nearby=None):
    """Output of a part's decoder of `output`, or of its two of visible and shadowed light."""
    with zipfile.ZipFile(path) as archive:  # 2: a ZIP of stored entries
        manifest = json.loads(archive.read("manifest.json"))  # 3
        tier = next(tier for tier in manifest["tiers"] if tier["name"] == tier_name)
        part, tier_part = manifest["parts"][number], tier["parts"][number]
        decoders = decoders_of(tier_part, output)
        if not decoders:
            return np.zeros((len(x), 3))
        planes = read_planes(archive.read(tier_part["planes"]))
        graphs = [read_decoder(archive.read(record["decoder"])) for record in decoders.values()]
    uses_base_color = output == "transport" and tier_part.get("usesBaseColor", False)
    low, high = (np.float32(part["bounds"][corner]).astype(float) for corner in ("min", "max"))
    # 8: what is not finite, or has no direction, gets 0; all else is brought into range.
    counts_nearby = output == "transport" and "nearby" in tier_part
    if counts_nearby and nearby is None:
        raise ValueError(f"{path}: tier {tier_name} counts nearby light: pass it")
    factors = [base_color] * uses_base_color + [nearby] * counts_nearby
    numbers = [x, axis, h, wo, wi, *factors]
    rows = np.isfinite(np.column_stack(numbers)).all(axis=1)
    rows &= axis.any(axis=1) & wo.any(axis=1) & wi.any(axis=1)
    p = np.clip((x[rows] - low) / (high - low), 0, 1)
    directions = (unit(v[rows]) for v in (axis, wo, wi))
    blocks = input_blocks(planes, p, np.clip(h[rows], -1, 1), *directions)
    colours = []
    for (name, record), (nodes, constants) in zip(decoders.items(), graphs, strict=True):
        queries = np.hstack([blocks[block] for block in record["inputs"]])
        colour = run(nodes, {**constants, "queries": queries})[name]
        if counts_nearby:  # 7.3: columns of its own, then as many for each length
            colour, *of_lengths = np.hsplit(colour, 4)
            for share, of_length in zip(nearby[rows].T, of_lengths, strict=True):
                colour = colour + np.maximum(share, 0)[:, None] * of_length
        if uses_base_color:  # 7.1: the second half of the columns are its factors
            colour, factor = np.hsplit(colour, 2)
            colour = np.maximum(
                colour + np.tile(base_color[rows], colour.shape[1] // 3) * factor, 0
            )
        colours.append(colour)
    result = np.zeros((len(x), {"transport": 6, "emission": 3}[output]))
    result[rows] = np.hstack(colours)
    return result


def decoders_of(tier_part, output):
    """Name of a decoder's output -> its record in the manifest (3)."""
    if output == "emission":
        return {output: tier_part[output]} if output in tier_part else {}
    if "shadowed" in tier_part:  # then the other gives visible light alone
        return {"visible": tier_part, "shadowed": tier_part["shadowed"]}
    return {"transport": tier_part}


def read_planes(data):
    """(3, R, R, C) features. 4.3: a header in JSON, its size before it, then the arrays."""
    size = int.from_bytes(data[:8], "little")
    tensors = {}
    for name, tensor in json.loads(data[8 : 8 + size]).items():
        if name != "__metadata__":
            first, last = tensor["data_offsets"]
            dtype = {"F32": "<f4", "F16": "<f2", "I8": "i1"}[tensor["dtype"]]
            values = np.frombuffer(data[8 + size + first : 8 + size + last], dtype)
            tensors[name] = values.reshape(tensor["shape"]).astype(float)
    scales = tensors.get("scales", np.ones(1))  # of int8: one a plane and channel
    return tensors["planes"] * scales.reshape(len(scales), 1, 1, -1)


def triplane(planes, p):
    """(n, C) features at p in [0, 1]. 5: the sum of three bilinear samples."""
    size, total = planes.shape[1], 0
    for plane, u, v in zip(planes, p.T[[0, 1, 2]], p.T[[1, 2, 0]], strict=True):  # XY, YZ, ZX
        s, t = (np.clip(side * size - 0.5, 0, size - 1) for side in (u, v))
        i, j = s.astype(int), t.astype(int)
        i1, j1 = np.minimum(i + 1, size - 1), np.minimum(j + 1, size - 1)
        a, b = (s - i)[:, None], (t - j)[:, None]
        lower = (1 - a) * plane[j, i] + a * plane[j, i1]
        upper = (1 - a) * plane[j1, i] + a * plane[j1, i1]
        total = total + (1 - b) * lower + b * upper
    return total


def input_blocks(planes, p, h, axis, wo, wi):
    """Name -> (n, width): inputs of decoders. 6.3; half are of surfaces, half of fibers."""
    f, n, t = triplane(planes, p), axis, axis
    bent = n + 0.1 * np.pad(f, ((0, 0), (0, 3)))[:, :3]  # features move highlights
    q = np.where(length(bent) < 1e-6, n, unit(bent))
    opposite = length(wi + wo) < 1e-6
    m = np.where(opposite, 0, unit(wi + wo))  # 0 for one across n, q and wi
    s_o, s_i, turned_o, turned_i = dot(t, wo), dot(t, wi), np.cross(t, wo), np.cross(t, wi)
    d = length(turned_o) * length(turned_i)
    cos_phi, sin_phi = dot(turned_o, turned_i) / d, dot(t, np.cross(wo, wi)) / d
    cos_phi, sin_phi = np.where(d < 1e-6, 1, cos_phi), np.where(d < 1e-6, 0, sin_phi)
    offset = h[:, None]
    g_o = np.arcsin(offset)  # at the fiber's surface, and refracted into it
    g_t = np.arcsin(offset * length(turned_o) / np.sqrt(1.55**2 - s_o**2))
    lobes = [2 * g_o - 2 * k * g_t - k * np.pi for k in range(3)]
    along = s_i + s_o
    plain = {"features": f, "position": 2 * p - 1, "h": offset, "wo": wo, "wi": wi}
    return plain | {
        "normal": n,
        "tangent": t,
        "half_vector": np.hstack([dot(n, m), gap(n, m), dot(n, wi), dot(n, wo), dot(wi, m)]),
        "highlight": np.log2(np.where(opposite, 1, length(np.cross(n, m))) ** 2 + 1e-8) / 12,
        "learned_normal": np.hstack([dot(q, m), gap(q, m)]),
        "fiber_angles": np.hstack(
            [s_i, s_o, along, np.log2(along**2 + 1e-3) / 6, cos_phi, sin_phi]
        ),
        "fiber_lobes": np.hstack([cos_phi * np.cos(a) + sin_phi * np.sin(a) for a in lobes]),
    }


def gap(n, m):
    """1 - n.m on a scale that resolves highlights."""
    return np.log2(np.maximum(1 - dot(n, m), 0) + 1e-4) / 6


def dot(a, b):
    return np.sum(a * b, axis=1, keepdims=True)


def length(v):
    return np.linalg.norm(v, axis=1, keepdims=True)


def unit(v):
    v = v / np.abs(v).max(axis=1, keepdims=True)  # so that no square leaves the range of numbers
    return v / length(v)


def read_decoder(model):
    """Nodes, and constants by name. 6.2: field 7 of an ONNX model is a graph of both (1 and 5)."""
    graph, nodes, constants = dict(fields(model))[7], [], {}
    for number, message in fields(graph):
        part = dict(fields(message)) if number in (1, 5) else {}
        if number == 1:  # of a node: names of its inputs (1), of its output (2), operator (4)
            inputs = [value.decode() for field, value in fields(message) if field == 1]
            nodes.append((part[4].decode(), inputs, part[2].decode()))
        elif number == 5:  # of a tensor: dimensions (1), data type (2), name (8), data (9)
            shape = [value for field, value in fields(message) if field == 1]
            dtype = {1: "<f4", 2: "u1", 3: "i1", 6: "<i4"}[part[2]]
            constants[part[8].decode()] = np.frombuffer(part[9], dtype).reshape(shape).astype(float)
    return nodes, constants


def fields(message):
    """(number, value) of a protobuf message, whose values are whole numbers or bytes."""
    at = 0
    while at < len(message):
        key, at = varint(message, at)
        value, at = varint(message, at)
        if key & 7 == 2:  # then that was the size
            value, at = message[at : at + value], at + value
        yield key >> 3, value


def varint(message, at):
    """A whole number, seven bits a byte, and where it ends."""
    value = shift = 0
    while True:
        value |= (message[at] & 127) << shift
        at, shift = at + 1, shift + 7
        if message[at - 1] < 128:
            return value, at


OPERATORS = {  # 6.2: the operators of the chain
    "Clip": np.clip,
    "Gemm": lambda x, weight, bias: x @ weight + bias,
    "MatMul": np.matmul,
    "Relu": lambda x: np.maximum(x, 0),
    "Exp": np.exp,
    "Add": np.add,
    "Sub": np.subtract,
    "Mul": np.multiply,
    "QuantizeLinear": lambda x, scale, zero: np.clip(np.rint(x / scale) + zero, 0, 255),
    "DequantizeLinear": lambda q, scale, zero=0: (q - zero) * scale,
}


def run(nodes, values):
    """The graph's values, name -> array, from `values`; float64 holds sums of integers exactly."""
    for operator, inputs, output in nodes:
        values[output] = OPERATORS[operator](*(values[name] for name in inputs))
    return values


if __name__ == "__main__":  # the protocol of spec/conformance/README.md
    if sys.argv[1:] == ["levels"]:
        print("evaluate\nnearby")
    elif sys.argv[1:2] in (["evaluate"], ["emission"], ["nearby"]) and len(sys.argv) == 7:
        command, package, tier, part, queries, results = sys.argv[1:]
        columns = {"evaluate": 16, "emission": 10, "nearby": 19}[command]
        ask = emission if command == "emission" else evaluate
        rows = np.fromfile(queries, "<f4").reshape(-1, columns).astype(float)
        x, axis, h, *others = np.split(rows, (3, 6, 7, *range(10, columns, 3)), axis=1)
        found = ask(package, tier, int(part), x, axis, h[:, 0], *others)
        found.astype("<f4").tofile(results)
    else:
        sys.exit(__doc__)
