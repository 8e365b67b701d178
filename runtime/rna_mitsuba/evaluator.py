"""Transport and emission of a part in Dr.Jit, as rna_sdk.runtime's `evaluate` in numpy."""

import drjit as dr
import mitsuba as mi

from rna_mitsuba import vectors
from rna_mitsuba.network import Network
from rna_mitsuba.planes import Triplane
from rna_mitsuba.vectors import is_zero, numbers, unit
from rna_sdk.package import Package, decoder_from_bytes, input_blocks

Arrays = dict[str, mi.Float | mi.Vector3f]


class PartEvaluator:
    """One part in one tier.

    Attributes:
        is_fiber: whether its axis is a tangent.
        uses_base_color: whether transport has a factor of the base colour.
        emits: whether it has emission.
        nearby: the record of the nearby light that transport counts; None for none.
    """

    def __init__(self, package: Package, tier: str, part: int) -> None:
        """Raises QueryError: there is no such tier."""
        record, tier_part = package.manifest.parts[part], package.tier(tier).parts[part]
        name = f"{record.name} in tier {tier}"
        self.is_fiber = record.kind == "fiber"
        self.uses_base_color = bool(tier_part.uses_base_color)
        self.nearby = tier_part.nearby
        self._triplane = Triplane(package.planes(tier, part), record.bounds)
        self._decoders = {}
        for one in tier_part.decoders:
            called = f"{one.form.name} of {name}"
            model = decoder_from_bytes(package.decoder(tier, part, one.form.name), called)
            self._decoders[one.form.name] = one.inputs, Network(model), len(one.form.results)
        self.emits = "emission" in self._decoders

    def decode(self, form: str, arrays: Arrays, active: mi.Bool) -> tuple[mi.Color3f, ...]:
        """The colours of a form for arguments in object space; 0 where they are no query.

        form: "transport" gives (visible, shadowed), "emission" the one radiance, 0 of a part that
        does not emit. arrays: position, axis (normal or tangent), h (of fibers the offset across),
        wo, and of transport wi, base_color and nearby, for which the part's means stand in. Lanes
        that are not active cost nothing where a whole vector of them is not, and get 0.
        """
        names = ("visible", "shadowed") if form not in self._decoders else (form,)
        if form == "emission" and not self.emits:
            return (mi.Color3f(0),)
        return tuple(color for name in names for color in self._run(name, arrays, active))

    def transport(self, v: mi.Color3f, arrays: Arrays, active: mi.Bool) -> mi.Color3f:
        """T for the visibility v; decoders apart are run where their light counts."""
        if "transport" in self._decoders:
            visible, shadowed = self._run("transport", arrays, active)
        else:
            (visible,) = self._run("visible", arrays, active & dr.any(v > 0))
            (shadowed,) = self._run("shadowed", arrays, active & dr.any(v < 1))
        return v * visible + (1 - v) * shadowed

    def _run(self, name: str, arrays: Arrays, active: mi.Bool) -> tuple[mi.Color3f, ...]:
        """The results of a decoder."""
        inputs, network, colours = self._decoders[name]
        arrays = dict(arrays)
        color = mi.Color3f(arrays.pop("base_color", 1))
        counted = arrays.pop("nearby", None)
        counts_nearby = self.nearby is not None and name != "emission"
        shares = self._shares(name, counted) if counts_nearby else []
        valid = active & _is_query(**arrays)
        scaled = self.uses_base_color and name != "emission"
        if scaled:
            valid &= dr.all(dr.isfinite(color))
        for share in shares:
            valid &= dr.all(dr.isfinite(share))

        def ask(arrays, color, shares, valid):  # type: ignore[no-untyped-def]
            result = network(self._columns(inputs, valid, **arrays))
            light = [mi.Color3f(*result[3 * k : 3 * k + 3]) for k in range(len(result) // 3)]
            if counts_nearby:
                light = _with_nearby(light, shares, colours)
            if not scaled:
                return tuple(light)
            pairs = zip(light[:colours], light[colours:], strict=True)
            return tuple(dr.maximum(0, plain + color * factor) for plain, factor in pairs)

        def nothing(*_):  # type: ignore[no-untyped-def]
            return tuple(mi.Color3f(0) for _ in range(colours))

        state = arrays, color, shares, valid
        result: tuple[mi.Color3f, ...] = dr.if_stmt(state, valid, ask, nothing)
        return result

    def _shares(self, name: str, counted: mi.Vector3f | None) -> list[mi.Vector3f]:
        """Nearby light for each result of a decoder."""
        assert self.nearby is not None
        means = {"visible": self.nearby.visible, "shadowed": self.nearby.shadowed}
        names = [name] if name in means else list(means)
        if counted is not None:
            return [mi.Vector3f(counted)] * len(names)
        return [mi.Vector3f(*means[of]) for of in names]

    def _columns(self, inputs, active, position, axis, h, wo, wi=None):  # type: ignore[no-untyped-def]
        p = self._triplane.place(position)
        features = self._triplane.features(p, active)
        axis, wo = unit(axis), unit(wo)
        wi = wo if wi is None else unit(wi)  # that no block reads
        f, h = mi.Vector3f(*[*features, 0, 0][:3]), dr.clip(h, -1, 1)
        blocks = input_blocks(vectors, inputs, p=p, n=axis, t=axis, h=h, f=f, wo=wo, wi=wi)
        blocks["features"] = tuple(features)
        return [column for name in inputs for value in blocks[name] for column in numbers(value)]


def _with_nearby(
    light: list[mi.Color3f], shares: list[mi.Vector3f], colours: int
) -> list[mi.Color3f]:
    """The first quarter of the colours, and each of the others times nearby light."""
    count, mixed = len(light) // 4, []
    for i in range(count):
        share = dr.maximum(shares[i % colours], 0)
        total = light[i]
        for k in range(3):
            total = total + share[k] * light[(k + 1) * count + i]
        mixed.append(total)
    return mixed


def _is_query(position: mi.Point3f, h: mi.Float, **directions: mi.Vector3f) -> mi.Bool:
    """Whether all is finite, and each direction has a length (spec/RNA.md, 8.1)."""
    result = dr.isfinite(h) & dr.all(dr.isfinite(position))
    for d in directions.values():
        result &= dr.all(dr.isfinite(d)) & ~is_zero(d)
    return result
