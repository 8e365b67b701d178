"""Pages whose policy refuses what the element could have been made with."""

import pytest

from tests.web.element_pages import SMALL, line, loads, show

pytestmark = pytest.mark.chromium

POLICY = "require-trusted-types-for 'script'; trusted-types 'none'"


def test_trusted_types(page, folder, url):
    policy = f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">'
    show(page, folder, url, f'{policy}<rna-viewer id="one" src="tiny.rna" {SMALL}></rna-viewer>')
    refused = "(() => { try { document.body.innerHTML = ''; } catch { return true; } })()"
    assert page.evaluate(refused)
    loads(page, "one")
    assert line(page) is None
