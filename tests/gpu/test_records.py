"""Records of the GPU: their members are where WGSL has them, and every input block has a slot."""

import importlib

import numpy as np
import pytest

from rna_gpu.records import part, write_records
from rna_gpu.records.record import Field, Record
from rna_sdk.package import INPUT_BLOCKS
from rna_sdk.package.block_table import BLOCK_TABLE
from rna_sdk.package.decoder.query_arrays import NEARBY, QUERY_ARRAYS

INNER = Record("Inner", Field("a", "<f4", (3,)), Field("b", "<u4"))
OUTER = Record(
    "Outer",
    Field("first", "<u4"),
    Field("pair", "<f4", (2,)),
    Field("vector", "<f4", (3,), "metres"),
    Field("inner", INNER),
    Field("rows", "<u4", (2, 4)),
    Field("many", INNER, (2,)),
)


def test_members_are_aligned_as_in_wgsl():
    """WGSL, section 14.4.1: vec2f at multiples of 8 bytes, vec3f and arrays at multiples of 16."""
    places = {"first": 0, "pair": 8, "vector": 16, "inner": 32, "rows": 48, "many": 80}
    assert OUTER.offsets == places and OUTER.dtype.itemsize == 112
    assert "    vector: vec3f, // 16; metres\n    inner: Inner, // 32\n" in OUTER.wgsl()
    assert (
        "    rows: array<vec4<u32>, 2>, // 48\n    many: array<Inner, 2>, // 80\n" in OUTER.wgsl()
    )
    assert OUTER.layout()["members"]["many"] == {"at": 20, "record": "Inner", "count": 2}
    with pytest.raises(ValueError, match=r"Bad\.inner is not at a multiple of 16 bytes"):
        Record("Bad", Field("first", "<u4"), Field("inner", Record("Two", Field("a", "<u4"))))


def test_accessors_read_the_members():
    record = Record(
        "Row", Field("flags", "<u4"), Field("half", "<f4", (2,)), Field("numbers", "<u4", (2, 4))
    )
    assert record.accessors("rows") == (
        "fn row_flags(k: u32) -> u32 {\n"
        "    return bitcast<u32>(table[frame.rows + 3u * k + 0u].x);\n}\n"
        "fn row_half(k: u32) -> vec2f {\n    return table[frame.rows + 3u * k + 0u].zw;\n}\n"
        "fn row_numbers(k: u32, i: u32) -> u32 {\n"
        "    return bitcast<u32>(table[frame.rows + 3u * k + 1u + i / 4u][i % 4u]);\n}\n"
    )


def test_a_row_has_every_array_of_queries():
    """Directions begin at vec4s, which `rna_evaluate` documents; a new array needs a member."""
    assert part.ROW.dtype.itemsize == 80 and part.ROW.offsets["wi"] == 48
    assert part.ROW.offsets[NEARBY.name] == 64
    for array in QUERY_ARRAYS:
        shape = () if array.columns == 1 else (array.columns,)
        if array.is_factor:  # a number in each of the free words
            assert {"red", "green", "blue"} <= set(part.ROW.dtype.names)
        else:
            assert part.ROW.dtype[array.name].shape == shape


def test_records_are_stacked():
    row = np.zeros((), OUTER.dtype)
    row["many"]["b"] = 3, 4
    stacked = OUTER.stacked([row, row])
    assert stacked["many"]["b"].tolist() == [[3, 4], [3, 4]]
    assert stacked.view(np.uint32).reshape(2, -1)[:, [1, 23, 27]].tolist() == [[0, 3, 4]] * 2
    assert OUTER.stacked([]).shape == (0,)


def test_a_part_has_a_slot_for_any_number_of_blocks(monkeypatch):
    """A thirteenth block takes a fourth vec4 of slots, and nothing else."""
    try:
        with monkeypatch.context() as changed:
            changed.setitem(INPUT_BLOCKS, "thirteenth", 2)
            more = importlib.reload(part)
            assert more.PART.dtype["slots"].shape == (4, 4)
            assert more.PART_CONSTANTS["RNA_BLOCK_THIRTEENTH"] == len(BLOCK_TABLE)
            text = importlib.reload(write_records).files()
            assert "slots: array<vec4<u32>, 4>" in text["runtime/rna_gpu/wgsl/part_records.wgsl"]
    finally:
        importlib.reload(part)
        importlib.reload(write_records)
    assert part.PART.dtype["slots"].shape == (3, 4)
