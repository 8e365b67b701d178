"""The images of one scene whose time counts: ours and Cycles', raw and denoised, by turns."""

from collections.abc import Sequence
from itertools import zip_longest

import numpy as np

from rna_bench.scenes.beside_cycles import CyclesScene, OurScene
from rna_export.compare.comparison_run import Timed
from rna_render import Denoiser
from rna_sdk.errors import SceneError
from rna_sdk.machine.cores import core_count

Arrays = dict[str, np.ndarray]

OURS, CYCLES, DENOISED = "ours", "cycles", "denoised"

_SECONDS = ".seconds"
_FIRST_SEED = 100  # of Cycles; the references have smaller ones


def find_denoiser() -> Denoiser | None:
    """Open Image Denoise on all cores, or None where it is not installed."""
    try:
        return Denoiser(core_count())
    except SceneError:
        return None


def label_of(who: str, samples: int, denoised: bool = False) -> str:
    """The name of an image among `render_by_turns`' arrays."""
    return f"{who}-{samples}" + (f"-{DENOISED}" if denoised else "")


def render_by_turns(
    ours: OurScene,
    cycles: CyclesScene,
    samples: Sequence[int],
    cycles_samples: Sequence[int],
    denoiser: Denoiser | None,
) -> Arrays:
    """RGB by `label_of`, and its seconds beside it: see `image_of`.

    Denoised ones count the render and the denoiser; without a denoiser of ours they are left out.
    """
    arrays: Arrays = {}

    def keep(label: str, image: Timed) -> None:
        arrays[label] = image.pixels.astype(np.float32)
        arrays[label + _SECONDS] = np.array([image.seconds])

    ours.render(1, denoiser=denoiser)  # compiles, and builds the denoiser's networks
    for n, m in zip_longest(samples, cycles_samples):
        if n is not None:
            keep(label_of(OURS, n), ours.render(n))
            if denoiser is not None:
                keep(label_of(OURS, n, True), ours.render(n, denoiser=denoiser))
        if m is not None:
            for denoise in (False, True):
                image = cycles.render(m, _FIRST_SEED + m, denoise)
                keep(label_of(CYCLES, m, denoise), image)
    return arrays


def image_of(arrays: Arrays, label: str) -> Timed | None:
    """One image of `render_by_turns`, if it is there."""
    if label not in arrays:
        return None
    return Timed(arrays[label], float(arrays[label + _SECONDS][0]))
