"""The outcome of a bake: errors by material, of highlights, of outlines, beside the promises."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from rna_export.asset_flip import AssetFlip, asset_flip, without_noise
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.validation_view import CapturedImage
from rna_export.capture.preflight.verdicts import MaterialVerdict, share_text
from rna_export.outcome.judged_image import JudgedImage, judged_images
from rna_export.outcome.triangle_materials import TriangleMaterials
from rna_export.outcome.worst_place import WorstPlace
from rna_render.lights import LUMINANCE
from rna_sdk.commands.error_words import FAIR, GOOD, error_in_words

_BRIGHTEST = 0.01  # of the pixels
_FEWEST = 50  # pixels of all images that tell the error of a material
_SHOWS = 12  # pixels of one image that show a material
_LOST, _LOST_SHARE = 0.35, 0.25  # FLIP around a pixel; of a material's pixels in one image
_AROUND = 3 / 64  # of an image's side
_LISTED = 8  # materials


@dataclass(frozen=True)
class MaterialOutcome:
    """A material, or a part, in the lit images.

    share: of the asset's pixels. flip: of its own, without noise; None of too few. shown, lost:
    images that show it, and those of them where a quarter of it or more is not to be recognised.
    promise: of the pre-flight; None where it promised nothing.
    """

    name: str
    share: float
    flip: float | None
    shown: int
    lost: int
    promise: MaterialVerdict | None

    def told(self, is_sketch: bool = False) -> str:
        """In words, beside the promise, of which a sketch cannot fall short."""
        promised = "" if self.promise is None else f", promised: {self.promise.promise}"
        first = f"  {self.name!r} ({share_text(self.share)} of the pixels){promised}: "
        if self.flip is None:
            return f"{first}too little is seen of it to tell"
        lost = f"; lost in {self.lost} of {self.shown} images that show it" if self.lost else ""
        word, _, _ = error_in_words(self.flip).partition(":")
        compared = ""
        if self.promise is not None and self.promise.learnt != "well" and self.flip < GOOD:
            compared = ", better than promised"
        elif self.promise is not None and self.promise.learnt == "well" and self.flip >= FAIR:
            compared = "" if is_sketch else ", worse than promised"
        return f"{first}FLIP {self.flip:.3f} ({word}){compared}{lost}"


@dataclass(frozen=True)
class Outcome:
    """The findings of an asset's lit images.

    error: of them together. materials: the worst first. brightest: light of the brightest 1% of the
    pixels over Cycles'. outline, outline_light, outline_share: FLIP of the outlines' pixels, their
    light over Cycles', and how many they are of all; None without any. worst: None of no image.
    """

    error: AssetFlip
    materials: tuple[MaterialOutcome, ...]
    brightest: float | None
    outline: float | None
    outline_light: float | None
    outline_share: float
    worst: WorstPlace | None

    @classmethod
    def of(
        cls, radiance: Sequence[np.ndarray], views: Sequence[CapturedImage], dataset: Dataset
    ) -> "Outcome":
        """The outcome of validation images. radiance: shaded rows of the views, (n, 3) each."""
        materials = TriangleMaterials(dataset)
        images = judged_images(radiance, views, materials)
        told = _by_material(images, materials, dataset.manifest.materials)
        is_of_strands = all(view.is_of_strands for view in views)
        unlit = len(views) - len(images)
        return cls.of_images(images, is_of_strands, told, materials.names, unlit)

    @classmethod
    def of_images(
        cls,
        images: Sequence[JudgedImage],
        is_of_strands: bool,
        materials: tuple[MaterialOutcome, ...] = (),
        names: Sequence[str] = (),
        unlit: int = 0,
    ) -> "Outcome":
        """is_of_strands: whether all that they show is strands. names: of materials, by number.

        unlit: how many further images are without light.
        """
        outline = _joined(images, lambda image: image.outline).astype(bool)
        light = _joined(images, lambda image: image.ours @ LUMINANCE)
        first = _joined(images, lambda image: image.halves[0] @ LUMINANCE)
        second = _joined(images, lambda image: image.halves[1] @ LUMINANCE)
        halves = np.stack([first, second])
        has_outline = outline.any() and not is_of_strands  # of strands all is outline
        return cls(
            error=asset_flip([image.flip for image in images], unlit),
            materials=materials,
            brightest=_of_brightest(light, halves),
            outline=_flip_of(images, outline) if has_outline else None,
            outline_light=_ratio(light[outline], halves.mean(axis=0)[outline]),
            outline_share=float(outline.mean()) if len(outline) else 0.0,
            worst=WorstPlace.of(images, names),
        )

    def told(
        self, picture: Path, what: str = "validation images", is_sketch: bool = False
    ) -> list[str]:
        """In words; writes a PNG of the worst place.

        what: what the images are. is_sketch: whether little was done for the model yet.
        """
        if self.worst is None:
            return []
        told, more = self.materials[:_LISTED], self.materials[_LISTED:]
        came_true = f"what came true{' so far' if is_sketch else ''}, " if self.materials else ""
        lines = [f"{came_true}in {self.error.images} lit {what}:"]
        lines += [each.told(is_sketch) for each in told]
        if more:
            worst = max((each.flip for each in more if each.flip is not None), default=0.0)
            lines.append(f"  {len(more)} more materials: FLIP {worst:.3f} or less")
        if self.brightest is not None:
            lines.append(
                f"  highlights: the brightest 1% has {self.brightest:.0%} of Cycles' light"
            )
        if self.outline is not None and self.outline_light is not None:
            lines.append(
                f"  outlines ({share_text(self.outline_share)} of the pixels): "
                f"FLIP {self.outline:.3f}, {self.outline_light:.0%} of Cycles' light"
            )
        self.worst.write(picture)
        return [*lines, f"  {self.worst.text}: {picture} shows it beside Cycles"]


def _by_material(
    images: Sequence[JudgedImage],
    materials: TriangleMaterials,
    promises: Sequence[MaterialVerdict],
) -> tuple[MaterialOutcome, ...]:
    """The worst first; none where all there is to tell of is one part."""
    of_pixels = _joined(images, lambda image: image.material)
    lost = [image.nearby_error(_AROUND) >= _LOST for image in images]
    numbers = [int(k) for k in np.unique(of_pixels) if k >= 0]
    if len(numbers) == 1 and materials.is_part(numbers[0]):
        return ()
    result = []
    for number in numbers:
        on = of_pixels == number
        counts = [
            (i.material == number, of_image) for i, of_image in zip(images, lost, strict=True)
        ]
        shows = [(there, gone) for there, gone in counts if there.sum() >= _SHOWS]
        result.append(
            MaterialOutcome(
                name=materials.names[number],
                share=float(on.mean()),
                flip=_flip_of(images, on) if on.sum() >= _FEWEST else None,
                shown=len(shows),
                lost=sum(float(gone[there].mean()) >= _LOST_SHARE for there, gone in shows),
                promise=None if materials.is_part(number) else promises[number],
            )
        )
    return tuple(sorted(result, key=lambda each: -1.0 if each.flip is None else -each.flip - 1.0))


def _joined(images: Sequence[JudgedImage], of: Callable[[JudgedImage], np.ndarray]) -> np.ndarray:
    """Values of a map at the asset's pixels, of all images one after the other, (..., n)."""
    return np.concatenate([np.zeros(0), *(of(image)[image.asset] for image in images)])


def _flip_of(images: Sequence[JudgedImage], rows: np.ndarray) -> float:
    """FLIP without noise of some of all images' pixels, (n,) bool."""
    errors = _joined(images, lambda image: image.errors)[rows].mean()
    noisier = _joined(images, lambda image: image.noisier.mean(axis=0))[rows].mean()
    return float(without_noise(errors, noisier))


def _of_brightest(ours: np.ndarray, halves: np.ndarray) -> float | None:
    """Light of the pixels that are the brightest in one reference, over the other's light.

    The noise by which a pixel comes to be among the brightest is not in the other one.
    """
    count = max(1, round(_BRIGHTEST * len(ours)))
    sums = np.zeros(2)
    for chosen, other in ((0, 1), (1, 0)):
        rows = np.argsort(halves[chosen])[-count:]
        sums += ours[rows].sum(), halves[other][rows].sum()
    return float(sums[0] / sums[1]) if sums[1] > 0.0 else None


def _ratio(ours: np.ndarray, cycles: np.ndarray) -> float | None:
    return float(ours.sum() / cycles.sum()) if cycles.sum() > 0.0 else None
