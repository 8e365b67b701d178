"""Data of the renderer's steps: their numbers, paths and queries."""

from rna_gpu.records.part import NONE
from rna_gpu.records.record import Field, Record
from rna_render.paths.sampling import (
    CHOICES,
    DIMENSIONS_A_VERTEX,
    DIRECTION,
    LENS_DIMENSION,
    LIGHT,
    NEARBY,
    ROULETTE,
)
from rna_trace import CAMERA_RAY, INDIRECT_RAY, SHADOW_RAY

FRAME = Record(
    "Frame",
    Field("camera", "<f4", (3,)),
    Field("width", "<u4"),
    Field("corner", "<f4", (3,), "direction through the image's top left corner"),
    Field("paths", "<u4"),
    Field("step_x", "<f4", (3,), "of a pixel"),
    Field("sample", "<u4"),
    Field("step_y", "<f4", (3,)),
    Field("seed", "<u4"),
    Field("depth", "<u4", (), "points of the path so far"),
    Field("light", "<u4", (), "that is sampled; NONE: one that is chosen"),
    Field("part", "<u4", (), "number of the sample of this light at this point"),
    Field("parts", "<u4", (), "samples of this light at this point"),
    Field("rays", "<u4", (), "bit of the sort of rays"),
    Field("clamp", "<f4"),
    Field("light_count", "<u4"),
    Field("sums", "<u4", (), "vec4f of a path in `sums`: SUM_GROUPS, and two a group of lights"),
    Field("flags", "<u4", (), "of those below"),
    Field("branch", "<u4", (), "number of the ray that went on from the first point"),
    Field("branches", "<u4", (), "of those rays; 1 before them"),
    Field("neural_part", "<u4"),
    Field("list", "<u4", (), "start in `live` of the list of paths that the step is for"),
    Field("next_list", "<u4", (), "likewise, of those that go on from there"),
    Field("table_size", "<u4", (), "of albedo"),
    Field("objects", "<u4", (), "this and the rest: starts of the sections of `table`"),
    Field("surfaces", "<u4"),
    Field("lights", "<u4"),
    Field("albedo", "<u4"),
    Field("domains", "<u4"),
    Field("textures", "<u4"),
    Field("spread", "<f4", (), "width of a pixel over the distance to it"),
    Field("lens_x", "<f4", (3,), "to the right, as long as the lens's radius"),
    Field("focus", "<f4", (), "distance of the sharp plane; 0 of a pinhole"),
    Field("lens_y", "<f4", (3,), "likewise, up"),
    Field("lengths", "<f4", (3,), "of the nearby light that neural_part counts; object space"),
)

HAS_SKY, FOR_BETA, RAYS_MEET_LIGHTS = 1, 2, 4
FOR_EMISSION, FOR_LIGHT, TRANSMITS = 8, 16, 32
FOR_VISIBLE, FOR_SHADOWED = 64, 128

PATH = Record(
    "Path",
    Field("origin", "<f4", (3,)),
    Field("pixel", "<u4"),
    Field("direction", "<f4", (3,)),
    Field("pdf", "<f4", (), "of the direction; 0 of camera rays"),
    Field("beta", "<f4", (3,)),
    Field("state", "<u4"),
    Field("normal", "<f4", (3,), "of a segment"),
    Field("t", "<f4"),
    Field("instance", "<u4"),
    Field("primitive", "<u4"),
    Field("ignored", "<u4", (), "instance that the ray passes through"),
    Field("b1", "<f4"),
    Field("leaving", "<f4", (3,), "of a ray that leaves an asset: its start in object space"),
    Field("b2", "<f4"),
)

QUERY = Record(
    "Query",
    Field("x", "<f4", (3,)),
    Field("h", "<f4"),
    Field("axis", "<f4", (3,)),
    Field("part", "<u4", (), "whose decoder answers, or NONE, MATERIAL_PART, CATCHER_PART"),
    Field("wo", "<f4", (3,)),
    Field("light", "<u4"),
    Field("wi", "<f4", (3,)),
    Field("strand", "<u4", (), "that a ray from here passes through"),
    Field("weight", "<f4", (3,)),
    Field("seen", "<f4", (), "mean of what all that is in the way leaves of the light"),
    Field("visible", "<f4", (3,), "what the asset itself leaves of it"),
    Field("far", "<f4", (), "distance of the light, object space; RNA_FAR of one without"),
    Field("base_color", "<f4", (3,)),
    Field("nearby", "<f4", (3,), "nearby light, where the part counts it"),
)

QUERIES = Record(
    "PathQueries",
    Field("at_point", QUERY, (), "what the path's point scatters or emits"),
    Field("at_light", QUERY, (), "what an asset emits at its point that was sampled as a light"),
)

IS_LIGHT = 0x80000000
"""In `instance` of a path: a light with a shape, whose number the other bits are."""

MATERIAL_PART, CATCHER_PART = 0xFFFFFFFE, 0xFFFFFFFD
"""In `part` of a query: a material scatters, or a shadow catcher receives, what at_light emits."""

SUMS = Record(
    "Sums",
    Field("beauty", "<f4", (4,)),
    Field("normal", "<f4", (3,)),
    Field("hit", "<f4", (), "1 of what scatters, 2 of a shadow catcher"),
    Field("position", "<f4", (3,)),
    Field("number", "<f4", (), "of the asset or object"),
    Field("light_samples", "<f4", (2,), "tried, and arrived"),
    Field("caught", "<f4", (2,), "received by a catcher, with and without what is in the way"),
    Field("behind", "<f4", (4,), "a catcher"),
)
"""What `sums` holds of a path; then for each group of lights its share of beauty and of behind."""

FILM = Record(
    "Film",
    Field("squares", "<f4", (3,), "of beauty, of each sample by itself"),
    Field("catcher", "<f4", (), "how many samples hit a shadow catcher"),
    Field("sums", SUMS, (), "hit: how many samples hit what scatters; number: the first of them"),
)
"""The sum of several samples of a pixel; then that of what `sums` holds of groups of lights."""

ALL_DIRECTIONS, HEMISPHERE = 0xFFFFFFFF, 0xFFFFFFFE  # in place of a number of cones of a domain

SCENE_CONSTANTS = {
    "NONE": NONE,
    **{f"SUM_{name.upper()}": at // 16 for name, at in SUMS.offsets.items() if at % 16 == 0},
    "IS_LIGHT": IS_LIGHT,
    "MATERIAL_PART": MATERIAL_PART,
    "CATCHER_PART": CATCHER_PART,
    "SUM_GROUPS": SUMS.dtype.itemsize // 16,
    "CAMERA_RAY": CAMERA_RAY,
    "INDIRECT_RAY": INDIRECT_RAY,
    "SHADOW_RAY": SHADOW_RAY,
    "ALL_DIRECTIONS": ALL_DIRECTIONS,
    "HEMISPHERE": HEMISPHERE,
    "CHOICES": CHOICES,
    "DIRECTION": DIRECTION,
    "ROULETTE": ROULETTE,
    "LIGHT": LIGHT,
    "NEARBY": NEARBY,
    "LENS": LENS_DIMENSION,
    "DIMENSIONS": DIMENSIONS_A_VERTEX,
    "HAS_SKY": HAS_SKY,
    "FOR_BETA": FOR_BETA,
    "RAYS_MEET_LIGHTS": RAYS_MEET_LIGHTS,
    "FOR_EMISSION": FOR_EMISSION,
    "FOR_LIGHT": FOR_LIGHT,
    "TRANSMITS": TRANSMITS,
    "FOR_VISIBLE": FOR_VISIBLE,
    "FOR_SHADOWED": FOR_SHADOWED,
}
