"""Makes an environment of the SDK: run by Blender's Python, standard library alone.

    python environment_setup.py FOLDER SDK EXTRAS [--blender]

FOLDER: of the environment. SDK: the folder with its sources. `--blender` gets Blender's module,
too, which captures need.
"""

import os
import subprocess
import sys
import venv
from pathlib import Path


def main():
    folder, sdk, extras, *more = sys.argv[1:]
    python = Path(folder) / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    done = Path(folder) / "installed"
    done.unlink(missing_ok=True)
    if not python.is_file():
        print(f"making {folder}", flush=True)
        venv.create(folder, with_pip=True)
    print(f"installing the SDK with [{extras}]: this takes a few minutes", flush=True)
    pip = ["-m", "pip", "install", "--disable-pip-version-check", "--progress-bar", "off"]
    pinned = ["--constraint", f"{sdk}/constraints.txt"] if sys.version_info[:2] == (3, 11) else []
    run(python, *pip, *pinned, f"{sdk}[{extras}]")
    if more:
        print("installing Blender's module, for captures", flush=True)
        run(python, "-m", "rna_export.capture.rna_capture", "--setup-blender")
    done.write_text(Path(sdk, "version").read_text())
    print(f"ready: {python}", flush=True)


def run(*command):
    status = subprocess.call([str(part) for part in command])
    if status:
        sys.exit(status)


if __name__ == "__main__":
    main()
