"""Mutants of short readers of the levels that no host in Python has, and of the validator.

    python -m tests.conformance.level_mutants [LEVEL...]

tries all, and writes what passes to level_mutants.json. The readers are the kit's own formulas; a
mutant of the validator leaves out one of its checks. How many pass for no reason is `MOST_MISSED`.
"""

import ast
import importlib
import json
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from rna_sdk.conformance.kit import Kit, ValidateCase, load_kit
from rna_sdk.conformance.scoring import cases, score
from rna_sdk.package import Curves, Package
from rna_sdk.package.container.zip_container import Container, read_file
from tests.conformance.conftest import KIT, InProcess
from tests.conformance.mutants import CAUGHT, Mutant, mutants_of
from tests.conftest import REPOSITORY
from tests.time_limit import time_limit

SECONDS = 120
RECORD = Path(__file__).with_name("level_mutants.json")
"""Level -> how many mutants there are, and the names of those that pass -> why they may, or ""."""
MOST_MISSED = 0.05
"""Share of the mutants of a level that may pass without a reason."""


@dataclass(frozen=True)
class Reader:
    """A level's reader in Python: modules that are mutated, and the functions of each that are.

    modules: by name; functions that make the kit's cases are left out, and those of `deformed`, of
    which mutants.py has a host. top: what has the answer.
    """

    modules: dict[str, tuple[str, ...]]
    top: str
    program: Callable[[ModuleType], InProcess]


def _visibility(module: ModuleType) -> InProcess:
    def answer(package: str, records: bytes) -> np.ndarray:
        words = np.frombuffer(records, "<u4").reshape(-1, 8)
        numbers = words.view("<f4").astype(np.float32)
        with Package.open(package) as opened:
            count = len(opened.manifest.parts)
            bodies = [
                module.Body(opened.geometry(k), tuple(opened.transmittance(k)))
                for k in range(count)
            ]
            result = np.empty((len(words), 3))
            for part in range(count):
                rows = words[:, 7] == part
                if isinstance(bodies[part].geometry, Curves):
                    hits = module.FiberHits(words[rows, 0], numbers[rows, 1:4], numbers[rows, 4:7])
                else:
                    place = numbers[rows, 1], numbers[rows, 2], numbers[rows, 3:6]
                    hits = module.MeshHits(words[rows, 0], *place)
                result[rows] = module.visibility(bodies, hits.rays(bodies, part))
        return np.float32(result)

    return InProcess(visibility=answer)


def _normals(module: ModuleType) -> InProcess:
    def answer(package: str, records: bytes) -> np.ndarray:
        words = np.frombuffer(records, "<u4").reshape(-1, 8)
        with Package.open(package) as opened:
            rows = []
            for word, (b1, b2) in zip(words, words.view("<f4")[:, 1:3].astype(float), strict=True):
                mesh, maps = opened.mesh(int(word[7])), opened.normal_maps(int(word[7]))
                b = np.array([1 - b1 - b2, b1, b2])
                rows.append(module.mapped_normal(mesh, maps, int(word[0]), b))
        return np.float32(rows)

    return InProcess(normals=answer)


def _base_color(module: ModuleType) -> InProcess:
    png = importlib.import_module("tests.conformance.kit.png")

    def answer(package: str, records: bytes) -> np.ndarray:
        words = np.frombuffer(records, "<u4").reshape(-1, 8)
        numbers = words.view("<f4").astype(float)
        container = Container.of(read_file(package), package)
        with Package.open(package) as opened:
            part = int(words[0, 7])
            mesh, colors = opened.mesh(part), []
            for record, stored in zip(
                opened.base_color(part), opened.manifest.parts[part].base_color, strict=True
            ):
                image = stored.image and png.decoded(bytes(container.view(stored.image)))
                colors.append(replace(record, image=image if stored.image else None))
        hits = [
            module.Hit(int(word[0]), *row[1:4]) for word, row in zip(words, numbers, strict=True)
        ]
        return np.float32([module.base_color(mesh, colors, hit) for hit in hits])

    return InProcess(base_color=answer)


def _deformed(module: ModuleType) -> InProcess:
    def answer(package: str, part: int, shape: np.ndarray, records: bytes) -> np.ndarray:
        words = np.frombuffer(records, "<u4").reshape(-1, 8)
        hits = module.Hits(words[:, 0].astype(int), words.view("<f4")[:, 1:6].astype(np.float32))
        with Package.open(package) as opened:
            return np.float32(module.at_rest(opened.geometry(part), shape, hits, lambda v: v))

    return InProcess(deformed=answer)


_KIT = "tests.conformance.kit"
READERS = {
    "visibility": Reader(
        {
            f"{_KIT}.visibility": (
                *("visibility", "extent", "MeshHits", "FiberHits", "strands"),
                *("_through_triangles", "_enters_strands"),
            ),
            f"{_KIT}.passing": ("tau", "_looked_up", "_fresnel"),
        },
        f"{_KIT}.visibility",
        _visibility,
    ),
    "normals": Reader(
        {f"{_KIT}.normals": ("mapped_normal", "_looked_up", "_unit")}, f"{_KIT}.normals", _normals
    ),
    "base-color": Reader(
        {
            f"{_KIT}.base_color": (
                *("base_color", "_filtered", "pyramid", "linear", "_narrowed", "_looked_up"),
                "_inside",
            ),
            f"{_KIT}.png": ("decoded", "_restored", "_unpacked", "_prediction"),
        },
        f"{_KIT}.base_color",
        _base_color,
    ),
    "deformed": Reader({f"{_KIT}.deformed": ()}, f"{_KIT}.deformed", _deformed),
    "environment": Reader(
        {
            "tests.reference.lobes": (
                *("lobes_reference", "mirror_reference", "visibility_reference"),
            )
        },
        "tests.conformance.twin_reader",
        lambda module: InProcess(environment=module.environment),
    ),
    "validate": Reader(
        {},
        "rna_sdk.conformance.reader",
        lambda module: InProcess(validate=module.check),
    ),
}


def mutants(level: str) -> list[Mutant]:
    if level == "validate":
        return list(_without_checks())
    made: list[Mutant] = []
    for name, functions in READERS[level].modules.items():
        source = source_of(name)

        def chosen(tree: ast.Module, functions: tuple[str, ...] = functions) -> list[ast.stmt]:
            return [s for s in tree.body if getattr(s, "name", "") in functions]

        made += mutants_of(name, source, chosen)
    return [one for one in made if not any(word in one.name for word in _NOT_OF_READERS)]


_NOT_OF_READERS = ("moves", "rounding", "Sequence[", "assert ", "rows[:", "rows = np.zeros(")
"""In lines of types, of tolerances and of the records of hits."""


def source_of(module: str) -> str:
    return Path(str(importlib.import_module(module).__file__)).read_text()


_NOT_OF_VALIDATORS = (
    *("writ", "generated", "schema.", "package.", "packing.", "exchanged_images."),
    *("block_formulas.", "languages.", "c_rules.", "carrier"),
)
"""Beginnings of files in which nothing is checked of a package that is read, but for the .glb about
one, which the kit has not."""


def _without_checks() -> Iterator[Mutant]:
    """The validator without one statement that refuses something, or notes an issue."""
    folder = REPOSITORY / "rna_sdk" / "package"
    for path in sorted(folder.rglob("*.py")):
        if "command" in path.parts or path.name.startswith(_NOT_OF_VALIDATORS):
            continue
        name = ".".join(path.relative_to(REPOSITORY).with_suffix("").parts)
        source = path.read_text()
        tree = ast.parse(source)
        for body in _bodies(tree):
            for k, statement in enumerate(body):
                if not _is_check(statement):
                    continue
                body[k] = ast.copy_location(ast.Pass(), statement)
                first = ast.unparse(statement).splitlines()[0]
                yield Mutant(name, f"{path.stem}.{statement.lineno}: {first}", ast.unparse(tree))
                body[k] = statement


def _bodies(tree: ast.AST) -> Iterator[list[ast.stmt]]:
    for node in ast.walk(tree):
        for member in ("body", "orelse", "finalbody"):
            value = getattr(node, member, None)
            if isinstance(value, list) and not isinstance(node, ast.Module | ast.ClassDef):
                yield value


def _is_check(statement: ast.stmt) -> bool:
    text = ast.unparse(statement)
    if isinstance(statement, ast.Raise):
        return statement.exc is not None
    simple = isinstance(statement, ast.Expr | ast.AugAssign | ast.Assign)
    return simple and ("refuse(" in text or "Issue.of(" in text) and "def " not in text


@contextmanager
def _mutated(level: str, mutant: Mutant) -> Iterator[InProcess]:
    """The level's reader with one module changed; the modules themselves stay as they are."""
    reader = READERS[level]
    group = {*reader.modules, reader.top, mutant.host}
    if level == "validate":
        prefixes = "rna_sdk.package", "rna_sdk.conformance.reader", "rna_sdk.files.atomic_file"
        group |= {name for name in sys.modules if name.startswith(prefixes)}
    saved = {name: sys.modules.pop(name) for name in group if name in sys.modules}
    try:
        module = ModuleType(mutant.host)
        module.__file__ = str(REPOSITORY / (mutant.host.replace(".", "/") + ".py"))
        sys.modules[mutant.host] = module
        exec(compile(mutant.source, mutant.host, "exec"), module.__dict__)
        yield reader.program(importlib.import_module(reader.top))
    finally:
        for name in [n for n in sys.modules if n in group or n in saved]:
            del sys.modules[name]
        sys.modules.update(saved)


def verdict(level: str, mutant: Mutant, kit: Kit) -> str:
    """CAUGHT, or "passes"."""
    try:
        with _mutated(level, mutant) as program, time_limit(SECONDS):
            passes = all(score(program, kit, case).passed for case in _ordered(level, mutant, kit))
    except Exception:
        return CAUGHT
    return "passes" if passes else CAUGHT


def _ordered(level: str, mutant: Mutant, kit: Kit) -> Sequence[Any]:
    """The cases, those first in which the mutant is likely to be wrong."""
    every = cases(kit, level)
    if level != "validate":
        return every
    likely = [c for c in every if isinstance(c, ValidateCase) and (c.code or "-") in mutant.name]
    others = [case for case in every if case not in likely]
    return [*likely, *others]


def main(levels: Sequence[str]) -> int:
    kit = load_kit(KIT)
    record = json.loads(RECORD.read_text()) if RECORD.exists() else {}
    for level in levels or READERS:
        known, passed = record.get(level, {}).get("passed", {}), {}
        if not (every := mutants(level)):
            continue
        for mutant in every:
            if verdict(level, mutant, kit) != CAUGHT:
                passed[mutant.name] = known.get(mutant.name, "")
                print(f"{level}: {mutant.name}: passes", flush=True)
        record[level] = {"mutants": len(every), "passed": passed}
        RECORD.write_text(json.dumps(record, indent=1) + "\n")
        missed = sum(not why for why in passed.values())
        print(f"{level}: {len(every)} mutants, {missed} pass without a reason", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
