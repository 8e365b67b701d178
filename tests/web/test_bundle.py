"""The pages shipped are what their sources give; the viewer's decoder is rna_gpu's WGSL."""

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

SHARED_BY_RAYS = (
    *("geometry.wgsl", "bvh.wgsl", "triangle.wgsl", "segment.wgsl", "visibility.wgsl"),
    *("normal_maps.wgsl", "render/surfaces.wgsl", "render/textures.wgsl", "render/sampler.wgsl"),
    *("render/transmittance.wgsl", "render/passing.wgsl", "render/tracing.wgsl"),
    "render/vertex.wgsl",
)

SITES = {
    "viewer": REPOSITORY / "runtime" / "rna_view" / "site",
    "preview": REPOSITORY / "runtime" / "rna_render" / "preview" / "site",
}


def test_page_is_small():
    assert sum(len(viewer_file(name)) for name in VIEWER_FILES) <= MOST_BYTES


def test_pages_are_what_their_sources_give(tmp_path):
    if shutil.which("npm") is None:
        pytest.skip("no Node; on Debian: apt-get install nodejs npm")
    subprocess.run([REPOSITORY / "scripts" / "web-bundle", tmp_path], check=True, timeout=300)
    built = {name: _contents(tmp_path / name) for name in SITES}
    shipped = {name: _contents(site) for name, site in SITES.items()}
    changed = [f"{s}/{n}" for s in SITES for n in built[s] if built[s][n] != shipped[s].get(n)]
    assert not changed, f"scripts/web-bundle builds another {changed}: commit what it gives"
    assert {s: set(shipped[s]) for s in SITES} == {s: set(built[s]) for s in SITES}


def _contents(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


@pytest.mark.chromium
def test_decoder_and_rays_are_the_wgsl_of_rna_gpu():
    with viewer(Site({}, {})) as page:
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
        nearby = kernels.pop("nearby")
        assert files["bvh.wgsl"] in nearby and files["render/nearby_light.wgsl"] in nearby
        for source in kernels.values():
            for name in SHARED_BY_RAYS:
                assert files[name] in source
        for name in ("render/directions.wgsl", "render/lights.wgsl", "render/environment.wgsl"):
            assert files[name] in kernels["light"]
