"""Materials that have holes or a normal map, with the colours of their nodes and their uses."""

from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

import bpy
from rna_geometry.shown_objects import as_rendered
from rna_materials import normal_maps
from rna_materials.material_uses import Use, Wanted, shown_materials, uses_of
from rna_materials.node_sources import origin
from rna_materials.relief import Bump, ReliefOfUv, bump_of
from rna_materials.transparency import transmittance_of
from rna_materials.uv_render import ColourOfUv
from rna_preflight.smooth_glass import is_left


@dataclass
class Surface:
    """One material: the colours of its nodes.

    holes: what is compared with the cutoff; shown: the transmittance that Cycles shows. no_normal:
    why there is no normal map. uses: triangles that show it; on_hair: whether strands do.
    """

    material: bpy.types.Material
    on_hair: bool
    holes: ColourOfUv | None = None
    shown: ColourOfUv | None = None
    cutoff: float | None = None
    ior: tuple[float, float] | None = None
    normal: ColourOfUv | None = None
    no_normal: str | None = None
    uses: list[Use] = field(default_factory=list)

    def colours(self) -> list[ColourOfUv]:
        return [c for c in (self.holes, self.shown, self.normal) if c is not None]


class Copies:
    """Copies of materials, whose nodes may be changed."""

    def __init__(self) -> None:
        self._groups = set(bpy.data.node_groups)
        self._made: list[bpy.types.Material] = []

    def of(self, material: bpy.types.Material) -> bpy.types.Material:
        copy = material.copy()
        self._made.append(copy)
        return copy

    def remove(self) -> None:
        """Remove them, and the copies of groups in them."""
        for material in self._made:
            bpy.data.materials.remove(material)
        for group in set(bpy.data.node_groups) - self._groups:
            bpy.data.node_groups.remove(group)


def shown_surfaces(copies: Copies, folder: Path, with_normals: bool) -> Iterable[Surface]:
    """The shown materials that have holes or a normal map."""
    on_surfaces, on_hair = as_rendered(shown_materials)
    for material in list(bpy.data.materials):
        name = material.name_full
        if name not in on_surfaces | on_hair or is_left(name) or material.node_tree is None:
            continue
        surface = Surface(material, name in on_hair)
        copy = copies.of(material)
        transmittance = transmittance_of(copy)
        if transmittance is not None:
            surface.cutoff, surface.ior = transmittance.cutoff, transmittance.ior
            surface.holes = surface.shown = ColourOfUv(copy, transmittance.colour, folder)
            if transmittance.cutoff is not None:
                copy = copies.of(material)
                shown = transmittance_of(copy, thresholds=False)
                assert shown is not None  # as before
                surface.shown = ColourOfUv(copy, shown.colour, folder)
        if with_normals and name in on_surfaces:
            surface.normal, surface.no_normal = _normal_of(material, copies, folder)
        if surface.colours() or surface.no_normal:
            yield surface


def _normal_of(
    material: bpy.types.Material, copies: Copies, folder: Path, below: int = 0
) -> tuple[ColourOfUv | None, str | None]:
    """The normal of a material's relief, or why it has no map; neither without relief.

    below: how many of its Bump nodes, from the shader on, to leave out.
    """
    copy = copies.of(material)
    source = normal_maps.normal_source(copy)
    for _ in range(below):
        assert source is not None  # each has bent another normal
        source = origin(source[0].inputs["Normal"], source[2])
    bump = bump_of(copy, source)
    if isinstance(bump, Bump):
        upon, problem = (
            _normal_of(material, copies, folder, below + 1) if bump.upon else (None, None)
        )
        return (None, problem) if problem else (ReliefOfUv(copy, bump, folder, upon), None)
    if bump is not None or source is None:
        return None, bump
    if problem := normal_maps.problem_of(source):
        return None, problem
    return ColourOfUv(copy, normal_maps.as_colour(copy, source), folder), None


def find_uses(surfaces: list[Surface]) -> None:
    wanted = {}
    for surface in surfaces:
        depends = [colour.depends for colour in surface.colours()]
        wanted[surface.material.name_full] = Wanted(
            {name for each in depends for name in each.layers},
            {name for each in depends for name in each.attributes},
        )
    uses = as_rendered(lambda: uses_of(wanted))
    for surface in surfaces:
        surface.uses = uses[surface.material.name_full]
