"""Runs a source script with `--help`; exits with 1 if it builds its scene instead of printing it.

Arguments: the script, then `--help`.
"""

import os
import runpy
import sys
from pathlib import Path

sys.argv = sys.argv[1:]
sys.path.append(str(Path(sys.argv[0]).parent))
status = 1
try:
    runpy.run_path(sys.argv[0], run_name="__main__")
except SystemExit as end:
    status = 0 if end.code in (None, 0) else 1
sys.stdout.flush()
os._exit(status)  # bpy may crash while it unloads
