"""Every command of `rna-bench`: its name and the module that measures."""

from __future__ import annotations

import ast
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path


@dataclass(frozen=True)
class Command:
    """One measurement.

    module: its docstring is the help, first line first; it has `add_options(parser)` and
    `run(args)`, and is imported when the command is chosen. resumes: whether a stopped run goes on
    where it was. extra: of the distribution, which the module needs.
    """

    name: str
    module: str
    resumes: bool = False
    extra: str = "bench"

    @property
    def sentence(self) -> str:
        """First line of the module's docstring: what it measures. Read without an import."""
        spec = find_spec(f"rna_bench.{self.module}")
        assert spec is not None and spec.origin is not None, self.module
        docstring = ast.get_docstring(ast.parse(Path(spec.origin).read_text()))
        assert docstring, self.module
        return docstring.splitlines()[0]


GROUPS: dict[str, tuple[Command, ...]] = {
    "an asset": (
        Command("scenes", "scenes.scenes_command", resumes=True),
        Command("gain", "accuracy.gain_command"),
        Command("frontier", "frontier.frontier_command", resumes=True),
        Command("stability", "stability.stability_command", resumes=True),
        Command("frontier-chart", "frontier.redraw"),
        Command("time-to-flip", "scenes.time_to_flip"),
        Command("threads", "scenes.thread_counts"),
        Command("film", "scenes.film_command", resumes=True),
        Command("peers", "peers.peers_command", resumes=True),
        Command("peers-data", "peers.views_command", resumes=True),
    ),
    "speed of queries": (
        Command("evaluate", "speed.evaluate"),
        Command("evaluate-against", "speed.evaluate_against"),
        Command("cores", "speed.cores"),
        Command("command-threads", "speed.command_threads"),
        Command("motion", "speed.motion"),
        Command("c-host", "speed.c_host_speed"),
        Command("gpu", "speed.gpu", extra="gpu"),
    ),
    "accuracy": (
        Command("presets", "accuracy.preset_scores", resumes=True),
        Command("int8-tiers", "accuracy.int8_tiers"),
        Command("strand-error", "accuracy.strand_error"),
        Command("emission", "accuracy.emission_scenes"),
        Command("lobes", "lobes.lobes_command"),
        Command("poses", "accuracy.poses"),
        Command("lobes-scenes", "lobes.lobes_scenes"),
    ),
    "readers and files": (
        Command("readers", "readers.reader_agreement"),
        Command("fuzz", "readers.fuzz"),
        Command("fuzz-scenes", "readers.fuzz_scenes"),
        Command("package-bytes", "packages.sizes"),
    ),
    "hosts": (
        Command("preview", "hosts.preview"),
        Command("viewer", "hosts.viewer", extra="gpu"),
        Command("first-look", "hosts.first_look"),
        Command("three", "hosts.three_memory"),
        Command("mitsuba", "hosts.mitsuba", extra="mitsuba"),
        Command("blender", "hosts.blender"),
    ),
    "clusters": (
        Command("cluster-rate", "cluster.rate", extra="cluster"),
        Command("cluster-scale", "cluster.scale", extra="cluster"),
    ),
}
"""What is measured -> its commands."""

COMMANDS = {command.name: command for group in GROUPS.values() for command in group}
