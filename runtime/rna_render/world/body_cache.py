"""Bodies of a scene's worlds, frame after frame: parts that do not move are made once."""

from collections.abc import Iterable
from typing import cast

from rna_render.world.bodies import RestMaps, make_body, rest_maps_of
from rna_render.world.placements import Placement
from rna_sdk.runtime import Asset
from rna_trace.points import Body

Key = tuple[int, int, int]


class BodyCache:
    """Makes bodies, and keeps those at rest for the next world, until one has no such object."""

    def __init__(self) -> None:
        self._bodies: dict[Key, tuple[Placement, Body]] = {}
        self._maps: dict[int, tuple[Asset, RestMaps]] = {}

    def of(self, placements: Iterable[Placement]) -> list[Body]:
        """A body for each placement; those given differ by `body_key`."""
        bodies: dict[Key, tuple[Placement, Body]] = {}
        for placement in placements:
            key = body_key(placement)
            bodies[key] = self._bodies.get(key) or (placement, self._made(placement))
        self._bodies = {key: pair for key, pair in bodies.items() if pair[0].shapes is None}
        return [body for _, body in bodies.values()]

    def _made(self, placement: Placement) -> Body:
        if placement.shapes is None:
            return make_body(placement.object, placement.indirect)
        asset = cast(Asset, placement.object)
        if id(asset) not in self._maps:
            self._maps[id(asset)] = asset, rest_maps_of(asset)
        return make_body(asset, placement.indirect, placement.shapes, self._maps[id(asset)][1])


def body_key(placement: Placement) -> Key:
    """Data that placements of one body share."""
    return id(placement.object), id(placement.indirect), id(placement.shapes)
