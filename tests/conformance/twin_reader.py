"""The references as a reader of base colours and lobes, with the decoder as the package has it."""

import numpy as np
from numpy.typing import NDArray

from rna_sdk.conformance.lobe_queries import LobeQueries, answer_of
from rna_sdk.conformance.reader_program import BASE_COLOR_HIT
from rna_sdk.package import Mesh, Package, Planes, float_planes
from rna_sdk.package.decoder.query_arrays import QUERY_ARRAYS, in_order
from rna_sdk.runtime.engine.decoder_sessions import Graph
from tests.reference.base_color import base_color_reference
from tests.reference.lobes import lobes_reference, mirror_reference, visibility_reference
from tests.reference.queries import fiber_queries_reference, queries_reference

Rows = NDArray[np.float32]


def base_color(package: str, records: bytes) -> Rows:
    """(n, 3): the base colour of n hits on meshes."""
    hits = np.frombuffer(records, BASE_COLOR_HIT)
    result = np.empty((len(hits), 3), np.float32)
    with Package.open(package) as opened:
        for part in np.unique(hits["part"]).tolist():
            rows = hits["part"] == part
            at = (hits[name][rows] for name in ("primitive", "u", "v", "level"))
            result[rows] = base_color_reference(opened.mesh(part), opened.base_color(part), *at)
    return result


def environment(package: str, tier: str, part: int, queries: LobeQueries) -> Rows:
    """(n, 6 L): amplitudes and axes, 0 for rows that are no queries. tier: any."""
    with Package.open(package) as opened:
        environment, kind = opened.environment(part), opened.manifest.parts[part].kind
        assert environment is not None
        arrays = {name: getattr(queries, name) for name in ("position", "axis", "h", "wo")}
        valid = _valid(arrays) & np.isfinite(queries.free)
        arguments = {name: rows[valid] for name, rows in arrays.items()}
        arguments["wi"] = mirror_reference(kind, arguments["axis"], arguments["wo"])
        of = environment.planes, environment.record.inputs
        inputs = _queries(opened, part, *of, arguments, of_lobes=True)
        if environment.harmonics is not None:
            corners, weights = _corners(opened, part, queries)
            mixed = visibility_reference(environment.harmonics, corners[valid], weights[valid])
            inputs = np.hstack([inputs, mixed.astype(np.float32)])
        output = Graph(bytes(environment.decoder), optimized=False).run(inputs)
        result = np.zeros((len(valid), 6 * environment.record.lobes), np.float32)
        results = lobes_reference(
            kind, output, arguments["axis"], arguments["wo"], queries.free[valid]
        )
        result[valid] = answer_of(*results)
        return result


def _corners(
    opened: Package, part: int, queries: LobeQueries
) -> tuple[NDArray[np.integer], NDArray[np.float64]]:
    """Vertices of the primitives of queries, and their weights, (n, 3 or 2) each."""
    geometry, u, v = opened.geometry(part), np.float64(queries.u), np.float64(queries.v)
    if isinstance(geometry, Mesh):
        return geometry.triangles[queries.primitive], np.stack([1 - u - v, u, v], axis=1)
    first = geometry.segments()[queries.primitive]
    return np.stack([first, first + 1], axis=1), np.stack([1 - u, u], axis=1)


def _valid(arrays: dict[str, Rows]) -> NDArray[np.bool_]:
    """Which rows are queries."""
    valid = np.ones(len(arrays["wo"]), np.bool_)
    for array in (array for array in QUERY_ARRAYS if array.name in arrays):
        rows = arrays[array.name].reshape(len(valid), -1)
        valid &= np.isfinite(rows).all(axis=1) & (rows.any(axis=1) | (not array.is_direction))
    return valid


def _queries(
    opened: Package,
    part: int,
    planes: Planes,
    inputs: tuple[str, ...],
    arrays: dict[str, Rows],
    of_lobes: bool = False,
) -> Rows:
    """(n, K): the blocks of these inputs."""
    at, axis, h, wo, wi = in_order(arrays)
    place = float_planes(planes), opened.manifest.parts[part].bounds.corners(), inputs
    if opened.manifest.parts[part].kind == "surface":
        return queries_reference(*place, at, axis, wo, wi, of_lobes)
    return fiber_queries_reference(*place, at, axis, h, wo, wi)
