"""Whether a decoder's input blocks are ones that it can have."""

from __future__ import annotations

from collections.abc import Iterator

from rna_sdk.package.decoder.decoder_form import PartDecoder
from rna_sdk.package.issues import Code, Issue
from rna_sdk.package.manifest.manifest_fields import Kind


def input_issues(decoder: PartDecoder, kind: Kind, what: str, where: str) -> Iterator[Issue]:
    """INPUT_KIND of each block that the kind of part cannot fill, or the decoder's form does not.

    what: it is for, for the message. where: JSON pointer of the decoder's `inputs`.
    """
    known = decoder.form.blocks(kind)
    for j, name in enumerate(decoder.inputs):
        if name not in known:
            yield Issue.of(Code.INPUT_KIND, f"{where}/{j}", name, f"for {what}: {', '.join(known)}")
