"""Runs in the SDK's Python: makes a package of a .blend file, then compares it with Cycles.

    python bake.py SOURCE.blend OUT.rna FOLDER OPTION...

Options are those of rna-make, whose rays and models stay in FOLDER/make. Stopped by SIGINT, the
same command continues. Cycles' pictures beside the package's go to FOLDER/compare.
"""

import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path


def main():
    source, out, folder, *options = sys.argv[1:]
    folder = Path(folder)
    check_can_bake()
    if not (folder / "made").is_file():
        run("rna_export.make.rna_make", source, "--out", out, "--work", folder / "make", *options)
        (folder / "made").touch()
    run(
        "rna_export.compare.rna_compare",
        out,
        source,
        "--out",
        folder / "compare",
        "--resolution",
        256,
        "--cycles-samples",
        64,
    )
    print("bake finished", flush=True)


def check_can_bake():
    """Ends with the button to press if this environment was set up for rendering alone."""
    if find_spec("torch") is None:
        button = "press Set Up for Baking, Too in the preferences of the extension"
        sys.exit(f"error: this environment of the SDK cannot bake: {button} (no PyTorch)")


def run(module, *arguments):
    """One of the SDK's commands; ends with its status if it fails."""
    command = [sys.executable, "-m", module, *map(str, arguments)]
    print(f"{module} {' '.join(command[3:])}", flush=True)
    status = subprocess.call(command)
    if status:
        sys.exit(status)


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit(130)
