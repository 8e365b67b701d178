"""Packages of fibers whose curves are wrong, though declared with their true hash."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import numpy as np

from rna_sdk.package.container.tensor_file import tensors_to_bytes
from tests.package.builders import make_curves
from tests.package.corpus.registry import CURVES, Entries, case, with_entry

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


@case("GEOMETRY_CONTAINER", "fiber")
def curves_of_three_bytes(entries: Entries) -> bytes:
    return with_entry(entries, CURVES, b"abc")


@case("GEOMETRY_CONTAINER", "fiber")
def curves_header_past_the_end(entries: Entries) -> bytes:
    return with_entry(entries, CURVES, b"\xff" * 8 + entries[CURVES][8:])


@case("GEOMETRY_CONTAINER", "fiber")
def curves_header_no_json(entries: Entries) -> bytes:
    return with_entry(entries, CURVES, (56).to_bytes(8, "little") + b"x" * 56)


@case("GEOMETRY_CONTAINER", "fiber")
def curves_header_over_the_limit(entries: Entries) -> bytes:
    size = 2**16 + 56
    return with_entry(entries, CURVES, size.to_bytes(8, "little") + b"{}".ljust(size))


@case("JSON_DUPLICATE_KEY", "fiber")
def curves_with_a_tensor_twice(entries: Entries) -> bytes:
    text = b'{"points": {}, "points": {}}'
    return with_entry(entries, CURVES, len(text).to_bytes(8, "little") + text)


@case("GEOMETRY_PROFILE", "fiber")
def curves_without_radii(entries: Entries) -> bytes:
    return with_tensors(entries, radii=None)


@case("GEOMETRY_PROFILE", "fiber")
def curves_with_another_tensor(entries: Entries) -> bytes:
    return with_tensors(entries, uvs=np.zeros((9, 2), np.float32))


@case("GEOMETRY_PROFILE", "fiber")
def curves_with_a_tensor_that_is_no_object(entries: Entries) -> bytes:
    return with_header(entries, lambda h: h.update(radii="F32"))


@case("GEOMETRY_PROFILE", "fiber")
def curves_of_half_floats(entries: Entries) -> bytes:
    return with_tensors(entries, points=make_curves().points.astype(np.float16))


@case("GEOMETRY_PROFILE", "fiber")
def curves_with_the_radius_in_the_points(entries: Entries) -> bytes:
    return with_tensors(entries, points=np.zeros((9, 4), np.float32))


@case("GEOMETRY_PROFILE", "fiber")
def curves_over_the_limit(entries: Entries) -> bytes:
    """Refused for what it announces, before the size is compared with the file."""
    return with_header(entries, lambda h: h["points"].update(shape=[2**26 + 1, 3]))


@case("GEOMETRY_PROFILE", "fiber")
def curves_of_negative_size(entries: Entries) -> bytes:
    return with_header(entries, lambda h: h["points"].update(shape=[-9, 3]))


@case("GEOMETRY_PROFILE", "fiber")
def curves_with_a_fraction_in_a_shape(entries: Entries) -> bytes:
    return with_header(entries, lambda h: h["radii"].update(shape=[9.5]))


@case("GEOMETRY_PROFILE", "fiber")
def curves_without_a_shape(entries: Entries) -> bytes:
    return with_header(entries, lambda h: h["radii"].pop("shape"))


@case("GEOMETRY_RANGE", "fiber")
def curves_without_offsets(entries: Entries) -> bytes:
    return with_header(entries, lambda h: h["radii"].pop("data_offsets"))


@case("GEOMETRY_PROFILE", "fiber")
def curves_unaligned(entries: Entries) -> bytes:
    return with_header(entries, lambda h: None, pad=1)


@case("GEOMETRY_RANGE", "fiber")
def curves_cut_short(entries: Entries) -> bytes:
    return with_entry(entries, CURVES, entries[CURVES][:-4])


@case("GEOMETRY_RANGE", "fiber")
def curves_with_bytes_left_over(entries: Entries) -> bytes:
    return with_entry(entries, CURVES, entries[CURVES] + bytes(4))


@case("GEOMETRY_RANGE", "fiber")
def curves_whose_tensors_overlap(entries: Entries) -> bytes:
    return with_header(entries, lambda h: h["radii"].update(data_offsets=[0, 36]))


@case("GEOMETRY_RANGE", "fiber")
def curves_larger_than_the_file(entries: Entries) -> bytes:
    many = {"shape": [2**26, 3], "data_offsets": [0, 2**26 * 12]}
    return with_header(entries, lambda h: h["points"].update(many))


@case("GEOMETRY_ARRAY", "fiber")
def curves_with_fewer_radii(entries: Entries) -> bytes:
    return with_tensors(entries, radii=make_curves().radii[:-1])


@case("GEOMETRY_NOT_FINITE", "fiber")
def curves_with_nan(entries: Entries) -> bytes:
    points = make_curves().points.copy()
    points[8, 2] = np.nan
    return with_tensors(entries, points=points)


@case("GEOMETRY_NOT_FINITE", "fiber")
def curves_infinitely_thick(entries: Entries) -> bytes:
    return with_tensors(entries, radii=np.full(9, np.inf, np.float32))


@case("GEOMETRY_STRANDS", "fiber")
def curves_that_start_late(entries: Entries) -> bytes:
    return with_tensors(entries, offsets=np.uint32([2, 4, 6, 9]))


@case("GEOMETRY_STRANDS", "fiber")
def curves_that_end_early(entries: Entries) -> bytes:
    return with_tensors(entries, offsets=np.uint32([0, 4, 6, 8]))


@case("GEOMETRY_STRANDS", "fiber")
def curves_with_offsets_past_the_points(entries: Entries) -> bytes:
    return with_tensors(entries, offsets=np.uint32([0, 2**32 - 1, 6, 9]))


@case("GEOMETRY_STRANDS", "fiber")
def curves_with_a_strand_of_one_point(entries: Entries) -> bytes:
    return with_tensors(entries, offsets=np.uint32([0, 4, 5, 9]))


@case("GEOMETRY_SEGMENT", "fiber")
def curves_with_a_point_twice(entries: Entries) -> bytes:
    points = make_curves().points.copy()
    points[5] = points[4]
    return with_tensors(entries, points=points)


@case("GEOMETRY_RADIUS", "fiber")
def curves_pointed(entries: Entries) -> bytes:
    radii = make_curves().radii.copy()
    radii[3] = 0
    return with_tensors(entries, radii=radii)


@case("GEOMETRY_OUTSIDE", "fiber")
def curves_outside_the_bounds_by_their_radius(entries: Entries) -> bytes:
    """The points themselves lie within 0.9."""
    return with_tensors(entries, radii=np.full(9, 0.15, np.float32))


@case("GEOMETRY_OUTSIDE", "fiber")
def curves_past_the_largest_number(entries: Entries) -> bytes:
    points = make_curves().points * np.float32(3e38)
    return with_tensors(entries, points=points, radii=np.full(9, np.finfo(np.float32).max))
