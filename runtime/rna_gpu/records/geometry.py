"""What rays read of bodies: nodes of trees, primitives, and instances."""

from rna_gpu.records.part import NONE
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

IS_SEGMENT, SURFACE_SHIFT = 1, 1
HAS_BEFORE, HAS_AFTER = 1, 2

PRIMITIVE = Record(
    "RnaPrimitive",
    Field("a", "<u4", (), "point: a triangle's first corner, a segment's start"),
    Field("b", "<u4", (), "second corner; of a segment RNA_HAS_BEFORE and RNA_HAS_AFTER"),
    Field("c", "<u4", (), "third corner; of a segment its strand"),
    Field("tag", "<u4", (), "surface << RNA_SURFACE_SHIFT, and RNA_IS_SEGMENT"),
)

GEOMETRY_CONSTANTS = {
    "RNA_NOTHING": NONE,
    "RNA_IS_SEGMENT": IS_SEGMENT,
    "RNA_SURFACE_SHIFT": SURFACE_SHIFT,
    "RNA_HAS_BEFORE": HAS_BEFORE,
    "RNA_HAS_AFTER": HAS_AFTER,
}

INSTANCE = Record(
    "RnaInstance",
    Field("to_object", "<f4", (3, 4), "rows of the matrix"),
    Field("rotation", "<f4", (3, 4), "to the world: rows, the fourth column free"),
    Field("place", "<f4", (3,), "in the world"),
    Field("scale", "<f4", (), "to the world"),
    Field("root", "<u4", (), "node"),
    Field("rays", "<u4", (), "bits of those that can hit it"),
    Field("extent", "<f4", (), "largest coordinate of its body"),
    Field("host_data", "<u4", (), "a number of the host's"),
)
