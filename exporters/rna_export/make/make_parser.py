"""The options of `rna-make`."""

import argparse
from pathlib import Path

from rna_export.capture.frame_options import add_frames
from rna_export.capture.rna_capture import add_scene, add_settings, add_workers
from rna_export.export.package_options import add_credit, add_environment
from rna_export.export.precision import add_precision
from rna_export.training.presets import PRESETS
from rna_export.training.training_options import add_device, add_nearby
from rna_sdk.commands.console import command_parser

_SETTINGS = (
    "samples",
    "rays",
    "domain",
    "parts",
    "sharpest",
    "glass",
    "normal_texels",
    "texture_size",
    "validation_views",
    "validation_resolution",
    "validation_samples",
)


def parser() -> argparse.ArgumentParser:
    """The options of `rna-make`."""
    p = command_parser(
        "rna-make",
        "Capture, train and export a model in one command, up to an error target.",
        "rna-make helmet.gltf --out helmet.rna --min-psnr 36",
        epilog="Without --minutes or --lights it runs until the target is met or the error stops "
        "falling.\nThe same command resumes an interrupted run. Arguments after -- are passed to "
        "the source,\nas in rna-capture.",
    )
    p.add_argument(
        "model",
        nargs="+",
        type=Path,
        help="any model that rna-capture reads (path); several with --out-dir",
    )
    p.add_argument(
        "--out",
        type=Path,
        metavar="RNA",
        help="output package, .rna, or .glb with a fallback for viewers that do not know RNA "
        "(path, no default: this or --out-dir is required)",
    )
    p.add_argument(
        "--out-dir",
        type=Path,
        metavar="FOLDER",
        help="folder for a package and a poster of each model, and a contact sheet (path, default: "
        "none)",
    )
    goal = p.add_mutually_exclusive_group()
    goal.add_argument(
        "--max-error",
        type=float,
        metavar="FLIP",
        help="target mean FLIP over the asset's pixels in validation images (float, default: none)",
    )
    goal.add_argument(
        "--min-psnr",
        type=float,
        metavar="DB",
        help="target PSNR of the validation images, dB; small images of short runs count without "
        "their noise (float, default: none)",
    )
    p.add_argument(
        "--minutes",
        type=float,
        help="wall-clock limit of the whole command; it ends earlier once the target is met "
        "(float, default: no limit)",
    )
    p.add_argument(
        "--more",
        type=float,
        metavar="MINUTES",
        help="continue a finished run, from its rays, for this many minutes (float, default: none)",
    )
    p.add_argument(
        "--update",
        action="store_true",
        help="recapture a source that has changed; parts of unchanged geometry are trained from "
        "their previous weights; takes --minutes, or a third of the previous time (default: off)",
    )
    p.add_argument(
        "--lights",
        type=int,
        help="number of light directions; each preset is then trained once (int, default: rounds "
        "with increasing numbers)",
    )
    p.add_argument(
        "--presets",
        nargs="+",
        choices=PRESETS["surface"],
        help="one tier per preset, the default tier first; the target applies to the most "
        "expensive (default: small)",
    )
    add_scene(p)
    p.add_argument(
        "--steps",
        type=int,
        help="training steps of the last phase; earlier phases are shorter (int, default: the "
        "preset's)",
    )
    add_settings(p, _SETTINGS)
    add_frames(p)
    p.add_argument("--seed", type=int, default=0, help="random seed (int, default: 0)")
    add_nearby(p)
    add_device(p, "trainings")
    add_workers(p)
    p.add_argument(
        "--work",
        type=Path,
        metavar="FOLDER",
        help="folder for rays and trainings, reused by --more and --update (path, default: OUT "
        "with suffix .make)",
    )
    p.add_argument(
        "--discard", action="store_true", help="delete the work folder at the end (default: off)"
    )
    add_precision(p)
    add_credit(p)
    add_environment(p)
    return p
