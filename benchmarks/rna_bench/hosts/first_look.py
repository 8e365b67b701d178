"""How soon the viewer shows a fully lit picture, with lobes for the environment and without.

    rna-bench first-look scene.yaml --out benchmarks/results/first-look.json

The scene's asset has lobes (RNA_environment). Two pages of the viewer in headless Chromium on
SwiftShader, WebGPU: one with the first look, one without (`?look=0`), which also gives the
converged picture. FLIP of what is on the canvas, the filter of first samples included, to that
picture; milliseconds from opening the page, the bundle in the cache.

    first_look    time and FLIP of the first picture in full size
    same_quality  time and samples until the page without it has that FLIP
    share         the first time over the second
    pictures      samples, ms, FLIP and brightness of each page's pictures in full size; brightness:
                  sum of R, G, B, linear, over that of the converged picture, where it differs from
                  the backdrop in its corner
"""

from __future__ import annotations

import argparse
import base64
import io
import os
from pathlib import Path
from typing import Any

import flip_evaluator
import numpy as np
from PIL import Image

from rna_bench.bench_options import add_out
from rna_bench.results import publish
from rna_sdk.errors import RnaError
from rna_view.site_files import Site
from rna_view.site_source import site_for
from tests.render.chromium import INSTALL, SOFTWARE_GPU, find_chromium, open_page
from tests.web.pages import served

TIMEOUT_S = 3600.0
KEPT = "(rounds <= 16 || rounds % 8 === 0)"

# What the canvas has after each picture in full size, from before the first one on.
LISTENING = f"""(() => {{
    const {{ viewer, canvas }} = rnaViewer;
    globalThis.pictures = [];
    viewer.addEventListener("shown", () => {{
        const ms = performance.now(), {{ rounds, scale }} = viewer.stats;
        if (scale !== 1 || !{KEPT}) return;
        const own = {{ ms, rounds, first: viewer.shown.firstLook }};
        pictures.push(own);
        canvas.toBlob(async (blob) => {{
            const bytes = new Uint8Array(await blob.arrayBuffer());
            let text = "";
            for (let k = 0; k < bytes.length; k += 8192) {{
                text += String.fromCharCode(...bytes.subarray(k, k + 8192));
            }}
            own.png = btoa(text);
        }});
    }});
}})()"""


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("scene", type=Path, help="scene file of one asset, which has lobes")
    parser.add_argument(
        "--resolution", type=int, nargs=2, default=(240, 135), help="width, height, pixels"
    )
    parser.add_argument("--samples", type=int, default=128, help="of the converged picture")
    parser.add_argument("--pictures", type=Path, help="folder for the pictures that are compared")
    add_out(parser)


def run(args: argparse.Namespace) -> None:
    site, load = site_for(args.scene), os.getloadavg()[0]
    without = in_chromium(site, args.resolution, args.samples, "&look=0")
    with_look = in_chromium(site, args.resolution, 8, "")
    if not with_look[0]["first"]:
        raise RnaError(f"{args.scene}: the asset has no lobes, found no RNA_environment in it")
    converged = without[-1]["image"]
    for own in (*without, *with_look):
        own["flip"] = round(flip(own["image"], converged), 4)
        own["brightness"] = brightness(own["image"], converged)
    first = with_look[0]
    same = next(own for own in without if own["flip"] <= first["flip"])
    if args.pictures:
        save(args.pictures, {"first-look": first, "same-quality": same, "converged": without[-1]})
    report = {
        "scene": str(args.scene),
        "resolution": list(args.resolution),
        "load_at_start": round(load, 1),
        "first_look": numbers(first),
        "same_quality": numbers(same),
        "share": round(first["ms"] / same["ms"], 3),
        "pictures": {
            "first_look": [numbers(own) for own in with_look],
            "without": [numbers(own) for own in without],
        },
    }
    publish(report, args)


def numbers(picture: dict[str, Any]) -> dict[str, Any]:
    """What the report says of a picture."""
    measured = {name: picture[name] for name in ("flip", "brightness")}
    return {"samples": picture["rounds"], "ms": round(picture["ms"]), **measured}


def in_chromium(
    site: Site, resolution: tuple[int, int], samples: int, query: str
) -> list[dict[str, Any]]:
    """Pictures of a page until it has so many samples; it is opened twice, then from the cache."""
    chromium = find_chromium()
    if chromium is None:
        raise RnaError(INSTALL)
    with served(site) as server, open_page(chromium, *resolution, SOFTWARE_GPU) as page:
        address = f"{server.url}?api=webgpu&dpr=1&ui=0&rounds={samples}{query}"
        page.call("Page.navigate", url=address)
        page.wait_for("globalThis.rnaViewer?.viewer?.hasShown", TIMEOUT_S)
        page.call("Page.navigate", url=f"{address}&again=1")
        page.wait_for(
            "location.search.includes('again') && globalThis.rnaViewer?.viewer", TIMEOUT_S
        )
        page.evaluate(LISTENING)
        done = f"pictures.at(-1)?.rounds >= {samples} && pictures.every((own) => own.png)"
        page.wait_for(done, TIMEOUT_S)
        found: list[dict[str, Any]] = page.evaluate("pictures")
    for own in found:
        image = Image.open(io.BytesIO(base64.b64decode(own.pop("png")))).convert("RGB")
        own["image"] = np.asarray(image, np.float32) / 255.0
    return found


def flip(image: np.ndarray, reference: np.ndarray) -> float:
    """Mean FLIP of two pictures (h, w, 3), values of the screen from 0 to 1."""
    _, mean, _ = flip_evaluator.evaluate(reference, image, "LDR", applyMagma=False)
    return float(mean)


def brightness(image: np.ndarray, reference: np.ndarray) -> list[float]:
    """Of two pictures as flip takes them: R, G, B."""
    seen = np.abs(reference - reference[0, 0]).max(axis=-1) > 1 / 255
    own, true = (
        np.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)
        for encoded in (image[seen], reference[seen])  # sRGB, IEC 61966-2-1
    )
    ratio = own.sum(axis=0) / true.sum(axis=0)
    return [round(float(value), 4) for value in ratio]


def save(folder: Path, pictures: dict[str, dict[str, Any]]) -> None:
    """PNG by name."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, own in pictures.items():
        pixels = np.round(255 * own["image"]).astype(np.uint8)
        Image.fromarray(pixels).save(folder / f"{name}.png")
