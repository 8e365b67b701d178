"""The viewer's reader refuses what the specification refuses, with its codes."""

import shutil

import numpy as np
import pytest

from rna_sdk.conformance.kit import find_kit, load_kit
from rna_sdk.package import Code, validate
from rna_sdk.package.issues import Severity
from tests.fuzz.packages import stream, viewer_verdicts
from tests.hosts.packages import broken_constants, make_profile_tier, write_profile_package
from tests.package.builders import make_tiny_package, read_entries
from tests.package.carriers import broken_carriers, make_carrier
from tests.package.corpus import content_cases
from tests.package.lobes import with_lobes

NOT_SEEN = {
    "proxy_that_is_no_mesh.rna",  # the viewer reads no proxies
    "variant_whose_image_is_none.rna",  # read when the variant is shown
    "coded_entry_with_bytes_behind.rna",  # browsers refuse them, Node's stream does not
}

pytestmark = pytest.mark.skipif(shutil.which("node") is None, reason="needs Node")


def verdicts(*packages: bytes) -> list[str]:
    """ "accepted", or the code of the refusal, of each."""
    return judged(*packages)[0]


def judged(*packages: bytes) -> tuple[list[str], list[list[str]]]:
    """The verdicts, and each package's warnings."""
    actual = viewer_verdicts(stream(packages))
    assert actual["failures"] == []
    return actual["verdicts"], actual["warnings"]


def test_broken_packages_of_the_kit():
    """Those that the viewer takes have warnings, as of an extension that it does not know."""
    cases = load_kit(find_kit()).validate
    actual, warnings = judged(*(case.package.read_bytes() for case in cases))
    wrong = [
        (case.package.name, case.code, verdict)
        for case, verdict, lines in zip(cases, actual, warnings, strict=True)
        if case.code is not None
        and Code[case.code].severity is Severity.ERROR
        and case.package.name not in NOT_SEEN
        and verdict != case.code
        and f"unknown extension {case.extension}" not in lines
    ]
    assert wrong == []


def test_broken_carriers_have_the_codes_of_the_sdk(tmp_path):
    """A glTF without a package, as far as the viewer looks, is no package to it."""
    good = make_carrier(make_tiny_package(tmp_path / "tiny.rna"), tmp_path / "good.glb")
    paths = broken_carriers(good, tmp_path)
    expected = [validate(path)[0].code for path in paths]
    actual = verdicts(*(path.read_bytes() for path in paths))
    others = {path.stem: pair for path, *pair in zip(paths, expected, actual, strict=True)}
    others = {name: (code, verdict) for name, (code, verdict) in others.items() if code != verdict}
    no_package = {("GLB_NO_PACKAGE", "ZIP_NOT_ZIP"), ("GLB_CONTAINER", "ZIP_NOT_ZIP")}
    assert set(others.values()) <= no_package and len(others) <= 10, others


def test_decoder_of_countless_layers_with_one_weight(tmp_path):
    """A small file, whose layers would be copied one after the other for the GPU."""
    entries = read_entries(make_tiny_package(tmp_path / "tiny.rna"))
    package = content_cases.decoder_of_countless_layers_with_one_weight(entries)
    assert verdicts(package) == ["DECODER_COST"]


@pytest.mark.parametrize("precision", ["float32", "int8"])
def test_constants_that_are_not_finite_are_refused(precision, tmp_path):
    """Every one, also where a later Clip or QuantizeLinear hides it."""
    tier = make_profile_tier("small", "surface", decoder_precision=precision)
    entries = read_entries(write_profile_package(tmp_path / "good.rna", tier))
    packages = [*broken_constants(entries, np.nan), *broken_constants(entries, np.inf)]
    assert len(packages) >= 16
    assert verdicts(*packages) == ["DECODER_RESULT"] * len(packages)


def test_packages_with_lobes_have_no_warnings(tmp_path):
    plain = make_tiny_package(tmp_path / "tiny.rna")
    cases = [
        with_lobes(plain, tmp_path / "told.rna"),
        with_lobes(plain, tmp_path / "untold.rna", visibility=False),
    ]
    assert judged(*(path.read_bytes() for path in cases)) == (["accepted"] * 2, [[], []])
