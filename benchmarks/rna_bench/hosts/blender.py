"""One scene in three renderers: rna-run, the engine in Blender, and Cycles with the original.

    rna-bench blender --picture docs/images/blender.jpg

A row for the toy and one for the curls: rna-run on the scene file that the extension writes, the
engine in Blender, Cycles, and the difference of the last two x 4, in blocks of 4 x 4 pixels. Prints
JSON.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from rna_bench.bench_options import add_out
from rna_bench.bench_pages import save_picture
from rna_bench.checkout import ROOT
from rna_bench.results import publish
from rna_export.capture.blender_process.blender_env import find_python
from rna_export.metrics import IRRADIANCE, psnr
from rna_render import read_exr, to_display

WIDTH = 1024  # pixels of the sheet
BLOCK = 4
ASSETS: dict[str, dict[str, Any]] = {
    "toy": {
        "package": "examples/quickstart/toy.rna",
        "original": "examples/quickstart/toy.py",
        "height": 0.0,
        "camera": (1.9, -1.45, 1.1),
        "target": (0.36, 0.16, 0.2),
    },
    "curls": {
        "package": "examples/fibers/curly_ball.rna",
        "original": "examples/fibers/curly_ball.py",
        "height": 0.36,
        "camera": (1.6, -1.7, 1.0),
        "target": (0.0, 0.0, 0.33),
    },
}


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--picture", type=Path, required=True, help="JPEG or PNG to write")
    parser.add_argument("--samples", type=int, default=64, help="rna-run samples per pixel")
    parser.add_argument("--cycles-samples", type=int, default=128, help="Cycles samples per pixel")
    parser.add_argument(
        "--width", type=int, default=320, help="width and height of one image, a multiple of 16"
    )
    add_out(parser)


def run(args: argparse.Namespace) -> None:
    rows, figures = [], {}
    with tempfile.TemporaryDirectory(prefix="rna-sheet-") as folder:
        extension = Path(folder) / "extension.zip"
        make_extension = str(ROOT / "scripts" / "blender-extension")
        subprocess.run([make_extension, str(extension)], check=True)
        for name in ASSETS:
            images = rendered(name, Path(folder), extension, args)
            rows.append(row(images))
            figures[name] = compared(images)
    save_picture(sheet(rows), args.picture)
    publish(figures, args)


def rendered(name: str, folder: Path, extension: Path, args: Any) -> dict[str, np.ndarray]:
    """Radiance by renderer: (h, w, 3)."""
    asset, scene = ASSETS[name], folder / name
    options = {
        **asset,
        "package": str(ROOT / asset["package"]),
        "original": str(ROOT / asset["original"]),
        "hairFolder": str(ROOT / "exporters" / "rna_export" / "blender"),
        "extension": str(extension),
        "resolution": (args.width, args.width * 3 // 4),
        "folder": str(scene),
    }
    ours = {"engine": "RNA", "samples": args.samples, "out": f"{scene}-rna.exr"}
    cycles = {"engine": "CYCLES", "samples": args.cycles_samples, "out": f"{scene}-cycles.exr"}
    for engine in (ours, cycles):
        in_blender(folder, {**options, **engine})
    out = folder / f"{name}-run.exr"
    command = [
        sys.executable,
        "-m",
        "rna_render.command.rna_run",
        f"{scene}/scene.yaml",
        "--out",
        str(out),
    ]
    subprocess.run(command, check=True)
    files = {"rna-run": out, "engine": Path(ours["out"]), "cycles": Path(cycles["out"])}
    return {who: rgb(path) for who, path in files.items()}


def in_blender(folder: Path, options: dict[str, Any]) -> None:
    (folder / "options.json").write_text(json.dumps(options))
    environment = {
        "BLENDER_USER_RESOURCES": str(folder / "user"),
        "RNA_SDK_PYTHON": sys.executable,
    }
    stage = Path(__file__).with_name("blender_stage.py")
    command = [str(find_python()), str(stage), str(folder / "options.json")]
    subprocess.run(command, env={**os.environ, **environment}, check=True)


def rgb(path: Path) -> np.ndarray:
    channels, _ = read_exr(path)
    return np.stack([channels[c] for c in "RGB"], axis=-1)


def sheet(rows: list[np.ndarray]) -> Image.Image:
    """The rows, made smaller if they are wider than a page shows."""
    image = Image.fromarray(np.concatenate(rows))
    width = min(image.width, WIDTH)
    return image.resize((width, round(image.height * width / image.width)), Image.Resampling.BOX)


def row(images: dict[str, np.ndarray]) -> np.ndarray:
    """8-bit images side by side, and their difference over blocks of pixels, for less noise."""
    difference = 4.0 * np.abs(blocks(images["engine"]) - blocks(images["cycles"]))
    enlarged = difference.repeat(BLOCK, axis=0).repeat(BLOCK, axis=1)
    shown = [to_display(image, "srgb") for image in (*images.values(), enlarged)]
    return np.concatenate([np.rint(255.0 * image).astype(np.uint8) for image in shown], axis=1)


def blocks(image: np.ndarray) -> np.ndarray:
    """Means of BLOCK x BLOCK pixels."""
    height, width, channels = image.shape
    return image.reshape(height // BLOCK, BLOCK, width // BLOCK, BLOCK, channels).mean(axis=(1, 3))


def compared(images: dict[str, np.ndarray]) -> dict[str, float]:
    """The engine's brightness relative to the other renders, and PSNR against Cycles."""
    ours, run, cycles = images["engine"], images["rna-run"], images["cycles"]
    return {
        "largest difference from rna-run": float(np.abs(ours - run).max()),
        "brightness over Cycles": float(ours.mean() / cycles.mean()),
        "PSNR against Cycles, dB": psnr(ours / IRRADIANCE, cycles / IRRADIANCE),
    }
