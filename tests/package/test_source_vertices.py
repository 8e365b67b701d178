"""RNA_source: vertices of the source in a package."""

from pathlib import Path

import numpy as np
import pytest

from rna_sdk.errors import PackageError
from rna_sdk.package import Package, SourceVertices
from rna_sdk.package.packing import Unpacked


def numbers_of(path: Path, shift: int = 0) -> SourceVertices:
    with Package.open(path) as package:
        count = len(package.mesh().positions)
    return SourceVertices(np.arange(count, dtype=np.uint32)[::-1] + np.uint32(shift), count)


def test_they_come_back(tiny, tmp_path):
    wanted, out = numbers_of(tiny), tmp_path / "numbered.rna"
    Unpacked.read(tiny).with_source([wanted]).deflated().write(out)
    with Package.open(out) as package:
        actual = package.source_vertices()
    assert actual is not None and actual.count == wanted.count
    np.testing.assert_array_equal(actual.numbers, wanted.numbers)
    with Package.open(tiny) as package:
        assert package.source_vertices() is None


@pytest.mark.parametrize(
    ("of", "code", "message"),
    [
        (lambda n: SourceVertices(n.numbers[1:], n.count), "GEOMETRY_PROFILE", "expected"),
        (lambda n: SourceVertices(n.numbers, n.count - 1), "GEOMETRY_INDEX", "expected less than"),
    ],
    ids=["fewer", "beyond"],
)
def test_what_does_not_fit_the_mesh_is_refused(tiny, tmp_path, of, code, message):
    wrong = of(numbers_of(tiny))
    with pytest.raises(PackageError, match=message) as caught:
        Unpacked.read(tiny).with_source([wrong]).write(tmp_path / "wrong.rna")
    assert [issue.code for issue in caught.value.issues] == [code]
    assert not (tmp_path / "wrong.rna").exists()
