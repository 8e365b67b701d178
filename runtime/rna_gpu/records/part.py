"""What the shaders of decoders read: a part of a tier, its layers, limits of both, and queries."""

from rna_gpu.records.record import Field, Record
from rna_sdk.package import INPUT_BLOCKS

GROUP = 4  # columns that a vec4f holds
NONE = 0xFFFFFFFF
PRECISIONS = {"float32": 0, "float16": 1, "int8": 2}
MAX_LAYERS = 32
MAX_CHANNEL_GROUPS = 16
MAX_EXACT_INPUTS = 512  # 512 * 255 * 128 < 2^24: float32 holds sums of int8 layers exactly
UNIFORM_WEIGHTS = 4096  # vec4f in 64 KiB

LAYER = Record(
    "RnaLayer",
    Field("inputs", "<u4", (), "groups of 4 columns"),
    Field("outputs", "<u4"),
    Field("weights", "<u4", (), "place of [outputs][inputs][4] vec4f"),
    Field("bias", "<u4", (), "place of [outputs] vec4f"),
    Field("units", "<u4", (), "place of [outputs] vec4f of an int8 layer: what a sum of 1 means"),
    Field("relu", "<u4", (), "1: negative results are 0"),
    Field("int8_step", "<f4", (), "of an int8 layer: what 1 means in its inputs; else 0"),
    Field("reserved", "<u4"),
)

PART = Record(
    "RnaPart",
    Field("low", "<f4", (3,), "smallest corner of the bounds"),
    Field("resolution", "<u4"),
    Field("high", "<f4", (3,)),
    Field("channel_groups", "<u4", (), "channels / 4, rounded up"),
    Field("query_groups", "<u4", (), "of the decoder's input"),
    Field("layer_count", "<u4"),
    Field("plane_precision", "<u4", (), "RNA_FLOAT32, RNA_FLOAT16 or RNA_INT8"),
    Field("gain", "<u4", (), "place of [query_groups] gains, then the offsets; RNA_NONE without"),
    Field("query_low", "<f4", (), "the decoder's first Clip"),
    Field("query_high", "<f4"),
    Field("top", "<f4", (), "of the Clip before Exp"),
    Field("unit", "<f4", (), "result = (exp(x) - 1) unit, or times the matrix; then 1"),
    Field("matrix", LAYER, (), "[n, columns of the results], with a bias of 0; all 0 without"),
    Field("scales", "<f4", (3, MAX_CHANNEL_GROUPS, GROUP), "of int8 planes, [plane][group]"),
    Field("layers", LAYER, (MAX_LAYERS,)),
    Field(
        "slots",
        "<u4",
        (-(-len(INPUT_BLOCKS) // GROUP), GROUP),
        "first group of each block, RNA_NONE for none: see rna_slot",
    ),
    Field(
        "factors", "<u4", (), "column of the results where those of base colour begin; 0 without"
    ),
    Field("nearby_columns", "<u4", (), "of each of the four sets with nearby light; 0 without"),
    Field("means", "<f4", (2, GROUP), "of nearby light, for the results of rows without it"),
)

ROW = Record(
    "RnaRow",
    Field("position", "<u4", (3,), "object space"),
    Field("h", "<u4"),
    Field("axis", "<u4", (3,), "normal or tangent"),
    Field("red", "<u4", (), "of the base colour"),
    Field("wo", "<u4", (3,)),
    Field("green", "<u4"),
    Field("wi", "<u4", (3,)),
    Field("blue", "<u4"),
    Field("nearby", "<u4", (3,), "nearby light"),
    Field("has_nearby", "<u4", (), "0: the part's means stand in"),
)
"""A query, the bits of float32: WGSL may assume that a float is finite."""

PART_CONSTANTS = {
    "RNA_NONE": NONE,
    **{f"RNA_{name.upper()}": number for name, number in PRECISIONS.items()},
    **{f"RNA_BLOCK_{name.upper()}": k for k, name in enumerate(INPUT_BLOCKS)},
    "RNA_CHANNEL_GROUPS": MAX_CHANNEL_GROUPS,
}
