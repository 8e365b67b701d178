"""Runs in the SDK's Python: a package's geometry, colours and facts as one NPZ.

    python unpack.py toy.rna toy.npz

Arrays of part K are named `K/positions` and so on, in object space with +Y up. `K/colors` is what
the first tier reflects at each vertex or point of light that comes from the side. `info` is JSON.
"""

import json
import sys
from pathlib import Path

import numpy as np

from rna_sdk.atomic_file import atomic_file
from rna_sdk.package import Package, PackageError
from rna_sdk.runtime import load

BRIGHT = 0.5  # of the brightest channel of hair, in a viewport


def main():
    source, out = map(Path, sys.argv[1:])
    try:
        asset = load(source)
        with Package.open(source) as package:
            manifest, poster = package.manifest, package.poster()
    except PackageError as error:
        sys.exit(f"error: {error}")
    arrays = {"info": np.array(json.dumps(facts(manifest)))}
    if poster is not None:
        arrays["poster"] = np.frombuffer(poster, np.uint8)
    for number, part in enumerate(asset.parts):
        arrays |= {f"{number}/{name}": values for name, values in geometry(part).items()}
    with atomic_file(out) as temporary, temporary.open("wb") as file:
        np.savez(file, **arrays)


def facts(manifest):
    """Properties for Blender's panels and stand-in materials."""
    standin = manifest.extensions.get("RNA_standin")
    return {
        "name": manifest.name,
        "license": manifest.license,
        "source": manifest.provenance.source,
        "tool": manifest.provenance.tool,
        "generator": manifest.generator,
        "parts": [{"name": part.name, "kind": part.kind} for part in manifest.parts],
        "standin": None if standin is None else standin["parts"],
        "tiers": [tier_facts(tier) for tier in manifest.tiers],
    }


def tier_facts(tier):
    found, cost = tier.validation, tier.cost
    return {
        "name": tier.name,
        "psnr": None if found is None else found.psnr,
        "flip": None if found is None else found.flip,
        "nsPerQuery": None if cost is None else cost.ns_per_query,
    }


def geometry(part):
    """Geometry of a part, with a colour per vertex or point."""
    if part.kind == "surface":
        mesh = part.mesh
        arrays = {"positions": mesh.positions, "normals": mesh.normals, "triangles": mesh.triangles}
        if mesh.uvs is not None:
            arrays["uvs"] = mesh.uvs
        return arrays | {"colors": surface_colors(part, mesh.positions, mesh.normals)}
    curves = part.curves
    arrays = {"points": curves.points, "radii": curves.radii, "offsets": curves.offsets}
    return arrays | {"colors": fiber_colors(part, curves)}


def surface_colors(part, positions, n):
    """Albedo, as far as one direction of light tells it: (v, 3) float32 in [0, 1]."""
    wi = unit(n + across(n))  # at 45 degrees, so that nothing is mirrored to the eye
    visible, _ = part.evaluate(positions, n, n, wi)
    return as_albedo(visible, np.sqrt(0.5)) + emitted(part, positions, n, n)


def fiber_colors(part, curves):
    """Colours of the points of strands: (p, 3) float32.

    Brightened, as an engine that knows no hair shades strands by their colour alone, without the
    light that goes on from strand to strand.
    """
    tangents = np.gradient(curves.points, axis=0)
    ends = curves.offsets.astype(np.int64)
    tangents[ends[:-1]] = curves.points[ends[:-1] + 1] - curves.points[ends[:-1]]
    tangents[ends[1:] - 1] = curves.points[ends[1:] - 1] - curves.points[ends[1:] - 2]
    t = unit(tangents)
    wo = across(t)
    wi = unit(wo + np.cross(t, wo))
    h = np.zeros(len(t), np.float32)
    visible, _ = part.evaluate(curves.points, t, h, wo, wi)
    bright = max(float(np.percentile(visible, 95)), 1e-6)
    return as_albedo(visible * (BRIGHT / (np.pi * bright)), 1.0) + emitted(
        part, curves.points, t, wo, h
    )


def as_albedo(transport, cosine):
    return np.clip(np.pi * transport / cosine, 0.0, 1.0).astype(np.float32)


def emitted(part, points, frame, wo, h=None):
    """Radiance that the part sends out by itself, at most 1."""
    if not part.emits:
        return np.float32(0.0)
    given = (points, frame, wo) if h is None else (points, frame, h, wo)
    return np.clip(part.emission(*given), 0.0, 1.0).astype(np.float32)


def across(vectors):
    """Unit vectors at right angles to unit vectors: (n, 3) float32."""
    axis = np.where(np.abs(vectors[:, 1:2]) < 0.9, [[0.0, 1.0, 0.0]], [[1.0, 0.0, 0.0]])
    return unit(np.cross(np.cross(vectors, axis), vectors))


def unit(vectors):
    length = np.linalg.norm(vectors, axis=1, keepdims=True)
    return (vectors / np.maximum(length, 1e-30)).astype(np.float32)


if __name__ == "__main__":
    main()
