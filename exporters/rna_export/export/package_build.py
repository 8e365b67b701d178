"""Checkpoints to one package: one tier each, with measured error and cost."""

import tempfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import torch

import rna_sdk
from rna_export.albedo import white_views
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.compare.origin import SOURCE_SHA256
from rna_export.export.measure import check_loss, measured
from rna_export.export.precision import MAX_LOSS, Precision
from rna_export.export.tiers import package_tiers
from rna_export.export.trained_tiers import TrainedTier, trained_tiers
from rna_export.training.checkpoint import Trained
from rna_sdk.files.atomic_file import write_atomically
from rna_sdk.files.file_kinds import glass_of
from rna_sdk.package import Bounds, Manifest, Part, Provenance, TierData, write_package
from rna_sdk.package.manifest.manifest_fields import GEOMETRY_ENTRIES
from rna_sdk.package.manifest.manifest_model import POSES, REST_FRAME
from rna_sdk.runtime import load


def build_package(
    trained: Sequence[Trained],
    dataset: Dataset,
    out: Path,
    source: str | None,
    license_: str,
    say: Callable[[str], None],
    precisions: Sequence[Precision] | Mapping[str, Sequence[Precision]] = (Precision(),),
    is_measured: bool = True,
    max_loss: float = MAX_LOSS,
    name: str | None = None,
) -> Manifest:
    """Write `out` with a tier for each preset and precision; returns its manifest.

    The glass that is left to hosts is written beside it: `glass_of`.

    trained: a model of each part of the dataset for each preset. precisions: of each preset's
    tiers, or by its name. Tiers are named for the preset and, unless it is the usual one, the
    precision. name: of the asset; None for the dataset's, the name of the source's file.

    Each tier's error and cost are measured through the runtime, from a package like the one
    written, unless that is not wanted: then the manifest has neither. Raises `ExportError` when
    the checkpoints do not belong together or to the dataset, a decoder is not the trained one, or
    a measured tier loses more than `max_loss` dB against it.
    """
    models = trained_tiers(trained, dataset)
    tiers, of_tiers, data = [], [], {}
    for model in models:
        wanted = precisions[model.preset_name] if isinstance(precisions, Mapping) else precisions
        for tier, tier_data in package_tiers(model, dataset, wanted, say):
            tiers.append(tier)
            of_tiers.append(model)
            data[tier.name] = tier_data
    manifest = Manifest(
        generator=f"rna-export {rna_sdk.__version__}",
        name=name or dataset.manifest.name,
        parts=_parts(models[0], dataset),
        domain=dataset.manifest.domain,
        tiers=tuple(tiers),
        provenance=_provenance(models, dataset, source),
        license=license_,
    )
    if is_measured:
        manifest = _measure(manifest, of_tiers, dataset, data, max_loss, say)
    if (glass := dataset.glass) is not None:
        write_atomically(glass_of(out), glass)
    return write_package(out, manifest, *_of_parts(dataset, data))


def _of_parts(dataset: Dataset, data: dict[str, list[TierData]]) -> tuple[Any, ...]:
    """Geometry, the tiers' data and textures, as `write_package` takes them."""
    textures = {
        name: texture
        for part in dataset.parts
        for name, texture in (part.textures() | part.base_color_files()).items()
    }
    return [part.geometry() for part in dataset.parts], data, textures


def _parts(model: TrainedTier, dataset: Dataset) -> tuple[Part, ...]:
    several, parts = len(dataset.parts) > 1, []
    for part, one in zip(dataset.parts, model.parts, strict=True):
        low, high = one.model.triplane.low, one.model.triplane.high
        usual = GEOMETRY_ENTRIES[part.kind]
        members = {
            "transmittance": part.captured.transmittance,
            "normal_maps": part.captured.normal_maps,
            "base_color": part.captured.base_color,
        }
        parts.append(
            Part(
                name=part.name,
                kind=part.kind,
                bounds=Bounds(min=tuple(low.tolist()), max=tuple(high.tolist())),
                geometry=f"geometry/{part.name}{Path(usual).suffix}" if several else usual,
                **{name: records for name, records in members.items() if records},
            )
        )
    return tuple(parts)


def _measure(
    manifest: Manifest,
    models: list[TrainedTier],
    dataset: Dataset,
    data: dict[str, list[TierData]],
    max_loss: float,
    say: Callable[[str], None],
) -> Manifest:
    """The manifest with each tier's error and cost, as the runtime gives them."""
    views, tiers = dataset.whole_views(), []
    glowing = [part.emission_views() for part in dataset.parts]
    white = white_views(dataset.parts)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "measured.rna"
        write_package(path, manifest, *_of_parts(dataset, data))
        for tier, model in zip(manifest.tiers, models, strict=True):
            asset = load(path, tier=tier.name)
            tier = measured(tier, asset, model, views, glowing, white, say)
            check_loss(tier, model, views, max_loss)
            tiers.append(tier)
    return manifest.model_copy(update={"tiers": tuple(tiers)})


def _provenance(models: list[TrainedTier], dataset: Dataset, source: str | None) -> Provenance:
    manifest = dataset.manifest
    runs = {model.preset_name: _runs(model) for model in models}
    return Provenance(
        source=source or f"{manifest.source} (sha256 {manifest.source_sha256})",
        tool=f"Blender {manifest.blender} Cycles, {manifest.generator}, "
        f"PyTorch {torch.__version__}",
        capture={
            **manifest.settings.model_dump(mode="json", by_alias=True),
            SOURCE_SHA256: manifest.source_sha256,
            REST_FRAME: manifest.rest_frame,
            POSES: list(manifest.poses),
        },
        training=runs,
    )


def _runs(model: TrainedTier) -> dict[str, Any]:
    """Training settings of the tier; by part if there are several."""
    runs = {
        one.part: {"steps": one.steps, "seed": one.seed, **one.preset.model_dump(mode="json")}
        for one in model.parts
    }
    return runs if len(runs) > 1 else next(iter(runs.values()))
