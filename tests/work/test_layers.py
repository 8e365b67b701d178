"""What `rna_work` imports, and that nothing imports Ray before it is asked for."""

import ast
import subprocess
import sys

from tests.conftest import REPOSITORY
from tests.test_commands import COMMANDS


def imports(path: object) -> set[str]:
    names = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            names.add(node.module)
    return names


def test_without_the_option_there_is_no_ray():
    """In a process that imports all commands, what they import late, and opens an executor."""
    steps = [
        "from rna_work.executors import open_executor; open_executor(None).__enter__()",
        "import rna_export.capture.capture_run",
        "import rna_render.command.sequence, rna_render.command.pieces",
        "import rna_work.cluster.ray_cluster, rna_work.cluster.ray_slots",
        *(f"import {entry.partition(':')[0]}" for entry in COMMANDS.values()),
    ]
    program = "import sys\n" + "".join(
        f"{step}\nif 'ray' in sys.modules: sys.exit({step!r})\n" for step in steps
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")


def test_where_ray_is_missing_a_line_says_how_to_get_it():
    program = (
        "import sys; sys.modules['ray'] = None\n"
        "from rna_render.command.rna_run import main; sys.exit(main(sys.argv[1:]))"
    )
    scene = REPOSITORY / "examples" / "quickstart" / "scene.yaml"
    command = [sys.executable, "-c", program, scene, "--out", "a.exr", "--cluster", "auto"]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 1
    hint = "pip install -e '.[cluster]' in the clone of rna-sdk"
    assert done.stderr == f"error: --cluster needs Ray: {hint}\n"
