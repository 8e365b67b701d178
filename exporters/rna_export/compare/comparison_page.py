"""The report of a comparison: a table of images, the numbers as JSON, and one sheet as PNG."""

import json
from dataclasses import asdict
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
from jinja2 import Environment, PackageLoader, StrictUndefined

from rna_export.asset_flip import DEFINITION, AssetFlip, asset_flip
from rna_export.compare.comparison_run import Pair, returned_light
from rna_export.compare.origin import Origin
from rna_export.metrics import PSNR_DEFINITION, WITHOUT_NOISE_DEFINITION, NoiselessPsnr
from rna_export.outcome.outcome import Outcome
from rna_export.pictures import comparison_sheet, pictures_of, write_picture
from rna_sdk.commands.error_words import albedo_text, error_in_words, error_text
from rna_sdk.files.atomic_file import write_atomically

_TEMPLATES = Environment(
    loader=PackageLoader("rna_export"),
    autoescape=True,
    undefined=StrictUndefined,
    trim_blocks=True,
    lstrip_blocks=True,
)
_TEMPLATES.policies["json.dumps_kwargs"] = {"sort_keys": False}  # pages show things in order

_NUMBERS = ("psnr", "coverage", "exposure", "seconds_ours", "seconds_cycles")


Made = tuple[Path, Path, Origin, str | None]
"""Package, source, the package's record of its making, and signs of another source."""

_WORDS = {
    "tier": "tier",
    "samples": "samples a pixel of ours",
    "cyclesSamples": "samples a pixel of Cycles",
    "resolution": "width and height, pixels",
    "threads": "threads",
}
"""Settings in words."""


def write_page(
    folder: Path,
    title: str,
    pairs: list[Pair],
    settings: dict[str, object],
    made: Made | None = None,
) -> None:
    """Write `index.html`, `results.json`, `sheet.png` and the single pictures into `folder`.

    To be called again with more pairs, which may have changed the exposures of those before.
    """
    folder.mkdir(parents=True, exist_ok=True)
    shots, strips = [], []
    for number, pair in enumerate(pairs):
        pictures = pictures_of(pair.ours, pair.cycles, pair.exposure)
        images = dict(zip(("ours", "cycles", "difference", "flip"), pictures, strict=True))
        strips.append((list(images.values()), f"{pair.shot.name}: {pair.error}"))
        files = {kind: f"{number}-{kind}.png" for kind in images}
        for kind, image in images.items():
            write_picture(folder / files[kind], image)
        shots.append({"pair": pair, "files": files})
    summary = _summary(pairs)
    page = _TEMPLATES.get_template("compare.html").render(
        title=title,
        settings={_WORDS.get(name, name): value for name, value in settings.items()},
        facts=_facts(made),
        doubt=made[3] if made else None,
        summary=summary,
        clean=NoiselessPsnr.mean([pair.psnr_without_noise for pair in _under_suns(pairs)]),
        returned=returned_light(pairs),
        recorded=made[2].validation if made else None,
        error=error_of(pairs),
        recorded_error=_recorded(made),
        words=error_in_words,
        light_text=albedo_text,
        date=datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC"),
        shots=shots,
        psnr_definition=PSNR_DEFINITION,
        flip_definition=DEFINITION,
        without_noise_definition=WITHOUT_NOISE_DEFINITION,
    )
    write_atomically(folder / "index.html", f"{page}\n".encode())
    results = {"title": title, "settings": settings, **summary, "pictures": _numbers(pairs)}
    write_atomically(folder / "results.json", (json.dumps(results, indent=1) + "\n").encode())
    write_picture(folder / "sheet.png", comparison_sheet(strips))


def error_of(pairs: list[Pair]) -> AssetFlip:
    """The asset's error over the pictures under suns."""
    suns = _under_suns(pairs)
    lit = [pair.flip for pair in suns if pair.is_lit]
    return asset_flip(lit, unlit=len(suns) - len(lit))


def outcome_of(pairs: list[Pair], is_of_strands: bool) -> Outcome:
    """The outcome of the lit pictures under suns."""
    lit = [pair.judged for pair in _under_suns(pairs) if pair.is_lit]
    return Outcome.of_images([image for image in lit if image is not None], is_of_strands)


def _under_suns(pairs: list[Pair]) -> list[Pair]:
    return [pair for pair in pairs if not pair.shot.is_white]


def _recorded(made: Made | None) -> str | None:
    """The error that the package records, in words; None where it records none."""
    validation = made[2].validation if made else None
    if validation is None or validation.flip_p95 is None:
        return None
    return error_text(validation.flip, validation.flip_p95)


def _facts(made: Made | None) -> dict[str, str]:
    """Rows of the page's first table."""
    if made is None:
        return {}
    package, source, origin, _ = made
    training = [
        f"{origin.steps:,} steps" if origin.steps else "steps not recorded",
        f"{origin.lights:,} light directions" if origin.lights else "lights not recorded",
    ]
    return {
        "package": package.name,
        "rendered with Cycles": source.name,
        "captured from": origin.source,
        "tier": origin.tier,
        "trained": ", ".join(training),
    }


def _summary(pairs: list[Pair]) -> dict[str, object]:
    """Means over the pictures under suns; `albedo` is of those in white worlds."""
    suns, error = _under_suns(pairs), error_of(pairs)
    clean = NoiselessPsnr.mean([pair.psnr_without_noise for pair in suns])
    return {
        "flip": error.mean,
        "flip_p95": error.p95,
        "albedo": returned_light(pairs),
        **{name: float(np.mean([getattr(pair, name) for pair in suns])) for name in _NUMBERS},
        "psnr_without_noise": asdict(clean),
    }


def _numbers(pairs: list[Pair]) -> list[dict[str, object]]:
    return [
        {
            "name": p.shot.name,
            "flip": p.flip.mean,
            "is_lit": p.is_lit,
            "albedo": returned_light([p]),
            **{n: getattr(p, n) for n in _NUMBERS},
            "psnr_without_noise": asdict(p.psnr_without_noise),
        }
        for p in pairs
    ]
