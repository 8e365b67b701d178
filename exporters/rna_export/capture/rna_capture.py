"""`rna-capture`: renders an asset under all view and light directions into a dataset."""

from __future__ import annotations

import argparse
import hashlib
import math
import sys
import tempfile
from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pydantic import ValidationError

from rna_export.blender.rna_sources.source_formats import SOURCE_FORMATS
from rna_export.capture.blender_process import blender_env, source_help
from rna_export.capture.blender_process.source_file import SUFFIXES, check_source
from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.frame_options import FRAME_SETTINGS, add_frames
from rna_export.capture.orientation import AXES, joined_axes
from rna_export.machine import keep_freed_memory
from rna_sdk.commands.console import (
    command_line,
    command_parser,
    run_command,
    split_script_arguments,
)
from rna_sdk.errors import CaptureError
from rna_sdk.files.owned_folder import owned
from rna_sdk.machine.cores import core_count
from rna_work.cluster.cluster_option import add_cluster_option
from rna_work.cluster.store import add_store_option
from rna_work.executors import open_executor

if TYPE_CHECKING:
    from rna_export.capture.dataset.dataset_folder import Dataset
    from rna_render.scene import SceneFile

_GO_ON = "run the same command again to resume"
_Z_UP = ", ".join(suffix for suffix, known in SOURCE_FORMATS.items() if known.up == "Z")
_BECOMES = {
    "front": "+Z (X, Y, Z, -X, -Y or -Z, default: -Y for Z up, as in Blender; else Z, as in glTF)",
    "up": f"+Y (as --front, default: Z for {_Z_UP}; upAxis for USD; else Y)",
}
_OPTIONS = (  # fields of CaptureSettings
    "samples",
    "rays",
    "lights",
    "domain",
    "parts",
    "sharpest",
    "glass",
    "normal_texels",
    "texture_size",
    "validation_views",
    "validation_resolution",
    "validation_samples",
    "seed",
)
_CHOICES = {
    "domain": ("sphere", "hemisphere"),
    "parts": ("kinds", "objects"),
    "glass": ("leave", "keep"),
}


def parser() -> argparse.ArgumentParser:
    """The options of `rna-capture`."""
    p = command_parser(
        "rna-capture",
        "Render an asset under all view and light directions with Blender Cycles.",
        "rna-capture helmet.gltf --out helmet.rays/ --minutes 30",
        epilog="The same command resumes an interrupted capture.\nArguments after -- are passed to "
        "a Python source, or set properties of a groom, Alembic or\nUSD file; to list them: "
        "rna-capture groom.tfx -- --help",
    )
    p.add_argument("source", nargs="?", type=Path, help=f"model (path), one of {SUFFIXES}")
    p.add_argument(
        "--out",
        type=Path,
        metavar="FOLDER",
        help="dataset to write or resume (path, no default: required with a source)",
    )
    p.add_argument(
        "--estimate",
        action="store_true",
        help="print the expected speedup over Cycles in scenes, then exit; excludes --out "
        "(default: off)",
    )
    p.add_argument(
        "--setup-blender",
        action="store_true",
        help="install Blender's Python module in its own environment, then exit (default: off)",
    )
    add_scene(p)
    p.add_argument(
        "--minutes",
        type=float,
        help="wall-clock budget of the whole command; sets --lights, and shrinks the validation "
        "images if they would take more than a quarter of it (float, default: no limit)",
    )
    add_settings(p, _OPTIONS)
    add_frames(p)
    add_workers(p)
    return p


def add_scene(p: argparse.ArgumentParser) -> None:
    """The option for a scene that limits a capture."""
    p.add_argument(
        "--for",
        dest="for_scene",
        type=Path,
        metavar="SCENE",
        help="capture only the view and light directions that this scene file uses (path, default: "
        "all of --domain)",
    )


def add_settings(p: argparse.ArgumentParser, names: Sequence[str]) -> None:
    """Options for these fields of `CaptureSettings`, and for the geometry."""
    for name in names:
        info = CaptureSettings.model_fields[name]
        p.add_argument(
            "--" + name.replace("_", "-"),
            type=type(info.default),
            choices=_CHOICES.get(name),
            help=f"{info.description or 'random seed'} ({_usual(name)})",
        )
    for name in ("front", "up"):
        p.add_argument(
            f"--{name}",
            choices=AXES,
            metavar="AXIS",
            help=f"{CaptureSettings.model_fields[name].description}, mapped to {_BECOMES[name]}",
        )
    p.add_argument(
        "--exact-geometry",
        action="store_const",
        const=True,
        help=f"{CaptureSettings.model_fields['exact_geometry'].description} (default: off)",
    )


def add_workers(p: argparse.ArgumentParser) -> None:
    """The options `--workers`, `--cluster` and `--store`."""
    p.add_argument(
        "--workers",
        type=int,
        help=f"single-threaded Blender processes (int, default: one per core, here {core_count()})",
    )
    add_cluster_option(p)
    add_store_option(p)


def _usual(name: str) -> str:
    default = CaptureSettings.model_fields[name].default
    hair, both = (getattr(CaptureSettings.usual(kind), name) for kind in ("fiber", "both"))
    if name == "sharpest":
        return "float, default: of the smoothest material, within 0.035 to 0.14"
    text = f"{type(default).__name__}, default {default}"
    text += f", for hair {hair}" if hair != default else ""
    return text + (f", with a surface {both}" if both != hair else "")


def main(argv: list[str] | None = None) -> int:
    """Entry point; returns the exit status."""
    command_line, arguments = split_script_arguments(argv)
    options = parser()
    args = options.parse_args(joined_axes(command_line))
    if args.source is not None and source_help.is_requested(arguments):
        return run_command(lambda: source_help.show(args.source), args.debug, _GO_ON, "capture")
    if args.estimate and (args.source is None or args.out is not None):
        options.error("--estimate takes a source and writes nothing: give no --out")
    if not (args.setup_blender or args.estimate) and (args.source is None or args.out is None):
        options.error("a source and --out are required (or --estimate, or --setup-blender)")
    if args.minutes is not None and args.lights is not None:
        options.error("--minutes sets --lights: give only one of them")
    for name in ("minutes", "workers"):
        value = getattr(args, name)
        if value is not None and not 0 < value < math.inf:
            options.error(f"argument --{name}: expected a number above 0, found {value:g}")
    check_settings(args, options)
    return run_command(lambda: _run(args, arguments), args.debug, _GO_ON, "capture")


def given_settings(args: argparse.Namespace) -> dict[str, Any]:
    """The settings given on the command line."""
    return {
        name: value
        for name in (*_OPTIONS, *FRAME_SETTINGS, "front", "up", "exact_geometry")
        if (value := getattr(args, name, None)) is not None
    }


def check_settings(args: argparse.Namespace, options: argparse.ArgumentParser) -> None:
    """Exit with an error line for the first invalid setting."""
    if args.for_scene is not None and args.domain is not None:
        options.error("--for sets the domain: give only one of --for and --domain")
    if args.poses and (args.for_scene is not None or args.domain == "hemisphere"):
        options.error("--poses turn the directions of rays: give neither --for nor a hemisphere")
    try:
        CaptureSettings(**given_settings(args))
    except ValidationError as error:
        first = error.errors()[0]
        name = str(first["loc"][0]).replace("_", "-")
        options.error(f"argument --{name}: {first['msg']}, found {first['input']}")


def _run(args: argparse.Namespace, arguments: tuple[str, ...]) -> None:
    if args.setup_blender:
        print(f"Blender {blender_env.BPY_VERSION} is ready: {blender_env.set_up()}")
        return
    check_source(args.source)
    if args.estimate:
        _estimate(args, arguments)
        return
    from rna_export.capture.blender_process.blender_process import Source
    from rna_export.capture.capture_run import CaptureWorkers, begin, finish
    from rna_export.capture.time_plan import TimeLimit
    from rna_render.scene import read_scene

    keep_freed_memory()
    given = given_settings(args)
    for_scene = None if args.for_scene is None else read_scene(args.for_scene)
    limit = None if args.minutes is None else TimeLimit(args.minutes)
    python = blender_env.find_python()
    with (
        owned(args.out, "rna-capture") as folder,
        folder.scratch() as scratch,
        open_executor(args.cluster) as executor,
    ):
        workers = CaptureWorkers(python, scratch, args.workers, executor, args.store)
        begun = _is_dataset(args.out)
        if begun:
            dataset = _continue(args.out, args.source, arguments, given)
            _check_scene(dataset, for_scene)
            settings = dataset.manifest.settings
        else:
            settings = CaptureSettings(**given)
        source = Source.captured(args.source, arguments, settings)
        if not begun:
            print(f"opening {args.source.name} in Blender", flush=True)
            dataset = begin(source, given, args.out, workers, limit, print, for_scene)
        finish(dataset, source, workers, limit)
    runs = Path("runs", args.source.stem)
    train = command_line("rna-train", args.out, "--preset", "small", "--out", runs)
    print(f"wrote {args.out}\nnext: {train}")


def _estimate(args: argparse.Namespace, arguments: tuple[str, ...]) -> None:
    """Print the materials of the source and its expected gain."""
    from rna_export.capture.blender_process.blender_process import Source
    from rna_export.capture.capture_run import CaptureWorkers, measured_pilot
    from rna_export.capture.estimate.gain import gain_text, table_of
    from rna_render.scene import read_scene

    given = given_settings(args)
    for_scene = None if args.for_scene is None else read_scene(args.for_scene)
    source = Source.captured(args.source, arguments, CaptureSettings(**given))
    python = blender_env.find_python()
    with tempfile.TemporaryDirectory(prefix="rna-capture-") as scratch:
        workers = CaptureWorkers(python, Path(scratch), args.workers)
        print(f"opening {args.source.name} in Blender", flush=True)
        say = partial(print, flush=True)
        pilot = measured_pilot(source, given, workers, say, for_scene)
    if pilot is not None:
        print(gain_text(pilot, table_of()))


def _is_dataset(folder: Path) -> bool:
    """Whether a capture has begun there; CaptureError if the manifest is no dataset's."""
    from rna_export.capture.dataset.dataset_folder import Dataset

    return (folder / "manifest.json").is_file() and bool(Dataset(folder))


def _continue(
    out: Path, source: Path, arguments: tuple[str, ...], given: dict[str, object]
) -> Dataset:
    """The unfinished dataset in `out`; raises CaptureError if source or settings differ."""
    from rna_export.capture.dataset.dataset_folder import Dataset

    dataset = Dataset(out)
    manifest = dataset.manifest
    sha = hashlib.sha256(source.read_bytes()).hexdigest()
    if (sha, arguments) != (manifest.source_sha256, manifest.arguments):
        raise CaptureError(
            f"{out} was started from another {manifest.source} or with other arguments"
        )
    for field, value in given.items():
        begun = getattr(manifest.settings, field)
        if value != begun:
            raise CaptureError(f"{out} was started with {field} {begun}, found {value}")
    print(f"resuming {out}")
    return dataset


def _check_scene(dataset: Dataset, for_scene: SceneFile | None) -> None:
    """Raises CaptureError if the scene uses other directions than the dataset."""
    from rna_export.capture.blender_process.capture_worker import scene_of
    from rna_export.capture.scene_domain import scene_domain

    manifest = dataset.manifest
    if for_scene is None:
        return
    domain = scene_domain(for_scene, dataset.folder.stem, scene_of(dataset))
    if domain != manifest.scene_domain:
        raise CaptureError(
            f"{dataset.folder} was started for other view or light directions than {for_scene.path}"
        )


if __name__ == "__main__":
    sys.exit(main())
