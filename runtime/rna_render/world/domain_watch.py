"""Counts how often an asset is queries for directions that it was not trained for."""

import warnings
from collections.abc import Callable, Iterable
from threading import Lock
from typing import Any, cast

import numpy as np

from rna_sdk.runtime import Asset, FiberAsset, SurfaceAsset, in_region


class DomainWarning(UserWarning):
    """An asset's answers are extrapolated."""


class WatchedAsset:
    """An asset that counts the queries outside its domain; else as rna_sdk.runtime.Asset.

    name: of its file, for the warning.

    Attributes:
        parts: its parts, whose queries are counted.
    """

    def __init__(self, asset: Asset, name: str) -> None:
        self._asset, self._name = asset, name
        self.parts = tuple(_WatchedPart(part, self) for part in asset.parts)
        self._counting = Lock()
        self._queries = self._from_outside = self._lit_outside = self._outside = 0
        self._warned = False

    def __getattr__(self, name: str) -> object:
        return getattr(self._asset, name)

    def with_base_color(self, *arguments: Any) -> "WatchedAsset":
        """Like the asset's own, watched as well."""
        return WatchedAsset(self._asset.with_base_color(*arguments), self._name)

    def count(self, wo: np.ndarray, wi: np.ndarray) -> None:
        """Count the queries of a part, directions (n, 3) float32 in object space."""
        seen = in_region(self._asset.domain.wo, wo)
        lit = in_region(self._asset.domain.wi, wi)
        self.add(len(wo), *(int(np.count_nonzero(~x)) for x in (seen, lit, seen & lit)))

    def add(self, queries: int, from_outside: int, lit_outside: int, outside: int) -> None:
        """Count queries: how many, with views and with lights from outside, and with either."""
        with self._counting:
            self._queries += queries
            self._from_outside += from_outside
            self._lit_outside += lit_outside
            self._outside += outside

    def complaint(self) -> str | None:
        """Warning about the share of queries outside the domain, once; None if there were none."""
        if self._warned or not self._outside:
            return None
        self._warned = True
        whole, views, lights = (
            f"{count / self._queries:.1%}"
            for count in (self._outside, self._from_outside, self._lit_outside)
        )
        return (
            f"{self._name}: {whole} of the queries are outside the directions that it was trained "
            f"for (views {views}, lights {lights})"
        )


class _WatchedPart:
    """A part of a watched asset; else as the part's own."""

    def __init__(self, part: SurfaceAsset | FiberAsset, asset: WatchedAsset) -> None:
        self._part, self._watched = part, asset

    def __getattr__(self, name: str) -> object:
        return getattr(self._part, name)

    def transport(self, *arguments: np.ndarray, **more: np.ndarray) -> np.ndarray:
        """Like the part's own; wo and wi follow position and axis, and h of strands."""
        first = 3 if self._part.kind == "fiber" else 2
        self._watched.count(*arguments[first : first + 2])
        transport: Callable[..., np.ndarray] = self._part.transport
        return transport(*arguments, **more)


def watched(asset: Asset, name: str) -> Asset:
    """The asset; one that was not trained for all directions is watched."""
    domain = asset.domain
    if domain.wo == domain.wi == "sphere":
        return asset
    return cast(Asset, WatchedAsset(asset, name))  # it has whatever an asset has


def warn_of_extrapolation(scene_objects: Iterable[object]) -> None:
    """Warn with DomainWarning of each of a world's assets that left its domain."""
    for scene_object in dict.fromkeys(
        scene_object for scene_object in scene_objects if isinstance(scene_object, WatchedAsset)
    ):
        complaint = scene_object.complaint()
        if complaint is not None:
            warnings.warn(complaint, DomainWarning, stacklevel=2)
