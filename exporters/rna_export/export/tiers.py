"""A trained tier in package form: planes and decoders of each part and precision."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import torch

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.capture.dataset.nearby_rows import of_image
from rna_export.capture.dataset.validation_view import queries_of
from rna_export.export.decoder import (
    DecoderModel,
    compare_decoder,
    compare_int8_decoder,
    decoders_of,
    export_decoder,
)
from rna_export.export.int8_decoder import int8_decoder
from rna_export.export.int8_tuning import Calibration, tuned
from rna_export.export.precision import Precision, stored_planes
from rna_export.export.trained_tiers import TrainedTier
from rna_export.training.checkpoint import Trained
from rna_export.training.presets import ModelConfig
from rna_sdk.package import Agreement, Tier, TierData, TierPart
from rna_sdk.package.decoder.decoder_form import EMISSION, SHADOWED, TRANSPORT, VISIBLE
from rna_sdk.package.manifest.manifest_fields import DecoderPrecision
from rna_sdk.package.manifest.manifest_tiers import TierNearby

_CALIBRATION_ROWS = 50_000
_CALIBRATION_SHARDS = 12


def package_tiers(
    trained: TrainedTier,
    dataset: Dataset,
    precisions: Sequence[Precision],
    say: Callable[[str], None],
) -> Iterator[tuple[Tier, list[TierData]]]:
    """A tier for each precision; those of one precision of planes or decoder share it."""
    parts = [
        _PartExport(one, part, say) for one, part in zip(trained.parts, dataset.parts, strict=True)
    ]
    for precision in precisions:
        made = [part.tier_part(precision) for part in parts]
        name = precision.tier_name(trained.preset_name)
        yield Tier(name=name, parts=tuple(part for part, _ in made)), [data for _, data in made]


class _PartExport:
    """One part of a trained tier."""

    def __init__(self, one: Trained, part: DatasetPart, say: Callable[[str], None]):
        self._one, self._part, self._say = one, part, say
        self._exported: dict[tuple[str, DecoderPrecision], tuple[bytes, Agreement]] = {}

    def tier_part(self, precision: Precision) -> tuple[TierPart, TierData]:
        """The part's record in a tier of this precision, and its data."""
        one, config = self._one, self._one.preset.model
        main, *others = decoders_of(one.model)
        decoder, agreement = self._of(main, precision.decoder)
        several = len(self._part.dataset.parts) > 1
        stem = f"{one.part}/{one.preset_name}" if several else one.preset_name
        self._say(
            f"{precision.tier_name(stem)}: the {precision.decoder} ONNX decoder and PyTorch differ "
            f"by at most {agreement.max_absolute:.1e} absolute, {agreement.max_relative:.1e} "
            "relative"
        )
        records, data = self._others(others, precision, stem)
        record = TierPart(
            planes=precision.planes_entry(stem),
            decoder=precision.decoder_entry(stem),
            inputs=config.inputs,
            resolution=config.resolution,
            channels=config.channels,
            plane_precision=precision.planes,
            decoder_precision=precision.decoder,
            agreement=agreement,
            uses_base_color=config.uses_base_color or None,
            nearby=_nearby(one),
            **records,
        )
        planes = stored_planes(main.triplane.planes.detach().numpy(), precision.planes)
        return record, TierData(planes, decoder, data)

    def _others(
        self, models: Sequence[DecoderModel], precision: Precision, stem: str
    ) -> tuple[dict[str, Any], dict[str, bytes]]:
        """Members of the record, and decoders, of other forms; emission is always float32."""
        records, data = {}, {}
        for model in models:
            arithmetic = "float32" if model.output == EMISSION.name else precision.decoder
            data[model.output], agreement = self._of(model, arithmetic)
            entry = Path(replace(precision, decoder=arithmetic).decoder_entry(stem))
            records[model.output] = {
                "decoder": str(entry.with_name(f"{entry.stem}-{model.output}.onnx")),
                "inputs": model.inputs,
                "decoder_precision": arithmetic,
                "agreement": agreement,
            }
        return records, data

    def _of(self, model: DecoderModel, precision: DecoderPrecision) -> tuple[bytes, Agreement]:
        """The exported decoder, and how far it is from the trained one."""
        key = model.output, precision
        if key not in self._exported:
            config = self._one.preset.model
            self._exported[key] = _exported(model, precision, self._part, config)
        return self._exported[key]


def _nearby(one: Trained) -> TierNearby | None:
    """Nearby light that the model counts, as a tier part has it."""
    lengths = one.preset.model.nearby
    if not lengths:
        return None
    visible, shadowed = (tuple(means) for means in one.model.nearby_means.tolist())
    return TierNearby(lengths=lengths, visible=visible, shadowed=shadowed)


def _exported(
    model: DecoderModel, precision: DecoderPrecision, part: DatasetPart, config: ModelConfig
) -> tuple[bytes, Agreement]:
    if precision == "float32":
        exported = export_decoder(model)
        return exported, compare_decoder(exported, model)
    at = calibration(model, part, config)
    layers = tuned(int8_decoder(model.decoder, at.queries), model, at)
    exported = export_decoder(model, layers)
    return exported, compare_int8_decoder(exported, model, layers, at.queries)


@torch.no_grad()
def calibration(model: DecoderModel, part: DatasetPart, config: ModelConfig) -> Calibration:
    """Random samples of the training data, of those whose light the decoder gives.

    config: of the model that the decoder is of.
    """
    samples = part.training_samples(_CALIBRATION_SHARDS)
    visible = samples["visible"].astype(np.float32).reshape(len(samples["visible"]), -1)
    share = {VISIBLE.name: visible, SHADOWED.name: 1.0 - visible}
    weights = list(share.values()) if model.output == TRANSPORT.name else [share[model.output]]
    rows = np.flatnonzero(np.stack(weights).max(axis=(0, 2)) > 0.0)
    picked = rows[np.random.default_rng(0).permutation(len(rows))[:_CALIBRATION_ROWS]]
    points = {k: torch.from_numpy(v[picked]) for k, v in queries_of(samples).items()}
    of_outputs = np.stack([weight[picked] for weight in weights], axis=1)
    if config.uses_base_color and model.output != EMISSION.name:
        color = samples["base_color"][picked][:, None].astype(np.float32)
        of_outputs = np.concatenate([of_outputs * np.ones_like(color), of_outputs * color], axis=1)
    if lengths := config.nearby:
        some = {name: samples[name][picked] for name in ("position", "wi")}
        nearby = of_image(some, part, lengths)
        shares = nearby.T[:, :, None, None]
        of_outputs = np.concatenate([of_outputs, *(of_outputs * s for s in shares)], axis=1)
    return Calibration(model.queries(points), torch.from_numpy(of_outputs))
