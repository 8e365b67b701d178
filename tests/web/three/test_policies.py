"""Pages that require trusted types: packages are read in the page, without a worker."""

import shutil

import pytest

from tests.web.pages import TIMEOUT
from tests.web.three.pages import PAGE, TINY, installed, opened

pytestmark = pytest.mark.chromium

POLICY = "require-trusted-types-for 'script'; trusted-types 'none'"


def test_trusted_types(tmp_path):
    installed(tmp_path)
    shutil.copy(TINY, tmp_path)
    policy = f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">'
    (tmp_path / "page.html").write_text(f"<!doctype html>{policy}{PAGE.read_text()}")
    with opened(tmp_path, "page.html", 32, 32) as page:
        page.wait_for("!!globalThis.test", TIMEOUT)
        refused = "(() => { try { new Worker('data:,'); } catch { return true; } })()"
        assert page.evaluate(refused)
        load = "new test.rna.RnaLoader().loadAsync('surface-tiny.rna')"
        assert page.evaluate(f"{load}.then((asset) => asset.meshes.length)") == 1
