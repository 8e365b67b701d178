"""The page that is shipped is what its sources give, and its decoder is rna_gpu's WGSL."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

import pytest

from rna_view.site_files import VIEWER_FILES, Site, viewer_file
from tests.web.pages import viewer

REPOSITORY = Path(__file__).parents[2]
MOST_BYTES = 1_500_000
SHADERS = REPOSITORY / "runtime" / "rna_gpu" / "wgsl"


def test_page_is_small():
    assert sum(len(viewer_file(name)) for name in VIEWER_FILES) <= MOST_BYTES


def test_page_is_what_its_sources_give(tmp_path):
    if shutil.which("npm") is None:
        pytest.skip("no Node; on Debian: apt-get install nodejs npm")
    subprocess.run([REPOSITORY / "scripts" / "web-bundle", tmp_path], check=True, timeout=300)
    built = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    shipped = {name: viewer_file(name) for name in VIEWER_FILES}
    assert built.keys() == shipped.keys()
    changed = [name for name in built if built[name] != shipped[name]]
    assert not changed, f"scripts/web-bundle builds another {changed}: commit what it gives"


@pytest.mark.chromium
def test_decoder_and_rays_are_the_wgsl_of_rna_gpu():
    with viewer(Site({}, {}), "api=webgl2") as page:
        files = page.evaluate("rnaViewer.wgsl.sharedFiles")
        assert files == {name: (SHADERS / name).read_text() for name in files}
        compositions = json.loads((SHADERS / "compositions.json").read_text())
        for kind in ("surface", "fiber"):
            names = ["weights_uniform.wgsl", *compositions[kind], *compositions["evaluate"]]
            wanted = "const RNA_GROUPS: u32 = 8u;\n" + "\n".join(files[name] for name in names)
            arguments = f'{{RNA_GROUPS: 8}}, "weights_uniform.wgsl", "{kind}", "evaluate"'
            assert page.evaluate(f"rnaViewer.wgsl.compose({arguments})") == wanted
        kernels = page.evaluate(
            "rnaViewer.wgsl.rayKernels({ hasSegments: true, hasTextures: true })"
        )
        for source in kernels.values():
            for name in ("triangle.wgsl", "segment.wgsl", "visibility.wgsl"):
                assert files[name] in source
