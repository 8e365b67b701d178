"""`rna-train`: trains a neural asset on a captured dataset."""

from __future__ import annotations

import argparse
import math
import sys
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING

from rna_export.training.presets import (
    ANALYTIC_NAME,
    BATCH,
    LOSSES,
    OPTIMIZERS,
    PRESETS,
    Preset,
    named_preset,
)
from rna_export.training.training_options import (
    add_device,
    add_incomplete,
    add_nearby,
    chosen_device,
)
from rna_sdk.commands.console import command_line, command_parser, run_command
from rna_sdk.errors import TrainingError
from rna_sdk.files.owned_folder import owned

if TYPE_CHECKING:
    from rna_export.capture.dataset.dataset_folder import Dataset


def parser() -> argparse.ArgumentParser:
    """The options of `rna-train`."""
    p = command_parser(
        "rna-train",
        "Train a neural asset on a captured dataset.",
        "rna-train helmet.rays/ --preset small --out runs/helmet --minutes 10",
        epilog="The same command resumes an interrupted training.",
    )
    p.add_argument("dataset", type=Path, help="dataset written by rna-capture (path)")
    p.add_argument(
        "--out",
        type=Path,
        required=True,
        metavar="FOLDER",
        help="folder for checkpoints, loss curves and images, or a run to resume; one subfolder "
        "per part if there are several (path, required)",
    )
    p.add_argument(
        "--part", metavar="NAME", help="train only this part (str, default: all parts in turn)"
    )
    p.add_argument(
        "--cut",
        type=int,
        default=1,
        metavar="N",
        help="split surfaces into N pieces with their own planes and decoder, for more detail in "
        "close-ups; package size grows in proportion (int, default: %(default)s)",
    )
    p.add_argument(
        "--preset",
        choices=[*PRESETS["surface"], ANALYTIC_NAME],
        default="small",
        help="model preset; analytic: a glTF material fitted to each surface, for comparison and "
        "for --standin of rna-export (default: %(default)s)",
    )
    p.add_argument(
        "--loss",
        choices=LOSSES,
        help="log: capture noise darkens the result slightly; unbiased: it does not, but sharp "
        "highlights are less accurate; auto: chosen by the noise level (default: the preset's, "
        "auto for ours)",
    )
    p.add_argument(
        "--shadow-weight",
        type=float,
        help="weight of shadowed samples in the loss; 10 in configurations of the paper's code "
        "(float, default: the preset's: 0.1 for our surfaces, which have a separate decoder for "
        "shadowed light, else 1)",
    )
    add_nearby(p)
    p.add_argument(
        "--optimizer",
        choices=OPTIMIZERS,
        help="optimizer of the decoder's matrices; other parameters use Adam (default: the "
        "preset's, muon for ours, adam for the paper's)",
    )
    p.add_argument(
        "--batch",
        type=int,
        help="samples per step; learning rates are unchanged (int, default: "
        f"{BATCH['cpu']:,} on the CPU, {BATCH['cuda']:,} on a GPU)",
    )
    lengths = sorted({preset.training.steps for preset in PRESETS["surface"].values()})
    usual = " or ".join(f"{steps:,}" for steps in lengths)
    length = p.add_mutually_exclusive_group()
    length.add_argument(
        "--minutes",
        type=float,
        help="wall-clock budget, including loading and validation; parts share it in proportion to "
        "their visible area (float, default: the preset's steps)",
    )
    length.add_argument(
        "--steps", type=int, help=f"training steps per part (int, default: the preset's, {usual})"
    )
    p.add_argument(
        "--seed",
        type=int,
        default=0,
        help="random seed; with --steps, CPU runs are reproducible (int, default: %(default)s)",
    )
    add_incomplete(p)
    add_device(p, "the training")
    return p


def main(argv: list[str] | None = None) -> int:
    """Entry point; returns the exit status."""
    options = parser()
    args = options.parse_args(argv)
    for name in ("minutes", "steps", "cut", "shadow_weight", "batch"):
        value = getattr(args, name)
        if value is not None and not 0 < value < math.inf:
            option = name.replace("_", "-")
            options.error(f"argument --{option}: expected a number above 0, found {value:g}")
    if not 0 <= args.seed < 2**32:
        options.error(f"argument --seed: expected 0 to 2^32 - 1, found {args.seed}")
    go_on = "run the same command again to resume"
    return run_command(lambda: _run(args), args.debug, go_on, "train")


def _run(args: argparse.Namespace) -> None:
    begun = monotonic()  # the imports take seconds
    from rna_export.capture.dataset.completeness import check_complete
    from rna_export.capture.dataset.dataset_folder import Dataset
    from rna_export.capture.geometry.cut import as_cut
    from rna_export.machine import keep_freed_memory
    from rna_export.training.nearby_choice import run_on
    from rna_export.training.part_runs import part_folder, shared_minutes
    from rna_export.training.training_run import Run, train
    from rna_export.training.training_summary import closing_lines

    keep_freed_memory()
    device = chosen_device(args.device)
    whole = Dataset(args.dataset)
    check_complete(whole, args.incomplete)
    dataset = as_cut(whole, args.cut)
    parts = dataset.parts if args.part is None else (dataset.part(args.part),)
    minutes = shared_minutes(args.minutes, parts)
    folders = {part.name: part_folder(args.out, dataset, part.name) for part in dataset.parts}
    written = []
    with owned(args.out, "rna-train"):
        for part in parts:
            out = folders[part.name]
            if len(dataset.parts) > 1:
                print(f"part {part.name}, {part.kind}:")
            preset = _chosen(args, part.kind, device)
            part.geometry()  # which export needs, and may refuse
            run = Run(
                part,
                preset,
                args.preset,
                out,
                seed=args.seed,
                minutes=minutes[part.name],
                begun=begun,
                device=device,
            )
            run, table = run_on(run, args.nearby, part.training_samples())
            best = train(run, table)
            print("\n".join(closing_lines(best, part)))
            written.append(f"wrote {best}, {out / 'curves.png'}, {out / 'sheet.png'}")
            begun = monotonic()
    print("\n".join([*(f"note: {note}" for note in dataset.manifest.all_notes), *written]))
    if args.preset == ANALYTIC_NAME:
        return
    package = f"{dataset.manifest.name}.rna"
    print(f"next: {command_line('rna-export', _to_export(args.out, dataset), '--out', package)}")


def _to_export(out: Path, dataset: Dataset) -> Path:
    return out / "best.ckpt" if len(dataset.parts) == 1 else out


def _chosen(args: argparse.Namespace, kind: str, device: str) -> Preset:
    """The named preset with the changes of the options."""
    if args.preset == ANALYTIC_NAME and kind != "surface":
        raise TrainingError(f"--preset {ANALYTIC_NAME}: found a part of strands, expected surfaces")
    preset = named_preset(kind, args.preset).on_device(device)
    for name in ("steps", "batch", "optimizer"):
        if (value := getattr(args, name)) is not None:
            preset = preset.with_training(**{name: value})
    if args.shadow_weight is not None:
        if preset.model.separates_direct:
            raise TrainingError(
                f"--shadow-weight: expected none, {args.preset} of a {kind} learns direct and "
                "scattered light apart"
            )
        preset = preset.with_training(shadow_weight=args.shadow_weight)
    if args.loss is not None:
        if preset.model.separates_direct:
            raise TrainingError(
                f"--loss: expected none, {args.preset} of a {kind} has one for each"
            )
        preset = preset.with_training(loss=args.loss)
    return preset


if __name__ == "__main__":
    sys.exit(main())
