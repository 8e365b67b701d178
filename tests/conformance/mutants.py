"""Mutants of the hosts in Python: each caught by the conformance kit, or allowed by a clause.

    python -m tests.conformance.mutants         tries all, and writes mutants.json

A mutant is a host with one change: a number, an operator, a comparison, a function. It is caught
where a case of the kit fails, or it ends in an exception or not at all. What passes must be in
ALLOWED, with the clause of the format that allows it.
"""

import ast
import json
import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from rna_sdk.conformance.kit import Kit, load_kit
from rna_sdk.conformance.scoring import cases, score
from rna_sdk.package.decoder.query_arrays import NEARBY, in_order
from tests.conformance.conftest import HOSTS, KIT, InProcess, with_geometry
from tests.time_limit import time_limit

LEVELS = {"minimal.py": ("evaluate", "nearby"), "deformed.py": ("geometry", "deformed")}
"""File below examples/hosts -> levels that it has."""
SECONDS = 60
CAUGHT, FORBIDDEN = "caught", "passes, though the format forbids it"
RECORD = Path(__file__).with_name("mutants.json")
"""Name of a mutant -> CAUGHT, or why it passes."""

FIRST = ("surface-float32", "fiber-float16", "surface-int8", "parts-lantern")
"""Packages whose cases are tried first: between them nearly all that can go wrong."""

_AREA = "8.3: readers may differ up to 1e-4, and no triangle of the kit is thinner"

ALLOWED = {
    ("", "v / np.abs(v).max(axis=1, keepdims=True) -> v * np.abs(v).max(axis=1, keepdims=True)"): (
        "6.3: float64 holds the squares of all float32, divided or not"
    ),
    ("", "2 * g_o - 2 * k * g_t - k * np.pi -> 2 * g_o - 2 * k * g_t + k * np.pi"): (
        "6.3, fiber_lobes: the same angle, a turn further"
    ),
    ("size, total = planes.shape[1]", ": 1 -> 2"): "5: planes are as high as wide",
    ("s, t = (np.clip", "size - 1 -> size + 1"): "5: the edge repeats",
    ("np.pad(f, ((0, 0), (0, 3)))", ": 3 -> 4"): "6.3, learned_normal: three features are taken",
    ("length(bent) < 1e-6", "1e-06 -> 1.5e-06"): "6.3, learned_normal: float32 turns such a q",
    ("length(bent) < 1e-6", "1e-06 -> 9.999999999999999e-05"): "6.3, learned_normal: likewise",
    ("np.rint", "np.rint(x / scale) + zero -> np.rint(x / scale) - zero"): "6.2: zero points are 0",
    ("(q - zero) * scale", "q - zero -> q + zero"): "6.2: zero points are 0",
    (
        "return np.zeros((len(x), 3))",
        ": 3 -> 4",
    ): "the kit asks for no emission where there is none",
    ("c = 1e-9 * np.eye(3)", ""): "8.3: any small share of the identity decides",
    ("far, kind", "13 -> 14"): "8.3: the host chooses which strands are near",
    ("across, longest =", "np.maximum -> np.minimum"): _AREA,
    ("longest**2", "longest ** 2 -> longest * 2"): _AREA,
    ("longest**2", "2 -> 3"): _AREA,
    ("longest**2", "1e-06 -> 1.5e-06"): _AREA,
    ("longest**2", "1e-06 -> 9.999999999999999e-05"): _AREA,
    ("longest**2", "1e-06 -> 1e-08"): "8.3: a triangle as thin has no rotation in float32",
    ("unit(across)]", "unit(across) -> np.array(across)"): "8.3: R is the same",
    ("p[:, 2] - p[:, 0]", ": 0 -> 1"): "8.3: two edges tell the gradient, whichever they are",
    ("for step in (0, 1, 2)", "k + step -> k - step"): "8.3: an angle has no direction",
    ('node["scale"][0]', "0 -> 1"): "4.1: the three are equal",
    ("np.arccos(np.clip", "1 -> 2"): "arguments of arccos are clipped against rounding alone",
    (".reshape(", ": 1 -> 2"): "numpy takes any negative number for -1",
    ("np.where(length(v) > 0, length(v), 1)", "1 -> 2"): "0 over any number is 0",
    ('words.view("<f4")[:, 1:6]', "6 -> 7"): "a column more is not looked at",
}
"""Part of the line and end of the name of mutants that pass, and why."""

_OPERATORS: dict[type, type] = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.Div: ast.Mult,
    ast.MatMult: ast.Mult,
    ast.Pow: ast.Mult,
    ast.BitAnd: ast.BitOr,
    ast.BitOr: ast.BitAnd,
    ast.LShift: ast.RShift,
    ast.RShift: ast.LShift,
    ast.Lt: ast.GtE,
    ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq,
    ast.In: ast.NotIn,
    ast.Is: ast.IsNot,
    ast.USub: ast.UAdd,
}
_FUNCTIONS = {
    "minimum": "maximum",
    "maximum": "minimum",
    "cos": "sin",
    "sin": "cos",
    "arcsin": "sin",
    "sqrt": "square",
    "log2": "log",
    "rint": "trunc",
    "all": "any",
    "any": "all",
}


@dataclass(frozen=True)
class Mutant:
    """A change of a host, by what it is, and the source with it."""

    host: str
    name: str
    source: str


def source_of(host: str) -> str:
    return (HOSTS / host).read_text()


def mutants(host: str) -> list[Mutant]:
    """All mutants of a program but of its last statement, the command line."""
    return mutants_of(host, source_of(host), lambda tree: tree.body[:-1])


def mutants_of(
    host: str, source: str, chosen: Callable[[ast.Module], Sequence[ast.stmt]]
) -> list[Mutant]:
    """All mutants of a source. host: its name; chosen: the statements that are changed."""
    tree, lines = ast.parse(source), source.splitlines()
    pieces = [ast.unparse(statement) for statement in tree.body]
    places = {statement: k for k, statement in enumerate(tree.body)}
    within = {n: places[piece] for piece in chosen(tree) for n in ast.walk(piece)}
    result = {}
    for node in ast.walk(tree):
        if node not in within or not hasattr(node, "lineno"):
            continue
        number = within[node]
        for values in list(_changes(node)):
            before, old = ast.unparse(node), {key: getattr(node, key) for key in values}
            _put(node, values)
            after, changed = ast.unparse(node), ast.unparse(tree.body[number])
            _put(node, old)
            line = lines[node.lineno - 1].strip()
            name = f"{host}:{node.lineno}:{node.col_offset} in {line}: {before} -> {after}"
            if changed != pieces[number]:
                whole = [*pieces[:number], changed, *pieces[number + 1 :]]
                result[name] = Mutant(host, name, "\n".join(whole))
    return list(result.values())


def _put(node: ast.AST, values: dict[str, Any]) -> None:
    for key, value in values.items():
        setattr(node, key, value)


def _changes(node: ast.AST) -> Iterator[dict[str, Any]]:
    """Values of the node's fields, one change after the other."""
    if isinstance(node, ast.Constant) and type(node.value) in (int, float):
        yield {"value": node.value + 1 if isinstance(node.value, int) else node.value * 1.5}
        if isinstance(node.value, float) and node.value < 0.01:  # thresholds
            yield {"value": node.value * 100}
            yield {"value": node.value / 100}
    if other := _OPERATORS.get(type(getattr(node, "op", None))):
        yield {"op": other()}
    if isinstance(node, ast.Compare) and (other := _OPERATORS.get(type(node.ops[0]))):
        yield {"ops": [other(), *node.ops[1:]]}
    if isinstance(node, ast.Attribute) and node.attr in _FUNCTIONS:
        yield {"attr": _FUNCTIONS[node.attr]}
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "unit":
        yield {"func": ast.Name("abs", ast.Load())}
        yield {"func": ast.Name("np.array", ast.Load())}


def reason(mutant: Mutant) -> str:
    """Why the format allows it; "" where it does not."""
    name = mutant.name
    return next((ALLOWED[at, end] for at, end in ALLOWED if at in name and name.endswith(end)), "")


def verdict(mutant: Mutant, kit: Kit) -> str:
    """CAUGHT, or "passes"."""
    host, levels = ModuleType("mutant"), LEVELS[mutant.host]
    try:
        exec(compile(mutant.source, mutant.name, "exec"), host.__dict__)
        program = _evaluates(host) if "evaluate" in levels else with_geometry(host)
        with time_limit(SECONDS):
            every = [case for level in levels for case in cases(kit, level)]
            order = sorted(every, key=lambda case: case.package.stem not in FIRST)
            passes = all(score(program, kit, case).passed for case in order)
    except Exception:
        return CAUGHT
    return "passes" if passes else CAUGHT


def _evaluates(host: ModuleType) -> InProcess:
    def evaluate(
        form: str, package: str, tier: str, part: int, arrays: dict[str, np.ndarray]
    ) -> np.ndarray:
        x, axis, h, wo, wi = (rows.astype(float) for rows in in_order(arrays))
        at = package, tier, part, x, axis, h if len(h) else np.zeros(len(x)), wo
        if form == "emission":
            return np.float32(host.emission(*at))
        base_color = np.asarray(arrays.get("base_color", np.ones(x.shape)), float)
        factors = base_color, arrays.get(NEARBY.name)
        return np.float32(host.evaluate(*at, wi, *factors))

    return InProcess(evaluate, nearby=evaluate)


def main() -> int:
    kit, verdicts = load_kit(KIT), {}
    for mutant in (mutant for host in LEVELS for mutant in mutants(host)):
        verdicts[mutant.name] = verdict(mutant, kit)
        if verdicts[mutant.name] != CAUGHT:
            verdicts[mutant.name] = reason(mutant) or FORBIDDEN
            print(f"{mutant.name}: {verdicts[mutant.name]}", flush=True)
    RECORD.write_text(json.dumps(verdicts, indent=1) + "\n")
    forbidden = list(verdicts.values()).count(FORBIDDEN)
    print(f"{len(verdicts)} mutants, {forbidden} pass that the format forbids")
    return int(forbidden > 0)


if __name__ == "__main__":
    sys.exit(main())
