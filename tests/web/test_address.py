"""What the page's address asks for, and an exported page on any other server."""

import pytest

from rna_view.site_export import export_site
from rna_view.site_source import site_for
from tests.package.builders import make_tiny_package
from tests.render.chromium import SOFTWARE_GPU, Page, open_page
from tests.web.pages import notice, served_folder, wait_for_picture

pytestmark = pytest.mark.chromium

TIMEOUT = 60.0
QUERY = "samples=1&pixel-ratio=1"
ODD_NAMES = ("Chair #2.rna", "50% off.rna", "ü ❤.rna", "a&b=c+d.rna")


@pytest.fixture(scope="module")
def site_url(tmp_path_factory):
    """An exported page on a plain server, with packages of odd names beside it."""
    folder = tmp_path_factory.mktemp("exported")
    package = make_tiny_package(tmp_path_factory.mktemp("package") / "Chair #2 50% off?.rna")
    export_site(site_for(package), folder)
    for name in ODD_NAMES:
        (folder / name).write_bytes(package.read_bytes())
    with served_folder(folder) as url:
        yield url


@pytest.fixture(scope="module")
def chromium_page():
    with open_page(160, 100, SOFTWARE_GPU) as page:
        yield page


def visit(page: Page, url: str) -> None:
    """Open an address, until its asset is shown or something failed."""
    page.call("Page.navigate", url="about:blank")
    page.call("Page.navigate", url=url)
    page.wait_for("!!globalThis.rnaViewer?.viewer", TIMEOUT)
    wait_for_picture(page, 1)


def test_an_exported_page_works_under_its_policy(chromium_page, site_url):
    visit(chromium_page, f"{site_url}?{QUERY}")
    assert notice(chromium_page) is None
    chromium_page.evaluate(
        """(() => {
            globalThis.refused = [];
            addEventListener("securitypolicyviolation", (e) => refused.push(e.effectiveDirective));
            const script = document.createElement("script");
            script.textContent = "globalThis.ran = 1";
            document.head.append(script);
        })()"""
    )
    chromium_page.wait_for("refused.length", TIMEOUT)
    assert chromium_page.evaluate("[globalThis.ran ?? 0, refused[0]]") == [0, "script-src-elem"]


@pytest.mark.parametrize("name", ODD_NAMES)
def test_an_asset_of_any_name(chromium_page, site_url, name):
    chromium_page.evaluate(f"globalThis.odd = encodeURIComponent({name!r})")
    odd = chromium_page.evaluate("odd")
    visit(chromium_page, f"{site_url}?{QUERY}&src={odd}")
    assert notice(chromium_page) is None
    assert chromium_page.evaluate("rnaViewer.opened.source.name") == name


def test_what_the_address_cannot_have_is_told(chromium_page, site_url):
    chromium_page.call("Page.navigate", url="about:blank")
    address = f"{QUERY}&samples=many&teir=hq&fbclid=1&environment=none.hdr"
    chromium_page.call("Page.navigate", url=f"{site_url}?{address}")
    chromium_page.wait_for("(globalThis.rnaViewer?.viewer?.stats.rounds ?? 0) >= 1", TIMEOUT)
    notice_text = notice(chromium_page)
    assert 'samples: expected a whole number from 1 to 1000000, found "many"' in notice_text
    assert "?teir= is no parameter of this page: did you mean tier=?" in notice_text
    assert "cannot load none.hdr: HTTP 404" in notice_text and "fbclid" not in notice_text
    assert chromium_page.evaluate("rnaViewer.viewer.rounds") == 256


def test_no_hint_while_an_asset_is_on_its_way(chromium_page, site_url):
    hint = "getComputedStyle(document.getElementById('hint')).display"
    held = """
        const begin = fetch, held = [];
        globalThis.fetch = (...asked) =>
            new Promise((answer) => held.push(() => answer(begin(...asked))));
        globalThis.letGo = () => { globalThis.fetch = begin; held.forEach((one) => one()); };
    """
    chromium_page.call("Page.navigate", url="about:blank")
    chromium_page.call("Page.enable")
    script = chromium_page.call("Page.addScriptToEvaluateOnNewDocument", source=held)
    chromium_page.call("Page.navigate", url=f"{site_url}?{QUERY}")
    chromium_page.wait_for(f"globalThis.rnaViewer && {hint} === 'none'", TIMEOUT)
    assert not chromium_page.evaluate("document.body.classList.contains('loaded')")
    chromium_page.call("Page.removeScriptToEvaluateOnNewDocument", **script)
    chromium_page.call("Page.disable")
    chromium_page.evaluate("letGo()")
    wait_for_picture(chromium_page, 1)
    assert chromium_page.evaluate(hint) == "none"
