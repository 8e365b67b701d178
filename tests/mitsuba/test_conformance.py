"""`rna_mitsuba` as a reader: transport and emission in Dr.Jit, rays, normals, base colours."""

import subprocess
import sys

import pytest

from rna_sdk.conformance.kit import load_kit
from rna_sdk.conformance.rna_conform import run_levels
from tests.conformance.conftest import KIT, InProcess


@pytest.mark.parametrize("level", ["evaluate", "nearby", "visibility", "normals", "base-color"])
def test_it_passes(level):
    from rna_mitsuba import conformance_reader as reader

    program = InProcess(
        reader.evaluate,
        reader.visibility,
        reader.normals,
        nearby=reader.evaluate,
        base_color=reader.base_color,
    )
    scores = list(run_levels(program, load_kit(KIT), [level]))
    assert scores and [score for score in scores if not score.passed] == []


def test_rays_without_a_lift_fail():
    """The kit sees a wrong visibility here, too."""
    from rna_mitsuba import conformance_reader as reader
    from rna_mitsuba import points

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(points, "_SMOOTH_BELOW", -2.0)
        program = InProcess(visibility=reader.visibility)
        scores = run_levels(program, load_kit(KIT), ["visibility"])
        assert any("terminator" in score.note for score in scores if not score.passed)


@pytest.mark.parametrize("variant", ["scalar_rgb", "llvm_ad_spectral"])
def test_another_variant_is_refused(variant):
    program = (
        f"import mitsuba as mi; mi.set_variant({variant!r})\n"
        "from rna_sdk.errors import QueryError\n"
        "try:\n    import rna_mitsuba\nexcept QueryError as error:\n    print(error)"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert f"found the Mitsuba variant {variant}, expected llvm_ad_rgb" in done.stdout
