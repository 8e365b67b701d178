"""Packages of random weights, for the speed of evaluation alone."""

from pathlib import Path

import numpy as np
import torch
import trimesh

from rna_bench.speed.query_batches import unit
from rna_export.export.decoder import decoders_of, export_decoder, random_queries
from rna_export.export.int8_decoder import int8_decoder
from rna_export.export.precision import PRECISIONS, Precision, stored_planes
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.model.triplane import Triplane
from rna_export.training.presets import PRESETS, ModelConfig
from rna_sdk.package import (
    Bounds,
    Domain,
    Manifest,
    Mesh,
    Part,
    Provenance,
    Tier,
    TierData,
    TierPart,
    write_package,
)
from rna_sdk.package.manifest.manifest_fields import GEOMETRY_ENTRIES

INPUTS = PRESETS["surface"]["small"].model.inputs
HIDDEN_LAYERS = 4


def write_random_package(path: Path, width: int, resolution: int, channels: int) -> None:
    """A surface with random planes and a random decoder, a tier for each of PRECISIONS."""
    model = random_model(width, resolution, channels)
    tiers = [random_tier(name, model, precision) for name, precision in PRECISIONS.items()]
    bounds = Bounds(min=(-1, -1, -1), max=(1, 1, 1))
    part = Part(name="asset", kind="surface", bounds=bounds, geometry=GEOMETRY_ENTRIES["surface"])
    manifest = Manifest(
        generator="rna-bench evaluate",
        name="random",
        parts=(part,),
        domain=Domain(wo="sphere", wi="sphere"),
        tiers=tuple(tiers),
        provenance=Provenance(source="random numbers", tool="rna-bench evaluate"),
        license="Apache-2.0",
    )
    data = {tier.name: [random_data(model, tier.parts[0])] for tier in tiers}
    write_package(path, manifest, [ball()], data)


def random_model(width: int, resolution: int, channels: int) -> NeuralAsset:
    """An untrained model over the box from -1 to 1, planes of deviation 0.5."""
    config = ModelConfig(
        inputs=INPUTS,
        width=width,
        hidden_layers=HIDDEN_LAYERS,
        resolution=resolution,
        channels=channels,
    )
    torch.manual_seed(0)
    model = NeuralAsset(config, torch.tensor([[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]])).eval()
    _planes(model).data.normal_(std=0.5)
    return model


def random_tier(name: str, model: NeuralAsset, precision: Precision) -> Tier:
    part = TierPart(
        planes=f"features/{name}.safetensors",
        decoder=f"decoders/{name}.onnx",
        inputs=model.config.inputs,
        resolution=model.config.resolution,
        channels=model.config.channels,
        plane_precision=precision.planes,
        decoder_precision=precision.decoder,
    )
    return Tier(name=name, parts=(part,))


def _planes(model: NeuralAsset) -> torch.Tensor:
    assert isinstance(model.triplane, Triplane)
    return model.triplane.planes


@torch.no_grad()
def random_data(model: NeuralAsset, part: TierPart) -> TierData:
    planes = stored_planes(_planes(model).detach().numpy(), part.plane_precision)
    (decoder,) = decoders_of(model)
    layers = None
    if part.decoder_precision == "int8":
        layers = int8_decoder(decoder.decoder, random_queries(decoder, 20_000, seed=0))
    return TierData(planes=planes, decoder=export_decoder(decoder, layers))


def ball() -> Mesh:
    shape = trimesh.creation.icosphere(subdivisions=2, radius=0.95)
    positions = np.asarray(shape.vertices, np.float32)
    faces = np.asarray(shape.faces, np.uint32)
    return Mesh(positions=positions, normals=unit(positions), uvs=None, triangles=faces)
