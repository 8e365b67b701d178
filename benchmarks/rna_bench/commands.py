"""Every command of `rna-bench`: its name and the module that measures."""

import ast
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path


@dataclass(frozen=True)
class Command:
    """One measurement.

    module: its docstring is the help, first line first; it has `add_options(parser)` and
    `run(args)`, and is imported when the command is chosen. resumes: whether a stopped run goes on
    where it was.
    """

    name: str
    module: str
    resumes: bool = False

    @property
    def sentence(self) -> str:
        """First line of the module's docstring, its subject. Read without an import."""
        spec = find_spec(f"rna_bench.{self.module}")
        assert spec is not None and spec.origin is not None, self.module
        docstring = ast.get_docstring(ast.parse(Path(spec.origin).read_text()))
        assert docstring, self.module
        return docstring.splitlines()[0]


COMMANDS = {
    command.name: command
    for command in (
        Command("scenes", "scenes.scenes_command", resumes=True),
        Command("time-to-flip", "scenes.time_to_flip"),
        Command("gain", "accuracy.gain_command"),
        Command("frontier", "frontier.frontier_command", resumes=True),
        Command("frontier-chart", "frontier.redraw"),
        Command("stability", "stability.stability_command", resumes=True),
        Command("peers", "peers.peers_command", resumes=True),
        Command("peers-data", "peers.views_command", resumes=True),
        Command("assets", "accuracy.assets_command"),
        Command("lobes", "accuracy.lobes_command"),
        Command("evaluate", "speed.evaluate"),
        Command("cores", "speed.cores"),
    )
}
