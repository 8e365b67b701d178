"""Hits of the kit, class by class: where readers get the visibility wrong."""

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from rna_sdk.package import Curves, Mesh
from tests.conformance.kit.blocks import dot, unit
from tests.conformance.kit.visibility import Body, FiberHits, MeshHits, stable, strands, visibility
from tests.render.round_cones import depths

Hits = MeshHits | FiberHits
Ranges = list[tuple[str, int, int]]


def make_hits(
    seed: int, names: Sequence[str], bodies: Sequence[Body]
) -> tuple[bytes, np.ndarray, Ranges]:
    """Stable hits as records, (n, 3) float64 visibility, and the ranges of the classes.

    names: of the parts.
    """
    rng = np.random.default_rng(seed)
    records, seen, ranges, first = [], [], [], 0
    for part, part_name in enumerate(names):
        for name, hits in _classes(rng, part, bodies):
            stable_hits = hits.take(stable(hits, bodies, part)[:60])
            if len(stable_hits.wi):
                records.append(stable_hits.records(part))
                seen.append(visibility(bodies, stable_hits.rays(bodies, part)))
                ranges.append(
                    (
                        f"{part_name}: {name}" if len(bodies) > 1 else name,
                        first,
                        len(stable_hits.wi),
                    )
                )
                first += len(stable_hits.wi)
    return b"".join(records), np.concatenate(seen), ranges


def _classes(
    rng: np.random.Generator, part: int, bodies: Sequence[Body]
) -> list[tuple[str, MeshHits]] | list[tuple[str, FiberHits]]:
    """Those of the kind, and directions to other parts and to what lets light through."""
    geometry = bodies[part].geometry
    if isinstance(geometry, Mesh):
        made = _mesh_classes(rng, geometry)
    else:
        made = _fiber_classes(rng, geometry)
    _, ordinary = made[0]
    targets = [("towards another part", b.geometry) for b in bodies if b is not bodies[part]]
    targets += [("towards what lets light through", _passing(b)) for b in bodies if b.records]
    for name, target in targets:
        points = _points_of(target)
        chosen = points[rng.integers(0, len(points), len(ordinary.wi))]
        wi = unit(chosen - ordinary.x(geometry) + 0.02 * rng.normal(size=chosen.shape))
        made.append((name, replace(ordinary, wi=wi.astype(np.float32))))
    return made


def _passing(body: Body) -> Mesh:
    """The triangles with records."""
    mesh = body.geometry
    rows = np.concatenate([np.arange(r.first, r.first + r.count) for r in body.records])
    return replace(mesh, triangles=mesh.triangles[rows])


def _points_of(geometry: Mesh | Curves) -> np.ndarray:
    """Points inside the triangles or on the strands."""
    if isinstance(geometry, Curves):
        return geometry.points.astype(np.float64)
    v = geometry.positions[geometry.triangles].astype(np.float64)
    weights = np.random.default_rng(0).dirichlet((1, 1, 1), (len(v), 8))
    return np.einsum("tpk,tkc->tpc", weights, v).reshape(-1, 3)


def _directions(rng: np.random.Generator, n: int) -> np.ndarray:
    return unit(rng.normal(size=(n, 3))).astype(np.float32)


def _mesh_classes(rng: np.random.Generator, mesh: Mesh) -> list[tuple[str, MeshHits]]:
    v = mesh.positions[mesh.triangles].astype(np.float64)
    area = np.linalg.norm(np.cross(v[:, 1] - v[:, 0], v[:, 2] - v[:, 0]), axis=1)
    real = np.flatnonzero(area > 1e-6 * area.max())

    def points(n: int, edge: bool = False) -> MeshHits:
        b = rng.dirichlet((1, 1, 1), n)
        if edge:  # on an edge, and every third at a corner
            b[:, 0], b[::3] = 0.0, (0.0, 1.0, 0.0)
            b[1::3, 1] = 1.0 - b[1::3, 2]
            b[2::3, 1] = 1.0 - b[2::3, 2]
        triangle = real[rng.integers(0, len(real), n)].astype(np.uint32)
        return MeshHits(triangle, *np.float32(b[:, 1:].T), _directions(rng, n))

    def aimed(wanted: Callable[[np.ndarray, np.ndarray], np.ndarray]) -> MeshHits:
        """Those of many whose n.wi and n_g.wi are as wanted."""
        hits = points(4000)
        n, n_g = hits.normals(mesh)
        wi = hits.wi.astype(np.float64)
        return hits.take(np.flatnonzero(wanted(dot(n, wi), dot(n_g, wi)))[:90])

    return [
        ("ordinary", points(90)),
        ("terminator", aimed(lambda n, n_g: (n > 0.005) & (abs(n_g) < 0.15))),
        ("behind the facet", aimed(lambda n, n_g: (n > 0.01) & (n_g < -0.005))),
        ("just above the facet", aimed(lambda n, n_g: (n > 0.05) & (n_g > 0) & (n_g < 0.1))),
        ("backs", aimed(lambda n, n_g: n < -0.05)),
        ("behind the smooth surface", aimed(lambda n, n_g: (n < -0.005) & (n_g > 0.005))),
        ("edges and corners", points(60, edge=True)),
    ]


def _fiber_classes(rng: np.random.Generator, curves: Curves) -> list[tuple[str, FiberHits]]:
    first, strand = curves.segments().astype(int), strands(curves)
    middle = (curves.points[first] + curves.points[first + 1]) / 2

    def points(n: int, u: np.ndarray | None = None) -> FiberHits:
        """On the cones, by a sphere of the segment and a direction across."""
        segment = rng.integers(0, len(first), n)
        a, b = (curves.points[first[segment] + k].astype(np.float64) for k in (0, 1))
        r_a, r_b = (curves.radii[first[segment] + k].astype(np.float64) for k in (0, 1))
        s = rng.random(n) if u is None else u
        length = np.linalg.norm(b - a, axis=1)
        slope = (r_a - r_b) / length
        along = (b - a) / length[:, None]
        side = unit(np.cross(along, _directions(rng, n)))
        normal = slope[:, None] * along + np.sqrt(1 - slope**2)[:, None] * side
        x = a + s[:, None] * (b - a) + (r_a + s * (r_b - r_a))[:, None] * normal
        return FiberHits(segment.astype(np.uint32), x.astype(np.float32), _directions(rng, n))

    def towards(hits: FiberHits, targets: np.ndarray) -> FiberHits:
        wi = unit(targets - hits.position + 0.02 * rng.normal(size=hits.position.shape))
        return FiberHits(hits.segment, hits.position, wi.astype(np.float32))

    def other(hits: FiberHits, same_strand: bool) -> np.ndarray:
        """For each hit a segment of its own strand, or of another."""
        chosen = []
        for k in strand[hits.segment]:
            choices = np.flatnonzero((strand == k) if same_strand else (strand != k))
            chosen.append(rng.choice(choices) if len(choices) else 0)
        return np.array(chosen)

    ends = rng.integers(0, 2, 90) * 0.98 + 0.01 * rng.random(90)
    joints, many = points(90, ends), points(90)
    inside = _inside_others(points(6000), curves)
    inside = inside.take(np.arange(len(inside.wi))[:90])
    return [
        ("ordinary", points(90)),
        ("towards other strands", towards(many, middle[other(many, same_strand=False)])),
        ("along and through the own strand", towards(many, middle[other(many, same_strand=True)])),
        ("at joints", joints),
        ("towards joints", towards(many, curves.points[first[other(many, same_strand=False)]])),
        ("inside another strand", inside),
        ("inside another strand, along it", towards(inside, _ends_of_other(inside, curves))),
    ]


def _inside_others(hits: FiberHits, curves: Curves) -> FiberHits:
    """Those that lie well inside a segment of another strand."""
    strand = strands(curves)
    deep = depths(curves, hits.position) > 0.005
    deep &= strand != strand[hits.segment][:, None]
    return hits.take(np.flatnonzero(deep.any(axis=1)))


def _ends_of_other(hits: FiberHits, curves: Curves) -> np.ndarray:
    """For each hit an end of a segment beside the one of another strand that it lies in."""
    strand, first = strands(curves), curves.segments().astype(int)
    depth = depths(curves, hits.position)
    depth[strand == strand[hits.segment][:, None]] = -np.inf
    inside = depth.argmax(axis=1)
    after = np.minimum(inside + 1, len(first) - 1)
    beyond = np.where(strand[after] == strand[inside], first[after] + 1, first[inside] - 1)
    return curves.points[np.maximum(beyond, 0)]
