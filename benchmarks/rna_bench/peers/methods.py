"""Every method of `rna-bench peers`: a row each."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from typing import TYPE_CHECKING

from rna_bench.peers.method import Method

if TYPE_CHECKING:
    from rna_bench.peers.known_geometry import KnownGeometry


@dataclass(frozen=True)
class Setting:
    """Arguments that a method is made with.

    seed: of its initialisation and training. device: of PyTorch. full: the published sizes of
    batches and numbers of samples a ray, instead of those for a CPU. geometry: of our package of
    the asset, for methods that know it.
    """

    seed: int = 0
    device: str = "cpu"
    full: bool = False
    geometry: KnownGeometry | None = None


@dataclass(frozen=True)
class MethodRow:
    """A method by name.

    title: for tables. make: imports its module. published_steps, published_batch: of the training
    as published; None where it is not known. reduced: what differs without `Setting.full`, for
    tables; empty for nothing. collocated: whether it is trained on views with the light at the
    camera. needs_geometry: whether `Setting.geometry` must be there.
    """

    name: str
    title: str
    make: Callable[[Setting], Method]
    published_steps: int | None
    published_batch: int | None
    reduced: str = ""
    collocated: bool = False
    needs_geometry: bool = False

    def share(self, samples: int) -> float | None:
        """Share of the published number of training pixels, counted with repetition."""
        if self.published_steps is None or self.published_batch is None:
            return None
        return samples / (self.published_steps * self.published_batch)


def _later(module: str, name: str) -> Callable[[Setting], Method]:
    """The maker of that name in a module of this package, imported when it is called."""

    def make(setting: Setting) -> Method:
        method: Method = getattr(import_module(f"rna_bench.peers.{module}"), name)(setting)
        return method

    return make


_REDUCED = (
    "32 rays of 8 + 16 samples a step instead of 512 of 64 + 64; 16 + 16 in the last two units "
    "from the light instead of 64 + 64 on the whole way"
)

_REDUCED_FIELDS = "64 rays of 16 + 24 samples a step instead of NeRF's 4,096 of 64 + 128"

_ROWS: tuple[MethodRow, ...] = (
    MethodRow("nrhints", "NRHints", _later("nrhints.nrhints", "make"), 1_000_000, 512, _REDUCED),
    MethodRow(
        "nrhints-known",
        "NRHints' networks on known geometry",
        _later("nrhints.nrhints_known", "KnownNRHints"),
        None,
        None,
        needs_geometry=True,
    ),
    MethodRow(
        "nrhints-geometry",
        "NRHints with depth and alpha losses, weight 1",
        _later("nrhints.nrhints", "make_with_geometry"),
        1_000_000,
        512,
        _REDUCED,
    ),
    MethodRow(
        "nrhints-geometry-low",
        "NRHints with depth and alpha losses, weight 0.1",
        _later("nrhints.nrhints", "make_with_less_geometry"),
        1_000_000,
        512,
        _REDUCED,
    ),
    MethodRow(
        "analytic",
        "An analytic material on known geometry",
        _later("analytic_known", "KnownMaterial"),
        None,
        None,
        needs_geometry=True,
    ),
    MethodRow(
        "fields",
        "Neural Reflectance Fields",
        _later("fields.reflectance_field", "make"),
        None,
        None,
        _REDUCED_FIELDS,
        collocated=True,
    ),
    MethodRow(
        "fields-fur",
        "Neural Reflectance Fields, for fur",
        _later("fields.reflectance_field", "make_of_fur"),
        None,
        None,
        _REDUCED_FIELDS,
        collocated=True,
    ),
)

METHODS = {row.name: row for row in _ROWS}
