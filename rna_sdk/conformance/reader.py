"""The SDK as a reader program: `rna-conform -- python -m rna_sdk.conformance.reader`.

It has no rays, and so no visibility; `rna_render.conformance_reader` has.
"""

import sys
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.conformance.lobe_queries import LobeQueries, answer_of
from rna_sdk.conformance.reader_program import BASE_COLOR_HIT, run_reader
from rna_sdk.package import Curves, Package
from rna_sdk.package.issues import is_valid
from rna_sdk.package.validator import validate


def evaluate(
    form: str, package: str, tier: str, part: int, arrays: dict[str, NDArray[np.float32]]
) -> NDArray[np.float32]:
    """(n, width) by the runtime."""
    from rna_sdk.runtime import load

    return np.hstack(load(package, tier).parts[part].decode(form, arrays))


def environment(package: str, tier: str, part: int, queries: LobeQueries) -> NDArray[np.float32]:
    """(n, 6 L) by the runtime."""
    from rna_sdk.runtime import load

    asset: Any = load(package, tier).parts[part]  # of either kind: the arguments fit it
    visibility = asset.visibility_at(queries.primitive, queries.u, queries.v)
    return answer_of(*asset.lobes(*queries.arguments(asset.kind), visibility))


def base_color(package: str, records: bytes) -> NDArray[np.float32]:
    """(n, 3): the base colour of n hits on meshes."""
    from rna_sdk.runtime.base_color import BaseColorMaps

    hits = np.frombuffer(records, BASE_COLOR_HIT)
    result = np.empty((len(hits), 3), np.float32)
    with Package.open(package) as opened:
        for part in np.unique(hits["part"]).tolist():
            rows = hits["part"] == part
            maps = BaseColorMaps(opened.mesh(part), opened.base_color(part))
            u, v, level = (hits[name][rows] for name in ("u", "v", "level"))
            result[rows] = maps.at_levels(hits["primitive"][rows].astype(np.int64), u, v, level)
    return result


def geometry(package: str, part: int) -> NDArray[np.float32]:
    """(v, 8) position, normal, texture coordinate; or (p, 4) point, radius."""
    with Package.open(package) as opened:
        shape = opened.geometry(part)
        if isinstance(shape, Curves):
            return np.column_stack([shape.points, shape.radii])
        uvs = np.zeros((len(shape.positions), 2), np.float32) if shape.uvs is None else shape.uvs
        return np.hstack([shape.positions, shape.normals, uvs])


def deformed(
    package: str, part: int, shape: NDArray[np.float32], records: bytes
) -> NDArray[np.float32]:
    """(n, 15) by the runtime."""
    from rna_sdk.runtime import load

    words = np.frombuffer(records, "<u4").reshape(-1, 8)
    primitive, place = words[:, 0].astype(np.int32), words.view("<f4")[:, 1:6].astype(np.float32)
    asset: Any = load(package).parts[part]  # of either kind: the arguments fit it
    first = np.ascontiguousarray(place[:, 0])
    across = place[:, 1:4] if asset.kind == "fiber" else place[:, 1]
    rest = asset.deformed(shape).rest_points(primitive, first, np.ascontiguousarray(across))
    return np.hstack([rest.positions, rest.axes, rest.rotations.reshape(-1, 9)])


def check(package: str) -> tuple[bool, list[str]]:
    """Whether the package is valid, and the codes of its issues."""
    issues = validate(package)
    return is_valid(issues), [issue.code for issue in issues]


if __name__ == "__main__":
    sys.exit(
        run_reader(
            evaluate=evaluate,
            environment=environment,
            nearby=evaluate,
            base_color=base_color,
            geometry=geometry,
            deformed=deformed,
            validate=check,
        )
    )
