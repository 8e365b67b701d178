"""One Blender process: start, JSON lines protocol, stop, restart."""

from __future__ import annotations

import contextlib
import errno
import json
import math
import os
import shutil
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from zipfile import BadZipFile

import numpy as np
import OpenEXR

from rna_export.capture.blender_axes import from_blender, to_blender
from rna_export.capture.capture_settings import CLAMP_DIRECT, CLAMP_INDIRECT, CaptureSettings
from rna_sdk.errors import CaptureError
from rna_sdk.package import Curves
from rna_work.processor_time import process_seconds

_CARD = 4  # pixels, a side
_LOBES = ("Diffuse", "Glossy", "Transmission")
_LITTLE = 1 << 20  # bytes; with fewer, the disk is full
_LINES = 5  # of Blender's output, in an error
_WORKER = Path(__file__).parents[2] / "blender" / "worker.py"


@dataclass(frozen=True)
class Source:
    """The source model and its Cycles settings; enough to open a worker again."""

    path: Path
    arguments: tuple[str, ...] = ()
    clamp_direct: float = CLAMP_DIRECT
    clamp_indirect: float = CLAMP_INDIRECT
    front: str | None = None  # axes of the file; None: the usual ones of its kind
    up: str | None = None
    parts: str = "kinds"  # see CaptureSettings
    rest_frame: int | None = None  # that is shown; None for the one that the file opens with

    @classmethod
    def captured(cls, path: Path, arguments: tuple[str, ...], settings: CaptureSettings) -> Source:
        """The source as a capture of these settings opens it."""
        clamps = settings.clamp_direct, settings.clamp_indirect
        axes = settings.front, settings.up
        return cls(path, arguments, *clamps, *axes, settings.parts, settings.rest_frame)


@dataclass(frozen=True)
class ScenePart:
    """The objects of an opened source that become a part of the asset."""

    name: str
    kind: str  # "surface" or "fiber"
    owner: str | None  # the top object that it is; None: whatever is of the kind


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
    learnt_relief: whether some relief has none. notes: for the user.
    """

    see_through: dict[str, SeeThrough]
    normals: dict[str, np.ndarray]
    charts: dict[str, Any]
    captured_holes: bool
    learnt_relief: bool
    notes: list[str]


@dataclass(frozen=True)
class RenderedRays:
    """One row a ray, float32.

    radiance: (n, 3) under irradiance 1. alpha: (n,), 1 for a hit. position: (n, 3) Cycles' own
    hits, object space. direct: (n, 3) the part of the radiance that scattered once, at the hit
    itself: without noise on fibers. None of a source without fibers. normal: (n, 3) Cycles' shading
    normals, object space; None where they were not asked for.
    """

    radiance: np.ndarray
    alpha: np.ndarray
    position: np.ndarray
    direct: np.ndarray | None
    normal: np.ndarray | None = None


class BlenderWorker:
    """Stock Cycles in a process of its own, holding one opened source; for a `with` statement.

    Raises `CaptureError` when Blender cannot start, cannot load the source or fails to render.
    """

    def __init__(self, python: Path, source: Source, folder: Path, threads: int, name: str = "0"):
        self._python, self.source, self._threads = python, source, threads
        self._folder, self._name = folder, name
        self._renders = 0
        self._frame = source.rest_frame  # that the source shows; None for the one it opens with
        self._samples: int | None = None  # of the last render
        self._holds_scene = False  # what `render_scene` made of the source
        self._process: subprocess.Popen[str] | None = None
        self._spent = 0.0  # processor time of processes that have ended, s

    def __enter__(self) -> BlenderWorker:
        self._folder.mkdir(parents=True, exist_ok=True)
        self._start()
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _start(self) -> None:
        self._log = (self._folder / f"worker-{self._name}.log").open("w", encoding="utf-8")
        self._process = self._launch()
        try:
            self.opened = self._ask(
                op="open",
                source=str(self.source.path.resolve()),
                arguments=list(self.source.arguments),
                threads=self._threads,
                clampDirect=self.source.clamp_direct,
                clampIndirect=self.source.clamp_indirect,
                front=self.source.front,
                up=self.source.up,
                parts=self.source.parts,
                frame=self._frame,
            )
            self._frame = self.opened["frame"]
            self.parts = tuple(ScenePart(**part) for part in self.opened["parts"])
        except BaseException:
            self.close()
            raise

    def _launch(self) -> subprocess.Popen[str]:
        """A process that has opened nothing yet."""
        return subprocess.Popen(
            [str(self._python), str(_WORKER)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self._log,
            encoding="utf-8",
            errors="replace",  # Blender prints names of files as their bytes are
            process_group=0,  # Ctrl-C is for us; half a render would look like a whole one
        )

    def kill(self) -> None:
        """Kill the process, if it runs: calls from other threads then raise CaptureError."""
        if self._process is not None:
            self._process.kill()

    def processor_seconds(self) -> float | None:
        """Processor time of all its processes so far, s; None where the system does not tell."""
        process = self._process
        if process is None or process.poll() is not None:
            return self._spent
        now = process_seconds(process.pid)
        return None if now is None else self._spent + now

    def close(self) -> None:
        """End the process; safe to call twice."""
        process = self._running()
        if process.poll() is None:
            self._spent += process_seconds(process.pid) or 0.0
        self.kill()
        process.wait()
        for stream in (process.stdin, process.stdout, self._log):
            if stream is not None:
                with contextlib.suppress(OSError):  # a request that never reached it; a full disk
                    stream.close()

    def _running(self) -> subprocess.Popen[str]:
        assert self._process is not None  # since __enter__
        return self._process

    def restart(self) -> None:
        """A fresh process with the same source: Blender's memory grows over many renders."""
        self.close()
        self._holds_scene = False
        self._start()

    def _ask(self, **request: Any) -> dict[str, Any]:
        process = self._running()
        assert process.stdin is not None and process.stdout is not None  # pipes
        try:
            process.stdin.write(json.dumps(request) + "\n")
            process.stdin.flush()
            for line in process.stdout:
                if line.startswith("RNA "):
                    answer: dict[str, Any] = json.loads(line[4:])
                    if not answer["ok"]:
                        raise CaptureError(f"{self.source.path}: Blender says: {answer['error']}")
                    return answer
                self._log.write(line)
        except BrokenPipeError:
            pass
        raise CaptureError(
            f"{self.source.path}: the Blender worker ended without an answer to "
            f"{request['op']!r}; its last output: {self._last_words()}"
        )

    def _last_words(self) -> str:
        self._log.flush()
        lines = Path(self._log.name).read_text("utf-8", errors="replace").split("\n")
        return " / ".join([line.strip() for line in lines if line.strip()][-_LINES:]) or "none"

    @property
    def kind(self) -> str:
        """Kind of the opened source's parts: "surface", "fiber" or "both"."""
        kinds = {part.kind for part in self.parts}
        return kinds.pop() if len(kinds) == 1 else "both"

    def frame_span(self) -> tuple[int, int, float]:
        """First and last frame of the source's scene, and frames a second."""
        answer = self._ask(op="frameSpan")
        return answer["first"], answer["last"], answer["rate"]

    def show_frame(self, frame: int) -> None:
        """Go to another frame of the source, for what is exported and rendered then."""
        if frame != self._frame:
            self._frame = frame
            self._ask(op="showFrame", frame=frame)

    def export_curves(self, owner: str | None = None) -> Curves:
        """All strands of a top object, or of the scene, +Y up."""
        arrays, _ = self._exported("exportCurves", owner=owner)
        points = np.ascontiguousarray(from_blender(arrays["points"]), np.float32)
        return Curves(points, arrays["radii"], arrays["offsets"].astype(np.uint32))

    def export_corners(
        self, owner: str | None = None, charts: dict[str, Any] | None = None
    ) -> dict[str, np.ndarray]:
        """Corners of a top object's triangles, or of the scene's, +Y up: see `mesh_export.py`.

        The materials of the triangles by their full name, "" for none. charts: of
        `MaterialTextures`, for the texture coordinates.
        """
        corners, answer = self._exported("exportMesh", owner=owner, charts=charts)
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
        flags = answer["captured"], answer["learnt"]
        return MaterialTextures(holes, normals, answer["charts"], *flags, answer["notes"])

    def _exported(self, op: str, **request: Any) -> tuple[dict[str, np.ndarray], dict[str, Any]]:
        path = self._folder / f"exported-{self._name}.npz"
        answer = self._ask(op=op, out=str(path), **request)
        with _exchanged(path), np.load(path) as data:
            arrays = dict(data)
        path.unlink()
        return arrays, answer

    def render_rays(
        self,
        origins: np.ndarray,
        directions: np.ndarray,
        wi: np.ndarray | None,
        samples: int,
        seed: int,
        reach: float | None = None,
        normals: bool = False,
    ) -> RenderedRays:
        """Radiance along rays: the asset lit from `wi` with irradiance 1, or its emission alone.

        `origins`, `directions`: (n, 3) float32, object space, +Y up; `wi`: (3,) towards the light,
        or None for what the asset emits. `reach`: how far the rays go. `normals`: whether to
        answer them.
        """
        n = len(origins)
        width = min(n, max(1, math.isqrt(n)))
        height = -(-n // width)
        stem = self._folder / f"rays-{self._name}-{self._renders}"
        paths = {
            k: stem.with_name(f"{stem.name}-{k}.exr") for k in ("origins", "directions", "out")
        }
        _write_rays(paths["origins"], to_blender(origins), width, height)
        _write_rays(paths["directions"], to_blender(directions), width, height)
        request = {k: str(p) for k, p in paths.items()} | {"reach": reach, "normals": normals}
        self._render("renderRays", request, wi, samples, seed, width, height)
        passes = _read_render(paths["out"], *self._needed())
        for path in paths.values():
            path.unlink(missing_ok=True)
        return self._rays(passes, n)

    def _needed(self) -> tuple[str, ...]:
        """Passes that `_rays` reads."""
        lobes = [f"{lobe} {kind}" for lobe in _LOBES for kind in ("Direct", "Color")]
        return "Combined", "Position", *(lobes if self.kind != "surface" else ())

    def _rays(self, passes: dict[str, np.ndarray], n: int) -> RenderedRays:
        rgba = _channels(passes, "Combined", "RGBA")[:n]
        position = from_blender(_channels(passes, "Position", "XYZ")[:n])
        direct = _direct(passes)[:n] if self.kind != "surface" else None
        normal = None
        if "Normal.X" in passes:
            normal = from_blender(_channels(passes, "Normal", "XYZ")[:n])
        return RenderedRays(rgba[:, :3], rgba[:, 3], position, direct, normal)

    def render_card(self) -> float:
        """Mean radiance of a white diffuse card that faces the sun: 1 / pi, or settings are off."""
        out = self._folder / f"card-{self._name}.exr"
        self._ask(op="renderCard", out=str(out), side=_CARD)
        passes = _read_render(out)
        out.unlink()
        return float(_channels(passes, "Combined", "RGB").mean())

    def render_pixel_centres(
        self,
        to_world: np.ndarray,
        fov_y: float,
        wi: np.ndarray,
        samples: int,
        seed: int,
        width: int,
        height: int,
    ) -> RenderedRays:
        """A pinhole image whose pixels are points, by rows from the top; with normals.

        Arguments as in `render_view`.
        """
        out = self._folder / f"view-{self._name}-{self._renders}.exr"
        options = {"out": str(out), "emits": False, "normals": True, "points": True}
        request = {**options, **_pinhole(to_world, fov_y, width, height)}
        self._render("renderView", request, wi, samples, seed, width, height)
        passes = _read_render(out, *self._needed())
        out.unlink()
        return self._rays(passes, width * height)

    def render_view(
        self,
        to_world: np.ndarray,
        fov_y: float,
        wi: np.ndarray,
        samples: int,
        seed: int,
        width: int,
        height: int,
        emits: bool = False,
    ) -> np.ndarray:
        """An ordinary pinhole image, (height, width, 4) float32 premultiplied RGBA.

        `to_world`: (4, 4) camera (looks along -z) to +Y-up world; `fov_y` in radians; `emits`:
        whether the materials emit light.
        """
        out = self._folder / f"view-{self._name}-{self._renders}.exr"
        options = {"out": str(out), "emits": emits, "normals": False, "points": False}
        request = {**options, **_pinhole(to_world, fov_y, width, height)}
        self._render("renderView", request, wi, samples, seed, width, height)
        passes = _read_render(out)
        out.unlink()
        return _channels(passes, "Combined", "RGBA").reshape(height, width, 4)

    def render_scene(
        self,
        scene: dict[str, Any],
        to_world: np.ndarray,
        fov_y: float,
        samples: int,
        seed: int,
        width: int,
        height: int,
        denoise: bool = False,
    ) -> tuple[np.ndarray, np.ndarray]:
        """A pinhole image of the source in a scene, and the points that it shows.

        The image: (height, width, 4) float32 premultiplied RGBA. The points: (height, width, 3)
        float32, world space, +Y up, of the first sample of each pixel; 0, 0, 0 where it hits
        nothing.

        scene: see `rna_export.compare.cycles_scene`. No clamping. `denoise`: by Cycles' own
        denoiser, Open Image Denoise with albedo and normals. What the scene describes is built
        anew when it is another one than in the render before; the numbers of samples may differ
        without a fresh process, so the same render need not repeat to the bit. `to_world` and
        `fov_y` as in `render_view`.
        """
        self._holds_scene = True
        out = self._folder / f"scene-{self._name}-{self._renders}.exr"
        self._renders += 1
        self._ask(
            op="renderScene",
            out=str(out),
            scene=_scene_to_blender(scene),
            **_pinhole(to_world, fov_y, width, height),
            samples=samples,
            seed=seed,
            denoise=denoise,
        )
        passes = _read_render(out, "Position")
        out.unlink()
        rgba = _channels(passes, "Combined", "RGBA").reshape(height, width, 4)
        points = from_blender(_channels(passes, "Position", "XYZ")).reshape(height, width, 3)
        return rgba, points

    def _render(
        self,
        op: str,
        request: dict[str, Any],
        wi: np.ndarray | None,
        samples: int,
        seed: int,
        width: int,
        height: int,
    ) -> None:
        if self._holds_scene or self._samples not in (None, samples):
            # Cycles keeps its table of sample points, whose size follows the sample count: without
            # a fresh process the same render would not repeat.
            self.restart()
        self._samples = samples
        self._renders += 1
        towards = None if wi is None else to_blender(np.asarray(wi, np.float64)).tolist()
        size = {"width": width, "height": height}
        self._ask(op=op, **{**request, **size}, wi=towards, samples=samples, seed=seed)


def _pinhole(to_world: np.ndarray, fov_y: float, width: int, height: int) -> dict[str, Any]:
    """A camera, which looks along its -z in Blender too, as a request has it."""
    matrix = np.eye(4)
    matrix[:3] = to_blender(np.asarray(to_world, np.float64)[:3].T).T
    size = {"width": width, "height": height}
    return {"matrix": matrix.tolist(), "fovY": float(fov_y), **size}


def _scene_to_blender(scene: dict[str, Any]) -> dict[str, Any]:
    """A scene in Blender's axes."""

    def turned(vectors: Any) -> Any:
        return to_blender(np.asarray(vectors, np.float64)).tolist()

    lights = [
        {k: turned(v) if k in ("position", "look_at", "up", "direction") else v for k, v in x}
        for x in (light.items() for light in scene["lights"])
    ]
    meshes = [{**mesh, "positions": turned(mesh["positions"])} for mesh in scene["meshes"]]
    assets = [_matrix_to_blender(matrix) for matrix in scene["assets"]]
    return {**scene, "lights": lights, "meshes": meshes, "assets": assets}


def _matrix_to_blender(matrix: list[list[float]]) -> list[list[float]]:
    """Both spaces turn: the rows, where the 4 x 4 matrix leads to, and the columns, where from."""
    turned = np.asarray(matrix, np.float64)
    turned[:3, :3] = to_blender(to_blender(turned[:3, :3].T).T)
    turned[:3, 3] = to_blender(turned[:3, 3])
    rows: list[list[float]] = turned.tolist()
    return rows


def _write_rays(path: Path, vectors: np.ndarray, width: int, height: int) -> None:
    image = np.zeros((height * width, 3), np.float32)
    image[: len(vectors)] = vectors
    header = {"compression": OpenEXR.NO_COMPRESSION, "type": OpenEXR.scanlineimage}
    channels = {"RGB": image.reshape(height, width, 3)}
    with _exchanged(path), OpenEXR.File(header, channels) as file:
        file.write(str(path))


def _read_render(path: Path, *needed: str) -> dict[str, np.ndarray]:
    """The channels of a multilayer or multi-part EXR, "Pass.C" -> (pixels,) float32.

    needed: passes, of which it is an error that one is missing.
    """
    planes: dict[str, np.ndarray] = {}
    if not path.is_file():
        raise CaptureError(f"{path}: Blender wrote no image")
    with _exchanged(path):
        with OpenEXR.File(str(path), separate_channels=True) as file:
            for part in file.parts:
                for name, channel in part.channels.items():
                    pixels = np.asarray(channel.pixels, np.float32).reshape(-1)
                    planes[".".join(name.split(".")[-2:])] = pixels
        there = {name.rpartition(".")[0] for name in planes}
        if missing := {"Combined", *needed} - there:
            raise ValueError(f"it has no {', '.join(sorted(missing))}")
    return planes


@contextlib.contextmanager
def _exchanged(path: Path) -> Iterator[None]:
    """Raises CaptureError where a file that goes to Blender or comes from it is not whole."""
    try:
        yield
    except (OSError, RuntimeError, ValueError, KeyError, EOFError, BadZipFile) as error:
        is_full = shutil.disk_usage(path.parent).free < _LITTLE
        why = os.strerror(errno.ENOSPC) if is_full else " ".join(str(error).split())
        raise CaptureError(f"{path}: a file exchanged with Blender is not whole: {why}") from error


def _channels(passes: dict[str, np.ndarray], name: str, channels: str) -> np.ndarray:
    return np.stack([passes[f"{name}.{c}"] for c in channels], axis=-1)


def _direct(passes: dict[str, np.ndarray]) -> np.ndarray:
    """Light of no bounce; Cycles divides each lobe's by its colour."""
    lobes = [
        _channels(passes, f"{lobe} Direct", "RGB") * _channels(passes, f"{lobe} Color", "RGB")
        for lobe in _LOBES
    ]
    diffuse, glossy, transmission = lobes
    return np.asarray(diffuse + glossy + transmission)
