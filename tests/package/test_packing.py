"""Coded entries, posters, stand-ins and proxies: written, read again, and left out again."""

import io
import os
import tracemalloc
import zlib
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from rna_sdk.errors import PackageError
from rna_sdk.package import Package, quantise, validate
from rna_sdk.package.command.rna_pack import main
from rna_sdk.package.container.zip_container import Container, read_file
from rna_sdk.package.manifest.deflate import decode, encode
from rna_sdk.package.manifest.extensions import (
    Deflate,
    Poster,
    Proxy,
    Standin,
    StandinMaterial,
    extension,
)
from rna_sdk.package.packing import Unpacked
from tests.package.builders import make_mesh, read_entries
from tests.time_limit import time_limit


def png(width: int = 3, height: int = 2) -> bytes:
    file = io.BytesIO()
    Image.new("RGBA", (width, height)).save(file, format="PNG")
    return file.getvalue()


@pytest.mark.parametrize("element_size", [1, 2, 4])
@pytest.mark.parametrize("distance", [0, 1, 3, 7, 500, 2**53 - 1])
@pytest.mark.parametrize("size", [0, 1, 3, 4, 257, 1026])
def test_coding_gives_back_every_byte(element_size, distance, size):
    data = np.random.default_rng(size).bytes(size)
    stream = encode(data, element_size, distance)
    assert decode(stream, size, element_size, distance) == data


def test_coding_of_the_specification():
    """Worked by hand: elements 0x0102, 0x0104, 0x0001, and a byte behind."""
    data = bytes.fromhex("0201 0401 0100 ff".replace(" ", ""))
    coded = bytes.fromhex("02 02 fd 01 00 fe ff".replace(" ", ""))
    assert decode(zlib.compress(coded), 7, 2, 1) == data
    assert zlib.decompress(encode(data, 2, 1)) == coded


def test_no_more_is_inflated_than_declared():
    bomb = zlib.compress(bytes(2**24))
    tracemalloc.start()
    try:
        with pytest.raises(ValueError, match="more than 10 bytes"):
            decode(bomb, 10, 1, 0)
        assert tracemalloc.get_traced_memory()[1] < 2**20
    finally:
        tracemalloc.stop()


def test_deflated_package_is_the_same_asset(tuft, tmp_path):
    coded, plain = tmp_path / "coded.rna", tmp_path / "plain.rna"
    assert main([str(tuft), "--out", str(coded), "--deflate"]) == 0
    stored, whole = (Container.of(read_file(p), p).entries for p in (coded, tuft))
    for name in ("geometry/curves.safetensors", "decoders/small.onnx"):
        assert stored[name].size < whole[name].size
    assert validate(coded) == []
    with Package.open(tuft) as one, Package.open(coded) as other:
        np.testing.assert_array_equal(one.curves().points, other.curves().points)
        np.testing.assert_array_equal(one.planes("small"), other.planes("small"))
        assert one.decoder("small") == other.decoder("small")
        assert other.manifest.extensions_required == (Deflate.NAME,)
    assert main([str(coded), "--out", str(plain)]) == 0
    assert plain.read_bytes() == tuft.read_bytes()


def test_entry_that_would_inflate_too_far_stays_as_it_is(tiny, tmp_path):
    path, png_of_zeros = tmp_path / "zeros.rna", png() + bytes(2**21)
    package = Unpacked.read(tiny).with_poster(png_of_zeros).deflated()
    package.write(path)
    (poster,) = (name for name in package.entries if name.endswith(".png"))
    assert len(package.entries[poster]) == len(png_of_zeros)
    with Package.open(path) as opened:
        assert opened.poster() == png_of_zeros


def test_a_pipe_or_device_is_no_package(tmp_path, capsys):
    """Neither is opened, not to see whether a ZIP program wrote it either: it may never end."""
    os.mkfifo(tmp_path / "pipe.rna")
    with time_limit(20):
        assert main([str(tmp_path / "pipe.rna"), "--out", str(tmp_path / "x.rna")]) == 1
    assert "Found a pipe or a device; expected a file" in capsys.readouterr().err


def test_a_pipe_is_no_poster(tiny, tmp_path, capsys):
    os.mkfifo(tmp_path / "pipe.png")
    arguments = [str(tiny), "--out", str(tmp_path / "x.rna"), "--poster"]
    assert main([*arguments, str(tmp_path / "pipe.png")]) == 1
    assert "is a pipe or a device" in capsys.readouterr().err


def test_coding_twice_changes_nothing(tiny, tmp_path):
    once = tmp_path / "once.rna"
    Unpacked.read(tiny).deflated().write(once)
    Unpacked.read(once).deflated().write(tmp_path / "twice.rna")
    assert once.read_bytes() == (tmp_path / "twice.rna").read_bytes()


def test_poster_replaces_the_one_before(tiny, tmp_path):
    picture, out = tmp_path / "poster.png", tmp_path / "out.rna"
    for size in ((3, 2), (5, 4)):
        picture.write_bytes(png(*size))
        assert main([str(tiny), "--out", str(out), "--poster", str(picture)]) == 0
    with Package.open(out) as package:
        poster = extension(package.manifest, Poster)
        assert (poster.width, poster.height) == (5, 4)
        assert package.poster() == png(5, 4)
    assert validate(out) == []


def test_poster_that_is_no_png_is_refused(tiny, tmp_path, capsys):
    out = str(tmp_path / "out.rna")
    assert main([str(tiny), "--out", out, "--poster", str(tiny)]) == 1
    assert "POSTER_IMAGE" in capsys.readouterr().err
    assert main([str(tiny), "--out", out, "--poster", str(tmp_path / "none.png")]) == 1
    assert "none.png" in capsys.readouterr().err
    assert not Path(out).exists()


def test_standin_and_proxy_come_back(tiny, tmp_path):
    material = StandinMaterial(base_color=(0.5, 0.25, 0.125), roughness=0.5, metallic=0.25)
    proxy = quantise(make_mesh())
    unpacked = Unpacked.read(tiny).with_extension(Standin(parts=(material,)), {})
    unpacked.with_proxies([[(make_mesh(), 64), (proxy, 32)]]).write(tmp_path / "x.rna")
    assert validate(tmp_path / "x.rna") == []
    with Package.open(tmp_path / "x.rna") as package:
        assert extension(package.manifest, Standin).parts == (material,)
        levels = extension(package.manifest, Proxy).parts[0]
        assert [level.height for level in levels] == [64, 32]
        assert package.geometry(pixels=65.0).quantised is None
        assert package.geometry(pixels=64.0).quantised is None
        np.testing.assert_array_equal(package.geometry(pixels=32.0).positions, proxy.positions)
    Unpacked.read(tmp_path / "x.rna").write(tmp_path / "again.rna")
    assert read_entries(tmp_path / "again.rna") == read_entries(tmp_path / "x.rna")


def test_broken_package_is_not_packed(tmp_path):
    (tmp_path / "bad.rna").write_bytes(b"no package")
    with pytest.raises(PackageError, match="ZIP_NOT_ZIP"):
        Unpacked.read(tmp_path / "bad.rna")
