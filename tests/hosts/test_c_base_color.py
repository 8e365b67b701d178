"""Base colour and decoders of shadowed light in the C host; its reader of PNG."""

import subprocess
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from rna_sdk.package import BaseColor, Package
from rna_sdk.runtime import load
from tests.hosts.c_host import SOURCES, CAsset, compiler
from tests.hosts.test_c_host import run
from tests.package.prints import LABEL, image_bytes, make_images, make_print, tiers
from tests.package.test_base_color import png, saved
from tests.reference.base_color import base_color_reference

pytestmark = pytest.mark.skipif(compiler() is None, reason="needs cc and make")

OK, BAD_ARGUMENT = 0, 1


@pytest.fixture(scope="module")
def printed(tmp_path_factory):
    return make_print(tmp_path_factory.mktemp("print") / "print.rna")


def records_of(package: Path) -> list[BaseColor]:
    with Package.open(package) as opened:
        return opened.base_color()


def test_the_host_sets_images_and_they_are_looked_up(printed, library):
    records = records_of(printed)
    rng = np.random.default_rng(3)
    triangle = np.arange(200) % 4
    b1, b2 = rng.dirichlet((1, 1, 1), 200)[:, 1:].T
    level = np.where(triangle % 2 == 0, 0, rng.uniform(0, 4, 200))
    mesh = load(printed).mesh
    expected = base_color_reference(mesh, records, triangle, b1, b2, level)
    rows = list(zip(triangle.tolist(), b1, b2, level, strict=True))
    with closing(CAsset(library, printed, "small")) as asset:
        plain = asset.base_color(*rows[0])
        np.testing.assert_allclose(plain, records[0].factor, atol=1e-7)  # white until it is set
        for k, record in enumerate(records):
            if record.image is None:
                assert asset.set_image(k, np.zeros((1, 1, 3), np.uint8)) == BAD_ARGUMENT
            else:
                assert asset.set_image(k, record.image) == OK
        assert asset.set_image(3, np.zeros((1, 1, 3), np.uint8)) == BAD_ARGUMENT
        actual = np.array([asset.base_color(*row) for row in rows])
        assert (asset.base_color(99, 0.2, 0.3, 0) == 1).all()
        np.testing.assert_array_equal(
            asset.base_color(0, 0.2, 0.3, np.nan), asset.base_color(0, 0.2, 0.3, 0)
        )
    np.testing.assert_allclose(actual, expected, atol=0.005)
    np.testing.assert_allclose(actual[level == 0], expected[level == 0], atol=1e-6)


def test_the_record_has_the_file_and_its_size(printed, library):
    label = make_images()[LABEL]
    with closing(CAsset(library, printed, "small")) as asset:
        assert asset.record.base_color_count == 3
        first, second, third = asset.record.base_colors[:3]
        assert bytes(first.file[: first.file_size]) == label
        assert (first.width, first.height) == (4, 3) and first.is_srgb and not second.is_srgb
        assert (second.width, second.height) == (1, 1)  # a JPEG
        assert not third.file and list(third.factor) == [0.2, 0.3, 0.4]
        assert list(first.wrap) == [2, 1] and list(third.wrap) == [0, 0]
        matrix = np.reshape(first.transform, (2, 3))[:, :2]
        mesh = load(printed).mesh
        corners = mesh.triangles[0]
        e1, e2 = (mesh.positions[corners[k]] - mesh.positions[corners[0]] for k in (1, 2))
        d1, d2 = (matrix @ (mesh.uvs[corners[k]] - mesh.uvs[corners[0]]) for k in (1, 2))
        texels = abs(d1[0] * d2[1] - d1[1] * d2[0]) * 12
        density = np.sqrt(texels / np.linalg.norm(np.cross(e1, e2)))
        assert asset.texel_density(0) == pytest.approx(density, rel=1e-5)
        assert asset.texel_density(3) == asset.texel_density(99) == 0


PROBE = """
#include "png.h"
#include <stdio.h>
#include <stdlib.h>
int main(int argc, char **argv) {
    static unsigned char file[1 << 20];
    const size_t size = fread(file, 1, sizeof file, stdin);
    const unsigned width = (unsigned)atoi(argv[1]), height = (unsigned)atoi(argv[argc - 1]);
    unsigned char *rgb = png_pixels(file, size, width, height);
    if (rgb) fwrite(rgb, 3 * width, height, stdout);
    const int status = rgb == NULL;
    free(rgb);
    return status;
}
"""


@pytest.fixture(scope="module")
def png_reader(tmp_path_factory):
    """A program that writes the pixels of a PNG; under sanitizers."""
    folder = tmp_path_factory.mktemp("png")
    (folder / "probe.c").write_text(PROBE)
    flags = ["-std=c11", "-g", "-O0", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"]
    sources = [folder / "probe.c", SOURCES / "png.c", SOURCES / "rna.c"]
    command = ["cc", *flags, f"-I{SOURCES}", *map(str, sources), "-o", str(folder / "probe"), "-lm"]
    if subprocess.run(command, capture_output=True).returncode:
        pytest.skip("the C compiler has no AddressSanitizer")
    return folder / "probe"


def read_png(program: Path, data: bytes, width: int, height: int) -> tuple[int, bytes]:
    command = [program, str(width), str(height)]
    done = subprocess.run(command, input=data, capture_output=True)
    assert done.stderr == b"", done.stderr
    return done.returncode, done.stdout


def test_the_programs_read_png(png_reader):
    rng = np.random.default_rng(2)
    noise = rng.integers(0, 256, (9, 31, 3)).astype(np.uint8)
    smooth = np.cumsum(np.ones((40, 50, 3), np.uint8) * (1, 2, 5), axis=1).astype(np.uint8)
    few = Image.fromarray(noise // 128 * 200).quantize(8)
    wide = rng.integers(0, 2**16, (5, 7, 4))
    for data, pixels in (
        *((image_bytes(noise, compress_level=level), noise) for level in (0, 1, 9)),
        (image_bytes(smooth), smooth),
        (image_bytes(noise[:, :, 0]), noise[:, :, :1].repeat(3, axis=2)),
        (image_bytes(np.dstack([noise, noise[:, :, 0]])), noise),
        (saved(few), np.array(few.convert("RGB"))),
        (png(wide, 6, 16), (wide >> 8)[:, :, :3].astype(np.uint8)),
        (saved(Image.fromarray(smooth[:, :, 2] > 99)), (smooth[:, :, 2:] > 99).repeat(3, 2) * 255),
    ):
        height, width = pixels.shape[:2]
        status, decoded = read_png(png_reader, data, width, height)
        assert status == 0
        np.testing.assert_array_equal(
            np.frombuffer(decoded, np.uint8).reshape(pixels.shape), pixels.astype(np.uint8)
        )
        assert read_png(png_reader, data, width + 1, height)[0] == 1


def test_damaged_png_harms_no_program(png_reader):
    rng = np.random.default_rng(4)
    noise = rng.integers(0, 40, (12, 17, 3)).astype(np.uint8)
    good, refused = image_bytes(noise), 0
    for _ in range(60):
        data = bytearray(good)
        for at in rng.integers(33, len(data), 2):
            data[at] = rng.integers(256)
        refused += read_png(
            png_reader, bytes(data[: rng.integers(len(data) - 20, len(data))]), 17, 12
        )[0]
    assert refused > 10


def test_the_renderer_shows_the_print(programs, tmp_path):
    """JPEG stays white, with a line that says so; the label is in the picture."""
    pictures = {}
    for name, uses in (("print", True), ("plain", None)):
        path = make_print(tmp_path / f"{name}.rna", tiers=tiers(uses))
        picture = tmp_path / f"{name}.ppm"
        done = run(programs["render"], path, picture, "--size", "48", "32", "--samples", "1")
        assert done.returncode == 0
        assert "image 1 of part 0 cannot be decoded" in done.stderr
        pictures[name] = np.array(Image.open(picture)).astype(int)
    assert np.abs(pictures["print"] - pictures["plain"]).max() > 10
