"""Small packages for the readers written by hand: any width, precision and kind."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import onnx
from onnx import numpy_helper

from rna_sdk.package import Tier, TierData, TierPart, write_package
from rna_sdk.package.geometry.geometry_files import quantise
from rna_sdk.package.manifest.extensions import Standin, StandinMaterial
from rna_sdk.package.packing import Unpacked
from tests.conformance.kit.decoders import make_decoder, make_int8_decoder
from tests.package.builders import (
    make_curves,
    make_manifest,
    make_mesh,
    make_planes,
    make_tier,
    make_tier_data,
)
from tests.package.corpus.registry import DECODER, Entries, with_entry
from tests.package.lantern import make_lantern, make_lantern_manifest, make_textures
from tests.package.prints import make_print
from tests.package.relief import make_maps, make_relief, make_relief_manifest

SURFACE_INPUTS = (
    *("features", "position", "normal", "wo", "wi"),
    *("half_vector", "highlight", "learned_normal"),
)
FIBER_INPUTS = ("features", "tangent", "h", "wo", "wi", "fiber_angles", "fiber_lobes")


def make_profile_tier(name: str, kind: str, **changes: Any) -> Tier:
    """A tier with every block of the kind."""
    return make_tier(name, inputs=SURFACE_INPUTS if kind == "surface" else FIBER_INPUTS, **changes)


def write_profile_package(path: Path, *tiers: Tier, kind: str = "surface") -> Path:
    """Write a package of `kind` with these tiers: random planes, and a random layer of 8 units."""
    data = {tier.name: [_part_data(tier.parts[0], (8,))] for tier in tiers}
    geometry = make_curves() if kind == "fiber" else make_mesh()
    write_package(path, make_manifest(*tiers, kind=kind), [geometry], data)
    return path


def _part_data(part: TierPart, widths: tuple[int, ...]) -> TierData:
    rng = np.random.default_rng(sum(widths))
    queries = np.clip(rng.normal(0, 0.6, (400, part.query_width)), -2, 2)
    decoder = make_decoder(rng, queries, widths, mixing=9 if len(widths) == 2 else 0)
    is_int8 = part.decoder_precision == "int8"
    file = (make_int8_decoder(decoder, queries) if is_int8 else decoder).file()
    planes = make_planes(part.resolution, part.channels, part.plane_precision)
    return TierData(planes, file)


def broken_constants(entries: Entries, number: float) -> Iterator[bytes]:
    """For each array of float32 in the decoder, the package with `number` as its last value."""
    for k in range(len(onnx.load_from_string(entries[DECODER]).graph.initializer)):
        model = onnx.load_from_string(entries[DECODER])
        constant = model.graph.initializer[k]
        values = numpy_helper.to_array(constant).copy()
        if values.dtype == np.float32:
            values.flat[-1] = number
            constant.CopyFrom(numpy_helper.from_array(values, constant.name))
            yield with_entry(entries, DECODER, model.SerializeToString())


def _write_plain(folder: Path) -> list[Path]:
    """Write packages of 5 to 10 KB below `folder`: kinds, planes and decoders."""
    paths = []
    for kind in ("surface", "fiber"):
        for decoder, planes in (
            ("float32", "float16"),
            ("float32", "float32"),
            ("float32", "int8"),
            ("int8", "float16"),
            ("int8", "int8"),
        ):
            changes = {"decoder_precision": decoder, "plane_precision": planes}
            tier = make_profile_tier("small", kind, resolution=8, channels=4, **changes)
            path = folder / f"{kind}-{decoder}-{planes}.rna"
            paths.append(write_profile_package(path, tier, kind=kind))
    return paths


def _write_rich(folder: Path) -> list[Path]:
    """Write packages of 6 to 20 KB below `folder` with all else that the format has.

    Parts with emission, holes and glass; normal maps; both with quantised geometry; proxies, a
    stand-in and a poster; entries that are coded; base colour, and a decoder of shadowed light.
    """
    lantern = make_lantern(folder / "parts.rna")
    coded = folder / "coded.rna"
    Unpacked.read(lantern).deflated().write(coded)
    return [
        lantern,
        write_quantised(folder / "quantised.rna"),
        make_relief(folder / "relief.rna"),
        _write_quantised_relief(folder / "quantised-relief.rna"),
        _write_proxies(folder / "proxies.rna"),
        coded,
        make_print(folder / "print.rna"),
    ]


def write_fuzz_packages(folder: Path) -> list[Path]:
    """Write all packages to mutate below `folder`."""
    return [*_write_plain(folder), *_write_rich(folder)]


def write_quantised(path: Path) -> Path:
    """Write the package of `make_lantern` with quantised geometry."""
    manifest = make_lantern_manifest()
    data = {tier.name: make_tier_data(tier) for tier in manifest.tiers}
    geometries = [quantise(make_mesh()), quantise(make_curves())]
    write_package(path, manifest, geometries, data, make_textures())
    return path


def _write_quantised_relief(path: Path) -> Path:
    manifest = make_relief_manifest()
    data = {tier.name: make_tier_data(tier) for tier in manifest.tiers}
    write_package(path, manifest, [quantise(make_mesh())], data, make_maps())
    return path


def _write_proxies(path: Path) -> Path:
    """Two parts without textures, each with a proxy, a stand-in and a poster."""
    parts = tuple(
        part.model_copy(update={"transmittance": ()}) for part in make_lantern_manifest().parts
    )
    manifest = make_lantern_manifest(parts=parts)
    data = {tier.name: make_tier_data(tier) for tier in manifest.tiers}
    write_package(path, manifest, [make_mesh(), make_curves()], data)
    material = StandinMaterial(base_color=(0.5, 0.4, 0.3), roughness=0.5, metallic=0)
    proxies = [[(make_mesh(uvs=False), 64)], [(quantise(make_curves()), 32)]]
    package = Unpacked.read(path).with_poster(_PNG).with_proxies(proxies)
    package.with_extension(Standin(parts=(material, material)), {}).write(path)
    return path


_PNG = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\2\0\0\0\1\x08\6\0\0\0"
"""The first bytes of a PNG of 2 by 1, all that a reader checks."""
