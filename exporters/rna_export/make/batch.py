"""Several models in one `rna-make`: one plan, one contact sheet, and failures at the end."""

import argparse
import io
from argparse import ArgumentParser, Namespace
from collections.abc import Callable, Sequence
from pathlib import Path

from rna_sdk.errors import RnaError

SHEET = "contact-sheet.png"
_TILE, _COLUMNS, _LABEL = 320, 4, 28  # pixels


def check_outs(args: Namespace, options: ArgumentParser) -> None:
    """Exit with an error of usage unless there is one model and --out, or --out-dir."""
    if (args.out is None) == (args.out_dir is None):
        options.error("expected one of --out and --out-dir")
    if args.out is not None and len(args.model) > 1:
        options.error(f"found {len(args.model)} models, which need --out-dir in place of --out")
    for name in ("work", "name") if args.out_dir is not None else ():
        if getattr(args, name) is not None:
            options.error(f"--{name} is for one model, not for --out-dir")


def jobs_of(args: Namespace) -> list[Namespace]:
    """The arguments of each model's own make.

    Raises RnaError for models of one name, and OSError where the folder cannot be made.
    """
    stems = [model.stem for model in args.model]
    twice = next((stem for stem in stems if stems.count(stem) > 1), None)
    if twice is not None:
        raise RnaError(f"--out-dir: two models would write {twice}.rna: rename one of them")
    args.out_dir.mkdir(parents=True, exist_ok=True)
    return [
        argparse.Namespace(
            **{**vars(args), "model": model, "out": args.out_dir / f"{model.stem}.rna"}
        )
        for model in args.model
    ]


def make_all(jobs: Sequence[Namespace], make: Callable[[Namespace], None]) -> int:
    """Make one after the other; returns the exit status, 1 if any failed."""
    folder = jobs[0].out.parent
    each = jobs[0].minutes or jobs[0].more
    time = "" if each is None else f", {each:g} minutes each, {each * len(jobs):g} in all"
    print(f"{len(jobs)} models into {folder}{time}: {', '.join(job.model.name for job in jobs)}")
    failures, made = [], []
    for number, job in enumerate(jobs, 1):
        print(f"\n{number} of {len(jobs)}: {job.model}", flush=True)
        try:
            make(job)
        except (RnaError, OSError) as error:
            print(f"failed: {error}", flush=True)
            failures.append(f"{job.model}: {error}")
        else:
            made.append(job.out)
    print()
    if made:
        sheet = folder / SHEET
        _write_sheet(sheet, made)
        print(f"made {len(made)} of {len(jobs)}: {sheet} and a poster of each show them")
    for failure in failures:
        print(f"failed: {failure}")
    return 1 if failures else 0


def _write_sheet(path: Path, packages: Sequence[Path]) -> None:
    """A tile a package, with its name; posters are written beside the packages, too."""
    from PIL import Image, ImageDraw, ImageFont

    from rna_sdk.files.atomic_file import write_atomically
    from rna_sdk.package import Package

    columns = min(_COLUMNS, len(packages))
    rows = -(-len(packages) // columns)
    sheet = Image.new("RGB", (columns * _TILE, rows * (_TILE + _LABEL)), (255, 255, 255))
    draw, font = ImageDraw.Draw(sheet), ImageFont.load_default(16)
    for number, package in enumerate(packages):
        with Package.open(package) as opened:
            poster = opened.poster()
        row, column = divmod(number, columns)
        at = column * _TILE, row * (_TILE + _LABEL)
        draw.text((at[0] + 8, at[1] + _TILE + 6), package.stem, (20, 20, 20), font)
        if poster is None:
            continue
        write_atomically(package.with_suffix(".png"), poster)
        image = Image.open(io.BytesIO(poster)).convert("RGB")
        image.thumbnail((_TILE, _TILE))
        left, top = (_TILE - image.width) // 2, (_TILE - image.height) // 2
        sheet.paste(image, (at[0] + left, at[1] + top))
    data = io.BytesIO()
    sheet.save(data, "PNG")
    write_atomically(path, data.getvalue())
