"""Base colour in packages: images of every sort decoded, records written and read again."""

import io
import struct
import zlib
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image, ImageCms

from rna_sdk.errors import PackageError
from rna_sdk.package import Package, write_package
from rna_sdk.package.textures.base_color import image_from_bytes
from tests.package.builders import make_mesh, make_part, make_tier_data
from tests.package.prints import (
    LABEL,
    image_bytes,
    make_images,
    make_print,
    make_print_manifest,
    tiers,
)

PIXELS = np.random.default_rng(3).integers(0, 256, (5, 7, 3)).astype(np.uint8)
NAME = "textures/label.png"


def decoded(data: bytes) -> np.ndarray:
    return image_from_bytes(data, NAME)


def saved(image: Image.Image, kind: str = "PNG", **options: object) -> bytes:
    file = io.BytesIO()
    image.save(file, kind, **options)
    return file.getvalue()


def png(pixels: np.ndarray, color_type: int, bits: int, *chunks: tuple[bytes, bytes]) -> bytes:
    """A PNG of (H, W, C) samples as they are, big-endian; chunks: of a name and data."""
    height, width, _ = pixels.shape
    samples = pixels.astype(">u2" if bits == 16 else "u1")
    rows = b"".join(b"\0" + row.tobytes() for row in samples)
    header = struct.pack(">IIBBBBB", width, height, bits, color_type, 0, 0, 0)
    made = (b"IHDR", header), *chunks, (b"IDAT", zlib.compress(rows)), (b"IEND", b"")
    checked = (
        struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
        for name, data in made
    )
    return b"\x89PNG\r\n\x1a\n" + b"".join(checked)


def test_records_are_read_as_they_were_written(tmp_path):
    with Package.open(make_print(tmp_path / "print.rna")) as package:
        label, stamp, plain = package.base_color()
    np.testing.assert_array_equal(label.image, decoded(make_images()[LABEL]))
    assert (label.first, label.count, label.color_space) == (0, 2, "srgb")
    assert label.factor == (0.5, 1.0, 0.25) and label.wrap == ("mirror", "clamp")
    assert label.transform == (2.0, 0.1, 0.3, -0.2, 1.5, 0.0)
    assert stamp.image is not None and stamp.image.shape == (1, 1, 3)
    assert (stamp.color_space, stamp.factor) == ("linear", (1, 1, 1))
    assert plain.image is None and plain.factor == (0.2, 0.3, 0.4)
    assert stamp.wrap == ("repeat", "repeat") and stamp.transform == (1, 0, 0, 0, 1, 0)
    assert not label.image.flags.writeable


def test_images_of_8_bits_are_what_they_were_made_of():
    for data in (image_bytes(PIXELS), image_bytes(PIXELS, "WEBP", lossless=True)):
        np.testing.assert_array_equal(decoded(data), PIXELS)
    np.testing.assert_array_equal(decoded(png(PIXELS, 2, 8)), PIXELS)
    smooth = np.full((8, 8, 3), (200, 90, 40), np.uint8)
    jpeg = decoded(image_bytes(smooth, "JPEG", quality=100))
    assert np.abs(jpeg.astype(int) - smooth).max() <= 2


@pytest.mark.parametrize(("color_type", "channels"), [(0, 1), (2, 3), (4, 2), (6, 4)])
def test_of_16_bits_the_higher_8_count(color_type, channels):
    rng = np.random.default_rng(color_type)
    wide = rng.integers(0, 2**16, (5, 7, channels))
    expected = np.broadcast_to((wide >> 8)[..., : 3 if channels > 2 else 1], (5, 7, 3))
    np.testing.assert_array_equal(decoded(png(wide, color_type, 16)), expected)


def test_a_palette_grey_and_alpha_are_colours():
    grey = PIXELS[:, :, 0]
    same = np.repeat(grey[:, :, None], 3, axis=2)
    np.testing.assert_array_equal(decoded(image_bytes(grey)), same)
    np.testing.assert_array_equal(decoded(saved(Image.fromarray(grey > 99))), 255 * (same > 99))
    few = PIXELS // 128 * 200
    palette = Image.fromarray(few).quantize(8)
    assert palette.mode == "P"
    for options in ({}, {"transparency": 0}):
        np.testing.assert_array_equal(decoded(saved(palette, **options)), few)
    for alpha in (0, 100):  # the colour behind it counts, not what it is mixed with
        rgba = np.dstack([PIXELS, np.full((5, 7), alpha, np.uint8)])
        np.testing.assert_array_equal(decoded(image_bytes(rgba)), PIXELS)
        lossless = image_bytes(rgba, "WEBP", lossless=True, exact=True)
        np.testing.assert_array_equal(decoded(lossless), PIXELS)
    clear = png(PIXELS, 2, 8, (b"tRNS", struct.pack(">HHH", *PIXELS[0, 0])))
    np.testing.assert_array_equal(decoded(clear), PIXELS)


def test_orientation_profiles_and_gamma_change_nothing():
    exif = Image.Exif()
    exif[0x0112] = 6  # turned by 90 degrees
    profile = ImageCms.ImageCmsProfile(ImageCms.createProfile("LAB")).tobytes()
    gamma = b"gAMA", struct.pack(">I", 100_000)
    for data in (
        image_bytes(PIXELS, exif=exif),
        image_bytes(PIXELS, icc_profile=profile),
        png(PIXELS, 2, 8, gamma),
        image_bytes(PIXELS, "WEBP", lossless=True, exif=exif, icc_profile=profile),
    ):
        np.testing.assert_array_equal(decoded(data), PIXELS)
    plain, turned = (decoded(image_bytes(PIXELS, "JPEG", **o)) for o in ({}, {"exif": exif}))
    np.testing.assert_array_equal(plain, turned)


def test_of_several_frames_the_first_counts():
    frames = [Image.fromarray(PIXELS), Image.fromarray(255 - PIXELS)]
    for kind, options in (("PNG", {}), ("WEBP", {"lossless": True})):
        data = saved(frames[0], kind, save_all=True, append_images=frames[1:], **options)
        np.testing.assert_array_equal(decoded(data), PIXELS)


def test_an_image_cut_short_is_refused():
    for kind in ("PNG", "JPEG", "WEBP"):
        whole = image_bytes(np.repeat(PIXELS, 40, axis=0), kind)
        for size in (len(whole) // 2, len(whole) * 9 // 10):
            with pytest.raises(PackageError, match=f"BASE_COLOR_IMAGE at {NAME}"):
                decoded(whole[:size])


def test_an_image_in_printing_inks_is_refused():
    data = saved(Image.fromarray(PIXELS).convert("CMYK"), "JPEG")
    with pytest.raises(PackageError, match=r"BASE_COLOR_IMAGE at .*Found a JPEG in CMYK"):
        decoded(data)


def test_what_is_wrong_is_refused_when_writing(tmp_path):
    manifest, path = make_print_manifest(), tmp_path / "print.rna"
    data, images = {tier.name: make_tier_data(tier) for tier in manifest.tiers}, make_images()
    bare = replace(make_mesh(), uvs=None)
    for code, mesh, files in (
        ("REFERENCE_MISSING", make_mesh(), {}),
        ("BASE_COLOR_IMAGE", make_mesh(), {**images, LABEL: b"GIF89a"}),
        ("BASE_COLOR_UV", bare, images),
    ):
        with pytest.raises(PackageError, match=code):
            write_package(path, manifest, [mesh], data, files)
    plain = make_print_manifest(parts=(make_part(),))
    with pytest.raises(PackageError, match="FIELD_VALUE at /tiers/0/parts/0/usesBaseColor"):
        write_package(path, plain, [make_mesh()], data)
    with pytest.raises(PackageError, match="DECODER_PROFILE"):
        other = replace_tiers(manifest, uses_base_color=None)
        write_package(path, other, [make_mesh()], data, images)
    assert list(tmp_path.iterdir()) == []


def replace_tiers(manifest, **changes):  # type: ignore[no-untyped-def]
    return manifest.model_copy(update={"tiers": tiers(**changes)})


def test_shadowed_light_needs_no_base_color(tmp_path):
    path = make_print(tmp_path / "plain.rna", tiers=tiers(None))
    with Package.open(path) as package:
        small, hq = package.manifest.tiers
        assert [d.form.name for d in small.parts[0].decoders] == ["transport"]
        assert [(d.form.name, d.width) for d in hq.parts[0].decoders] == [
            *(("visible", 3), ("shadowed", 3))
        ]
        assert package.decoder("hq") == package.decoder("hq", 0, "visible")
        assert package.decoder("hq", 0, "shadowed") != package.decoder("hq")
