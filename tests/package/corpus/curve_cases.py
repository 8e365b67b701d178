"""Packages of fibers whose curves are wrong, though declared with their true hash."""

import json
from collections.abc import Callable
from typing import Any

import numpy as np

from rna_sdk.package.container.tensor_file import tensors_to_bytes
from tests.package.builders import make_curves
from tests.package.corpus.registry import CURVES, Corpus, Entries, breaks_by, with_entry

CASES = Corpus("fiber")


Header = dict[str, dict[str, Any]]


def with_tensors(entries: Entries, **changes: Any) -> bytes:
    """The package with other arrays in its curves; None leaves a tensor out."""
    good = make_curves()
    tensors = {"points": good.points, "radii": good.radii, "offsets": good.offsets, **changes}
    remaining = {name: array for name, array in tensors.items() if array is not None}
    return with_entry(entries, CURVES, tensors_to_bytes(remaining))


def with_header(entries: Entries, edit: Callable[[Header], object], pad: int = 64) -> bytes:
    """The package with an edited header before the data of its curves."""
    data = entries[CURVES]
    start = 8 + int.from_bytes(data[:8], "little")
    header = json.loads(data[8:start])
    edit(header)
    text = json.dumps(header).encode()
    text += b" " * (-(8 + len(text)) % pad)
    return with_entry(entries, CURVES, len(text).to_bytes(8, "little") + text + data[start:])


in_header = breaks_by(with_header)


CASES.add(
    "GEOMETRY_CONTAINER",
    curves_of_three_bytes=lambda e: with_entry(e, CURVES, b"abc"),
    curves_header_past_the_end=lambda e: with_entry(e, CURVES, b"\xff" * 8 + e[CURVES][8:]),
    curves_header_no_json=lambda e: with_entry(e, CURVES, (56).to_bytes(8, "little") + b"x" * 56),
)


@CASES.case("GEOMETRY_CONTAINER")
def curves_header_over_the_limit(entries: Entries) -> bytes:
    size = 2**16 + 56
    return with_entry(entries, CURVES, size.to_bytes(8, "little") + b"{}".ljust(size))


@CASES.case("JSON_DUPLICATE_KEY")
def curves_with_a_tensor_twice(entries: Entries) -> bytes:
    text = b'{"points": {}, "points": {}}'
    return with_entry(entries, CURVES, len(text).to_bytes(8, "little") + text)


CASES.add(
    "GEOMETRY_PROFILE",
    curves_without_radii=lambda e: with_tensors(e, radii=None),
    curves_with_another_tensor=lambda e: with_tensors(e, uvs=np.zeros((9, 2), np.float32)),
    curves_with_a_tensor_that_is_no_object=in_header(lambda h: h.update(radii="F32")),
    curves_of_half_floats=lambda e: with_tensors(e, points=make_curves().points.astype(np.float16)),
    curves_with_the_radius_in_the_points=lambda e: with_tensors(
        e, points=np.zeros((9, 4), np.float32)
    ),
    curves_of_negative_size=in_header(lambda h: h["points"].update(shape=[-9, 3])),
    curves_with_a_fraction_in_a_shape=in_header(lambda h: h["radii"].update(shape=[9.5])),
    curves_without_a_shape=in_header(lambda h: h["radii"].pop("shape")),
    curves_unaligned=lambda e: with_header(e, lambda h: None, pad=1),
)


@CASES.case("GEOMETRY_PROFILE")
def curves_over_the_limit(entries: Entries) -> bytes:
    """Refused for what it announces, before the size is compared with the file."""
    return with_header(entries, lambda h: h["points"].update(shape=[2**26 + 1, 3]))


CASES.add(
    "GEOMETRY_RANGE",
    curves_without_offsets=in_header(lambda h: h["radii"].pop("data_offsets")),
    curves_cut_short=lambda e: with_entry(e, CURVES, e[CURVES][:-4]),
    curves_with_bytes_left_over=lambda e: with_entry(e, CURVES, e[CURVES] + bytes(4)),
    curves_whose_tensors_overlap=in_header(lambda h: h["radii"].update(data_offsets=[0, 36])),
    curves_larger_than_the_file=in_header(
        lambda h: h["points"].update({"shape": [2**26, 3], "data_offsets": [0, 2**26 * 12]})
    ),
)
CASES.add(
    "GEOMETRY_ARRAY",
    curves_with_fewer_radii=lambda e: with_tensors(e, radii=make_curves().radii[:-1]),
)


@CASES.case("GEOMETRY_NOT_FINITE")
def curves_with_nan(entries: Entries) -> bytes:
    points = make_curves().points.copy()
    points[8, 2] = np.nan
    return with_tensors(entries, points=points)


CASES.add(
    "GEOMETRY_NOT_FINITE",
    curves_infinitely_thick=lambda e: with_tensors(e, radii=np.full(9, np.inf, np.float32)),
)
CASES.add(
    "GEOMETRY_STRANDS",
    curves_that_start_late=lambda e: with_tensors(e, offsets=np.uint32([2, 4, 6, 9])),
    curves_that_end_early=lambda e: with_tensors(e, offsets=np.uint32([0, 4, 6, 8])),
    curves_with_offsets_past_the_points=lambda e: with_tensors(
        e, offsets=np.uint32([0, 2**32 - 1, 6, 9])
    ),
    curves_with_a_strand_of_one_point=lambda e: with_tensors(e, offsets=np.uint32([0, 4, 5, 9])),
)


@CASES.case("GEOMETRY_SEGMENT")
def curves_with_a_point_twice(entries: Entries) -> bytes:
    points = make_curves().points.copy()
    points[5] = points[4]
    return with_tensors(entries, points=points)


@CASES.case("GEOMETRY_RADIUS")
def curves_pointed(entries: Entries) -> bytes:
    radii = make_curves().radii.copy()
    radii[3] = 0
    return with_tensors(entries, radii=radii)


@CASES.case("GEOMETRY_OUTSIDE")
def curves_outside_the_bounds_by_their_radius(entries: Entries) -> bytes:
    """The points themselves lie within 0.9."""
    return with_tensors(entries, radii=np.full(9, 0.15, np.float32))


CASES.add(
    "GEOMETRY_OUTSIDE",
    curves_past_the_largest_number=lambda e: with_tensors(
        e,
        points=make_curves().points * np.float32(3e38),
        radii=np.full(9, np.finfo(np.float32).max),
    ),
)
