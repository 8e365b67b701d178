"""Outputs that are checked before time is spent: inputs are not replaced."""

import os
from pathlib import Path

import pytest

from rna_sdk.errors import RnaError
from rna_sdk.files.atomic_file import write_atomically
from rna_sdk.files.outputs import check_glb_name, check_outputs, check_package_name, check_writable


def test_a_device_is_not_replaced_by_a_file(tmp_path):
    """Which the superuser could do, to /dev/null too."""
    os.mkfifo(tmp_path / "pipe")
    with pytest.raises(RnaError, match="pipe: cannot be written: it is a pipe or a device"):
        check_outputs([tmp_path / "pipe"], [])
    with pytest.raises(OSError, match="it is a pipe or a device"):
        write_atomically(tmp_path / "pipe", b"x")
    assert (tmp_path / "pipe").is_fifo()


def test_an_output_that_cannot_be_written_is_named(tmp_path):
    (tmp_path / "taken.exr").mkdir()
    with pytest.raises(RnaError, match=r"taken\.exr: cannot be written: it is a folder"):
        check_writable(tmp_path / "taken.exr")
    with pytest.raises(RnaError, match=r"\.: cannot be written: it is a folder"):
        check_writable(Path(""))
    with pytest.raises(RnaError, match=r"a\.exr: there is no folder .*nowhere: make it first"):
        check_writable(tmp_path / "nowhere" / "a.exr")
    check_writable(tmp_path / "new.exr")
    assert [path.name for path in tmp_path.iterdir()] == ["taken.exr"]


@pytest.mark.parametrize("link", [None, "symlink_to", "hardlink_to"])
def test_an_input_is_no_output_by_any_name(tmp_path, link):
    source = output = tmp_path / "s.glb"
    source.write_bytes(b"mine")
    if link is not None:
        output = tmp_path / "t.glb"
        getattr(output, link)(source)
    with pytest.raises(RnaError, match=r"\.glb: is an input \(.*s\.glb\); expected another"):
        check_outputs([tmp_path / "new", output], [tmp_path / "missing", source])
    check_outputs([tmp_path / "new"], [source])
    assert source.read_bytes() == b"mine"


def test_a_package_is_named_as_one():
    check_package_name(Path("toy.rna"))
    check_package_name(Path("toy.GLB"))
    for name in ("toy", "toy.gltf"):
        expected = rf"^--out: expected a name that ends with \.rna or \.glb, found {name}$"
        with pytest.raises(RnaError, match=expected):
            check_package_name(Path(name))
    check_glb_name(Path("toy.glb"))
    with pytest.raises(RnaError, match=r"^--glb: expected a name that ends with \.glb, found toy$"):
        check_glb_name(Path("toy"))
