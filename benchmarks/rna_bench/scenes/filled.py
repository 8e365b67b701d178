"""The camera's distance at which the asset covers a given share of the picture."""

from dataclasses import replace

from rna_bench.scenes.beside_cycles import OurScene
from rna_bench.scenes.stage import Stage
from rna_sdk.errors import SceneError

_SIDE = 120  # pixels of the shorter side of trial pictures
_TRIES, _CLOSE = 8, 0.02
_SAMPLES = 4


def filled(stage: Stage, share: float) -> Stage:
    """The stage with a margin at which the asset alone covers that share of the picture, about.

    Raises SceneError for a share that is not between 0 and 1.
    """
    if not 0.0 < share < 1.0:
        raise SceneError(f"--share: expected a number between 0 and 1, found {share:g}")
    for _ in range(_TRIES):
        covered = _covered(stage)
        if abs(covered - share) < _CLOSE * share:
            break
        stage = replace(stage, margin=stage.margin * (covered / share) ** 0.5)
    return stage


def _covered(stage: Stage) -> float:
    """Share of the picture that the asset covers."""
    smaller = min(1.0, _SIDE / min(stage.resolution))
    width, height = (max(1, round(smaller * side)) for side in stage.resolution)
    small = replace(stage, resolution=(width, height))
    return float(OurScene(small.scene()).channels(_SAMPLES)["A"].mean())
