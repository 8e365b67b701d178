"""Images as environments: where texels are, how directions are chosen, and what they bring."""

import numpy as np
import pytest

from rna_render.image.images import write_exr
from rna_render.lights.equirectangular import EquirectangularImage
from rna_render.lights.files.environment_file import read_environment
from rna_render.lights.intervals import find_interval, interval_near
from tests.render.chi_squared import assert_directions_follow
from tests.render.lights import light

LUMINANCE = np.array([0.2126, 0.7152, 0.0722])


def grey(values: np.ndarray) -> np.ndarray:
    return np.repeat(np.asarray(values, np.float32)[:, :, None], 3, axis=2)


def one_texel(row: int, column: int, height: int = 9, width: int = 16) -> np.ndarray:
    values = np.zeros((height, width))
    values[row, column] = 1.0
    return grey(values)


def squares(n: int) -> np.ndarray:
    return np.random.default_rng(7).random((n, 2))


# Texel of a 9 x 17 image (at the poles a whole row), degrees that the image is turned, and where
# the texel is then.
CONVENTION = {
    "the middle is -z": (4, 8, 0, (0, 0, -1)),
    "the right half is towards +x": (4, 12, 0, (1, 0, -0.1)),
    "the left half is towards -x": (4, 4, 0, (-1, 0, -0.1)),
    "the upper edge is +y": (0, 3, 0, (0, 1, 0)),
    "the lower edge is -y": (8, 3, 0, (0, -1, 0)),
    "a quarter turn takes the middle to -x": (4, 8, 90, (-1, 0, 0)),
    "a quarter turn the other way to +x": (4, 8, -90, (1, 0, 0)),
    "half a turn to +z": (4, 8, 180, (0, 0, 1)),
}


@pytest.mark.parametrize("name", CONVENTION)
def test_where_a_texel_is_seen(name, tmp_path):
    row, column, turn, direction = CONVENTION[name]
    path = tmp_path / "one.exr"
    values = np.zeros((9, 17), np.float32)
    values[row, column if 0 < row < 8 else slice(None)] = 1.0
    write_exr(path, dict.fromkeys("RGB", values), {})
    sky = light("environment", path=path, rotation_deg=turn)
    d = np.float32([direction]) / np.float32(np.linalg.norm(direction))
    assert sky.eval_environment(d)[0][0] == pytest.approx([1, 1, 1], abs=0.15)
    assert (sky.eval_environment(-d)[0] == 0).all()
    drawn = sky.sample(np.zeros((4096, 3), np.float32), squares(4096))
    assert np.mean(drawn.wi_world @ d[0]) > 0.94


def test_the_lookup_is_bilinear_and_goes_around_the_seam():
    rng = np.random.default_rng(8)
    texels = rng.random((6, 10, 3)).astype(np.float32)
    image = EquirectangularImage(texels)

    def looked_up(s: float, t: float) -> np.ndarray:
        phi, theta = 2 * np.pi * (s - 0.5), np.pi * t
        d = [np.sin(theta) * np.sin(phi), np.cos(theta), -np.sin(theta) * np.cos(phi)]
        return image.lookup(np.float32([d]))[0][0]

    def expected(*parts: tuple[float, int, int]) -> object:
        value = sum(weight * texels[row, column] for weight, row, column in parts)
        return pytest.approx(value, abs=1e-5)

    assert looked_up(0.35, 2.5 / 6) == expected((1, 2, 3))
    assert looked_up(0.40, 2.5 / 6) == expected((0.5, 2, 3), (0.5, 2, 4))
    assert looked_up(0.375, 2.75 / 6) == expected(
        (0.5625, 2, 3), (0.1875, 2, 4), (0.1875, 3, 3), (0.0625, 3, 4)
    )
    assert looked_up(0.98, 2.5 / 6) == expected((0.7, 2, 9), (0.3, 2, 0))
    assert looked_up(0.02, 2.5 / 6) == expected((0.3, 2, 9), (0.7, 2, 0))
    assert looked_up(0.35, 0.01) == expected((1, 0, 3))
    assert looked_up(0.35, 0.99) == expected((1, 5, 3))


def random_image() -> np.ndarray:
    """Five orders of magnitude, and black places."""
    values = 10 ** np.random.default_rng(9).uniform(-3, 2, (8, 12, 3))
    values[3:5, 2:6] = 0
    return values.astype(np.float32)


IMAGES = {
    "one colour": np.full((5, 8, 3), 0.3, np.float32),
    "smooth": grey(2 + np.sin(np.linspace(0, 6, 20))[:, None] * np.cos(np.linspace(0, 5, 30))),
    "random": random_image(),
    "one texel": one_texel(3, 5),
    "one texel at the seam": one_texel(4, 0),
    "one texel at the pole": one_texel(0, 5),
    "one row": one_texel(0, 3, 1, 5),
    "one column": one_texel(2, 0, 5, 1),
}


@pytest.mark.parametrize("turn", [0.0, 1.1])
@pytest.mark.parametrize("name", IMAGES)
def test_directions_follow_the_density(name, turn):
    image = EquirectangularImage(IMAGES[name], turn)
    d, radiance, pdf = image.sample(squares(200_000))
    assert_directions_follow(d, lambda d: image.lookup(d)[1], (0, 1, 0), np.pi, 0.01)
    # A sample knows its place in the image; a lookup has it from a direction rounded to float32.
    looked_up = image.lookup(d)
    np.testing.assert_allclose(looked_up[0], radiance, rtol=1e-3, atol=1e-5 * radiance.max())
    np.testing.assert_allclose(looked_up[1], pdf, rtol=1e-3, atol=1e-5 * pdf.max())


@pytest.mark.parametrize("name", ["smooth", "random", "one texel", "one row"])
def test_mis_compensated_directions_follow_the_density(name):
    """And none goes to where the mean of a cell is below half of that of the image."""
    image = EquirectangularImage(IMAGES[name])
    beside = image.compensated().turned(0.7)
    d, radiance, pdf = beside.sample(squares(200_000))
    assert_directions_follow(d, lambda d: beside.lookup(d)[1], (0, 1, 0), np.pi, 0.01)
    looked_up = beside.lookup(d)
    np.testing.assert_allclose(looked_up[0], radiance, rtol=1e-3, atol=1e-5 * radiance.max())
    np.testing.assert_allclose(looked_up[1], pdf, rtol=2e-3, atol=1e-4 * pdf.max())
    np.testing.assert_array_equal(looked_up[0], image.turned(0.7).lookup(d)[0])
    everywhere = squares(10_000) @ [[2, 0], [0, 2]] - 1
    z, turn = everywhere[:, 0], np.pi * everywhere[:, 1]
    side = np.sqrt(1 - z * z)
    d = np.stack([side * np.cos(turn), z, side * np.sin(turn)], 1).astype(np.float32)
    dim = image.lookup(d)[0] @ LUMINANCE < 0.1 * image.total / (4 * np.pi)
    assert not dim.any() or (image.compensated().lookup(d[dim])[1] == 0).mean() > 0.5


def test_intervals_are_found_from_wherever_the_search_starts():
    cumulative = np.array([0.0, 0.0, 1.0, 1.0, 1.0, 4.0, 4.5, 4.5])
    for value, interval in ((0.0, 1), (0.99, 1), (1.0, 4), (3.9, 4), (4.0, 5), (4.4, 5)):
        assert find_interval(cumulative, value) == interval
        for near in range(7):
            assert interval_near(cumulative, near, value) == interval


@pytest.mark.parametrize("name", IMAGES)
def test_the_density_follows_what_is_looked_up(name):
    """Luminance over density is constant, except for the sine within a row of cells."""
    d, radiance, pdf = EquirectangularImage(IMAGES[name]).sample(squares(10_000))
    ratio = (radiance @ LUMINANCE) / pdf
    assert (pdf > 0).all()
    height = len(IMAGES[name])
    inner = np.abs(d[:, 1]) < np.cos(np.pi * 1.5 / height)
    assert not inner.any() or np.std(ratio[inner]) < 0.2 * np.mean(ratio)
    # Within a cell the total leaves out how the sine changes: much, in images of a few rows.
    assert np.mean(ratio) == pytest.approx(EquirectangularImage(IMAGES[name]).total, rel=0.15)


def test_a_dim_sky_beside_a_bright_sun_is_sampled_too():
    """Eight orders of magnitude within a row: sums of float32 would lose the sky."""
    values = np.full((64, 128), 1.0)
    values[20, 40] = 1e8
    image = EquirectangularImage(grey(values))
    # The end of the row with the sun: 87 cells of sky, 1.74e-6 of the row.
    u = np.stack([1 - 1.74e-6 * np.random.default_rng(1).random(4096), np.full(4096, 0.3)], axis=1)
    d, _, _ = image.sample(u)
    cell = np.floor((0.5 + np.arctan2(d[:, 0], -d[:, 2]) / (2 * np.pi)) * 128 - 0.5).astype(int)
    counts = np.bincount(cell % 128, minlength=128)
    assert (counts[42:127] > 20).all() and counts[1:41].sum() == 0


def test_a_black_image_gives_nothing():
    image = EquirectangularImage(np.zeros((4, 8, 3), np.float32))
    d, radiance, pdf = image.sample(squares(100))
    assert image.total == 0 and (radiance == 0).all() and (pdf == 0).all()
    np.testing.assert_allclose(np.linalg.norm(d, axis=1), 1, atol=1e-6)


def test_directions_at_the_poles_and_broken_ones_are_survived():
    image = EquirectangularImage(IMAGES["random"])
    broken = np.float32([[0, 1, 0], [0, -1, 0], [-0.0, 1, 0.0], [0, 0, 1], [-0.0, 0, 1], [0, 0, 0]])
    radiance, pdf = image.lookup(broken)
    assert np.isfinite(radiance).all() and np.isfinite(pdf).all()
    image.lookup(np.float32([[np.nan, 0, 1], [np.inf, 0, 0]]))
    edges = np.array([[0, 0], [1 - 2**-32, 1 - 2**-32], [0, 1 - 2**-32], [1 - 2**-32, 0]])
    d, radiance, pdf = image.sample(edges)
    assert np.isfinite(d).all() and np.isfinite(pdf).all()


@pytest.mark.data
@pytest.mark.parametrize("name", ["forest", "studio"])
def test_a_real_environment(name, data_folder):
    path = data_folder / "hdri" / f"{name}.hdr"
    texels = read_environment(path)
    assert texels.shape == (512, 1024, 3)
    sky = light("environment", path=path, rotation_deg=30)
    n = 1 << 17
    drawn = sky.sample(np.zeros((n, 3), np.float32), squares(n))
    up = np.maximum(drawn.wi_world[:, 1], 0) / drawn.pdf
    got = np.mean(drawn.radiance * up[:, None], axis=0)
    theta = (np.arange(512) + 0.5) / 512 * np.pi
    ring = np.sin(theta) * np.maximum(np.cos(theta), 0) * 2 * np.pi**2 / 512
    np.testing.assert_allclose(got, ring @ texels.mean(axis=1, dtype=np.float64), rtol=0.01)
    axis = (0.0, 1.0, 0.0)
    assert_directions_follow(
        drawn.wi_world, lambda d: sky.eval_environment(d)[1], axis, np.pi, 0.05
    )
