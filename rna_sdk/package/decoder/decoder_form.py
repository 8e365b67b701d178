"""Decoder forms: the kinds of decoder that a part can have in a tier.

A form says what a decoder gives, of which query arrays, and so of which input blocks; validator,
writer, runtime, exporter and conformance kit go by it. A new form is a value here and, in
`manifest_tiers.py`, the member of a tier part that declares it, or a record of an extension.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.blocks import UNLIT_BLOCKS, blocks_for

if TYPE_CHECKING:
    from rna_sdk.package.manifest.manifest_fields import DecoderPrecision

INPUT_NAME = "queries"

COLUMNS = 3
"""Columns of each result: RGB, or XYZ."""

NEARBY_LENGTHS = 3
NEARBY_SETS = 1 + NEARBY_LENGTHS
"""Sets of columns of a decoder with nearby light: its output is the first, plus each of the others
times the nearby light of one length."""


@dataclass(frozen=True)
class DecoderForm:
    """A kind of decoder.

    Attributes:
        name: of the form and of the decoder's one output.
        results: what the output's columns are, COLUMNS each, side by side.
        arrays: names of the QUERY_ARRAYS that it takes.
        member: of a tier part, with the decoder's record; "" for the tier part itself.
        count: name of a member of the record: so many times there are all results; "" for once.
        has_factors: whether a tier part that uses base colour has a factor of each result, in the
            same order behind them: the result is then `output + base colour * factor`. In a tier
            part with nearby light all of these columns are there NEARBY_SETS times.
    """

    name: str
    results: tuple[str, ...]
    arrays: tuple[str, ...]
    member: str = ""
    count: str = ""
    has_factors: bool = False

    @property
    def path(self) -> tuple[str, ...]:
        """From a tier part to the decoder's record in the manifest."""
        return (self.member,) if self.member else ()

    def record(self, part: Any) -> Any:
        """The record of such a decoder in a tier part; None if the part has none."""
        return getattr(part, self.member) if self.member else part

    def result_count(self, record: Any) -> int:
        """Results of a decoder with this record; of None, all results once."""
        sets = getattr(record, self.count) if self.count and record is not None else 1
        return len(self.results) * int(sets)

    def width(self, record: Any, uses_base_color: bool = False, nearby: bool = False) -> int:
        """Columns of the output, in a tier part that has base colour and nearby light or not."""
        sets = 1
        if self.has_factors:
            sets *= (2 if uses_base_color else 1) * (NEARBY_SETS if nearby else 1)
        return COLUMNS * self.result_count(record) * sets

    def blocks(self, kind: str) -> list[str]:
        """The input blocks that it can have in a part of this kind."""
        lit = "wi" in self.arrays
        return [name for name in blocks_for(kind) if lit or name in UNLIT_BLOCKS]


_LIT = ("position", "axis", "h", "wo", "wi")
_COLOURED = (*_LIT, "base_color")

TRANSPORT = DecoderForm("transport", ("visible", "shadowed"), _COLOURED, has_factors=True)
VISIBLE = DecoderForm("visible", ("visible",), _COLOURED, has_factors=True)
SHADOWED = DecoderForm("shadowed", ("shadowed",), _COLOURED, "shadowed", has_factors=True)
"""These two together are TRANSPORT, of a tier part with a decoder for shadowed light."""

EMISSION = DecoderForm("emission", ("radiance",), ("position", "axis", "h", "wo"), "emission")

FORMS = (TRANSPORT, EMISSION)
"""Forms of a tier part: always the first, and the other if it has a decoder of it."""

ENVIRONMENT = DecoderForm("environment", ("visible", "shadowed", "axis"), _LIT, count="lobes")
"""Form of the extension RNA_environment; wi is the mirror direction of wo."""


def form_named(name: str) -> DecoderForm:
    """The form of this name, which must be one of FORMS."""
    return next(form for form in FORMS if form.name == name)


@dataclass(frozen=True)
class PartDecoder:
    """A decoder of a part in a tier, by the manifest.

    Attributes:
        entry: its name.
        columns: K, of the input `queries`: those of the blocks, and any others behind them.
        width: of the output.
        precision: of its arithmetic.
        inputs: its input blocks.
    """

    form: DecoderForm
    entry: str
    columns: int
    width: int
    precision: DecoderPrecision
    inputs: tuple[str, ...] = field(compare=False)


def allowed(output: NDArray[np.floating]) -> NDArray[np.bool_]:
    """Which values are finite and not negative, as all of a decoder must be."""
    good: NDArray[np.bool_] = np.isfinite(output) & (output >= 0)
    return good
