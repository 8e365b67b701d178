"""Ten materials of artists: what the pre-flight says of each, and what then happens.

    rna-bench materials --work bench/materials --out materials.json --picture materials.jpg

Runs `rna-make` on `examples/recipes/materials.py` for each material whose package is not yet in the
work folder. The picture has a row a material: two validation images of ours, each with Cycles'.
"""

from __future__ import annotations

import argparse
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from rna_bench.bench_options import add_out
from rna_bench.checkout import ROOT
from rna_bench.results import publish
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.make.rna_make import main as make
from rna_export.metrics import to_png
from rna_export.training.asset_error import picture_exposures
from rna_sdk.errors import RnaError
from rna_sdk.files.atomic_file import write_atomically
from rna_sdk.runtime import load

RECIPE = ROOT / "examples" / "recipes" / "materials.py"
NAMES = ("paint", "brushed", "wax", "velvet", "leaf", "marble", "neon", "fur")
"""The glass is left to hosts, and the volume refused: neither has anything to train."""
_VIEWS, _SIDE, _LABEL = 2, 128, 22


def run(args: argparse.Namespace) -> None:
    """Make what is missing, then the table and the picture."""
    rows, pictures = [], []
    for name in NAMES:
        package = args.work / f"{name}.rna"
        if not package.is_file():
            _make(package, name, args)
        dataset = Dataset(package.with_suffix(".make") / "rays")
        rows.append(_row(name, package, dataset))
        pictures.append((name, shown(package, dataset)))
    if args.picture is not None:
        data = BytesIO()
        sheet(pictures).save(data, "JPEG", quality=88)
        write_atomically(args.picture, data.getvalue())
    publish({"lights": args.lights, "steps": args.steps, "materials": rows}, args)


def _make(package: Path, name: str, args: argparse.Namespace) -> None:
    package.parent.mkdir(parents=True, exist_ok=True)
    effort = "--lights", str(args.lights), "--steps", str(args.steps)
    images = "--validation-views", "4", "--validation-resolution", str(_SIDE)
    workers = () if args.workers is None else ("--workers", str(args.workers))
    if make([str(RECIPE), "--out", str(package), *effort, *images, *workers, "--", name]) != 0:
        raise RnaError(f"{package}: rna-make failed")


def _row(name: str, package: Path, dataset: Dataset) -> dict[str, Any]:
    """What was said of the material, and the error that is recorded."""
    records = [each for each in dataset.manifest.materials if not each.name.startswith("foot")]
    validation = load(package).tier.validation
    return {
        "material": name,
        "verdicts": [line.strip() for each in records for line in each.lines],
        "flip": None if validation is None else round(validation.flip, 4),
        "psnr": None if validation is None else round(validation.psnr, 2),
    }


def shown(package: Path, dataset: Dataset) -> list[np.ndarray]:
    """Validation images of a package and of Cycles in turn, (h, w, 3) uint8 each."""
    views, asset = dataset.whole_views()[:_VIEWS], load(package)
    pictures = []
    for view, exposure in zip(views, picture_exposures(views), strict=True):
        parts = zip(view.parts, asset.parts, strict=True)
        ours = np.concatenate([part.shaded_by(part_asset) for part, part_asset in parts])
        for radiance in (ours, view.reference):
            pictures.append(to_png(view.image(radiance), exposure.factor))
    return pictures


def sheet(rows: list[tuple[str, list[np.ndarray]]]) -> Image.Image:
    """A row a material, its name above; small pictures are enlarged to one size."""
    columns = max(len(pictures) for _, pictures in rows)
    result = Image.new("RGB", (columns * _SIDE, len(rows) * (_SIDE + _LABEL)), (255, 255, 255))
    draw, font = ImageDraw.Draw(result), ImageFont.load_default(14)
    for k, (name, pictures) in enumerate(rows):
        top = k * (_SIDE + _LABEL)
        label = f"{name}: ours, Cycles, ours, Cycles"
        draw.text((6, top + _LABEL // 2), label, (20, 20, 20), font, anchor="lm")
        for column, picture in enumerate(pictures):
            one = Image.fromarray(picture).resize((_SIDE, _SIDE))
            result.paste(one, (column * _SIDE, top + _LABEL))
    return result


def add_options(parser: argparse.ArgumentParser) -> None:
    """The options of this command."""
    parser.add_argument(
        "--work", type=Path, default=Path("bench", "materials"), help="folder of the packages"
    )
    parser.add_argument("--lights", type=int, default=250, help="light directions per material")
    parser.add_argument("--steps", type=int, default=4000, help="training steps per material")
    parser.add_argument("--workers", type=int, help="Blender processes (int, default: rna-make's)")
    parser.add_argument("--picture", type=Path, help="JPEG to write (path)")
    add_out(parser)
