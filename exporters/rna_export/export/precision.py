"""Number formats of a tier: planes and decoder."""

from argparse import ArgumentParser, ArgumentTypeError
from collections.abc import Collection, Sequence
from dataclasses import dataclass

import numpy as np

from rna_sdk.errors import ExportError
from rna_sdk.package import Int8Planes, Planes
from rna_sdk.package.manifest.manifest_fields import DecoderPrecision, PlanePrecision


@dataclass(frozen=True)
class Precision:
    """A tier's decoderPrecision and planePrecision."""

    decoder: DecoderPrecision = "float32"
    planes: PlanePrecision = "int8"

    def tier_name(self, preset: str) -> str:
        """The preset's name, marked unless this is the usual precision."""
        if self == Precision():
            return preset
        if self.decoder == self.planes:
            return f"{preset}-{self.decoder}"
        return f"{preset}-{self.decoder}-{self.planes}"

    def planes_entry(self, preset: str) -> str:
        """The package's entry with the planes, which tiers of the same planes share."""
        return f"features/{preset}{_mark(self.planes, 'int8')}.safetensors"

    def decoder_entry(self, preset: str) -> str:
        """The package's entry with the decoder, shared in the same way."""
        return f"decoders/{preset}{_mark(self.decoder, 'float32')}.onnx"


def _mark(precision: str, usual: str) -> str:
    return "" if precision == usual else f"-{precision}"


MAX_LOSS = 0.5
"""PSNR that a tier may lose against the trained model before the export is refused, dB."""

PRECISIONS = {
    "float32": Precision(),
    "int8": Precision("int8"),
    "float32-float16": Precision(planes="float16"),
}
"""The values of `--precision`."""


def add_precision(p: ArgumentParser) -> None:
    """Add --precision."""
    p.add_argument(
        "--precision",
        nargs="+",
        type=precision_word,
        metavar="FORMAT",
        default=[],
        help="number formats, one tier per preset and format; float32: float32 decoder and int8 "
        "planes; int8: int8 decoder and planes (tier suffix -int8); float32-float16: float32 "
        "decoder and float16 planes, twice the size. PRESET=FORMAT overrides the formats of one "
        "preset (default: float32)",
    )


def precision_word(word: str) -> tuple[str, Precision]:
    """FORMAT or PRESET=FORMAT of `--precision`: the preset, "" for all, and the format.

    Raises `ArgumentTypeError` for another format.
    """
    preset, _, name = word.rpartition("=")
    if name not in PRECISIONS:
        raise ArgumentTypeError(f"found {word}, expected [PRESET=]{'|'.join(PRECISIONS)}")
    return preset, PRECISIONS[name]


def precisions_of(
    given: Sequence[tuple[str, Precision]], presets: Collection[str]
) -> dict[str, list[Precision]]:
    """Preset -> its formats; those for one preset are in place of those for all.

    given: as `precision_word` has them. Raises `ExportError` for a preset that is not there.
    """
    of: dict[str, list[Precision]] = {"": [], **{preset: [] for preset in presets}}
    for preset, precision in dict.fromkeys(given):
        if preset not in of:
            raise ExportError(
                f"--precision: found preset {preset!r}, expected one of {', '.join(presets)}"
            )
        of[preset].append(precision)
    return {preset: of[preset] or of[""] or [Precision()] for preset in presets}


def stored_planes(planes: np.ndarray, precision: PlanePrecision) -> Planes:
    """Float32 planes as a package holds them; `ExportError` when they do not fit."""
    if precision == "int8":
        return _int8(planes)
    if np.abs(planes).max() > np.finfo(precision).max:
        raise ExportError(f"plane values exceed the range of {precision}")
    return planes.astype(precision)


def _int8(planes: np.ndarray) -> Int8Planes:
    """Rounded to steps by which the largest texel of each plane and channel is 127."""
    scales = np.maximum(np.abs(planes).max(axis=(1, 2)), np.finfo(np.float32).tiny * 127) / 127
    texels = np.round(planes / scales[:, None, None, :]).astype(np.int8)
    return Int8Planes(texels, scales.astype(np.float32))
