"""What rays read of bodies: nodes of trees, and instances."""

from __future__ import annotations

from rna_gpu.records.record import Field, Record

NODE = Record(
    "RnaNode",
    Field("low", "<f4", (3,)),
    Field(
        "child", "<u4", (), "the right one, the left one is the next node; a leaf's first primitive"
    ),
    Field("high", "<f4", (3,)),
    Field("count", "<u4", (), "a leaf's primitives; 0 of inner nodes"),
)

INSTANCE = Record(
    "RnaInstance",
    Field("to_object", "<f4", (3, 4), "rows of the matrix"),
    Field("rotation", "<f4", (3, 4), "to the world: rows, the fourth column free"),
    Field("place", "<f4", (3,), "in the world"),
    Field("scale", "<f4", (), "to the world"),
    Field("root", "<u4", (), "node"),
    Field("rays", "<u4", (), "bits of those that meet it"),
    Field("extent", "<f4", (), "largest coordinate of its body"),
    Field("own", "<u4", (), "a number of the host's"),
)
