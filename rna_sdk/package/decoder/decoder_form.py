"""What a decoder must be: that of transport, or that of emission."""

from __future__ import annotations

from dataclasses import dataclass

from rna_sdk.package.limits import EMISSION_WIDTH, TRANSPORT_WIDTH
from rna_sdk.package.manifest.manifest_fields import DecoderPrecision
from rna_sdk.package.manifest.manifest_tiers import TierPart

INPUT_NAME = "queries"
TRANSPORT, EMISSION = "transport", "emission"


@dataclass(frozen=True)
class DecoderForm:
    """A decoder's form by the manifest.

    Attributes:
        entry: its name.
        columns: K, of the input `queries`.
        output: name of the one output, of `width` columns.
        precision: of its arithmetic.
    """

    entry: str
    columns: int
    output: str
    width: int
    precision: DecoderPrecision


def transport_form(part: TierPart) -> DecoderForm:
    """The form of the transport decoder, with outputs visible and shadowed RGB."""
    columns, precision = part.query_width, part.decoder_precision
    return DecoderForm(part.decoder, columns, TRANSPORT, TRANSPORT_WIDTH, precision)


def emission_form(part: TierPart) -> DecoderForm | None:
    """The form of the emission decoder, with output RGB; None if the part does not emit."""
    own = part.emission
    if own is None:
        return None
    columns, precision = part.emission_query_width, own.decoder_precision
    return DecoderForm(own.decoder, columns, EMISSION, EMISSION_WIDTH, precision)
