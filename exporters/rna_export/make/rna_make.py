"""`rna-make`: captures, trains and exports a model until it meets an error target."""

from __future__ import annotations

import argparse
import math
import sys
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING

from rna_export.capture.blender_process import source_help
from rna_export.capture.blender_process.source_file import check_source
from rna_export.capture.orientation import joined_axes
from rna_export.capture.rna_capture import check_settings, given_settings
from rna_export.export.package_options import check_environment, lobe_minutes
from rna_export.export.precision import precisions_of
from rna_export.make.batch import check_outs, jobs_of, make_all
from rna_export.make.make_parser import parser
from rna_export.training.training_options import chosen_device
from rna_sdk.commands.console import command_line, run_command, split_script_arguments
from rna_sdk.files.atomic_file import write_atomically
from rna_sdk.files.outputs import check_outputs, check_outside, check_package_name
from rna_sdk.files.owned_folder import owned
from rna_sdk.package.gltf.glb_file import package_to_write
from rna_work.executors import open_executor

if TYPE_CHECKING:
    from rna_export.make.goal import Goal
    from rna_export.make.make_options import MakeOptions
    from rna_export.make.make_run import Made
    from rna_sdk.package import Manifest

_GO_ON = "run the same command again to resume"
_NOT_WITH_MORE = ("minutes", "lights", "steps", "max_error", "min_psnr", "update")


def main(argv: list[str] | None = None) -> int:
    """Entry point; returns the exit status."""
    begun = monotonic()
    command_line, arguments = split_script_arguments(argv)
    options = parser()
    args = options.parse_args(joined_axes(command_line))
    if source_help.is_requested(arguments):
        (model, *_) = args.model
        return run_command(lambda: source_help.show(model), args.debug, _GO_ON, "capture")
    check_outs(args, options)
    if args.minutes is not None and (args.lights is not None or args.steps is not None):
        options.error("--minutes sets --lights and --steps: give either it or them")
    for name in _NOT_WITH_MORE if args.more is not None else ():
        if getattr(args, name):
            options.error(f"--more has its own length: give no --{name.replace('_', '-')}")
    for name in ("minutes", "more", "workers", "max_error", "min_psnr", "steps"):
        value = getattr(args, name)
        if value is not None and not 0 < value < math.inf:
            options.error(
                f"argument --{name.replace('_', '-')}: expected a number above 0, found {value:g}"
            )
    if args.max_error is not None and args.max_error >= 1.0:
        options.error(
            "argument --max-error: expected a FLIP below 1, such as 0.07 for good, found "
            f"{args.max_error:g}; --min-psnr is for dB"
        )
    if not 0 <= args.seed < 2**32:
        options.error(f"argument --seed: expected 0 to 2^32 - 1, found {args.seed}")
    if args.presets and len(set(args.presets)) < len(args.presets):
        options.error(f"argument --presets: expected each once, found {' '.join(args.presets)}")
    check_settings(args, options)
    check_environment(args, options)

    def run() -> int:
        jobs = jobs_of(args)
        return make_all(jobs, lambda job: _run(job, arguments, monotonic()))

    if args.out_dir is None:
        (args.model,) = args.model
        return run_command(lambda: _run(args, arguments, begun), args.debug, _GO_ON, "train")
    return run_command(run, args.debug, _GO_ON, "train")


def _run(args: argparse.Namespace, arguments: tuple[str, ...], begun: float) -> None:
    check_source(args.model)
    check_package_name(args.out)
    from rna_export.capture.blender_process.blender_env import find_python
    from rna_export.capture.blender_process.blender_process import Source
    from rna_export.capture.capture_run import CaptureWorkers
    from rna_export.capture.capture_settings import CaptureSettings
    from rna_export.export.export_summary import closing_lines
    from rna_export.fallback_error import complete_fallback
    from rna_export.lobes.environment_training import add_lobes
    from rna_export.machine import keep_freed_memory
    from rna_export.make.carry_on import carried_options, size_of
    from rna_export.make.make_options import MakeOptions
    from rna_export.make.make_run import Make, export
    from rna_export.make.state import WRITTEN
    from rna_export.pictures import sheet_of, training_picture_of
    from rna_render.scene import read_scene

    keep_freed_memory()
    work = args.work or args.out.with_suffix(".make")
    given = [args.model] if args.for_scene is None else [args.model, args.for_scene]
    check_outputs([args.out], [*given, *args.environment_files])
    check_outside(work, [args.out, *given])
    lobes_take = lobe_minutes(args)
    carried = carried_options(args, work, arguments, lobes_take)
    arguments = carried.arguments
    settings = {**carried.settings, **given_settings(args), "seed": carried.seed}
    args.presets = list(carried.presets)
    goal = _goal(args)
    precisions = precisions_of(args.precision, args.presets)
    source = Source.captured(args.model, arguments, CaptureSettings(**settings))
    for_scene = None if args.for_scene is None else read_scene(args.for_scene)
    device, python = chosen_device(args.device), find_python()
    picture = training_picture_of(args.out)
    print(f"{work} holds rays and trainings; Ctrl-C stops, and the same command resumes")
    print(f"{picture} shows the model while it is trained: ours, Cycles, the error", flush=True)
    with owned(work, "rna-make") as folder:
        with folder.scratch() as scratch, open_executor(args.cluster) as executor:
            options = MakeOptions(
                source=source,
                settings=settings,
                for_scene=for_scene,
                work=work,
                presets=tuple(args.presets),
                goal=goal,
                minutes=carried.minutes,
                steps=args.steps,
                seed=carried.seed,
                device=device,
                nearby=args.nearby,
                workers=CaptureWorkers(python, scratch, args.workers, executor, args.store),
                picture=picture,
                more=carried.more,
                update=args.update,
            )
            made = Make(options, begun, print).run()
        print("writing the package: measuring its error and cost, rendering its poster", flush=True)
        with package_to_write(args.out) as out:
            manifest = export(made, out, args.source, args.license, precisions, args.name)
            lobes = (
                add_lobes(out, out, lobes_take, args.environment_files) if args.environment else []
            )
        marked = _saved_picture(options, args.out)
        lines = [*closing_lines(args.out, manifest, made.trained(), made.dataset), *lobes]
        lines += complete_fallback(args.out, made.dataset, args.model)
        others = folder.dissolve(*WRITTEN) if args.discard else []
    if others:
        print(f"kept {work}: rna-make did not write {', '.join(others)}")
    print("\n".join([*lines, _outcome(made, manifest, goal)]))
    size = args.out.stat().st_size / 1e6
    print(f"wrote {args.out}, {size:.2f} MB, {sheet_of(args.out)}")
    if not args.discard:
        line = f"kept {work}, {size_of([work]) / 1e6:,.0f} MB of rays and models"
        print(f"{line}: --more 10 goes on from them, --discard deletes them")
    if marked is not None:
        print(f"note: the exported geometry differs from Cycles' renders; {marked} marks it")
    _tell_next(args)


def _tell_next(args: argparse.Namespace) -> None:
    """Write the scene beside the package, and print the commands that show and check both."""
    from rna_export.make.starter import write_starter
    from rna_sdk.commands.size_note import size_note
    from rna_sdk.package import Package

    with Package.open(args.out) as package:
        note = size_note(*package.box())
    if note is not None:
        print(f"note: {note}")
    scene = write_starter(args.out)
    if scene is not None:
        print(f"wrote {scene}, a scene that shows it")
    report = f"{args.out.stem}-compare"
    print(f"next: {command_line('rna-view', args.out)}")
    print(f"      {command_line('rna-compare', args.out, args.model, '--out', report)}")


def _saved_picture(options: MakeOptions, out: Path) -> Path | None:
    """A copy of the self-check's picture beside the package; None without a picture."""
    from rna_export.capture.check.self_check import PICTURE
    from rna_export.make.capture_rounds import rays_folder

    marked = rays_folder(options) / PICTURE
    if not marked.is_file():
        return None
    copy = out.with_suffix(f".{PICTURE}")
    write_atomically(copy, marked.read_bytes())
    return copy


def _goal(args: argparse.Namespace) -> Goal | None:
    from rna_export.make.goal import Goal

    if args.max_error is not None:
        return Goal("max_error", args.max_error)
    return None if args.min_psnr is None else Goal("min_psnr", args.min_psnr)


def _outcome(made: Made, manifest: Manifest, goal: Goal | None) -> str:
    """Why it ended, whether the goal is met, and by which of several tiers at the least cost."""
    (lead, *_) = [t.validation for t in manifest.tiers if f"{t.name}-".startswith(f"{made.lead}-")]
    end: str = "the error stopped falling" if made.why == "stopped falling" else made.why
    if goal is not None and lead is not None and goal.met_by(lead):
        end = f"goal met: {goal}{_cheapest(manifest, goal)}"
    elif made.why == "goal met" and made.without_noise:
        end = f"goal met: {goal}, without the noise of the validation images"
    elif goal is not None:
        end = f"goal not met, {end}: {goal}"
    return f"{end}; capture rounds: {made.rounds}"


def _cheapest(manifest: Manifest, goal: Goal) -> str:
    """The cheapest tier that meets the goal, where there are several tiers."""
    meet = [
        (tier.cost.ns_per_query, tier.name)
        for tier in manifest.tiers
        if tier.cost and tier.validation and goal.met_by(tier.validation)
    ]
    if len(manifest.tiers) == 1 or not meet:
        return ""
    ns, name = min(meet)
    return f", cheapest by {name}: {ns:.0f} ns/query"


if __name__ == "__main__":
    sys.exit(main())
