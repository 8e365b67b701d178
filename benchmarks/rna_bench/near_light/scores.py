"""PSNR without noise, FLIP and brightness of checkpoints by the distance of the lamp."""

from __future__ import annotations

import argparse
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from rna_export.capture.dataset.validation_view import picked
from rna_export.metrics import IRRADIANCE, display, flip, psnr_without_noise
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.validation import answer
from rna_render.lights import LUMINANCE

Image = dict[str, np.ndarray]
_NO_QUERY = ("halves", "pixel", "irradiance", "visible")


def images_of(path: Path) -> Iterator[tuple[str, Image]]:
    """Names and fields of the images in a file of references or limits."""
    with np.load(path) as data:
        arrays = {key: data[key] for key in data.files if "/" in key}
    for name in dict.fromkeys(key.split("/")[0] for key in arrays):
        fields = {k.split("/")[1]: v for k, v in arrays.items() if k.startswith(f"{name}/")}
        yield name, fields


def exposed(image: Image, radiance: np.ndarray) -> np.ndarray:
    """Radiance (..., n, 3) at irradiance 1 of each point as the metrics take it.

    The 95th percentile of the image's luminance is shown at 0.8.
    """
    e = image["irradiance"][:, None]
    white = np.percentile((image["halves"].mean(axis=0) * e) @ LUMINANCE, 95.0)
    return np.asarray(radiance * e * (0.8 / white / IRRADIANCE), np.float32)


def answered(model: NeuralAsset, image: Image) -> np.ndarray:
    """Radiance of the rows at irradiance 1, (n, 3)."""
    queries = {name: rows for name, rows in image.items() if name not in _NO_QUERY}
    return picked(image["visible"], *answer(model, queries))


def of_image(image: Image, radiance: np.ndarray, side: int) -> tuple[float, float, float]:
    """PSNR without noise in dB, FLIP and the brightness over Cycles'."""
    halves = exposed(image, image["halves"])
    ours = display(exposed(image, radiance)) / IRRADIANCE
    pictures = np.zeros((2, side**2, 3), np.float32)
    pictures[0, image["pixel"]], pictures[1, image["pixel"]] = ours, halves.mean(axis=0)
    error = flip(*pictures.reshape(2, side, side, 3))[0]
    brightness = exposed(image, radiance).mean() / halves.mean()
    return psnr_without_noise(ours, *halves).db, error, float(brightness)


def limited(image: Image, limit: Image, radiance: np.ndarray) -> tuple[float, float]:
    """Mean squared errors as displayed at the limit's pixels: of distant light, of a model."""
    rows = limit["rows"]
    some = {k: v[:, rows] if k == "halves" else v[rows] for k, v in image.items()}
    scale = exposed(image, np.ones_like(radiance))[rows] * IRRADIANCE
    halves, far = some["halves"] * scale, np.minimum(limit["halves"] * scale, 1.0)
    ours = np.minimum(radiance[rows] * scale, 1.0)
    weight = np.mean(halves <= 1.0, axis=0)
    of_far = np.mean(weight * (far[0] - halves[0]) * (far[1] - halves[1]))
    return float(of_far), float(np.mean(weight * (ours - halves[0]) * (ours - halves[1])))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("references", type=Path)
    parser.add_argument("checkpoints", type=Path, nargs="+")
    parser.add_argument("--limit", type=Path)
    args = parser.parse_args()
    side = int(np.load(args.references)["side"])
    limits = dict(images_of(args.limit)) if args.limit else {}
    for path in args.checkpoints:
        model, scores, errors = load_checkpoint(path).model, defaultdict(list), defaultdict(list)
        for name, image in images_of(args.references):
            distance, radiance = float(name.split("-")[-1]), answered(model, image)
            scores[distance].append(of_image(image, radiance, side))
            if name in limits:
                errors[distance].append(limited(image, limits[name], radiance))
        print(path)
        for distance, of_images in sorted(scores.items()):
            db, error, brightness = np.mean(of_images, axis=0)
            print(f"  {distance:4g} sizes: {db:.2f} dB, FLIP {error:.4f}, light {brightness:.3f}")
        for distance, pairs in sorted(errors.items()):
            far, ours = np.mean(pairs, axis=0)
            print(
                f"  {distance:4g} sizes: squared error of distant light {far:.2e}, ours {ours:.2e}"
            )


if __name__ == "__main__":
    main()
