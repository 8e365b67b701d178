"""Run a command as on a CPU with AVX2 alone: python -m tests.avx2 COMMAND [ARGUMENTS].

    python -m tests.avx2 pytest tests/runtime
    python -m tests.avx2 rna-bench evaluate --precisions float32 int8 --out avx2.json

onnxruntime is made to see such a CPU (`masked.py`); numba, Embree, PyTorch and numpy have settings
for it.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

from tests.avx2.masked import make_avx2_onnxruntime, missing


def avx2_environment(folder: Path) -> dict[str, str]:
    """The environment of a Python process on such a CPU; `folder`: an empty one, kept meanwhile."""
    packages, cache = folder / "packages", folder / "cache" / "rna-sdk"
    packages.mkdir()
    cache.mkdir(parents=True)
    user_cache = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
    for blender in (user_cache / "rna-sdk").glob("blender-*"):
        (cache / blender.name).symlink_to(blender)
    paths = [str(make_avx2_onnxruntime(packages)), os.environ.get("PYTHONPATH", "")]
    return {
        **os.environ,
        "XDG_CACHE_HOME": str(cache.parent),  # costs of tiers are measured anew
        "PYTHONPATH": os.pathsep.join(filter(None, paths)),
        "NUMBA_CPU_NAME": "haswell",
        "NUMBA_CPU_FEATURES": "",
        "NUMBA_CACHE_DIR": str(folder / "numba"),
        "RNA_EMBREE_CONFIG": "isa=avx2",
        "OPENBLAS_CORETYPE": "Haswell",
        "ATEN_CPU_CAPABILITY": "avx2",
        "ONEDNN_MAX_CPU_ISA": "AVX2",
        "NPY_DISABLE_CPU_FEATURES": "X86_V4 AVX512_ICL AVX512_SPR",
    }


def main() -> int:
    if len(sys.argv) < 2:
        print(__doc__, file=sys.stderr)
        return 2
    if lacking := missing():
        print(f"error: {lacking}", file=sys.stderr)
        return 1
    with tempfile.TemporaryDirectory() as folder:
        environment = avx2_environment(Path(folder))
        beside = Path(sys.executable).parent
        environment["PATH"] = os.pathsep.join([str(beside), environment.get("PATH", "")])
        return subprocess.run(sys.argv[1:], env=environment).returncode


if __name__ == "__main__":
    sys.exit(main())
