"""A trained tier in package form: planes and decoders of each part and precision."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np
import torch

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.capture.dataset.validation_view import queries_of
from rna_export.export.decoder import (
    compare_decoder,
    compare_int8_decoder,
    export_decoder,
    other_models,
)
from rna_export.export.int8_decoder import int8_decoder
from rna_export.export.int8_tuning import Calibration, tuned
from rna_export.export.precision import Precision, stored_planes
from rna_export.export.trained_tiers import TrainedTier
from rna_export.training.checkpoint import Trained
from rna_export.training.model.triplane import Triplane
from rna_sdk.package import Agreement, Tier, TierData, TierPart
from rna_sdk.package.decoder.decoder_form import form_named
from rna_sdk.package.manifest.manifest_fields import DecoderPrecision

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
        self._decoders: dict[DecoderPrecision, tuple[bytes, Agreement]] = {}

    def tier_part(self, precision: Precision) -> tuple[TierPart, TierData]:
        """The part's record in a tier of this precision, and its data."""
        one, config = self._one, self._one.preset.model
        decoder, agreement = self._decoder(precision.decoder)
        several = len(self._part.dataset.parts) > 1
        stem = f"{one.part}/{one.preset_name}" if several else one.preset_name
        self._say(
            f"{precision.tier_name(stem)}: the {precision.decoder} ONNX decoder and PyTorch differ "
            f"by at most {agreement.max_absolute:.1e} absolute, {agreement.max_relative:.1e} "
            "relative"
        )
        records, others = self._others(stem)
        record = TierPart(
            planes=precision.planes_entry(stem),
            decoder=precision.decoder_entry(stem),
            inputs=config.inputs,
            resolution=config.resolution,
            channels=config.channels,
            plane_precision=precision.planes,
            decoder_precision=precision.decoder,
            agreement=agreement,
            **records,
        )
        triplane = one.model.triplane
        assert isinstance(triplane, Triplane)
        planes = stored_planes(triplane.planes.detach().numpy(), precision.planes)
        return record, TierData(planes, decoder, others)

    def _others(self, stem: str) -> tuple[dict[str, Any], dict[str, bytes]]:
        """Members of the record, and decoders, of other forms: float32 in all precisions."""
        records, decoders = {}, {}
        for model in other_models(self._one.model):
            decoder = decoders[model.output] = export_decoder(model)
            records[form_named(model.output).member] = {
                "decoder": f"decoders/{stem}-{model.output}.onnx",
                "inputs": model.inputs,
                "decoder_precision": "float32",
                "agreement": compare_decoder(decoder, model),
            }
        return records, decoders

    def _decoder(self, precision: DecoderPrecision) -> tuple[bytes, Agreement]:
        """The exported decoder, and how far it is from the trained one."""
        if precision not in self._decoders:
            self._decoders[precision] = _exported(self._one, precision, self._part)
        return self._decoders[precision]


def _exported(
    one: Trained, precision: DecoderPrecision, part: DatasetPart
) -> tuple[bytes, Agreement]:
    if precision == "float32":
        exported = export_decoder(one.model)
        return exported, compare_decoder(exported, one.model)
    at = calibration(one, part)
    layers = tuned(int8_decoder(one.model, at.queries), one.model, at)
    exported = export_decoder(one.model, layers)
    return exported, compare_int8_decoder(exported, one.model, layers, at.queries)


@torch.no_grad()
def calibration(one: Trained, part: DatasetPart) -> Calibration:
    """Random samples of the training data."""
    samples = part.training_samples(_CALIBRATION_SHARDS)
    rows = len(samples["position"])
    picked = np.random.default_rng(0).permutation(rows)[:_CALIBRATION_ROWS]
    points = {k: torch.from_numpy(v[picked]) for k, v in queries_of(samples).items()}
    visible = torch.from_numpy(samples["visible"][picked].astype(np.float32))
    return Calibration(one.model.queries(points), visible.reshape(len(picked), -1))
