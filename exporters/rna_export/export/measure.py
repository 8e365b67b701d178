"""Error and cost of a package's tiers, through the runtime, all parts together."""

from collections.abc import Callable, Sequence

import numpy as np

from rna_export.albedo import DEFINITION as ALBEDO_DEFINITION
from rna_export.albedo import albedo
from rna_export.asset_flip import DEFINITION
from rna_export.brightness import brightness
from rna_export.capture.dataset.asset_arguments import Arguments, rows_of
from rna_export.capture.dataset.validation_view import (
    EmissionView,
    WhiteView,
    WholeView,
    all_queries,
)
from rna_export.export.trained_tiers import TrainedTier
from rna_export.machine import seconds_of
from rna_export.metrics import PSNR_DEFINITION, plain, psnr, relative_mse
from rna_export.training.asset_error import asset_error, smallest_factor, worse_error
from rna_export.training.validation import exposure, mean_psnr, shade
from rna_sdk.errors import ExportError
from rna_sdk.machine.cores import core_count
from rna_sdk.machine.cpu import processor
from rna_sdk.package import Albedo, Cost, FlipAtHeight, Tier, Validation
from rna_sdk.runtime import Asset, FiberAsset, SurfaceAsset

Emitted = tuple[np.ndarray, EmissionView]
"""Emission of a part, (n, 3), in one of its images of emission."""

_COST_ROWS = 200_000
_SMALLEST, _HALVINGS = 8, 4  # pixels of small images, of which fewer say little; their sizes


def measured(
    tier: Tier,
    asset: Asset,
    trained: TrainedTier,
    views: list[WholeView],
    emission: Sequence[Sequence[EmissionView]],
    white: Sequence[WhiteView] | None,
    say: Callable[[str], None],
) -> Tier:
    """The tier with its error and cost.

    asset: the tier, loaded. emission: views of each part. white: of each part; None: no albedo.
    """
    of_parts = [
        [
            part.shaded_by(part_asset)
            for part, part_asset in zip(view.parts, asset.parts, strict=True)
        ]
        for view in views
    ]
    radiance = [np.concatenate(rows) for rows in of_parts]
    emitted = [
        (view.shaded_by(part), view)
        for part, glowing in zip(asset.parts, emission, strict=True)
        for view in glowing
        if part.emits
    ]
    validation = None
    if not plain([v.reference for v in views]):
        returned = None if white is None else _albedo(asset, white)
        validation = _validation(radiance, views, emitted, returned)
    light = brightness(
        zip(radiance, (v.reference for v in views), (v.visible for v in views), strict=True)
    )
    cost = _cost(asset, trained, views)
    say(
        f"{tier.name}: {_validation_text(validation)}\n"
        + f"{tier.name}: {light}\n"
        + "".join(f"warning: {tier.name}: {fault}\n" for fault in light.faults)
        + "".join(_part_lines(tier.name, asset, of_parts, views))
        + f"{tier.name}: {cost.ns_per_query:.0f} ns/query on {cost.threads} threads"
    )
    return tier.model_copy(update={"validation": validation, "cost": cost})


def _albedo(asset: Asset, white: Sequence[WhiteView]) -> Albedo | None:
    pairs = zip(asset.parts, white, strict=True)
    return albedo((view.shaded_by(part), view) for part, view in pairs)


def _validation_text(validation: Validation | None) -> str:
    if validation is None:
        return "no error: the validation images show nothing to compare"
    scores = f"FLIP {validation.flip:.4f}, PSNR {validation.psnr:.2f} dB"
    return f"{scores} ({validation.definition})"


def check_loss(tier: Tier, trained: TrainedTier, views: list[WholeView], max_loss: float) -> None:
    """Raises ExportError where the tier's PSNR is too far below the trained models' PSNR."""
    if tier.validation is None:
        return
    in_torch = mean_psnr([_shaded(trained, view) for view in views], views)
    if not in_torch - tier.validation.psnr <= max_loss:
        raise ExportError(
            f"{tier.name}: found {tier.validation.psnr:.2f} dB, the trained model has "
            f"{in_torch:.2f} dB; expected to lose at most {max_loss:g} dB (--max-loss)"
        )


def _shaded(trained: TrainedTier, view: WholeView) -> np.ndarray:
    pairs = zip(trained.parts, view.parts, strict=True)
    return np.concatenate([shade(one.model, part) for one, part in pairs])


def _part_lines(
    name: str, asset: Asset, of_parts: list[list[np.ndarray]], views: list[WholeView]
) -> list[str]:
    """PSNR of each of several parts, over the images that show it."""
    if len(asset.parts) == 1:
        return []
    lines = []
    for k, part in enumerate(asset.parts):
        rows = [(r[k], v.parts[k].reference) for r, v in zip(of_parts, views, strict=True)]
        shown = [psnr(r, reference, exposure(views)) for r, reference in rows if len(r)]
        lines.append(f"{name}: part {part.name} PSNR {np.mean(shown):.2f} dB\n")
    return lines


def _validation(
    radiance: list[np.ndarray],
    views: Sequence[WholeView],
    emitted: list[Emitted],
    returned: Albedo | None,
) -> Validation:
    brightest = exposure(views)
    brighter = f"; both {brightest:.3g} times as bright, since the asset is dark"
    size = smallest_factor(views)
    pixels = f", in pixels of {size} x {size} rays" if size > 1 else ""
    error = worse_error(asset_error(radiance, views), emitted)
    unlit = f"; images without light: {error.unlit}" if error.unlit else ""
    return Validation(
        psnr=mean_psnr(radiance, views),
        flip=error.mean,
        flip_p95=error.p95,
        relative_mse=float(
            np.mean([relative_mse(r, v.reference) for r, v in zip(radiance, views, strict=True)])
        ),
        images=len(views),
        definition=f"psnr: {PSNR_DEFINITION}{brighter if brightest > 1.0 else ''}; "
        f"flip: {DEFINITION}{pixels}{unlit}"
        f"{'' if returned is None else f'; albedo: {ALBEDO_DEFINITION}'}",
        albedo=returned,
        flip_at_height=flip_at_heights(radiance, views, emitted),
    )


def _cost(asset: Asset, trained: TrainedTier, views: list[WholeView]) -> Cost:
    """Means over the queries of the images."""
    queries = [all_queries([view.parts[k] for view in views]) for k in range(len(asset.parts))]
    rows = np.array([len(of_part[0]) for of_part in queries], float)
    ns = [
        _ns_per_query(part, of_part) if len(of_part[0]) else 0.0
        for part, of_part in zip(asset.parts, queries, strict=True)
    ]
    multiply_adds = [one.model.multiply_adds for one in trained.parts]
    return Cost(
        multiply_adds=round(float(np.average(multiply_adds, weights=rows))),
        ns_per_query=float(np.average(ns, weights=rows)),
        threads=asset.threads,
        machine=f"{processor()}, {core_count()} cores",
    )


def _ns_per_query(part: SurfaceAsset | FiberAsset, queries: Arguments) -> float:
    """Median over five runs on real queries."""
    rows = rows_of(queries, np.arange(_COST_ROWS) % len(queries[0]))
    seconds = [seconds_of(lambda: part.evaluate(*rows)) for _ in range(6)]
    return 1e9 * float(np.median(seconds[1:])) / _COST_ROWS


def flip_at_heights(
    radiance: list[np.ndarray], views: Sequence[WholeView], emitted: list[Emitted]
) -> tuple[FlipAtHeight, ...]:
    """Mean FLIP of the asset's pixels at the images' height, half of it, and so on.

    radiance: shaded rows, (n, 3) a view. Pixels are averaged as radiance, as a renderer's samples
    of a pixel are; rows and columns that a height does not divide are left out.
    """
    result = []
    for factor in (2**k for k in range(_HALVINGS)):
        height = views[0].resolution // (factor * smallest_factor(views))
        if height < _SMALLEST and factor > 1:
            break
        error = worse_error(asset_error(radiance, views, factor), emitted, factor)
        result.append(FlipAtHeight(height=height, flip=error.mean))
    return tuple(result)
