"""Base colour in the viewer: as a factor of transport, and looked up in images at the hits."""

from __future__ import annotations

import base64

import numpy as np
import pytest

from rna_sdk import runtime
from rna_view.site_files import Site
from tests.gpu.test_evaluate import rows
from tests.package.prints import make_print
from tests.web.pages import base64_of, call_reader, viewer

pytestmark = pytest.mark.chromium


def test_transport_as_the_runtime_has_it(tmp_path):
    """By one decoder, and by two of which one is for shadowed light."""
    path = make_print(tmp_path / "print.rna")
    colors = np.random.default_rng(1).uniform(size=(500, 3)).astype(np.float32)
    with viewer(Site({}, {})) as page:
        for tier in ("small", "hq"):
            asset = runtime.load(path, tier)
            x, n, wo, wi = rows(500, asset.bounds)
            expected = np.hstack(asset.evaluate(x, n, wo, wi, base_color=colors))
            queries = np.hstack([x, n, np.zeros((500, 1), np.float32), wo, wi, colors])
            text = base64.b64encode(queries.tobytes()).decode()
            call_reader(page, "load", base64_of(path), tier)
            answer = call_reader(page, "evaluate", 0, "transport", text)
            actual = np.frombuffer(base64.b64decode(answer), "<f4").reshape(500, 6)
            assert np.abs(actual - expected).max() <= 1e-3 * np.sqrt(np.mean(expected**2))
