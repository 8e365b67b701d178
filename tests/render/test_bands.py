"""How an image is cut into bands, and which samples are rendered together."""

import numpy as np
import pytest

from rna_render.image.film import Layers
from rna_render.paths.bands import render
from rna_render.paths.sampling import Sampler
from rna_render.scene import Scene


class Several:
    """Renders up to 16 samples at once of up to 30 pixels; each sample has its number as red."""

    groups, at_once, band = (), 1, 30

    def __init__(self, samples: int = 16) -> None:
        self.samples = samples
        self.seen: list[tuple[int, int, int]] = []

    def render(self, pixels: np.ndarray, sampler: Sampler) -> Layers:
        self.seen.append((len(pixels), sampler.sample, sampler.count))
        layers = Layers.empty(len(pixels), 0, np.float32)
        for number in range(sampler.sample, sampler.sample + sampler.count):
            layers.beauty[:, 0] += number
            layers.squares[:, 0] += number**2
        return layers


def scene(samples: int) -> Scene:
    camera = {"position": [0, 0, 1], "look_at": [0, 0, 0], "vertical_fov_deg": 40}
    size = {"resolution": [12, 5], "samples": samples}
    return Scene.model_validate({"camera": camera, "ground": {}, **size})


def test_ever_more_samples_are_rendered_together():
    several, pixels = Several(), []
    films: list[int] = []
    film = render(
        scene(40),
        several,
        progress=pixels.append,
        on_sample=lambda film: films.append(film.samples),
    )
    counts = [(0, 1), (1, 3), (4, 12), (16, 16), (32, 8)]
    assert several.seen == [(30, *group) for group in counts for _ in range(2)]
    assert film.samples == 40 and films == [1, 4, 16, 32] and sum(pixels) == 60 * 40
    channels = film.channels()
    np.testing.assert_allclose(channels["R"], 19.5)
    np.testing.assert_allclose(channels["variance.R"], np.var(np.arange(40)) / 39, rtol=1e-6)


@pytest.mark.parametrize("samples", [1, 16])
def test_a_sum_is_that_of_samples_one_by_one(samples):
    film = render(scene(21), Several(samples))
    np.testing.assert_array_equal(film.channels()["R"], np.float32(10))


def test_a_stop_drops_the_samples_under_way():
    several = Several()
    film = render(scene(40), several, stop=lambda: len(several.seen) >= 4)
    assert film.samples in (1, 4)
    np.testing.assert_allclose(film.channels()["R"], np.arange(film.samples).mean())
