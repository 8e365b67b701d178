"""The spec's generated files are current, its lists complete, and its worked example right."""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import jsonschema
import numpy as np

from rna_sdk.package import INPUT_BLOCKS, Code
from rna_sdk.package.manifest.schema import manifest_schema

REPOSITORY = Path(__file__).parents[2]
SPEC = REPOSITORY / "spec"
TEXT = (SPEC / "RNA.md").read_text(encoding="utf-8")
OF_CARRIERS = (SPEC / "RNA_relightable_asset.md").read_text(encoding="utf-8")


GENERATE = [str(REPOSITORY / "scripts" / "generate")]


def generate(*arguments: str) -> subprocess.CompletedProcess[str]:
    environment = os.environ | {"PYTHON": sys.executable}
    command = [*GENERATE, *arguments]
    return subprocess.run(command, capture_output=True, text=True, env=environment)


def test_generated_files_are_current():
    checked = generate("--check")
    assert checked.returncode == 0, checked.stdout + checked.stderr


def test_generated_files_are_written_and_checked(tmp_path):
    assert generate("--root", str(tmp_path)).returncode == 0
    written = [path for path in tmp_path.rglob("*") if path.is_file()]
    assert len(written) == 17
    for path in written:
        text = path.read_text(encoding="utf-8")
        assert text == (REPOSITORY / path.relative_to(tmp_path)).read_text(encoding="utf-8")
        path.write_text(text + "\n", encoding="utf-8")
    stale = generate("--root", str(tmp_path), "--check")
    assert stale.returncode == 1
    assert stale.stdout.count(" is stale: run python -m ") == len(written)


def test_schema_accepts_a_good_manifest_only(entries, fiber_entries):
    schema = json.loads(manifest_schema())
    validator = jsonschema.Draft202012Validator(schema)
    validator.check_schema(schema)
    manifest = json.loads(entries["manifest.json"])
    assert validator.is_valid(manifest)
    assert validator.is_valid(json.loads(fiber_entries["manifest.json"]))
    for field in ("format", "entries", "tiers", "license"):
        broken = {key: value for key, value in manifest.items() if key != field}
        assert not validator.is_valid(broken), field
    assert not validator.is_valid({**manifest, "novel": 1})


def test_spec_names_every_code_and_block():
    for code in Code:
        text = OF_CARRIERS if code.name.startswith("GLB_") else TEXT
        assert f"`{code.name}`" in text, code.name
    for block, width in INPUT_BLOCKS.items():
        assert f"| `{block}` | {'C' if width is None else width} |" in TEXT, block


def bilinear(plane: np.ndarray, u: float, v: float) -> np.ndarray:
    """The spec's interpolation, written from its text."""
    size = plane.shape[0]
    s, t = (float(np.clip(p * size - 0.5, 0, size - 1)) for p in (u, v))
    i, j = min(int(s), size - 2), min(int(t), size - 2)
    a, b = s - i, t - j
    low = (1 - a) * plane[j, i] + a * plane[j, i + 1]
    high = (1 - a) * plane[j + 1, i] + a * plane[j + 1, i + 1]
    return (1 - b) * low + b * high


def test_worked_example_of_the_planes():
    planes = np.zeros((3, 4, 4, 1))
    k, row, column = np.meshgrid(range(3), range(4), range(4), indexing="ij")
    planes[..., 0] = 100 * k + 10 * row + column
    low, high, x = np.array([-1, 0, 2]), np.array([1, 4, 4]), np.array([0, 1, 3.9])
    p = (x - low) / (high - low)
    parts = [bilinear(planes[i], *p[list(uv)]) for i, uv in enumerate([(0, 1), (1, 2), (2, 0)])]
    values = [float(part[0]) for part in parts]
    np.testing.assert_allclose(values, [6.5, 130.5, 218.0])
    assert "6.5 + 130.5 + 218 = 355" in TEXT


def test_worked_example_of_the_fiber_blocks():
    """By angles, while the runtime goes without."""
    t, wo, wi = np.array([0, 1, 0]), np.array([0.8, 0.6, 0]), np.array([0, -0.28, 0.96])
    s_o, s_i = t @ wo, t @ wi
    across_o, across_i = wo - s_o * t, wi - s_i * t
    phi = np.arctan2(t @ np.cross(across_o, across_i), across_o @ across_i)
    angles = [s_i, s_o, s_i + s_o, np.log2((s_i + s_o) ** 2 + 1e-3) / 6, np.cos(phi), np.sin(phi)]
    g_o, g_t = np.arcsin(0.5), np.arcsin(0.5 * 0.8 / np.sqrt(1.55**2 - s_o**2))
    lobes = [np.cos(phi - (2 * g_o - 2 * p * g_t - p * np.pi)) for p in range(3)]
    for block, values in (("fiber_angles", angles), ("fiber_lobes", lobes)):
        actual = re.search(rf"`{block}` is ((?:-?[\d.]+,?\s*)+)\.\n", TEXT)
        assert actual is not None
        np.testing.assert_allclose(np.fromstring(actual[1], sep=","), values, atol=5e-5)
