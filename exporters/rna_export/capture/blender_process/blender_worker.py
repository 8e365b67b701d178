"""Requests to a Blender process: exports of its source, and renders by Cycles."""

import math
from collections.abc import Collection
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from rna_export.capture.blender_axes import (
    Pinhole,
    from_blender,
    pinhole,
    scene_to_blender,
    to_blender,
)
from rna_export.capture.blender_process.blender_process import BlenderProcess, Source
from rna_export.capture.blender_process.exchanged_files import (
    RenderedRays,
    channels,
    exchanged,
    needed_passes,
    read_render,
    write_rays,
)
from rna_export.capture.blender_process.lighting import Light, asked_light
from rna_export.capture.blender_process.material_colors import MaterialColors, Piece
from rna_sdk.package import Curves


@dataclass(frozen=True)
class SeeThrough:
    """Transmittance of a material without refraction; as in rna_sdk.package.Transmittance."""

    texture: np.ndarray  # (h, w, 1 or 3) uint8
    cutoff: float | None
    ior: tuple[float, float] | None


@dataclass(frozen=True)
class MaterialTextures:
    """Textures by the full name of their material.

    see_through: holes and thin glass. normals: normal maps, (h, w, 2) uint8 as in a package.
    charts: the texture coordinates that they are looked up at (see `uv_charts.py`). captured_holes:
    whether light through some material has no texture and is part of its captured light.
    learnt_relief: whether some relief has none. obstacles: by material, what that is by. notes: for
    the user.
    """

    see_through: dict[str, SeeThrough]
    normals: dict[str, np.ndarray]
    charts: dict[str, Any]
    captured_holes: bool
    learnt_relief: bool
    obstacles: dict[str, str]
    notes: list[str]


_CARD = 4  # pixels, a side


class BlenderWorker(BlenderProcess):
    """Exports and renders of one opened source.

    Raises `CaptureError` as `BlenderProcess`, and when a file that is exchanged is not whole.
    """

    def __init__(self, python: Path, source: Source, folder: Path, threads: int, name: str = "0"):
        super().__init__(python, source, folder, threads, name)
        self._renders = 0
        self._samples: int | None = None  # of the last render
        self._holds_scene = False  # what `render_scene` made of the source

    def restart(self) -> None:
        """See `BlenderProcess`; the scene of `render_scene` is gone."""
        self._holds_scene = False
        super().restart()

    @property
    def _has_fibers(self) -> bool:
        return self.kind != "surface"

    def export_curves(self, owner: str | None = None) -> Curves:
        """All strands of a top object, or of the scene, +Y up."""
        arrays, _ = self._exported("exportCurves", owner=owner)
        points = np.ascontiguousarray(from_blender(arrays["points"]), np.float32)
        return Curves(points, arrays["radii"], arrays["offsets"].astype(np.uint32))

    def export_corners(
        self, owner: str | None = None, charts: dict[str, Any] | None = None, of_hosts: bool = False
    ) -> dict[str, np.ndarray]:
        """Corners of a top object's triangles, or of the scene's, +Y up: see `mesh_export.py`.

        The materials of the triangles by their full name, "" for none; `tile` makes them pieces
        (see `material_colors.py`). charts: of
        `MaterialTextures`, for the texture coordinates. of_hosts: whether those of the glass that
        is left to hosts, else of all but that.
        """
        request = {"owner": owner, "charts": charts, "ofHosts": of_hosts}
        corners, answer = self._exported("exportMesh", **request)
        for name in ("positions", "normals"):
            corners[name] = from_blender(corners[name])
        corners["material"] = np.array([*answer["materials"], ""])[corners["material"]]
        return corners

    def export_textures(self, normal_texels: int) -> MaterialTextures:
        """Holes, thin glass and normal maps of all materials that surfaces show.

        normal_texels: along a side of a normal map, at most; 0 for no normal maps.
        """
        textures, answer = self._exported("exportTextures", side=normal_texels)
        holes = {
            record["material"]: SeeThrough(textures[f"holes{k}"], record["cutoff"], record["ior"])
            for k, record in enumerate(answer["holes"])
        }
        normals = {name: textures[f"normals{k}"] for k, name in enumerate(answer["normals"])}
        return MaterialTextures(
            see_through=holes,
            normals=normals,
            charts=answer["charts"],
            captured_holes=answer["captured"],
            learnt_relief=answer["learnt"],
            obstacles=answer["obstacles"],
            notes=answer["notes"],
        )

    def export_base_colors(
        self,
        charts: dict[str, Any],
        largest: int,
        as_texels: Collection[Piece] = (),
        whole: Collection[str] = (),
        only: Collection[str] | None = None,
    ) -> MaterialColors:
        """Base colours of all materials that surfaces show, or of some of them.

        charts: of `MaterialTextures`. largest: texels a side of what is baked, at most.
        as_texels: pieces whose image is wanted as Cycles shows it, and not as its file. whole:
        materials whose UDIM tiles are to be baked as one image. only: materials that are wanted.
        """
        request = {"charts": charts, "asTexels": sorted(as_texels), "largest": largest}
        request["whole"] = sorted(whole)
        wanted = None if only is None else sorted(only)
        return MaterialColors.of(*self._exported("exportBaseColors", **request, only=wanted))

    def _exported(self, op: str, **request: Any) -> tuple[dict[str, np.ndarray], dict[str, Any]]:
        path = self._folder / f"exported-{self._name}.npz"
        answer = self._ask(op=op, out=str(path), **request)
        with exchanged(path), np.load(path) as data:
            arrays = dict(data)
        path.unlink()
        return arrays, answer

    def render_rays(
        self,
        origins: np.ndarray,
        directions: np.ndarray,
        wi: Light,
        samples: int,
        seed: int,
        reach: float | None = None,
        normals: bool = False,
    ) -> RenderedRays:
        """Radiance along rays: the asset lit from `wi` with irradiance 1, or by another `Light`.

        `origins`, `directions`: (n, 3) float32, object space, +Y up; `wi`: (3,) towards the light,
        a white world, or None for what the asset emits. `reach`: how far the rays go. `normals`:
        whether to answer them.
        """
        n = len(origins)
        width = min(n, max(1, math.isqrt(n)))
        height = -(-n // width)
        stem = self._folder / f"rays-{self._name}-{self._renders}"
        paths = {
            k: stem.with_name(f"{stem.name}-{k}.exr") for k in ("origins", "directions", "out")
        }
        write_rays(paths["origins"], to_blender(origins), width, height)
        write_rays(paths["directions"], to_blender(directions), width, height)
        options = {"reach": reach, "normals": normals, "width": width, "height": height}
        request = {k: str(p) for k, p in paths.items()} | options
        self._render("renderRays", request, wi, samples, seed)
        passes = read_render(paths["out"], *needed_passes(self._has_fibers))
        for path in paths.values():
            path.unlink(missing_ok=True)
        return RenderedRays.of_passes(passes, n, self._has_fibers)

    def render_card(self) -> float:
        """Mean radiance of a white diffuse card that faces the sun: 1 / pi, or settings are off."""
        out = self._folder / f"card-{self._name}.exr"
        self._ask(op="renderCard", out=str(out), side=_CARD)
        passes = read_render(out)
        out.unlink()
        return float(channels(passes, "Combined", "RGB").mean())

    def render_pixel_centres(
        self, camera: Pinhole, wi: np.ndarray, samples: int, seed: int
    ) -> RenderedRays:
        """A pinhole image whose pixels are points, by rows from the top; with normals.

        Arguments as in `render_view`.
        """
        out = self._folder / f"view-{self._name}-{self._renders}.exr"
        options = {"out": str(out), "emits": False, "normals": True, "points": True}
        self._render("renderView", {**options, **pinhole(camera)}, wi, samples, seed)
        passes = read_render(out, *needed_passes(self._has_fibers))
        out.unlink()
        return RenderedRays.of_passes(passes, camera.width * camera.height, self._has_fibers)

    def render_view(
        self, camera: Pinhole, wi: Light, samples: int, seed: int, emits: bool = False
    ) -> np.ndarray:
        """An ordinary pinhole image, (height, width, 4) float32 premultiplied RGBA.

        `camera`: in a world of +Y up. `wi`: as in `render_rays`. `emits`: whether the materials
        emit light.
        """
        out = self._folder / f"view-{self._name}-{self._renders}.exr"
        options = {"out": str(out), "emits": emits, "normals": False, "points": False}
        self._render("renderView", {**options, **pinhole(camera)}, wi, samples, seed)
        passes = read_render(out)
        out.unlink()
        return channels(passes, "Combined", "RGBA").reshape(camera.height, camera.width, 4)

    def render_scene(
        self,
        scene: dict[str, Any],
        camera: Pinhole,
        samples: int,
        seed: int,
        denoise: bool = False,
    ) -> tuple[np.ndarray, np.ndarray]:
        """A pinhole image of the source in a scene, and the points that it shows.

        The image: (height, width, 4) float32 premultiplied RGBA. The points: (height, width, 3)
        float32, world space, +Y up, of the first sample of each pixel; 0, 0, 0 where it hits
        nothing.

        scene: see `rna_export.compare.cycles_scene`. No clamping. `denoise`: by Cycles' own
        denoiser, Open Image Denoise with albedo and normals. What the scene describes is
        built anew when it is another one than in the render before; the numbers of samples may
        differ without a fresh process, so the same render need not repeat to the bit. The source
        emits nothing.
        """
        self._holds_scene = True
        out = self._folder / f"scene-{self._name}-{self._renders}.exr"
        self._renders += 1
        self._ask(
            op="renderScene",
            out=str(out),
            scene=scene_to_blender(scene),
            **pinhole(camera),
            samples=samples,
            seed=seed,
            denoise=denoise,
        )
        passes = read_render(out, "Position")
        out.unlink()
        rgba = channels(passes, "Combined", "RGBA").reshape(camera.height, camera.width, 4)
        points = from_blender(channels(passes, "Position", "XYZ")).reshape(rgba[..., :3].shape)
        return rgba, points

    def _render(self, op: str, request: dict[str, Any], wi: Light, samples: int, seed: int) -> None:
        if self._holds_scene or self._samples not in (None, samples):
            # Cycles keeps its table of sample points, whose size follows the sample count: without
            # a fresh process the same render would not repeat.
            self.restart()
        self._samples = samples
        self._renders += 1
        self._ask(op=op, **request, light=asked_light(wi), samples=samples, seed=seed)
