"""Pixels far smaller than a texel.

What a picture may lose there is what a texture loses: Cycles' own image with one value a texel, and
straight lines between them, as any renderer shows a texture from too near.
"""

import base64
import io
from functools import partial

import numpy as np
from matplotlib.figure import FigureBase
from PIL import Image

from rna_bench.scenes.beside_cycles import OurScene
from rna_bench.stability.case import Case, Row, Verdict, values
from rna_bench.stability.fixtures import Fixtures
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.blender_process.lighting import WhiteWorld
from rna_export.compare.views import shots_of
from rna_export.metrics import flip, psnr_without_noise, to_png
from rna_render import Camera
from rna_render.scene import AssetModel, CameraModel, DirectionalModel, Scene
from rna_sdk.runtime import Asset

FLIP, FACTOR = 0.1, 1.5  # the mark

FOOTPRINTS = (10.0, 3.0, 1.0, 0.3, 0.1)  # of a pixel, in texels
_TEXELS = 256  # along a side of the planes of `small` and `hq`
PIXELS, _SAMPLES, _CYCLES_SAMPLES = 96, 16, 48


def measure(fixtures: Fixtures) -> list[Row]:
    asset = fixtures.asset
    close_ups = [s for s in shots_of(asset, PIXELS) if s.camera_name == "close-up"]
    shots = [(s, s.light) for s in close_ups if not isinstance(s.light, WhiteWorld)][:2]
    rows = []
    with fixtures.cycles(fixtures.source) as worker:
        for number, (shot, wi) in enumerate(shots):
            for footprint in FOOTPRINTS:
                camera = zoomed(shot.eye, shot.target, footprint * texel(asset))
                scene = _scene(fixtures, camera, wi)
                name = f"zoom-{fixtures.name}-{number}-{footprint:g}"
                reference = fixtures.stored(name, partial(_cycles, worker, camera, wi))
                halves = reference["halves"]
                ours = OurScene(scene).render(fixtures.some(_SAMPLES)).pixels
                rows.append({"view": number, "texels": footprint, **_row(ours, halves, footprint)})
    return rows


def texel(asset: Asset) -> float:
    """The longest side of a texel of the usual planes around the whole asset, metres.

    Whatever planes it has: an asset that is cut into pieces is seen as near as one that is not.
    """
    low = np.min([part.bounds[0] for part in asset.parts], axis=0)
    high = np.max([part.bounds[1] for part in asset.parts], axis=0)
    return float((high - low).max()) / _TEXELS


def zoomed(eye: np.ndarray, target: np.ndarray, pixel: float) -> CameraModel:
    """A camera at `eye` whose pixels are `pixel` metres wide at `target`: a long lens."""
    half = 0.5 * PIXELS * pixel / np.linalg.norm(target - eye)
    return CameraModel(
        position=tuple(eye),
        look_at=tuple(target),
        vertical_fov_deg=float(np.degrees(2.0 * np.arctan(half))),
    )


def _scene(fixtures: Fixtures, camera: CameraModel, wi: np.ndarray) -> Scene:
    light = DirectionalModel(type="directional", direction=tuple(wi), irradiance=(1.0, 1.0, 1.0))
    model = AssetModel(path=fixtures.package, tier=fixtures.subject.tier)
    return Scene(assets=(model,), camera=camera, lights=(light,), resolution=(PIXELS, PIXELS))


def _cycles(worker: BlenderWorker, camera: CameraModel, wi: np.ndarray) -> dict[str, np.ndarray]:
    view = Camera(camera, (PIXELS, PIXELS))
    halves = [worker.render_view(view, wi, _CYCLES_SAMPLES, seed)[..., :3] for seed in (4, 5)]
    return {"halves": np.stack(halves)}


def _row(ours: np.ndarray, halves: np.ndarray, footprint: float) -> Row:
    reference = halves.mean(axis=0)
    texture = as_texture(reference, footprint)
    flat = [image.reshape(-1, 3) for image in (ours, *halves)]
    return {
        "flip": flip(ours, reference)[0],
        "texture_flip": flip(texture, reference)[0],
        "psnr": psnr_without_noise(*flat).db,
        "picture": _as_text(np.concatenate([ours, reference, texture], axis=1)),
    }


def as_texture(image: np.ndarray, texels: float) -> np.ndarray:
    """The image (n, n, 3) of a texture with so many texels a pixel; itself from one texel on."""
    n = len(image)
    count = max(1, round(n * texels))
    if count >= n:
        return image
    resample = Image.Resampling
    channels = [Image.fromarray(c) for c in np.moveaxis(image.astype(np.float32), 2, 0)]
    coarse = [c.resize((count, count), resample.BOX) for c in channels]
    return np.stack([np.asarray(c.resize((n, n), resample.BILINEAR)) for c in coarse], axis=2)


def _as_text(radiance: np.ndarray) -> str:
    """Half its size, as a PNG in base64."""
    file = io.BytesIO()
    Image.fromarray(to_png(radiance)[::2, ::2]).save(file, "PNG")
    return base64.b64encode(file.getvalue()).decode()


def _from_text(picture: str) -> np.ndarray:
    return np.asarray(Image.open(io.BytesIO(base64.b64decode(picture))))


def judge(rows: list[Row]) -> Verdict:
    finest = [row for row in rows if row["texels"] == min(FOOTPRINTS)]
    figures = ", ".join(f"{row['flip']:.3f} ({row['texture_flip']:.3f})" for row in finest)
    passed = all(row["flip"] <= max(FLIP, FACTOR * row["texture_flip"]) for row in finest)
    return Verdict(passed, f"FLIP (a texture's) at a tenth of a texel a pixel: {figures}")


def draw(figure: FigureBase, rows: list[Row]) -> None:
    left, right = figure.subplots(1, 2)
    for view in dict.fromkeys(values(rows, "view")):
        texels = values(rows, "texels", view=view)
        (line,) = left.plot(texels, values(rows, "flip", view=view), "o-", label=f"view {view + 1}")
        texture = values(rows, "texture_flip", view=view)
        left.plot(texels, texture, ":", color=line.get_color())
    left.plot([], [], "k:", label="a texture")
    left.axhline(FLIP, color="grey", linewidth=0.8)
    left.set_xscale("log")
    left.invert_xaxis()
    left.set_xlabel("texels a pixel")
    left.set_ylabel("FLIP against Cycles")
    left.legend()
    pairs = [_from_text(picture) for picture in values(rows, "picture", view=0)]
    right.imshow(_sheet(pairs))
    right.set_title("ours, Cycles, a texture; from the left down", fontsize="small")
    right.axis("off")


def _sheet(pairs: list[np.ndarray]) -> np.ndarray:
    """Two columns, filled downwards."""
    pairs = [*pairs, *[np.full_like(pairs[0], 255)] * (len(pairs) % 2)]
    half = len(pairs) // 2
    columns = [np.concatenate(part) for part in (pairs[:half], pairs[half:])]
    return np.concatenate([columns[0], np.full_like(columns[0][:, :4], 255), columns[1]], axis=1)


CASE = Case(
    name="zoom",
    title="Strong zoom",
    varies="a pixel's footprint, 10 texels down to a tenth",
    mark="at a tenth of a texel FLIP at most 0.1, or 1.5 times the FLIP of a texture as coarse",
    measure=measure,
    judge=judge,
    draw=draw,
    needs=("package", "source"),
)
