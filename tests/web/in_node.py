"""The web sources in Node, without a browser."""

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

from tests.conftest import REPOSITORY

SOURCES = REPOSITORY / "runtime" / "web" / "src"
ELEMENT_SOURCES = SOURCES / "element"


def in_node(program: str | Path, *arguments: object) -> Any:
    """The JSON that the text of a module, or a file, prints; without Node the test is skipped."""
    if shutil.which("node") is None:
        pytest.skip("needs Node")
    what = [program] if isinstance(program, Path) else ["--input-type=module", "-e", program]
    command = ["node", *map(str, [*what, *arguments])]
    done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=300)
    return json.loads(done.stdout)
