"""WGSL files composed to one module.

The files in `wgsl/` hold one concept each; `wgsl/compositions.json` names what goes together. The
web viewer composes the same files in the same way: `wgsl/README.md`.
"""

import json
from functools import cache
from importlib.resources import files


@cache
def wgsl_file(name: str) -> str:
    """The text of a file in `wgsl/`."""
    return (files("rna_gpu") / "wgsl" / name).read_text("utf-8")


@cache
def composition(name: str) -> tuple[str, ...]:
    """The names of the files that make `name`, in order; render/ has compositions of its own."""
    place = "render/compositions.json" if name.startswith("render/") else "compositions.json"
    return tuple(file for part in json.loads(wgsl_file(place))[name] for file in _files(part))


def compose(constants: dict[str, int], *parts: str) -> str:
    """A module: one `const` line a constant, then the files; parts: files or compositions."""
    names = [file for part in parts for file in _files(part)]
    lines = [f"const {name}: u32 = {value}u;\n" for name, value in constants.items()]
    return "".join(lines) + "\n".join(wgsl_file(name) for name in dict.fromkeys(names))


def _files(part: str) -> tuple[str, ...]:
    return (part,) if part.endswith(".wgsl") else composition(part)
