"""Sets up AMD's TressFX bear (MIT) as white fur: every strand of the file, without the body.

    rna-capture examples/recipes/bear.py --out bear.rays/ -- FOLDER

FOLDER holds `bear.tfx`. Runs inside Blender.
"""

import argparse
from pathlib import Path

import rna_hair
from rna_hair.objects import add_curves, chiang_material

RADIUS = 0.16  # units of the file, where a hair is 4 long and the bear 115 tall: thick, for density


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, help="folder of bear.tfx")
    args = parser.parse_args()
    fur = rna_hair.resample(rna_hair.read_tfx(args.folder / "bear.tfx", RADIUS), 6)
    fur = rna_hair.fit(rna_hair.taper(fur, RADIUS, tip=0.2, start=0.5))
    white = chiang_material("white fur", melanin=0.0, roughness=0.3, radial_roughness=0.7)
    add_curves(fur, "bear", white)


main()
