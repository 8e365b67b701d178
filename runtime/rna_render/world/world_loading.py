"""From a scene file to its world: packages, meshes and lights, loaded and placed."""

import warnings
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from rna_render.lights import AssetEmission, PlacedLight, make_light
from rna_render.materials import MeshObject, ground, read_mesh_object
from rna_render.materials.textures import read_texels
from rna_render.scene.light_models import AreaModel, LightModel
from rna_render.scene.limits import MAX_SIZE, MIN_SIZE
from rna_render.scene.scene_file import SceneFile
from rna_render.scene.scene_model import AssetModel, CameraModel, GroundModel
from rna_render.scene.transforms import from_origin, world_from_object
from rna_render.world.body_cache import BodyCache
from rna_render.world.domain_watch import watched
from rna_render.world.motion_loading import MotionLoader
from rna_render.world.placements import Placement, emission_of, mesh_light, place_asset
from rna_render.world.tier_choice import Tiers
from rna_render.world.world import World
from rna_sdk.errors import MotionError, QueryError, SceneError
from rna_sdk.runtime import Asset

# What extends further than this many times the distance of `look_at` says nothing of the size of
# the scene, which lights are weighed by: a hill on the horizon, or the terrain.
_REACH = 100.0


class Loaded:
    """Contents of a scene's files, each loaded once, for the worlds of several frames.

    Attributes:
        tiers: of the last world that was placed.
    """

    def __init__(self) -> None:
        self.assets = _AssetLoader()
        self.motions = MotionLoader()
        self.objects: dict[tuple[Path, str, bool], MeshObject] = {}
        self.bodies = BodyCache()
        self.tiers: Tiers = ()


def placed_world(scene_file: SceneFile, tiers: Tiers, loaded: Loaded | None = None) -> World:
    """The scene's objects: assets with these tiers, objects, the ground, lights with a shape.

    Each package is loaded once a tier and proxy, and each object file once a material; none that
    is among those `loaded`. Assets in motion are as at their `motion.start`. Raises SceneError
    where the file names something that cannot be used, PackageError for a broken package.
    """
    loaded = loaded or Loaded()
    loaded.tiers = tiers
    loaded.motions.begin_frame()
    view = scene_file.viewpoint
    origin = np.array(view.position, np.float64)
    placed = (
        _placed_assets(scene_file, tiers, loaded, origin),
        _placed_objects(scene_file, loaded.objects, origin),
    )
    _check_sizes(scene_file, "assets", placed[0])
    _check_sizes(scene_file, "objects", placed[1])
    standing = [*placed[0], *placed[1]]
    still = [
        *_placed_ground(scene_file.resolved.ground, view),
        *_placed_lights(scene_file.scene.lights, origin),
    ]
    reach = _REACH * float(np.linalg.norm(np.subtract(view.look_at, view.position)))
    return World([*standing, *still], loaded.bodies, origin, reach)


def _check_sizes(scene_file: SceneFile, key: str, placements: Sequence[Placement]) -> None:
    """Raises SceneError for an object that rays would miss: too small or large, or once placed."""
    sizes: dict[tuple[int, int], float] = {}
    for index, placement in enumerate(placements):
        which = id(placement.object), id(placement.shapes)
        if which not in sizes:
            low, high = placement.own_box
            sizes[which] = float((high.astype(np.float64) - low).max())
        scale = np.linalg.norm(placement.world_from_object[:3, 0])
        for size, what in (
            (sizes[which], "its size"),
            (scale * sizes[which], "its size as placed"),
        ):
            if not MIN_SIZE <= size <= MAX_SIZE:
                message = f"{what} is {size:.3g} m; expected {MIN_SIZE:g} to {MAX_SIZE:g}"
                raise scene_file.error((key, index), message)


def _placed_assets(
    scene_file: SceneFile, tiers: Tiers, loaded: Loaded, origin: np.ndarray
) -> list[Placement]:
    load, motions = loaded.assets, loaded.motions
    placements = []
    for index, (model, chosen) in enumerate(zip(scene_file.resolved.assets, tiers, strict=True)):
        path, pixels = model.path, chosen.pixels
        if model.motion is not None:
            pixels = None  # a proxy has other vertices
        try:
            asset = load(path, chosen.tier, pixels, model.variant)
        except QueryError as error:
            key = "tier" if model.variant is None else "variant"
            raise scene_file.error(("assets", index, key), str(error)) from error
        other = None
        if chosen.indirect is not None:
            other = load(path, chosen.indirect, pixels, model.variant)
        if model.maps or model.tint != (1.0, 1.0, 1.0):
            try:
                asset = load.printed(asset, model)
                other = None if other is None else load.printed(other, model)
            except (QueryError, SceneError) as error:
                raise scene_file.error(("assets", index, "maps"), str(error)) from error
        shapes, after = None, None
        if model.motion is not None:
            try:
                shapes = motions.shapes(model.motion, path, asset)
                after = motions.after(model.motion, path, shapes)
            except (MotionError, QueryError) as error:
                raise scene_file.error(("assets", index, "motion"), str(error)) from error
        emission = load.emission(asset) if shapes is None else motions.emission(asset, shapes)
        matrix = world_from_object(model.transform, origin)
        placements.append(
            place_asset(asset, matrix, emission, model.emission, other, shapes, after)
        )
    return placements


class _AssetLoader:
    """Loads each tier, proxy, variant and emission of a package once."""

    def __init__(self) -> None:
        self._loaded: dict[tuple[Path, str | None, float | None, str | None], Asset] = {}
        # With the asset that each was made of, so that its id stays its own.
        self._printed: dict[tuple[int, str], tuple[Asset, Asset]] = {}
        self._emissions: dict[int, AssetEmission | None] = {}

    def __call__(
        self, path: Path, tier: str | None, pixels: float | None, variant: str | None
    ) -> Asset:
        from rna_sdk.runtime import load

        key = path, tier, pixels, variant
        if key not in self._loaded:
            asset = load(path, tier=tier, threads=1, pixels=pixels, variant=variant)
            self._loaded[key] = watched(asset, path.name)
        return self._loaded[key]

    def printed(self, asset: Asset, model: AssetModel) -> Asset:
        """The asset with the images and the tint of its place in the scene.

        Raises SceneError for a file that is no image, QueryError for a label that is not there.
        """
        key = id(asset), repr((model.maps, model.tint))
        if key not in self._printed:
            images = {label: read_texels(path, path) for label, path in model.maps.items()}
            self._printed[key] = asset, asset.with_base_color(images, model.tint)
        return self._printed[key][1]

    def emission(self, asset: Asset) -> AssetEmission | None:
        if id(asset) not in self._emissions:
            self._emissions[id(asset)] = emission_of(asset)
        return self._emissions[id(asset)]


def _placed_objects(
    scene_file: SceneFile, loaded: dict[tuple[Path, str, bool], MeshObject], origin: np.ndarray
) -> list[Placement]:
    placements = []
    for index, model in enumerate(scene_file.resolved.objects):
        key = model.path, repr(model.material), model.fallbacks
        if key not in loaded:
            try:
                loaded[key] = read_mesh_object(model.path, model.material, model.fallbacks)
            except SceneError as error:
                raise scene_file.error(("objects", index), str(error)) from error
        matrix = world_from_object(model.transform, origin)
        placements.append(Placement(loaded[key], matrix, mesh_light(loaded[key], matrix)))
    return placements


def _placed_ground(model: GroundModel | None, camera: CameraModel) -> list[Placement]:
    if model is None:
        return []
    mesh = ground(model, camera)
    return [Placement(mesh, np.eye(4), mesh_light(mesh, np.eye(4)), boundless=True)]


def _placed_lights(models: Sequence[LightModel], origin: np.ndarray) -> list[Placement]:
    areas = (model for model in models if isinstance(model, AreaModel))
    lights = [make_light(from_origin(model, origin)) for model in areas]
    return [
        Placement(light, light.world_from_object, light, boundless=True)
        for light in lights
        if isinstance(light, PlacedLight)
    ]


class DarkWarning(UserWarning):
    """Nothing in a scene shines."""


def warn_of_darkness(scene: Path, lights: Sequence[LightModel], world: World) -> None:
    """Warns with DarkWarning where no light, object, ground or asset of a scene file shines."""
    shining = any(p.light is not None and p.light is not p.object for p in world.placements)
    if not shining and not any(map(_shines, lights)):
        message = "the scene has no light, so its image is black: give it lights (docs/scene.md)"
        warnings.warn(f"{scene}: {message}", DarkWarning, stacklevel=2)


def _shines(light: LightModel) -> bool:
    strengths = ("irradiance", "intensity", "radiance")
    return any(any(getattr(light, name, ())) for name in strengths)
