"""The code of docs/your_own_host.md runs as it stands, and shows what the page says."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from tests.conftest import REPOSITORY

PAGE = REPOSITORY / "docs" / "your_own_host.md"


def blocks(page: Path) -> list[str]:
    return re.findall(r"```python\n(.*?)```", page.read_text(), re.DOTALL)


def test_the_code_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(REPOSITORY / "examples" / "quickstart")
    names: dict[str, object] = {}
    exec("\n".join(blocks(PAGE)), names)
    image, visible = names["image"], names["visible"]
    assert np.isfinite(image).all() and image.max() > 0.3
    assert 0.1 < names["lost"] < 0.9
    blocked = names["blocked"]
    assert 0.5 < blocked.mean() < 0.99  # lit from behind
    np.testing.assert_array_equal(names["again"], visible)
    np.testing.assert_allclose(names["wi_object"], names["arguments"][3], atol=1e-6)
    assert names["curls"].shape == (100, 3) and names["curls"].max() > 0


@pytest.mark.parametrize("page", ["your_own_host.md", "mitsuba.md"])
def test_links_lead_somewhere(page: str) -> None:
    links = re.findall(r"\]\((?!https?:)([^)#]+)", (REPOSITORY / "docs" / page).read_text())
    assert [link for link in links if not (REPOSITORY / "docs" / link).exists()] == []
