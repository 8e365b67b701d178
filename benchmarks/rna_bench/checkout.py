"""Where the repository is: benchmarks run from a checkout, beside its examples and tests."""

from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TOY = ROOT / "examples" / "quickstart" / "toy.rna"
QUICKSTART = ROOT / "examples" / "quickstart" / "scene.yaml"
