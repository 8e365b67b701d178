"""Decoder forms: the kinds of decoder that a part can have in a tier.

A form says what a decoder gives, of which query arrays, and so of which input blocks; validator,
writer, runtime, exporter and conformance kit go by it. A new form is a value in FORMS and, in
`manifest_tiers.py`, the member of a tier part that declares it.
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


@dataclass(frozen=True)
class DecoderForm:
    """A kind of decoder.

    Attributes:
        name: of the form and of the decoder's one output.
        results: what the output's columns are, each of `columns`, side by side.
        arrays: names of the QUERY_ARRAYS that it is asked with.
        member: of a tier part, with the decoder's record; "" for the tier part itself.
        columns: of each result; 3 for RGB.
        count: name of a member of the record: so many times there are all results; "" for once.
        signed: numbers of the columns of a result that may be negative.
    """

    name: str
    results: tuple[str, ...]
    arrays: tuple[str, ...]
    member: str = ""
    columns: int = 3
    count: str = ""
    signed: tuple[int, ...] = ()

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

    def width(self, record: Any) -> int:
        """Columns of the output."""
        return self.columns * self.result_count(record)

    def allowed(self, output: NDArray[np.floating]) -> NDArray[np.bool_]:
        """Which values of (n, width) are finite, and not negative where they must not be."""
        column = np.arange(output.shape[1]) % self.columns
        good: NDArray[np.bool_] = np.isfinite(output)
        return good & ((output >= 0) | np.isin(column, self.signed))

    def blocks(self, kind: str) -> list[str]:
        """The input blocks that it can have in a part of this kind."""
        lit = "wi" in self.arrays
        return [name for name in blocks_for(kind) if lit or name in UNLIT_BLOCKS]


TRANSPORT = DecoderForm("transport", ("visible", "shadowed"), ("position", "axis", "h", "wo", "wi"))
EMISSION = DecoderForm("emission", ("radiance",), ("position", "axis", "h", "wo"), "emission")

FORMS = (TRANSPORT, EMISSION)
"""Every part has the first; the others are optional."""


def form_named(name: str) -> DecoderForm:
    """The form of this name, which must be one of FORMS."""
    return next(form for form in FORMS if form.name == name)


@dataclass(frozen=True)
class PartDecoder:
    """A decoder of a part in a tier, by the manifest.

    Attributes:
        entry: its name.
        columns: K, of the input `queries`.
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
