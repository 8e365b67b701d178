"""Sets up AMD's TressFX ponytail (MIT) as a head of blonde or brown hair.

    rna-capture examples/recipes/ponytail.py --out blonde.rays/ -- FOLDER --hair blonde

FOLDER holds `back.tfx`, `front_top.tfx`, `side.tfx` and `tail.tfx`. Runs inside Blender.
"""

import argparse
from pathlib import Path

import rna_hair
from rna_hair.objects import add_curves, chiang_material

# Strands of each part; the tail, which all hair ends in, gets more than its share of guides.
PARTS = {"side": 19000, "front_top": 7500, "back": 5000, "tail": 8500}

# One unit of the files is about a third of a centimetre: the head is 60 units high. Real hair is
# 0.035 to 0.05 mm in radius, which would be 0.014 here; but a head has 100,000 strands.
RADIUS = 0.028

# melanin, redness, roughness
COLOURS = {"blonde": (0.1, 0.5, 0.25), "brown": (0.6, 0.6, 0.3)}


def grow(folder):
    """40,000 strands of 16 points, within a ball of radius 1 around the origin."""
    parts = []
    for seed, (name, count) in enumerate(PARTS.items()):
        guides = rna_hair.read_tfx(folder / f"{name}.tfx", RADIUS)
        part = rna_hair.interpolate(
            guides, count, points=16, seed=seed, clump=0.35, noise=0.006, shorten=0.15
        )
        parts.append(rna_hair.taper(part, RADIUS, tip=0.3, start=0.6))
    return rna_hair.fit(rna_hair.join(parts))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, help="folder of the four .tfx files")
    parser.add_argument("--hair", choices=sorted(COLOURS), default="blonde")
    args = parser.parse_args()
    melanin, redness, roughness = COLOURS[args.hair]
    material = chiang_material(
        args.hair,
        melanin=melanin,
        redness=redness,
        roughness=roughness,
        radial_roughness=0.4,
        ior=1.55,
        offset_deg=2.0,
    )
    add_curves(grow(args.folder), "ponytail", material)


main()
