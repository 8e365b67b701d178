"""Trained lobes in package form."""

from __future__ import annotations

import numpy as np
import torch

from rna_export.export.decoder import compare_answers, export_decoder
from rna_export.lobes.lobe_model import LOBES, LobeModel
from rna_export.lobes.lobe_queries import QueryRows
from rna_export.lobes.view_points import PartViews
from rna_sdk.package import Lobes

_COMPARED, _EXTREME, _FAR = 5000, 500, 10.0  # queries; factor on extreme ones


def exported_lobes(model: LobeModel, views: PartViews, queries: QueryRows, tier: str) -> Lobes:
    """The decoder in ONNX, compared with the trained one, and the visibility that it reads.

    Raises ExportError where they differ.
    """
    decoder = export_decoder(model)
    points = views.points(_COMPARED, np.random.default_rng(1))
    usual = torch.from_numpy(queries.of(points).queries)
    far = _FAR * usual[:_EXTREME]
    extreme = torch.cat([torch.zeros_like(usual[:1]), far, -far])
    return Lobes(
        tier=tier,
        lobes=LOBES,
        inputs=queries.inputs,
        decoder=decoder,
        harmonics=views.visibility,
        agreement=compare_answers(decoder, model, usual, extreme),
    )
