"""A folder on a plain server with the element and packages, and a browser's page for it."""

import pytest

from rna_view.site_files import ELEMENT, viewer_file
from tests.package.builders import make_tier, make_tiny_fiber_package, make_tiny_package
from tests.render.chromium import SOFTWARE_GPU, open_page
from tests.web.element_pages import Static
from tests.web.pages import served_folder


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("theirs")
    (folder / ELEMENT).write_bytes(viewer_file(ELEMENT))
    make_tiny_package(folder / "tiny.rna", make_tier("small"), make_tier("hq", resolution=256))
    make_tiny_fiber_package(folder / "fibers.rna")
    (folder / "bad.rna").write_bytes(b"this is no package")
    return folder


@pytest.fixture(scope="module")
def url(folder):
    with served_folder(folder, Static) as address:
        yield address


@pytest.fixture(scope="module")
def page():
    with open_page(200, 200, SOFTWARE_GPU) as page:
        yield page
