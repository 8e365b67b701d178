"""The C host opens packages in .glb files, and refuses what the SDK refuses, by the same codes."""

import pytest

from rna_sdk.package import validate
from rna_sdk.runtime import load
from tests.hosts.c_host import CAsset, compiler
from tests.hosts.test_c_host import random_rows, run
from tests.package.builders import make_tiny_package
from tests.package.carriers import broken_carriers, make_carrier, opened, written

pytestmark = pytest.mark.skipif(compiler() is None, reason="needs cc and make")


@pytest.fixture(scope="module")
def tiny(tmp_path_factory):
    return make_tiny_package(tmp_path_factory.mktemp("c-carrier") / "tiny.rna")


@pytest.fixture(scope="module")
def carrier(tiny):
    return make_carrier(tiny, tiny.with_suffix(".glb"))


def test_answers_and_pictures_have_the_same_bits(programs, tiny, carrier, tmp_path):
    one, other = (CAsset(programs["librna.so"], path, "small") for path in (tiny, carrier))
    rows = random_rows("surface", load(tiny).bounds, 500)
    for a, b in zip(one.evaluate(*rows), other.evaluate(*rows), strict=True):
        assert a.tobytes() == b.tobytes()
    one.close()
    other.close()
    pictures = [tmp_path / f"{path.suffix}.ppm" for path in (tiny, carrier)]
    for path, picture in zip((tiny, carrier), pictures, strict=True):
        size = "--size", "24", "16", "--samples", "1"
        assert run(programs["render"], path, picture, *size).returncode == 0
    assert pictures[0].read_bytes() == pictures[1].read_bytes()


def test_broken_carriers_have_the_codes_of_the_sdk(programs, carrier, tmp_path):
    document, blob = opened(carrier)
    paths = [written(document, blob, tmp_path / "unaligned.glb", 1)]
    paths += broken_carriers(carrier, tmp_path)
    for path in paths:
        result = run(programs["conform"], "validate", path)
        codes = [issue.code for issue in validate(path)]
        assert (result.returncode, result.stdout.split()) == (1, codes), path.name
