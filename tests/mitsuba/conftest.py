"""Mitsuba with LLVM, for the tests of `rna_mitsuba` alone."""

import os
from pathlib import Path

import pytest

mi = pytest.importorskip("mitsuba", reason="mitsuba is not installed: pip install mitsuba")


def _usable_llvm() -> str | None:
    """Why there is no LLVM that Dr.Jit can use; None if there is."""
    actual = sorted(Path("/usr/lib").glob("**/libLLVM*.so.19*"))
    if "DRJIT_LIBLLVM_PATH" not in os.environ and actual:
        os.environ["DRJIT_LIBLLVM_PATH"] = str(actual[0])
    try:
        mi.set_variant("llvm_ad_rgb")
        import drjit as dr

        dr.eval(mi.Float(1) + dr.arange(mi.Float, 2))
    except Exception as error:
        return f"no LLVM for Dr.Jit: {str(error).splitlines()[0]}"
    return None


@pytest.fixture(scope="module", autouse=True)
def llvm():
    """The variant is llvm_ad_rgb in these modules; the others keep theirs."""
    before = mi.variant()
    try:
        reason = _usable_llvm()
        if reason is not None:
            pytest.skip(reason)
        mi.set_log_level(mi.LogLevel.Error)
        yield
    finally:
        mi.set_variant(before or "scalar_rgb")
