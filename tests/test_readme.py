"""What the README says can be done."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import numpy as np
import pytest

from tests.conftest import REPOSITORY
from tests.package.builders import make_tiny_package

PAGES = [path.relative_to(REPOSITORY) for path in (REPOSITORY / "docs").rglob("*.md")]
README = (REPOSITORY / "README.md").read_text()


def test_the_example_runs(tmp_path: Path) -> None:
    make_tiny_package(tmp_path / "tiny.rna")
    (code,) = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    code, count = re.subn(
        r'load\("helmet\.rna".*?\)', f"load({str(tmp_path / 'tiny.rna')!r})", code
    )
    assert count == 1
    names: dict[str, object] = {}
    exec(code, names)
    radiance = names["radiance"]
    assert isinstance(radiance, np.ndarray)
    assert radiance.shape == names["points"].shape and np.isfinite(radiance).all()


def test_its_commands_exist() -> None:
    scripts = tomllib.loads((REPOSITORY / "pyproject.toml").read_text())["project"]["scripts"]
    commands = set(re.findall(r"\brna-[a-z]+\b", README)) - {"rna-sdk"}
    assert commands <= set(scripts)


@pytest.mark.parametrize("page", ["README.md", "CONTRIBUTING.md", *map(str, PAGES)])
def test_links_lead_somewhere(page: str) -> None:
    path = REPOSITORY / page
    links = re.findall(r"\]\((?!https?:)([^)#]+)", path.read_text())
    assert [link for link in links if not (path.parent / link).exists()] == []
