"""Tutorials and examples: the Python of "Choose a tier" prints what it says; all commands parse.

"Choose a tier" runs in a folder with a small stand-in for its toy.rna that has the page's records.
The commands of all tutorials (lines indented by four spaces) are parsed by the command's own
parser, not run: tests/test_road.py runs them, shortened. tests/test_own_host.py runs the Python of
"Your own host".
"""

import contextlib
import io
import re
import shlex
from importlib import import_module
from pathlib import Path

import pytest

from rna_bench.cli import parser_of
from rna_bench.commands import COMMANDS
from rna_sdk.commands.console import split_script_arguments
from rna_sdk.package import Cost, FlipAtHeight, Tier, Validation
from tests.conftest import REPOSITORY
from tests.package.builders import make_tier, make_tiny_package

TIERS = REPOSITORY / "docs" / "choosing-a-tier.md"
PAGES = [
    "docs/first-asset.md",
    "docs/first-hair.md",
    "examples/quickstart/README.md",
    "examples/fibers/README.md",
    "examples/jade/README.md",
    "examples/scene/README.md",
    "docs/your-own-host.md",
    "docs/choosing-a-tier.md",
    "docs/frontier.md",
]
PARSERS = {
    "rna-run": "rna_render.command.rna_run:_parser",
    "rna-capture": "rna_export.capture.rna_capture:parser",
    "rna-train": "rna_export.training.rna_train:parser",
    "rna-export": "rna_export.export.rna_export:parser",
    "rna-make": "rna_export.make.rna_make:parser",
    "rna-motion": "rna_export.motion.rna_motion:parser",
    "rna-compare": "rna_export.compare.rna_compare:parser",
    "rna-view": "rna_view.rna_view_command:_parser",
    "rna-info": "rna_sdk.package.command.rna_info:parser",
}
RECORDS = {
    "small": ("float32", 24320, 40.12, (0.08413, 0.07496, 0.06383, 0.05890)),
    "hq-int8": ("int8", 240256, 40.57, (0.0773, 0.0685, 0.0576, 0.0527)),
}
"""The page's package: decoder, multiply-adds, dB, FLIP at 160, 80, 40 and 20 pixels."""


def record(name: str) -> Tier:
    decoder, multiply_adds, psnr, flips = RECORDS[name]
    heights = zip((160, 80, 40, 20), flips, strict=True)
    validation = Validation(
        psnr=psnr,
        flip=flips[0],
        relative_mse=0.1,
        images=8,
        definition="the page's",
        flip_at_height=tuple(FlipAtHeight(height=h, flip=flip) for h, flip in heights),
    )
    cost = Cost(multiply_adds=multiply_adds, ns_per_query=1.0, threads=1, machine="made up")
    return make_tier(name, validation=validation, cost=cost, decoder_precision=decoder)


def commands(page: str) -> list[str]:
    """The commands of a page's indented blocks, continued lines joined."""
    text = re.sub(r"```.*?```", "", (REPOSITORY / page).read_text(), flags=re.DOTALL)
    return re.findall(r"^    (rna-.*)$", re.sub(r" \\\n +", " ", text), re.MULTILINE)


def test_choosing_a_tier_prints_what_it_says(tmp_path, monkeypatch):
    make_tiny_package(tmp_path / "toy.rna", *map(record, RECORDS))
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    blocks = re.findall(r"```python\n(.*?)```\n\n```text\n(.*?)```", TIERS.read_text(), re.DOTALL)
    assert len(blocks) == TIERS.read_text().count("```python") >= 4
    for code, expected in blocks:
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            exec(code, names)
        assert printed.getvalue() == expected


@pytest.mark.parametrize(
    "command", [pytest.param(c, id=f"{p}: {c[:40]}") for p in PAGES for c in commands(p)]
)
def test_commands_are_good_usage(command):
    name, *arguments = shlex.split(command)
    if name == "rna-bench":
        parser = parser_of(COMMANDS[arguments.pop(0)])
    else:
        module, function = PARSERS[name].split(":")
        parser = getattr(import_module(module), function)()
    assert parser.parse_args(split_script_arguments(arguments)[0])
    for path in (Path(a) for a in arguments if a.startswith("examples/")):
        assert (REPOSITORY / path).exists(), path
