"""Runs in the SDK's Python: a package's geometry, colours and facts as one NPZ.

    python unpack.py toy.rna toy.npz

Arrays of part K are named `K/positions` and so on, in object space with +Y up. `K/colors` is what
the first tier reflects at each vertex or point of light that comes from the side. `info` is JSON.
"""

import json
import sys
from pathlib import Path

import numpy as np

from rna_sdk.commands.error_words import error_in_words
from rna_sdk.errors import PackageError
from rna_sdk.files.atomic_file import atomic_file
from rna_sdk.package import Package
from rna_sdk.runtime import load
from rna_sdk.runtime.standin_colors import fiber_colors, surface_colors


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
    validation, cost = tier.validation, tier.cost
    flip = None if validation is None else validation.flip
    return {
        "name": tier.name,
        "flip": flip,
        "words": None if flip is None else error_in_words(flip),
        "nsPerQuery": None if cost is None else cost.ns_per_query,
    }


def geometry(part):
    """Geometry of a part, with a colour per vertex or point."""
    if part.kind == "surface":
        mesh = part.mesh
        arrays = {"positions": mesh.positions, "normals": mesh.normals, "triangles": mesh.triangles}
        if mesh.uvs is not None:
            arrays["uvs"] = mesh.uvs
        return arrays | {"colors": surface_colors(part)}
    curves = part.curves
    arrays = {"points": curves.points, "radii": curves.radii, "offsets": curves.offsets}
    return arrays | {"colors": fiber_colors(part, curves)}


if __name__ == "__main__":
    main()
