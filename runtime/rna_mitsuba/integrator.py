"""The integrator plug-in `rna_path`: a path tracer for scenes with assets.

Direct light combines emitter and BSDF samples with the power heuristic. At an asset the decoder
gives the outgoing radiance; the visibility ray against the asset selects its output, and a ray that
starts on an asset passes through it (spec/RNA.md, 7.1). All other shapes are shaded by Mitsuba.
"""

from typing import Any

import drjit as dr
import mitsuba as mi

from rna_mitsuba.shape import check_placed, shapes_of
from rna_mitsuba.tracer import Path, Tracer, Vertex
from rna_mitsuba.world import NOBODY, World
from rna_sdk.errors import QueryError

AOVS = (
    *("depth", "position.X", "position.Y", "position.Z"),
    *("normal.X", "normal.Y", "normal.Z", "asset"),
)


class RnaPath(mi.SamplingIntegrator):
    """The integrator `rna_path`, with the properties of Mitsuba's `path`.

    `max_depth` is the maximum path length in edges, default 6 (1: visible emitters only; 2: direct
    light). Russian roulette starts at `rr_depth` edges, default 5. `aovs` adds the channels `AOVS`
    to the image, default false.
    """

    def __init__(self, props: mi.Properties) -> None:
        """Raises QueryError if `hide_emitters` is set."""
        super().__init__(props)
        if self.hide_emitters:
            raise QueryError("rna_path: hide_emitters: found true, expected false; it shows them")
        self.max_depth = int(props.get("max_depth", 6))
        self.rr_depth = int(props.get("rr_depth", 5))
        self._aovs = bool(props.get("aovs", False))
        self._unrolled = False

    def aov_names(self) -> list[str]:
        return list(AOVS) if self._aovs else []

    def render_forward(self, *arguments: Any, **named: Any) -> Any:
        """Forward-mode derivatives, with the path loop unrolled."""
        self._unrolled = True
        try:
            return super().render_forward(*arguments, **named)
        finally:
            self._unrolled = False

    def render_backward(self, *arguments: Any, **named: Any) -> Any:
        """Reverse-mode derivatives, with the path loop unrolled."""
        self._unrolled = True
        try:
            return super().render_backward(*arguments, **named)
        finally:
            self._unrolled = False

    def sample(self, scene, sampler, ray, medium=None, active=True):  # type: ignore[no-untyped-def]
        """Radiance along camera rays, whether they hit anything, and the AOVs."""
        shapes = shapes_of(scene)
        for shape in shapes:
            check_placed(shape)
        world = World(shapes)
        tracer = Tracer(scene, world, self.max_depth, self.rr_depth)
        state = tracer.start(sampler, ray, active)
        met = state.pi.is_valid() | (state.hits.instance != NOBODY)
        aovs = _aovs(world, state) if self._aovs else []
        if self._unrolled:
            for _ in range(self.max_depth):
                state = tracer.step(state)
        else:
            (state,) = dr.while_loop(
                (state,), lambda s: s.active, lambda s: (tracer.step(s),), label="rna_path"
            )
        return state.L, met, aovs

    def to_string(self) -> str:
        return f"RnaPath[max_depth={self.max_depth}, rr_depth={self.rr_depth}]"


def _aovs(world: World, state: Path) -> list[mi.Float]:
    """Channels `AOVS` of the hits of camera rays; 0 for background."""
    at = Vertex(world, state)
    met = at.on_asset | (at.on_plain & at.si.is_valid())
    normal = world.to_world_directions(at.hits.instance, at.points.n)
    normal = dr.select(at.on_asset, normal, at.si.sh_frame.n)
    index = dr.select(at.on_asset, mi.Float(at.hits.instance) + 1, 0)
    values = [at.place.t, *(at.place.p[k] for k in range(3)), *(normal[k] for k in range(3)), index]
    return [dr.select(met, value, 0) for value in values]


mi.register_integrator("rna_path", RnaPath)
