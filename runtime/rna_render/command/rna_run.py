"""`rna-run`: render a scene file."""

from __future__ import annotations

import argparse
import math
import re
import sys
import time
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from rna_render.scene.limits import MAX_FRAMES, MAX_PIXELS_A_SIDE, MAX_SAMPLES, MAX_SEED
from rna_sdk.commands.console import INTERRUPTED, command_parser, run_command
from rna_work.cluster.cluster_option import add_cluster_option

if TYPE_CHECKING:
    from rna_render.image.output import Output
    from rna_render.scene.scene_file import SceneFile

# Before the heavy imports, which are made when they are needed and are part of the way to the
# first ray.
_START = time.perf_counter()


VIEWS = ("srgb", "filmic")

FRAME_NUMBER = re.compile(r"[^%]*%(0\d)?d[^%]*")
"""A file name with one place for a number."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Entry point. Returns 0, 1 for bad input, or 130 after Ctrl-C; exits with 2 for bad usage."""
    parser = _parser()
    options = parser.parse_args(arguments)
    _sort_images(parser, options)
    _check_usage(parser, options)
    stopped = "the image under way was not written"
    return run_command(lambda: _run(options), options.debug, stopped, "render")


def _parser() -> argparse.ArgumentParser:
    parser = command_parser(
        "rna-run",
        "Render a scene of relightable neural assets, or one asset, to an image.",
        "rna-run scene.yaml --out out.exr --png out.png",
        usage="rna-run FILE --png IMAGE.png [options]\n       rna-run FILE --preview [options]",
        epilog="Scene file reference: docs/scene.md. Preview: docs/preview.md.\nCtrl-C stops the "
        "render and writes the image so far, or closes the preview.",
    )
    add = parser.add_argument
    add(
        "scene",
        metavar="FILE",
        type=Path,
        help="scene file (YAML), or a package (.rna), placed on a ground under default lights",
    )
    add(
        "--out",
        metavar="FILE",
        type=Path,
        help="linear HDR image with AOVs, .exr or .npz; .png: as by --png (path, default: none)",
    )
    add(
        "--png",
        metavar="FILE",
        type=Path,
        help="sRGB image, instead of --out or beside it (path, default: none)",
    )
    add(
        "--preview",
        action="store_true",
        help="render progressively in a browser page served on localhost until Ctrl-C; writes no "
        "files (default: off)",
    )
    add(
        "--port",
        metavar="N",
        type=_whole(1, 65535),
        help="port of the preview page (int, default: a free port)",
    )
    add(
        "--environments",
        metavar="FOLDER",
        type=Path,
        help="folder of .hdr and .exr environments offered by the preview (path, default: the "
        "folder of FILE)",
    )
    add(
        "--frames",
        metavar="RANGE",
        type=_frames,
        help="render an animation: all, 3, or 0-10; --out and --png need a frame number, such as "
        "frame.%%04d.exr; existing frames are skipped; a scene without an animation becomes a "
        "turntable, one turn over frames 0 to the last (default: one still image)",
    )
    add("--view", choices=VIEWS, help="view transform of the PNG (default: the scene's)")
    add(
        "--every",
        metavar="SECONDS",
        type=_seconds,
        help="also write intermediate images: after the first sample, then at this interval; only "
        "the final image is denoised (float, seconds, default: off)",
    )
    add(
        "--denoise",
        action="store_true",
        help="denoise with Intel Open Image Denoise (default: off)",
    )
    add(
        "--samples",
        metavar="N",
        type=_whole(1, MAX_SAMPLES),
        help="samples per pixel (int, default: the scene's)",
    )
    add(
        "--resolution",
        metavar="WxH",
        type=_resolution,
        help="image size in pixels, such as 640x480 (default: the scene's)",
    )
    add("--tier", metavar="NAME", help="tier used for every asset (default: the scene's)")
    add(
        "--seed",
        metavar="N",
        type=_whole(0, MAX_SEED),
        help="random seed (int, default: the scene's)",
    )
    add(
        "--threads",
        metavar="N",
        type=_whole(1, 4096),
        help="render threads, at most one per core (int, default: one per core)",
    )
    add(
        "--device",
        metavar="NAME",
        default="cpu",
        help="render device: cpu, or gpu with the extra `gpu`, see docs/gpu.md (default: cpu)",
    )
    add_cluster_option(parser)
    return parser


def _whole(low: int, high: int) -> Callable[[str], int]:
    def parse(text: str) -> int:
        if not re.fullmatch(r"\d{1,10}", text) or not low <= int(text) <= high:
            raise argparse.ArgumentTypeError(
                f"expected a whole number from {low} to {high}, found {text!r}"
            )
        return int(text)

    return parse


def _seconds(text: str) -> float:
    try:
        seconds = float(text)
    except ValueError:
        seconds = -1.0
    if not 0.0 <= seconds < math.inf:
        raise argparse.ArgumentTypeError(f"expected seconds, 0 or more, found {text!r}")
    return seconds


def _resolution(text: str) -> tuple[int, int]:
    side = _whole(1, MAX_PIXELS_A_SIDE)
    width, by, height = text.partition("x")
    if not by:
        raise argparse.ArgumentTypeError(f"expected WxH such as 640x480, found {text!r}")
    return side(width), side(height)


def _frames(text: str) -> tuple[int, int | None]:
    """The first frame and the last one, None for the scene's."""
    if text == "all":
        return 0, None
    number = _whole(0, MAX_FRAMES - 1)
    first, to, last = text.partition("-")
    span = number(first), number(last if to else first)
    if span[0] > span[1]:
        raise argparse.ArgumentTypeError(f"expected the lower number first, found {text!r}")
    return span


def _sort_images(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    """A PNG that --out names becomes the PNG of --png."""
    if options.out is None or options.out.suffix.lower() != ".png":
        return
    if options.png is not None:
        parser.error(f"{options.out}: --out and --png both name a PNG")
    options.out, options.png = None, options.out


def _check_usage(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    if options.out is None and options.png is None and not options.preview:
        parser.error("one of --png, --out and --preview is required")
    others = (
        ("out", "png", "frames", "every", "denoise", "cluster")
        if options.preview
        else ("port", "environments")
    )
    for name in others:
        value = getattr(options, name)
        if value is not None and value is not False:  # --every may be 0
            parser.error(f"--{name} is {'not for' if options.preview else 'only for'} --preview")
    if options.device != "cpu" and options.preview:
        parser.error(f"--preview is not for --device {options.device}")
    if options.environments is not None and not options.environments.is_dir():
        parser.error(f"{options.environments}: no such folder")
    for name in ("frames", "cluster"):
        if options.every is not None and getattr(options, name) is not None:
            parser.error(f"--every is for a still image on this machine, not for --{name}")
    for path, suffixes in ((options.out, (".exr", ".npz", ".png")), (options.png, (".png",))):
        if path is not None and path.suffix.lower() not in suffixes:
            parser.error(f"{path}: expected a name that ends with {' or '.join(suffixes)}")
        if path is not None and not path.parent.is_dir():
            parser.error(f"{path}: there is no folder {path.parent}")
        if path is not None and bool(FRAME_NUMBER.fullmatch(path.name)) != bool(options.frames):
            parser.error(
                f"{path}: expected a place for the frame's number, such as %04d"
                if options.frames
                else f"{path}: has a place for a frame's number, which needs --frames"
            )


def _run(options: argparse.Namespace) -> int:
    from rna_render.command.compilation import compilations_reported

    with compilations_reported(options.scene):
        return _shown(options)


def _shown(options: argparse.Namespace) -> int:
    from rna_render.command.sequence import animated, frame_numbers, render_sequence
    from rna_render.command.terminal import tell_size
    from rna_render.image.denoise import Denoiser
    from rna_render.image.output import Output
    from rna_render.paths.integrator_factory import check_device
    from rna_render.scene.scene_file import read_scene
    from rna_work.executors import open_executor

    names = ("samples", "resolution", "seed", "tier", "view")
    changes = {name: value for name in names if (value := getattr(options, name)) is not None}
    scene_file = read_scene(options.scene).with_changes(**changes)
    check_device(options.device, scene_file)
    tell_size(scene_file)
    threads = _use_threads(options.threads)
    if options.preview:
        from rna_render.preview.preview_command import preview

        preview(scene_file, threads, options.port or 0, options.environments)
        return 0
    denoiser = Denoiser(threads) if options.denoise else None
    output = Output(options.out, options.png, denoiser)
    if options.frames is None and options.cluster is None:
        return _render_still(scene_file, output, options)
    if options.frames is None:
        return _render_in_pieces(scene_file, output, options)
    scene_file = animated(scene_file, options.frames[1])
    numbers = frame_numbers(scene_file, *options.frames)
    with open_executor(options.cluster) as executor:
        return render_sequence(
            scene_file,
            numbers,
            output,
            threads=options.threads,
            started=_START,
            executor=executor,
            device=options.device,
        )


def _use_threads(count: int | None) -> int:
    from rna_sdk.machine.kernel_threads import limit_kernel_threads

    return limit_kernel_threads(count)


def _render_still(scene_file: SceneFile, output: Output, options: argparse.Namespace) -> int:
    from rna_render.command.terminal import (
        Interim,
        Interrupt,
        cost_lines,
        render_with_bar,
        tell_clamp,
        tell_tiers,
    )
    from rna_render.paths.integrator_factory import open_renderer
    from rna_render.paths.world_in_time import load_world
    from rna_render.world.scene_sources import files_of
    from rna_render.world.world_loading import warn_of_darkness

    scene, resolved = scene_file.scene, scene_file.resolved
    output.check(files_of(scene_file))
    opener = partial(open_renderer, options.device, resolved, next_camera=scene_file.camera_after)
    world = load_world(scene_file, open_renderer=opener)
    tell_tiers(scene.quality, world)
    warn_of_darkness(scene_file.path, scene.lights, world)
    if options.device == "cpu":
        for line in cost_lines([asset.path for asset in resolved.assets], world):
            print(line, file=sys.stderr)
    with Interrupt() as interrupt:
        film = render_with_bar(
            scene,
            opener(world),
            world,
            interrupt.requested,
            first_band=lambda: f"first pixels after {time.perf_counter() - _START:.2f} s",
            on_sample=Interim(options.every, partial(output.write_so_far, scene)),
        )
    if not film.samples:
        print("stopped before the first sample was finished; nothing was written", file=sys.stderr)
        return INTERRUPTED
    stopped = interrupt.requested() and film.samples < scene.samples
    if stopped:
        print(
            f"stopped: the image is the mean of {film.samples} of {scene.samples} samples",
            file=sys.stderr,
        )
    output.write(scene, film)
    tell_clamp(resolved, film)
    for path in output.paths():
        print(f"wrote {path}")
    return INTERRUPTED if stopped else 0


def _render_in_pieces(scene_file: SceneFile, output: Output, options: argparse.Namespace) -> int:
    from rna_render.command.finished_pieces import finished_pixels
    from rna_render.command.pieces import render_pieces
    from rna_render.command.terminal import tell_clamp
    from rna_render.world.scene_sources import files_of
    from rna_sdk.files.owned_folder import owned
    from rna_work.executors import open_executor

    output.check(files_of(scene_file))
    first = output.paths()[0]
    folder = first.with_name(f"{first.name}.pieces")
    try:
        with (
            owned(folder, "rna-run") as work_folder,
            open_executor(options.cluster) as executor,
        ):
            film, finished = render_pieces(
                scene_file, executor, options.threads, folder, options.device
            )
            output.write(scene_file.scene, film)
            tell_clamp(scene_file.scene, film)
            finished.remove()
            work_folder.dissolve()
    except KeyboardInterrupt:
        scene = scene_file.scene
        share = finished_pixels(folder) / math.prod(scene.resolution)
        print(
            f"stopped: no image was written; {share:.0%} of its pixels, each with all "
            f"{scene.samples} samples, are in {folder}; the same command goes on",
            file=sys.stderr,
        )
        return INTERRUPTED
    for path in output.paths():
        print(f"wrote {path}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
