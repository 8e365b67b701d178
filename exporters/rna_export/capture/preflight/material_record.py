"""Blender's facts about a source's materials: `blender/rna_preflight/material_facts.py`."""

from typing import Literal, NamedTuple

from pydantic import Field

from rna_export.capture.capture_settings import DatasetModel

Kind = Literal[
    "opaque",
    "coat",
    "metal",
    "glossy",
    "brushed",
    "velvet",
    "scattering",
    "thin",
    "see-through",
    "refracting",
    "glass",
    "volume",
    "emissive",
    "hair",
    "varied",
]
"""glass: smooth and refracting, mixed with something else; see-through: holes and thin panes.
varied: each strand differs at random."""


class Detail(DatasetModel):
    """The finest texture of a sort.

    of: what it changes. node: its name in the node editor. size: metres from one detail to the
    next; None where its coordinates do not tell.
    """

    of: Literal["relief", "gloss", "colour", "emission"]
    node: str
    size: float | None = Field(ge=0)


class MaterialFacts(DatasetModel):
    """A material that is learnt.

    roughness: of its sharpest highlight; None without one, or where a texture gives it.
    """

    name: str
    full_name: str
    kinds: tuple[Kind, ...] = Field(min_length=1)
    roughness: float | None
    details: tuple[Detail, ...]


class Visible(NamedTuple):
    """share: of the visible area. mirroring: share of it whose mirror direction meets the asset."""

    share: float
    mirroring: float = 0.0


class Glass(DatasetModel):
    """Smooth glass that is left to hosts: see `blender/rna_preflight/smooth_glass.py`."""

    name: str
    full_name: str
    ior: float
    tint: tuple[float, float, float]
    roughness: float
    absorption: tuple[float, float, float]  # 1/m
