"""Check a decoder: its file, its declaration in the manifest, its cost, and its results."""

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.decoder.decoder_form import PartDecoder, allowed
from rna_sdk.package.decoder.decoder_reader import decoder_from_bytes
from rna_sdk.package.decoder.profile_decoder import ProfileDecoder
from rna_sdk.package.decoder.saturation import PAIR_LIMIT, can_saturate
from rna_sdk.package.issues import Code, Issue, refuse
from rna_sdk.package.limits import MAX_DECODER_BYTES, MAX_QUERY_VALUES, MAX_QUERY_WORK

_PROBES = (0.0, 1.0, -1.0, 1e4, -1e4, float(np.finfo(np.float32).max), -3.4e38)
_RANDOM_ROWS = 17


def check_decoder(data: memoryview, part_decoder: PartDecoder) -> list[Issue]:
    """Check the entry `data` against the spec; returns warnings.

    Raises:
        PackageError: with the first DECODER_* issue found.
    """
    if len(data) > MAX_DECODER_BYTES:
        expected = f"at most {MAX_DECODER_BYTES}"
        refuse(Code.DECODER_TOO_LARGE, part_decoder.entry, f"{len(data)} bytes", expected)
    decoder = decoder_from_bytes(data, part_decoder.entry)
    _check_declared(decoder, part_decoder)
    for count, what, limit in (
        (decoder.values, "values", MAX_QUERY_VALUES),
        (decoder.multiply_adds, "multiply-adds", MAX_QUERY_WORK),
    ):
        if count > limit:
            refuse(
                Code.DECODER_COST, part_decoder.entry, f"{count} {what} a query", f"at most {limit}"
            )
    _check_finite(decoder, part_decoder.entry)
    _check_results(decoder, part_decoder)
    return _warnings(decoder, part_decoder.entry)


def _check_declared(decoder: ProfileDecoder, part_decoder: PartDecoder) -> None:
    """Whether the decoder matches the manifest."""
    precision = "int8" if decoder.is_int8 else "float32"
    for where, found, expected in (
        (
            "input",
            f"queries of {decoder.columns} columns",
            f"queries of {part_decoder.columns} columns",
        ),
        (
            "output",
            f"{decoder.output} of {decoder.outputs} columns",
            f"{part_decoder.form.name} of {part_decoder.width} columns",
        ),
        ("node", f"layers in {precision}", f"layers in {part_decoder.precision}"),
    ):
        if found != expected:
            refuse(Code.DECODER_PROFILE, f"{part_decoder.entry}#/graph/{where}", found, expected)


def _check_finite(decoder: ProfileDecoder, name: str) -> None:
    numbers = [decoder.low, decoder.high, decoder.gain, decoder.offset]
    numbers += [decoder.top, decoder.unit, decoder.matrix]
    for layer in decoder.layers:
        numbers += [layer.weight, layer.bias, layer.step, layer.scale]
    if not all(np.isfinite(one).all() for one in numbers if one is not None):
        refuse(Code.DECODER_RESULT, name, "a constant that is NaN or infinite", "finite ones")


def _check_results(decoder: ProfileDecoder, part_decoder: PartDecoder) -> None:
    queries = _probes(part_decoder.columns)
    with np.errstate(all="ignore"):
        output = decoder.run(queries)
    good = allowed(output).all(axis=1)
    if not good.all():
        row = int(np.argmin(good))
        found = f"{output[row].tolist()} for inputs that begin with {queries[row, 0]:g}"
        refuse(
            Code.DECODER_RESULT, part_decoder.entry, found, "finite and >= 0 for any finite input"
        )


def _probes(columns: int) -> NDArray[np.float32]:
    """Queries (n, columns): rows of one number each, up to the largest, and random ones."""
    constant = np.repeat(np.array(_PROBES, np.float32)[:, None], columns, axis=1)
    random = np.random.default_rng(0).uniform(-1, 1, (_RANDOM_ROWS, columns)).astype(np.float32)
    return np.concatenate([constant, random])


def _warnings(decoder: ProfileDecoder, name: str) -> list[Issue]:
    saturating = [
        k
        for k, layer in enumerate(decoder.layers)
        if decoder.is_int8 and can_saturate(layer.weight)
    ]
    if not saturating:
        return []
    found = f"larger sums in layer {saturating[0]}"
    expected = f"neighbours of one sign that add up to at most {PAIR_LIMIT}"
    return [Issue.of(Code.DECODER_SATURATION, name, found, expected)]
