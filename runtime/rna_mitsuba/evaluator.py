"""Transport and emission of a part in Dr.Jit: what rna_sdk.runtime's `evaluate` is in numpy."""

from __future__ import annotations

import drjit as dr
import mitsuba as mi

from rna_mitsuba.blocks import fiber_columns, surface_columns
from rna_mitsuba.network import Network
from rna_mitsuba.planes import Triplane
from rna_mitsuba.vectors import is_zero, unit
from rna_sdk.package import Package, read_profile_decoder


class PartEvaluator:
    """One part in one tier.

    Attributes:
        is_fiber: whether its axis is a tangent.
        emits: whether it has emission.
    """

    def __init__(self, package: Package, tier: str, part: int) -> None:
        """Raises QueryError: a decoder is outside the decoder profile, or there is no such tier."""
        record, own = package.manifest.parts[part], package.tier(tier).parts[part]
        name = f"{record.name} in tier {tier}"
        self.is_fiber = record.kind == "fiber"
        self._inputs = own.inputs
        self._triplane = Triplane(package.planes(tier, part), record.bounds)
        self._transport = Network(read_profile_decoder(package.decoder(tier, part), name))
        emission = package.emission_decoder(tier, part)
        self.emits = emission is not None
        if emission is not None and own.emission is not None:
            self._emission_inputs = own.emission.inputs
            self._emission = Network(read_profile_decoder(emission, f"emission of {name}"))

    def transport(
        self,
        x: mi.Point3f,
        axis: mi.Vector3f,
        h: mi.Float,
        wo: mi.Vector3f,
        wi: mi.Vector3f,
        active: mi.Bool,
    ) -> tuple[mi.Color3f, mi.Color3f]:
        """(visible, shadowed) for arguments in object space; 0 where they are no query.

        axis: normal or tangent. h: for fibers alone, the offset across. Lanes that are not active
        cost nothing where a whole vector of them is not, and get 0.
        """
        valid = active & _is_query(x, axis, h, wo, wi)

        def ask(x, axis, h, wo, wi, valid):  # type: ignore[no-untyped-def]
            columns = self._columns(self._inputs, x, axis, h, wo, wi, valid)
            found = self._transport(columns)
            return mi.Color3f(*found[:3]), mi.Color3f(*found[3:])

        def nothing(*_):  # type: ignore[no-untyped-def]
            return mi.Color3f(0), mi.Color3f(0)

        asked = (x, axis, h, wo, wi, valid)
        visible, shadowed = dr.if_stmt(asked, valid, ask, nothing)
        return visible, shadowed

    def emission(
        self, x: mi.Point3f, axis: mi.Vector3f, h: mi.Float, wo: mi.Vector3f, active: mi.Bool
    ) -> mi.Color3f:
        """Radiance towards wo with no light on the asset; for arguments see `transport`."""
        if not self.emits:
            return mi.Color3f(0)
        valid = active & _is_query(x, axis, h, wo)

        def ask(x, axis, h, wo, valid):  # type: ignore[no-untyped-def]
            # No block of emission reads wi.
            columns = self._columns(self._emission_inputs, x, axis, h, wo, wo, valid)
            return mi.Color3f(*self._emission(columns))

        asked = (x, axis, h, wo, valid)
        radiance: mi.Color3f = dr.if_stmt(asked, valid, ask, lambda *_: mi.Color3f(0))
        return radiance

    def _columns(self, inputs, x, axis, h, wo, wi, active):  # type: ignore[no-untyped-def]
        p = self._triplane.place(x)
        features = self._triplane.features(p, active)
        axis, wo, wi = unit(axis), unit(wo), unit(wi)
        if self.is_fiber:
            return fiber_columns(inputs, features, p, axis, dr.clip(h, -1, 1), wo, wi)
        return surface_columns(inputs, features, p, axis, wo, wi)


def _is_query(x: mi.Point3f, axis: mi.Vector3f, h: mi.Float, *directions: mi.Vector3f) -> mi.Bool:
    """Whether all is finite, and each direction has a length (spec/RNA.md, 8.1)."""
    result = dr.isfinite(h) & dr.all(dr.isfinite(x))
    for d in (axis, *directions):
        result &= dr.all(dr.isfinite(d)) & ~is_zero(d)
    return result
