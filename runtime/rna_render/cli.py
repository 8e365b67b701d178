"""`rna-run`: render a scene file."""

from __future__ import annotations

import argparse
import os
import re
import signal
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from rna_render.limits import MAX_PIXELS_A_SIDE, MAX_SAMPLES, MAX_SEED
from rna_sdk.console import INTERRUPTED, command_parser, run_command

if TYPE_CHECKING:
    from rna_render.film import Film
    from rna_render.scene_file import SceneFile
    from rna_render.scene_model import Scene

# Before the heavy imports, which are made when they are needed and are part of the way to the
# first ray.
_START = time.perf_counter()


def main(arguments: Sequence[str] | None = None) -> int:
    """Entry point. Returns 0, 1 for bad input, or 130 after Ctrl-C; exits with 2 for bad usage."""
    parser = _parser()
    options = parser.parse_args(arguments)
    _check_usage(parser, options)
    return run_command(lambda: _run(options), options.debug, "nothing was written")


def _parser() -> argparse.ArgumentParser:
    parser = command_parser(
        "rna-run",
        "Render a scene of relightable neural assets to an image.",
        "rna-run scene.yaml --out out.exr --png out.png",
        usage="rna-run SCENE --out IMAGE.exr [options]\n       rna-run SCENE --preview [options]",
        epilog="docs/scene.md says what a scene file may contain, docs/preview.md what the preview "
        "can do.\nCtrl-C ends the render early and writes what is there, or ends the preview.",
    )
    add = parser.add_argument
    add("scene", metavar="SCENE", type=Path, help="the scene file (YAML)")
    add("--out", metavar="FILE", type=Path, help="linear EXR with AOVs to write")
    add("--png", metavar="FILE", type=Path, help="sRGB PNG to write beside it (default: none)")
    add(
        "--preview",
        action="store_true",
        help="show the scene in a browser page, which this computer alone can open, while it is "
        "rendered, until Ctrl-C; nothing is written (default: off)",
    )
    add(
        "--port",
        metavar="N",
        type=_whole(1, 65535),
        help="of the page of --preview (default: any that is free)",
    )
    add(
        "--environments",
        metavar="FOLDER",
        type=Path,
        help="more .hdr and .exr images for the page of --preview (default: those beside SCENE)",
    )
    add(
        "--samples",
        metavar="N",
        type=_whole(1, MAX_SAMPLES),
        help="samples a pixel (default: the scene's)",
    )
    add(
        "--resolution",
        metavar="WxH",
        type=_resolution,
        help="pixels, such as 640x480 (default: the scene's)",
    )
    add("--tier", metavar="NAME", help="tier of every asset (default: the scene's)")
    add(
        "--seed",
        metavar="N",
        type=_whole(0, MAX_SEED),
        help="of the random numbers (default: the scene's)",
    )
    add(
        "--threads",
        metavar="N",
        type=_whole(1, 4096),
        help="threads to use, at most one a core (default: one a core)",
    )
    add("--debug", action="store_true", help="show the traceback of an error (default: off)")
    return parser


def _whole(low: int, high: int) -> Callable[[str], int]:
    def parse(text: str) -> int:
        if not re.fullmatch(r"\d{1,10}", text) or not low <= int(text) <= high:
            raise argparse.ArgumentTypeError(
                f"expected a whole number from {low} to {high}, found {text!r}"
            )
        return int(text)

    return parse


def _resolution(text: str) -> tuple[int, int]:
    side = _whole(1, MAX_PIXELS_A_SIDE)
    width, by, height = text.partition("x")
    if not by:
        raise argparse.ArgumentTypeError(f"expected WxH such as 640x480, found {text!r}")
    return side(width), side(height)


def _check_usage(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    if options.out is None and not options.preview:
        parser.error("one of --out and --preview is required")
    others = ("out", "png") if options.preview else ("port", "environments")
    for name in others:
        if getattr(options, name) is not None:
            parser.error(f"--{name} is {'not for' if options.preview else 'only for'} --preview")
    if options.environments is not None and not options.environments.is_dir():
        parser.error(f"{options.environments}: no such folder")
    for path, suffix in ((options.out, ".exr"), (options.png, ".png")):
        if path is not None and path.suffix.lower() != suffix:
            parser.error(f"{path}: expected a name that ends with {suffix}")
        if path is not None and not path.parent.is_dir():
            parser.error(f"{path}: there is no folder {path.parent}")


def _run(options: argparse.Namespace) -> int:
    from rna_render.scene_file import read_scene

    names = ("samples", "resolution", "seed", "tier")
    changes = {name: value for name in names if (value := getattr(options, name)) is not None}
    scene_file = read_scene(options.scene).with_changes(**changes)
    threads = _use_threads(options.threads)
    if options.preview:
        from rna_render.preview.command import preview

        preview(scene_file, threads, options.port or 0, options.environments)
        return 0
    film = _render(scene_file, threads)
    stopped = film.samples < scene_file.scene.samples
    if not film.samples:
        print("stopped before the first sample was finished; nothing was written", file=sys.stderr)
        return INTERRUPTED
    if stopped:
        print(
            f"stopped: the image is the mean of {film.samples} of "
            f"{scene_file.scene.samples} samples",
            file=sys.stderr,
        )
    for path in _write_images(options, scene_file.scene, film):
        print(f"wrote {path}")
    return INTERRUPTED if stopped else 0


def _use_threads(count: int | None) -> int:
    # libgomp's threads spin while they have nothing to do, and take the cores from ONNX Runtime's.
    # It reads this when numba loads it.
    os.environ.setdefault("OMP_WAIT_POLICY", "passive")
    import numba

    threads = min(count or numba.config.NUMBA_NUM_THREADS, numba.config.NUMBA_NUM_THREADS)
    numba.set_num_threads(threads)
    return threads


def _render(scene_file: SceneFile, threads: int) -> Film:
    from tqdm import tqdm

    from rna_render.render import load_world, make_integrator, render

    scene = scene_file.scene
    world = load_world(scene_file, threads)
    total = scene.resolution[0] * scene.resolution[1] * scene.samples
    bar = tqdm(total=total, unit="ray", unit_scale=True, desc="rendering", leave=False)

    def report_start() -> None:
        bar.write(f"first rays traced after {time.perf_counter() - _START:.2f} s", file=sys.stderr)

    integrator = make_integrator(scene, world, report_start)
    with bar, _Interrupt() as interrupt:
        return render(scene, integrator, stop=interrupt.requested, progress=bar.update)


class _Interrupt:
    """While entered, the first Ctrl-C asks for a stop and the second one ends the program."""

    def __init__(self) -> None:
        self._asked = False

    def requested(self) -> bool:
        return self._asked

    def __enter__(self) -> _Interrupt:
        self._previous = signal.signal(signal.SIGINT, self._ask)
        return self

    def __exit__(self, *exception: object) -> None:
        signal.signal(signal.SIGINT, self._previous)

    def _ask(self, number: int, frame: object) -> None:
        if self._asked:
            raise KeyboardInterrupt
        self._asked = True
        print("\nstopping after this band of pixels; Ctrl-C again ends at once", file=sys.stderr)


def _write_images(options: argparse.Namespace, scene: Scene, film: Film) -> list[Path]:
    import numpy as np

    from rna_render.images import write_exr, write_png

    channels = film.channels()
    attributes = {"rnaScene": scene.model_dump_json(), "rnaSamples": str(film.samples)}
    write_exr(options.out, channels, attributes)
    if options.png is None:
        return [options.out]
    rgb = np.stack([channels[name] for name in "RGB"], axis=-1)
    write_png(options.png, rgb, scene.exposure)
    return [options.out, options.png]


if __name__ == "__main__":
    sys.exit(main())
