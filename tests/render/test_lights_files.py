"""Images of environments: read files and refused files."""

import struct
from pathlib import Path

import numpy as np
import pytest

from rna_render.image.images import write_exr
from rna_render.lights.files.environment_file import read_environment
from rna_sdk.errors import SceneError

HEADER = b"#?RADIANCE\n# a comment\nFORMAT=32-bit_rle_rgbe\n%s\n-Y %d +X %d\n"


def hdr(path: Path, pixels: bytes, height: int, width: int, more: bytes = b"") -> Path:
    path.write_bytes(HEADER % (more, height, width) + pixels)
    return path


def values(rgbe: np.ndarray) -> np.ndarray:
    step = np.where(rgbe[..., 3:] > 0, 2.0 ** (rgbe[..., 3:].astype(float) - 136), 0)
    return (rgbe[..., :3] * step).astype(np.float32)


def random_rgbe(height: int, width: int) -> np.ndarray:
    rgbe = np.random.default_rng(1).integers(0, 256, (height, width, 4), np.uint8)
    rgbe[..., 3] = np.where(rgbe[..., 3] < 90, 0, rgbe[..., 3] % 30 + 115)
    rgbe[..., 0] |= 128  # no pixel looks like one of the older code's repetitions
    return rgbe


def new_code(rgbe: np.ndarray) -> bytes:
    """Each component of a line as runs of equal bytes where there are any, else as dumps."""
    out = b""
    for line in rgbe:
        out += struct.pack(">BBH", 2, 2, len(line))
        for component in line.T:
            x = 0
            while x < len(component):
                run = 1
                while x + run < len(component) and run < 127 and component[x + run] == component[x]:
                    run += 1
                if run > 1:
                    out += bytes([128 + run, component[x]])
                else:
                    out += bytes([1, component[x]])
                x += run
    return out


def test_flat_pixels(tmp_path):
    rgbe = random_rgbe(3, 5)
    read = read_environment(hdr(tmp_path / "flat.hdr", rgbe.tobytes(), 3, 5))
    np.testing.assert_array_equal(read, values(rgbe))
    assert read.dtype == np.float32


def test_the_newer_code(tmp_path):
    rgbe = random_rgbe(4, 300)
    rgbe[1, 50:290] = rgbe[1, 50]
    rgbe[2] = (1, 2, 3, 130)
    read = read_environment(hdr(tmp_path / "new.hdr", new_code(rgbe), 4, 300))
    np.testing.assert_array_equal(read, values(rgbe))
    dump = b"".join(
        struct.pack(">BBH", 2, 2, 40) + b"".join(b"\x28" + c.tobytes() for c in line.T)
        for line in rgbe[:, :40]
    )
    read = read_environment(hdr(tmp_path / "dump.hdr", dump, 4, 40))
    np.testing.assert_array_equal(read, values(rgbe[:, :40]))


def test_the_older_code(tmp_path):
    """Repetitions of 3, and of 2 + (1 << 8) pixels."""
    first, second = bytes([200, 10, 20, 130]), bytes([130, 20, 40, 128])
    pixels = first + bytes([1, 1, 1, 3]) + second + bytes([1, 1, 1, 2]) + bytes([1, 1, 1, 1])
    read = read_environment(hdr(tmp_path / "old.hdr", pixels, 1, 5 + 2 + 256))
    expected = [list(first)] * 4 + [list(second)] * (1 + 2 + 256)
    np.testing.assert_array_equal(read, values(np.uint8([expected])))


def test_known_values_and_exposure(tmp_path):
    """128 with exponent 129 is 1; an image that was made twice as bright is divided by 2."""
    pixel = bytes([128, 64, 32, 129])
    read = read_environment(hdr(tmp_path / "one.hdr", pixel, 1, 1))
    assert read.tolist() == [[[1.0, 0.5, 0.25]]]
    more = b"EXPOSURE=4\nEXPOSURE= 0.5\n"
    read = read_environment(hdr(tmp_path / "exposed.hdr", pixel, 1, 1, more))
    assert read.tolist() == [[[0.5, 0.25, 0.125]]]


LINE = struct.pack(">BBH", 2, 2, 8)
GOOD = LINE + bytes([136, 128, 136, 64, 136, 32, 136, 129])
BAD = {
    "nothing but a header": (b"", 1, 8, "line 0: the file ends"),
    "half a pixel": (b"\x80\x80", 1, 2, "line 0: the file ends"),
    "a line is missing": (GOOD, 2, 8, "line 1: the file ends"),
    "a run ends with the file": (GOOD[:-1], 1, 8, "line 0: the file ends"),
    "a dump ends with the file": (GOOD[:-2] + bytes([8, 1, 2]), 1, 8, "line 0: the file ends"),
    "a run is too long": (LINE + bytes([137, 128]) + GOOD, 1, 8, "past the line's end"),
    "a dump is too long": (LINE + bytes([9]) + GOOD, 1, 8, "past the line's end"),
    "another width in the line": (struct.pack(">BBH", 2, 2, 9) + GOOD[4:], 1, 8, "past the line"),
    "a run of nothing": (LINE + bytes([0, 0, 0, 0]), 1, 8, "a run of no pixels"),
    "a repetition at the start": (bytes([1, 1, 1, 2]), 1, 3, "there is none before it"),
    "a repetition too long": (bytes([9, 9, 9, 9, 1, 1, 1, 3]), 1, 3, "past the line's end"),
    "shifts without end": (bytes([9] * 4 + [1, 1, 1, 0] * 40), 1, 3, "past the line's end"),
    "no pixels": (b"", 0, 8, "has 8 x 0 pixels"),
    "too wide": (b"", 1, 32769, "from 1 to 32768 a side"),
    "too many": (b"", 32768, 32768, "2^27 in all"),
}


@pytest.mark.parametrize("name", BAD)
def test_a_broken_picture_is_refused(name, tmp_path):
    pixels, height, width, message = BAD[name]
    path = hdr(tmp_path / "bad.hdr", pixels, height, width)
    with pytest.raises(SceneError, match=r"bad\.hdr: (broken HDR image|has)") as caught:
        read_environment(path)
    assert message in str(caught.value)


BAD_HEADERS = {
    b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n": "no header",
    b"#?RADIANCE\n\n": "no header",
    b"#?RADIANCE\n" + b"A=1\n" * 30_000 + b"\n-Y 1 +X 1\n": "no header",
    b"#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\nabcd": "32-bit_rle_xyze",
    b"#?RADIANCE\n\n+X 1 -X 1\nabcd": "expected such as '-Y height +X width'",
    b"#?RADIANCE\n\n-Y -1 +X 1\nabcd": "expected such as '-Y height +X width'",
    b"#?RADIANCE\n\n-Y 99999999999999999999 +X 1\nabcd": "expected such as '-Y height +X width'",
    b"#?RADIANCE\nEXPOSURE=-1\n\n-Y 1 +X 1\nabcd": "EXPOSURE",
    b"#?RADIANCE\nEXPOSURE=nan\n\n-Y 1 +X 1\nabcd": "EXPOSURE",
    b"#?RADIANCE\nEXPOSURE=bright\n\n-Y 1 +X 1\nabcd": "EXPOSURE",
}


@pytest.mark.parametrize("header", BAD_HEADERS)
def test_a_broken_header_is_refused(header, tmp_path):
    path = tmp_path / "bad.hdr"
    path.write_bytes(header)
    with pytest.raises(SceneError, match=r"bad\.hdr: broken HDR image") as caught:
        read_environment(path)
    assert BAD_HEADERS[header] in str(caught.value)


def test_random_bytes_never_do_more_than_raise(tmp_path):
    """A good picture with bytes changed at random is read or refused."""
    rgbe = random_rgbe(6, 40)
    rgbe[:, 10:30] = rgbe[:, 10:11]
    good = HEADER % (b"", 6, 40) + new_code(rgbe)
    rng = np.random.default_rng(2)
    for _ in range(300):
        broken = bytearray(good)
        for at in rng.integers(0, len(good), 3):
            broken[at] = rng.integers(0, 256)
        path = tmp_path / "broken.hdr"
        path.write_bytes(broken[: rng.integers(20, len(good) + 1)])
        try:
            assert np.isfinite(read_environment(path)).all()
        except SceneError as error:
            assert "broken.hdr" in str(error)


def planes(**channels: float) -> dict[str, np.ndarray]:
    return {name: np.full((2, 4), value, np.float32) for name, value in channels.items()}


def test_an_exr(tmp_path):
    path = tmp_path / "sky.exr"
    channels = planes(R=1, G=2, B=3, A=1)
    channels["G"][1, 2] = 7
    write_exr(path, channels, {})
    read = read_environment(path)
    assert read.shape == (2, 4, 3) and read.dtype == np.float32
    assert read[0, 0].tolist() == [1, 2, 3] and read[1, 2].tolist() == [1, 7, 3]


def test_negative_values_are_nothing_and_others_stay(tmp_path):
    write_exr(tmp_path / "filtered.exr", planes(R=-0.1, G=2, B=3), {})
    assert read_environment(tmp_path / "filtered.exr")[0, 0].tolist() == [0, 2, 3]


def test_what_is_no_image_is_refused(tmp_path):
    with pytest.raises(SceneError, match=r"none\.hdr: cannot read the image: No such file"):
        read_environment(tmp_path / "none.hdr")
    with pytest.raises(SceneError, match="cannot read the image"):
        read_environment(tmp_path)
    for content in (b"", b"GIF89a and more"):
        (tmp_path / "other.hdr").write_bytes(content)
        with pytest.raises(SceneError, match=r"other\.hdr: is neither an EXR nor"):
            read_environment(tmp_path / "other.hdr")
    (tmp_path / "cut.exr").write_bytes(bytes([0x76, 0x2F, 0x31, 0x01, 2, 0, 0, 0]))
    with pytest.raises(SceneError, match=r"cut\.exr: cannot read the image"):
        read_environment(tmp_path / "cut.exr")
