"""Checkpoints to one package: a tier each, with its measured error and cost."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict
from pathlib import Path

import numpy as np
import torch

import rna_sdk
from rna_export.capture.dataset import Dataset, ValidationView, all_queries, queries_of
from rna_export.export.decoder import Agreement as DecoderAgreement
from rna_export.export.decoder import check_decoder, check_int8_decoder, export_decoder
from rna_export.export.int8_decoder import int8_decoder
from rna_export.export.precision import MAX_LOSS, Precision, stored_planes
from rna_export.export.small_images import flip_at_heights
from rna_export.machine import seconds_of
from rna_export.metrics import FLIP_DEFINITION, PSNR_DEFINITION, psnr
from rna_export.training.checkpoint import Trained
from rna_export.training.validation import score, shade
from rna_sdk.cpu import processor
from rna_sdk.errors import ExportError
from rna_sdk.package import (
    Agreement,
    Bounds,
    Cost,
    Manifest,
    Part,
    Provenance,
    Tier,
    TierData,
    TierPart,
    Validation,
    write_package,
)
from rna_sdk.package.manifest_fields import GEOMETRY_ENTRIES, DecoderPrecision
from rna_sdk.runtime import Asset, load

_COST_ROWS = 200_000
_CALIBRATION_ROWS = 50_000
_CALIBRATION_SHARDS = 12


def build_package(
    trained: list[Trained],
    dataset: Dataset,
    out: Path,
    source: str | None,
    license_: str,
    say: Callable[[str], None],
    precisions: Sequence[Precision] = (Precision(),),
    measured: bool = True,
    max_loss: float = MAX_LOSS,
) -> Manifest:
    """Write `out` with a tier for each checkpoint and precision; returns its manifest.

    Tiers are named for the preset and, unless it is the usual one, the precision.

    Each tier's error and cost are measured through the runtime, from a package like the one
    written, unless that is not wanted: then the manifest has neither. Raises `ExportError` when
    the checkpoints do not belong together or to the dataset, a decoder is not the trained one, or
    a measured tier loses more than `max_loss` dB against it.
    """
    _check_together(trained, dataset)
    tiers, data = [], {}
    models = [one for one in trained for _ in precisions]
    for one in trained:
        for tier, tier_data in _tiers(one, precisions, dataset, say):
            tiers.append(tier)
            data[tier.name] = [tier_data]
    bounds, kind = trained[0].model.triplane, dataset.manifest.kind
    manifest = Manifest(
        generator=f"rna-export {rna_sdk.__version__}",
        name=dataset.manifest.name,
        parts=(
            Part(
                name="asset",
                kind=kind,
                bounds=Bounds(min=tuple(bounds.low.tolist()), max=tuple(bounds.high.tolist())),
                geometry=GEOMETRY_ENTRIES[kind],
            ),
        ),
        domain=dataset.manifest.domain,
        tiers=tuple(tiers),
        provenance=_provenance(trained, dataset, source),
        license=license_,
    )
    if measured:
        manifest = _measure(manifest, models, dataset, data, say)
        _check_losses(manifest.tiers, models, dataset.validation_views(), max_loss)
    return write_package(out, manifest, [dataset.geometry()], data)


def _check_together(trained: list[Trained], dataset: Dataset) -> None:
    names = [one.preset_name for one in trained]
    if len(set(names)) < len(names):
        raise ExportError(f"found presets {', '.join(names)}, expected each once")
    for one in trained:
        if one.capture.source_sha256 != dataset.manifest.source_sha256:
            raise ExportError(
                f"the {one.preset_name} checkpoint was trained on {one.capture.source} "
                f"({one.capture.source_sha256[:12]}), expected the dataset's "
                f"{dataset.manifest.source} ({dataset.manifest.source_sha256[:12]})"
            )


def _tiers(
    one: Trained,
    precisions: Sequence[Precision],
    dataset: Dataset,
    say: Callable[[str], None],
) -> Iterator[tuple[Tier, TierData]]:
    """The checkpoint's tiers; those of one precision share planes or decoder."""
    config, decoders = one.preset.model, {}
    for precision in precisions:
        name = precision.tier_name(one.preset_name)
        if precision.decoder not in decoders:
            decoders[precision.decoder] = _decoder(one, precision.decoder, dataset)
        decoder, agreement = decoders[precision.decoder]
        say(
            f"{name}: the {precision.decoder} ONNX decoder and PyTorch differ by at most "
            f"{agreement.max_absolute:.1e} absolute, {agreement.max_relative:.1e} relative"
        )
        part = TierPart(
            planes=precision.planes_entry(one.preset_name),
            decoder=precision.decoder_entry(one.preset_name),
            inputs=config.inputs,
            resolution=config.resolution,
            channels=config.channels,
            plane_precision=precision.planes,
            decoder_precision=precision.decoder,
            agreement=Agreement(**asdict(agreement)),
        )
        planes = stored_planes(one.model.triplane.planes.detach().numpy(), precision.planes)
        yield Tier(name=name, parts=(part,)), TierData(planes, decoder)


def _decoder(
    one: Trained, precision: DecoderPrecision, dataset: Dataset
) -> tuple[bytes, DecoderAgreement]:
    """The exported decoder, and how far it is from the trained one."""
    if precision == "float32":
        exported = export_decoder(one.model)
        return exported, check_decoder(exported, one.model)
    queries = calibration_queries(one, dataset)
    layers = int8_decoder(one.model, queries)
    exported = export_decoder(one.model, layers)
    return exported, check_int8_decoder(exported, one.model, layers, queries)


@torch.no_grad()
def calibration_queries(one: Trained, dataset: Dataset) -> torch.Tensor:
    """What the decoder is asked at random samples of the training data, (n, K)."""
    samples = dataset.training_samples(_CALIBRATION_SHARDS)
    rows = len(samples["visible"])
    picked = np.random.default_rng(0).permutation(rows)[:_CALIBRATION_ROWS]
    points = {k: torch.from_numpy(v[picked]) for k, v in queries_of(samples).items()}
    return one.model.queries(points)


def _measure(
    manifest: Manifest,
    models: list[Trained],
    dataset: Dataset,
    data: dict[str, list[TierData]],
    say: Callable[[str], None],
) -> Manifest:
    """The manifest with each tier's error and cost, as the runtime gives them."""
    views, tiers = dataset.validation_views(), []
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "measured.rna"
        write_package(path, manifest, [dataset.geometry()], data)
        for tier, one in zip(manifest.tiers, models, strict=True):
            asset = load(path, tier=tier.name)
            validation = _validation(asset, views)
            cost = _cost(asset, one.model.multiply_adds, views)
            say(
                f"{tier.name}: PSNR {validation.psnr:.2f} dB, FLIP {validation.flip:.4f} "
                f"({validation.definition})\n"
                f"{tier.name}: {cost.ns_per_query:.0f} ns a query on {cost.threads} threads"
            )
            tiers.append(tier.model_copy(update={"validation": validation, "cost": cost}))
    return manifest.model_copy(update={"tiers": tuple(tiers)})


def _check_losses(
    tiers: Sequence[Tier], models: list[Trained], views: list[ValidationView], max_loss: float
) -> None:
    """Raises ExportError where a tier's PSNR is too far below that of the trained model."""
    for tier, one in zip(tiers, models, strict=True):
        assert tier.validation is not None
        trained = np.mean([psnr(shade(one.model, v), v.samples["radiance"]) for v in views])
        if not trained - tier.validation.psnr <= max_loss:
            raise ExportError(
                f"{tier.name}: found {tier.validation.psnr:.2f} dB, the trained model has "
                f"{trained:.2f} dB; expected to lose at most {max_loss:g} dB (--max-loss)"
            )


def _validation(asset: Asset, views: list[ValidationView]) -> Validation:
    radiance = [view.shaded_by(asset) for view in views]
    scores = score(radiance, views)
    return Validation(
        psnr=scores.psnr,
        flip=scores.flip,
        relative_mse=scores.relative_mse,
        images=scores.images,
        definition=f"psnr: {PSNR_DEFINITION}; flip: {FLIP_DEFINITION}",
        flip_at_height=flip_at_heights(radiance, views),
    )


def _cost(asset: Asset, multiply_adds: int, views: list[ValidationView]) -> Cost:
    """Median over five runs on real queries."""
    every = all_queries(views)
    wanted = np.arange(_COST_ROWS) % len(every[0])
    rows = [values[wanted] for values in every]
    seconds = [seconds_of(lambda: asset.evaluate(*rows)) for _ in range(6)]
    return Cost(
        multiply_adds=multiply_adds,
        ns_per_query=1e9 * float(np.median(seconds[1:])) / _COST_ROWS,
        threads=asset.threads,
        machine=f"{processor()}, {len(os.sched_getaffinity(0))} cores",
    )


def _provenance(trained: list[Trained], dataset: Dataset, source: str | None) -> Provenance:
    manifest = dataset.manifest
    runs = {
        one.preset_name: {
            "steps": one.steps,
            "seed": one.seed,
            **one.preset.model_dump(mode="json"),
        }
        for one in trained
    }
    return Provenance(
        source=source or f"{manifest.source} (sha256 {manifest.source_sha256})",
        tool=f"Blender {manifest.blender} Cycles, {manifest.generator}, "
        f"PyTorch {torch.__version__}",
        capture=manifest.settings.model_dump(mode="json", by_alias=True),
        training=runs,
    )
