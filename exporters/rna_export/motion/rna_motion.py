"""`rna-motion`: writes the motion of a package, from an animated source, as a file."""

from __future__ import annotations

import argparse
import re
import sys
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING

from rna_export.capture.orientation import AXES, joined_axes
from rna_sdk.commands.console import command_parser, run_command, split_script_arguments
from rna_sdk.files.file_kinds import is_gltf

if TYPE_CHECKING:
    import numpy as np

    from rna_sdk.package import Curves, Mesh, SourceVertices


def parser() -> argparse.ArgumentParser:
    """The options of `rna-motion`."""
    p = command_parser(
        "rna-motion",
        "Convert the animation of a model to a motion file for its package, used by rna-run.",
        "rna-motion walk.blend fox.rna --out walk.rnam",
        epilog="At the rest frame the model must have the package's shape. glTF is read directly; "
        "other formats\nare evaluated in Blender. Arguments after -- are passed to the source, as "
        "in rna-capture.",
    )
    add = p.add_argument
    add("source", type=Path, help="animated model (path): glTF, .blend, Alembic, USD or a script")
    add("package", type=Path, help="package of the same model (path)")
    add("--out", type=Path, required=True, metavar="FILE", help="motion file (path, required)")
    add(
        "--made-from",
        type=Path,
        metavar="FILE",
        help="glTF of the same character that the package was made from, whose rest pose the "
        "animated one need not have (path, default: the animated one)",
    )
    add("--clip", metavar="NAME", help="name of a glTF's animation (text, default: the first)")
    add(
        "--rate",
        type=float,
        help="frames per second (float, default: 24 for glTF, else the scene's)",
    )
    add(
        "--frames",
        type=_frames,
        metavar="A-B",
        help="frames to write, both included (default: all of the source)",
    )
    add(
        "--rest-frame",
        type=int,
        metavar="N",
        help="frame of the source that has the package's shape (int, default: as captured)",
    )
    for name in ("front", "up"):
        add(f"--{name}", choices=AXES, metavar="AXIS", help="as for rna-capture (default: none)")
    return p


def main(argv: Sequence[str] | None = None) -> int:
    """Entry point; returns the exit status."""
    given, script = split_script_arguments(list(sys.argv[1:] if argv is None else argv))
    p = parser()
    options = p.parse_args(joined_axes(given))
    if options.rate is not None and not options.rate > 0:
        p.error(f"--rate: expected more than 0, found {options.rate:g}")
    for name in ("clip", "made_from"):
        if getattr(options, name) is not None and not is_gltf(options.source):
            p.error(f"--{name.replace('_', '-')} is for glTF")
    run = lambda: _run(options, tuple(script))  # noqa: E731
    return run_command(run, options.debug, "nothing was written", "capture")


def _frames(text: str) -> tuple[int, int]:
    match = re.fullmatch(r"(-?\d{1,6})(?:-(-?\d{1,6}))?", text)
    span = (int(match[1]), int(match[2] or match[1])) if match else (1, 0)
    if span[0] > span[1]:
        raise argparse.ArgumentTypeError(f"expected frames such as 1-24, found {text!r}")
    return span


def _run(options: argparse.Namespace, script: tuple[str, ...]) -> None:
    from rna_sdk.files.outputs import check_outputs
    from rna_sdk.motion import write_motion
    from rna_sdk.package import Package
    from rna_work.bar import Bar

    made_from = [] if options.made_from is None else [options.made_from]
    check_outputs([options.out], [options.source, options.package, *made_from])
    with Package.open(options.package) as package:
        parts = range(len(package.manifest.parts))
        geometries = [package.geometry(k) for k in parts]
        numbers = [package.source_vertices(k) for k in parts]
        captured = package.manifest.provenance.rest_frame
    options.rest_frame = _rest_frame(options, captured)
    with ExitStack() as stack:
        frames, count, rate = (
            _of_gltf(options, geometries)
            if is_gltf(options.source)
            else _of_blender(options, script, geometries, numbers, stack)
        )
        bar = Bar(frames, total=count, unit="frame", leave=False)
        write_motion(options.out, geometries, bar, count=count, rate=rate)
    size = options.out.stat().st_size
    print(
        f"wrote {options.out}: {count} frames at {rate:g} a second, {size / 1e6:.1f} MB\n"
        f"next: give the asset `motion: {options.out.name}` in a scene file (docs/scene.md)"
    )


def _rest_frame(options: argparse.Namespace, captured: int | None) -> int | None:
    """The requested frame, or the frame of the package's capture."""
    from rna_sdk.errors import MotionError

    given: int | None = options.rest_frame
    if given is None or captured in (None, given):
        return captured if given is None else given
    found = f"was captured at frame {captured}, found --rest-frame {given}"
    raise MotionError(f"{options.package}: {found}: leave it out, or capture that frame")


_Frames = tuple["Iterator[list[np.ndarray]]", int, float]
"""Positions by frame, how many frames, and their rate."""


def _of_gltf(options: argparse.Namespace, geometries: Sequence[Mesh | Curves]) -> _Frames:
    from rna_render import open_asset_motion

    rate = options.rate or 24.0
    motion = open_asset_motion(
        options.source,
        geometries,
        options.package.name,
        clip=options.clip,
        rate=rate,
        rest_frame=options.rest_frame,
        made_from=options.made_from,
    )
    first, last = options.frames or (0, motion.frames - 1)
    return map(motion.positions, range(first, last + 1)), last + 1 - first, rate


def _of_blender(
    options: argparse.Namespace,
    script: tuple[str, ...],
    geometries: Sequence[Mesh | Curves],
    vertices: Sequence[SourceVertices | None],
    stack: ExitStack,
) -> _Frames:
    from rna_export.capture.blender_process.blender_env import find_or_set_up
    from rna_export.capture.blender_process.blender_process import Source
    from rna_export.capture.blender_process.blender_worker import BlenderWorker
    from rna_export.capture.blender_process.source_file import check_source
    from rna_export.capture.geometry.followed_source import FollowedSource
    from rna_sdk.errors import CaptureError

    check_source(options.source)
    axes = {"front": options.front, "up": options.up}
    source = Source(options.source, script, rest_frame=options.rest_frame, **axes)
    folder = stack.enter_context(tempfile.TemporaryDirectory(prefix="rna-motion-"))
    worker = stack.enter_context(BlenderWorker(find_or_set_up(), source, Path(folder), threads=1))
    first, last, rate = worker.frame_span()
    followed = FollowedSource(worker, geometries, options.package.name, vertices)
    how = "the numbers of its vertices" if followed.by_number else "places at rest"
    print(f"{options.package.name} follows {options.source.name} by {how}")
    first, last = options.frames or (first, last)
    if last < first:
        raise CaptureError(f"the source has frames {first} to {last}: give --frames")
    numbers = range(first, last + 1)
    return map(followed.positions, numbers), len(numbers), options.rate or rate


if __name__ == "__main__":
    sys.exit(main())
