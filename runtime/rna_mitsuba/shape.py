"""The shape plug-in `rna`: an instance of a package."""

import itertools
import os
from os import PathLike
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np

from rna_mitsuba.evaluator import PartEvaluator
from rna_mitsuba.lobes import PointMixture
from rna_mitsuba.tracing import PackageScene, Shape, geometry_of
from rna_sdk.errors import QueryError
from rna_sdk.motion import open_motion
from rna_sdk.package import Package
from rna_sdk.runtime import Transform, choose_tier, load


class LoadedPackage:
    """One tier of a package in Mitsuba's memory, shared by its instances.

    motion: a motion file and its frame; None for the asset at rest. variant: one of
    `Package.variants`; None for the default base colours.

    Attributes:
        scene: the geometry for ray queries.
        evaluators: decoders of the parts.
        mixtures: of each part, lobes that rays leave its triangles in, from the first one on.
        bounds: (2, 3), box of all parts in object space.
    """

    def __init__(
        self,
        path: str,
        tier: str | None,
        motion: tuple[str, float] | None = None,
        variant: str | None = None,
    ) -> None:
        with Package.open(path) as package:
            record = choose_tier(package, tier, variant=variant)
            shapes = None if motion is None else _shapes(path, record.name, *motion)
            self.scene = PackageScene(package, shapes, variant)
            parts = range(len(package.manifest.parts))
            self.evaluators = [PartEvaluator(package, record.name, part) for part in parts]
            self.mixtures = [
                [
                    (mixture.first, PointMixture.of(mixture, part.kind))
                    for mixture in package.sampling(k)
                ]
                for k, part in enumerate(package.manifest.parts)
            ]
            boxes = np.array([part.bounds.corners() for part in package.manifest.parts])
            if shapes is not None:
                boxes = np.array([geometry_of(s).box() for s in shapes])
        self.bounds = np.stack([boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)])
        self.emits = any(evaluator.emits for evaluator in self.evaluators)


def _shapes(path: str, tier: str, motion: str, frame: float) -> list[Shape]:
    """The parts of a package at a frame of a motion."""
    loaded = load(path, tier=tier, threads=1)
    geometries = [p.curves if p.kind == "fiber" else p.mesh for p in loaded.parts]
    positions = open_motion(motion, geometries, os.path.basename(path)).positions(frame)
    return [part.deformed(p) for part, p in zip(loaded.parts, positions, strict=True)]


_loaded: dict[tuple[Any, ...], LoadedPackage] = {}


def load_package(
    path: str,
    tier: str | None,
    motion: tuple[str, float] | None = None,
    variant: str | None = None,
) -> LoadedPackage:
    """The package at `path`; cached until the file changes. A frame of a motion is not cached."""
    if motion is not None:
        return LoadedPackage(path, tier, motion, variant)
    real = os.path.realpath(path)
    changed = os.path.getmtime(real) if os.path.exists(real) else 0.0
    key = real, changed, tier, variant
    if key not in _loaded:
        _loaded[key] = LoadedPackage(path, tier, None, variant)
    return _loaded[key]


def asset(
    path: str | PathLike[str],
    tier: str | None = None,
    to_world: Any = None,
    motion: str | PathLike[str] | None = None,
    frame: float = 0.0,
    variant: str | None = None,
) -> dict[str, Any]:
    """The scene entry of a package instance, for `mitsuba.load_dict`.

    Args:
        path: the `.rna` file.
        tier: name of the tier; None is the first.
        to_world: object to world: a Mitsuba transform or a (4, 4) array with a rotation, a uniform
            scale and a translation, which may mirror; None is the identity.
        motion: a motion file of `rna-motion` that bends the asset; None is the asset at rest.
        frame: of the motion, from 0; it may lie between two.
        variant: one of `Package.variants`; None for the default base colours.

    Raises:
        PackageError, QueryError: the package, the tier, the variant or the transform cannot be
            used. Mitsuba would say so behind a traceback.

    Example:
        >>> entry = asset("toy.rna", to_world=mi.ScalarTransform4f().translate([0, 0, -1]))
        >>> scene = mi.load_dict({"type": "scene", "toy": entry, "sky": {"type": "constant"}})
    """
    load_package(str(mi.file_resolver().resolve(os.fspath(path))), tier, variant=variant)
    entry: dict[str, Any] = {"type": "rna", "filename": os.fspath(path)}
    if variant is not None:
        entry["variant"] = variant
    if tier is not None:
        entry["tier"] = tier
    if motion is not None:
        entry |= {"motion": os.fspath(motion), "frame": float(frame)}
    if to_world is not None:
        matrix = getattr(to_world, "matrix", to_world)
        numbers = np.array(matrix, float).reshape(4, 4)
        Transform(numbers)  # raises if not a similarity
        entry["to_world"] = mi.ScalarTransform4f(numbers)
    return entry


class RnaShape(mi.Mesh):
    """The shape `rna`, an instance of a package. Only rays of `rna_path` intersect it.

    For Mitsuba itself the shape is one degenerate triangle across the asset's bounding box, which
    gives the scene its extent and is never hit. The parameter `to_world` is differentiable.

    Attributes:
        loaded: the package.
        to_world: object to world, Transform4f.
    """

    def __init__(self, props: mi.Properties) -> None:
        """Raises PackageError, QueryError and MotionError, as Package.open, choose_tier, Transform
        and open_motion."""
        self.to_world: mi.Transform4f | None = None
        path = props["filename"]
        tier, variant = (props[n] if n in props else None for n in ("tier", "variant"))
        matrix = np.eye(4)
        if "to_world" in props:
            matrix = np.array(props["to_world"].matrix, float).reshape(4, 4)
        resolver, motion = mi.file_resolver(), None
        if "motion" in props:
            motion = str(resolver.resolve(props["motion"])), float(props.get("frame", 0.0))
        self.loaded = load_package(str(resolver.resolve(path)), tier, motion, variant)
        Transform(matrix)  # raises if not a similarity
        corners = np.array(list(itertools.product(*self.loaded.bounds.T)))
        corners = corners @ matrix[:3, :3].T + matrix[:3, 3]
        super().__init__(props.id(), 3, 1)
        self.set_id(props.id())
        parameters = mi.traverse(self)
        low, high = corners.min(axis=0), corners.max(axis=0)
        parameters["vertex_positions"] = mi.Float(np.concatenate([low, high, low]))
        parameters["faces"] = mi.UInt32([0, 1, 2])
        parameters.update()
        self.to_world = mi.Transform4f(mi.ScalarTransform4f(matrix))
        dr.make_opaque(self.to_world)

    def traverse(self, callback: mi.TraversalCallback) -> None:
        if self.to_world is None:
            super().traverse(callback)  # called by the base class's constructor
        else:
            callback.put("to_world", self.to_world, mi.ParamFlags.Differentiable)

    def parameters_changed(self, keys: list[str]) -> None:
        """Keeps the placeholder triangle."""
        if self.to_world is None:
            super().parameters_changed(keys)

    def to_string(self) -> str:
        return "RnaShape[]"


def shapes_of(scene: mi.Scene) -> list[RnaShape]:
    """The assets of a scene."""
    return [shape for shape in scene.shapes() if isinstance(shape, RnaShape)]


def check_placed(shape: RnaShape) -> None:
    """Raises QueryError if `to_world` is not a similarity."""
    try:
        Transform(np.array(shape.to_world.matrix, float).reshape(4, 4))
    except QueryError as error:
        raise QueryError(f"shape rna: to_world: {error}") from None


mi.register_shape("rna", RnaShape)
