"""Stand-in textures that an export makes by itself: a short fit of glTF's material."""

from collections.abc import Callable

import torch

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.export.standin_textures import TEXELS, standin_textures, texture_mesh, uv_points
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.optimization.fitting import Fitting
from rna_export.training.optimization.losses import with_fitting_loss
from rna_export.training.optimization.samples import SampleTable
from rna_export.training.presets import ANALYTIC
from rna_export.training.training_run import padded_bounds
from rna_sdk.errors import ExportError

LARGEST_SHARE = 0.15
"""Share of a package's size that textures may add to it."""

_SIDES = (TEXELS, TEXELS // 2, TEXELS // 4)
_RESOLUTION = 128  # of planes: so few steps fit no finer ones
_STEPS = 800
_PASSES = 40  # over samples that are few
_SHARDS = 12

Textures = list[dict[str, bytes] | None]


def textures_within(dataset: Dataset, size: int, say: Callable[[str], None]) -> Textures:
    """The textures of each part in the largest side that adds at most LARGEST_SHARE to `size`
    bytes; None for parts that have base colour, which viewers draw stand-ins with, or that can
    have none.
    """
    parts = [part if _is_bare(part) else None for part in dataset.parts]
    models = [None if part is None else _fitted(part) for part in parts]
    if not any(models):
        return [None] * len(parts)
    for side in _SIDES:
        textures = [
            standin_textures(model, texture_mesh(part), side) if part and model else None
            for part, model in zip(parts, models, strict=True)
        ]
        added = sum(len(png) for one in textures if one for png in one.values())
        if added <= LARGEST_SHARE * size:
            share = 100.0 * added / size
            say(f"stand-in: textures of {side} x {side} texels, {share:.0f}% of the package")
            return textures
    say(f"stand-in: no textures, they exceed {LARGEST_SHARE:.0%} of the package")
    return [None] * len(parts)


def _is_bare(part: DatasetPart) -> bool:
    """Whether the part has no colours for a stand-in, and can have textures."""
    if part.captured.base_color:
        return False
    try:
        uv_points(texture_mesh(part), _SIDES[-1])
    except ExportError:
        return False
    return True


def _fitted(part: DatasetPart) -> NeuralAsset:
    """glTF's material by place, fitted to some of the part's samples on the CPU."""
    table = SampleTable(part.training_samples(_SHARDS))
    preset = ANALYTIC.with_model(resolution=_RESOLUTION)
    preset = with_fitting_loss(preset, part, table.usual_radiance).for_rows(len(table))
    batch = preset.training.batch
    steps = min(_STEPS, max(1, _PASSES * len(table) // batch))
    rows = iter(table.shuffled(batch, 0, 0))
    ceiling = 1.5 * table.largest_radiance
    torch.manual_seed(0)
    fitting = Fitting(preset, padded_bounds(part), ceiling, table.usual_radiance, table.fields)
    for step in range(steps):
        fitting.step(next(rows), step / steps)
    return fitting.model.eval()
