"""The files of the kit: made in memory, written, compared with those that are there."""

import hashlib
import json
import os
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from rna_sdk.conformance.kit import LEVELS, VERSION
from rna_sdk.package import Mesh
from tests.conformance.kit.answers import Answers
from tests.conformance.kit.assets import Query, write_asset
from tests.conformance.kit.base_color import BaseColorHits, make_base_color_hits
from tests.conformance.kit.broken import broken_packages
from tests.conformance.kit.deformed import SHAPES, DeformedHits, make_deformed_hits
from tests.conformance.kit.hits import make_hits
from tests.conformance.kit.normals import NormalHits, make_normal_hits
from tests.conformance.kit.plans import LEAST, PLANS, Plan
from tests.conformance.kit.restored import PLAIN, restored

INDEX = "kit.json"
BY_HAND = {"README.md"}
INT8_SHARE = 0.02  # of the rows of an int8 decoder may differ by a step
VISIBILITY_TOLERANCE = 1e-3
ROUNDED = (
    *("expected/", "blocks/", "queries/", "visibility/", "normals/", "base-color/"),
    *("geometry/", "deformed/"),
)

Files = dict[str, bytes]


def kit_files() -> Files:
    """Path below the kit -> content."""
    files: Files = {}
    index: dict[str, Any] = {"version": VERSION, "int8Share": INT8_SHARE}
    index |= {"visibilityTolerance": VISIBILITY_TOLERANCE}
    index |= {level: [] for level in LEVELS}
    with tempfile.TemporaryDirectory() as folder:
        for plan in PLANS:
            answers = write_asset(plan, Path(folder))
            package = f"packages/{plan.name}.rna"
            files[package] = (Path(folder) / f"{plan.name}.rna").read_bytes()
            for query, answer in answers.items():
                if query.tier == LEAST.name:  # of packages for other levels
                    continue
                level = _level(plan, query)
                index[level].append(_evaluate_case(files, plan, package, query, answer))
            index["validate"].append(_validate_case(package, True, plan.warning))
            if plan.counts_nearby:  # which readers without it refuse
                continue
            index["visibility"].append(_visibility_case(files, plan, package))
            index["normals"] += _normals_cases(files, plan, package)
            index["base-color"] += _base_color_cases(files, plan, package)
            index["geometry"] += _geometry_cases(files, plan, package)
            index["deformed"] += _deformed_cases(files, plan, package)
        for name, broken in broken_packages(Path(folder)).items():
            path = f"broken/{name}.rna"
            files[path] = broken.data
            case = _validate_case(path, broken.is_valid, broken.code, broken.extension)
            index["validate"].append(case)
    index["files"] = {
        name: {"size": len(data), "sha256": hashlib.sha256(data).hexdigest()}
        for name, data in sorted(files.items())
    }
    return {**files, INDEX: (_json(index) + "\n").encode()}


def _level(plan: Plan, query: Query) -> str:
    if query.output == "environment":
        return query.output
    return "nearby" if plan.counts_nearby else "evaluate"


def _evaluate_case(
    files: Files, plan: Plan, package: str, query: Query, answers: Answers
) -> dict[str, Any]:
    form = "" if query.output == "transport" else f".{query.output}"
    name = f"{plan.name}.{query.tier}.{query.part}{form}"
    paths = {
        "queries": f"queries/{name}.f32",
        "blocks": f"blocks/{name}.f32",
        "expected": f"expected/{name}.f64",
    }
    files[paths["queries"]] = answers.queries.astype("<f4").tobytes()
    files[paths["blocks"]] = answers.blocks.astype("<f4").tobytes()
    both = np.concatenate([answers.expected, answers.tolerance], axis=1)
    files[paths["expected"]] = both.astype("<f8").tobytes()
    return {
        "package": package,
        "tier": query.tier,
        "part": query.part,
        "output": query.output,
        "what": plan.what,
        **paths,
        "rows": len(answers.queries),
        "columns": answers.blocks.shape[1],
        "scale": answers.scale,
        "step": answers.step,
        "classes": _classes(answers.classes),
    }


def _visibility_case(files: Files, plan: Plan, package: str) -> dict[str, Any]:
    names = [part.name for part in plan.parts]
    bodies = [part.body() for part in plan.parts]
    records, seen, classes = make_hits(len(plan.name), names, bodies)
    paths = {"hits": f"hits/{plan.name}.bin", "expected": f"visibility/{plan.name}.f32"}
    files[paths["hits"]] = records
    files[paths["expected"]] = seen.astype("<f4").tobytes()
    return {
        "package": package,
        "what": plan.what,
        **paths,
        "rows": len(seen),
        "classes": _classes(classes),
    }


def _normals_cases(files: Files, plan: Plan, package: str) -> list[dict[str, Any]]:
    """One of each part with normal maps."""
    cases = []
    for number, part in enumerate(plan.parts):
        if part.maps and isinstance(part.geometry, Mesh):
            maps = [record for _, record in part.maps]
            made = make_normal_hits(len(plan.name), number, part.geometry, maps)
            cases.append(_hits_case(files, plan, package, number, "normals", made))
    return cases


def _base_color_cases(files: Files, plan: Plan, package: str) -> list[dict[str, Any]]:
    """One of each part with images of base colour."""
    cases = []
    for number, part in enumerate(plan.parts):
        colors = [record for _, record in part.colors]
        if any(one.image is not None for one in colors) and isinstance(part.geometry, Mesh):
            made = make_base_color_hits(len(plan.name), number, part.geometry, colors)
            cases.append(_hits_case(files, plan, package, number, "base-color", made))
    return cases


def _geometry_cases(files: Files, plan: Plan, package: str) -> list[dict[str, Any]]:
    """One of each part whose geometry is in integers, and of PLAIN."""
    cases = []
    for number, part in enumerate(plan.parts):
        if part.geometry.quantised is not None or plan.name in PLAIN:
            rows, tolerance = restored(part.geometry)
            made = rows, tolerance, [("all", 0, len(rows))]
            cases.append(_part_case(files, plan, package, number, "geometry", *made))
    return cases


def _deformed_cases(files: Files, plan: Plan, package: str) -> list[dict[str, Any]]:
    """One of each part that has a deformed shape."""
    cases = []
    for number, part in enumerate(plan.parts):
        if deform := SHAPES.get((plan.name, number)):
            made = make_deformed_hits(len(plan.name), number, part.geometry, deform)
            case = _hits_case(files, plan, package, number, "deformed", made)
            case["shape"] = f"hits/{plan.name}.{number}.shape.f32"
            files[case["shape"]] = made.shape.astype("<f4").tobytes()
            cases.append(case)
    return cases


def _hits_case(
    files: Files,
    plan: Plan,
    package: str,
    part: int,
    level: str,
    made: NormalHits | BaseColorHits | DeformedHits,
) -> dict[str, Any]:
    answers = made.expected, made.tolerance, made.classes
    case = _part_case(files, plan, package, part, level, *answers)
    case["hits"] = f"hits/{plan.name}.{part}.{level}.bin"
    files[case["hits"]] = made.records
    return case


def _part_case(
    files: Files,
    plan: Plan,
    package: str,
    part: int,
    level: str,
    expected: np.ndarray,
    tolerance: np.ndarray,
    classes: list[tuple[str, int, int]],
) -> dict[str, Any]:
    path = f"{level}/{plan.name}.{part}.f64"
    files[path] = np.concatenate([expected, tolerance], axis=1).astype("<f8").tobytes()
    case = {"package": package, "part": part, "what": plan.what, "expected": path}
    return case | {"rows": len(expected), "classes": _classes(classes)}


def _validate_case(
    package: str, valid: bool, code: str | None, extension: str | None = None
) -> dict[str, Any]:
    return {"package": package, "valid": valid, "code": code, "extension": extension}


def _classes(ranges: list[tuple[str, int, int]]) -> list[dict[str, Any]]:
    return [{"name": name, "first": first, "rows": rows} for name, first, rows in ranges]


def _json(index: dict[str, Any]) -> str:
    """One line a case, a class and a file."""
    parts = []
    for key, value in index.items():
        if isinstance(value, list):
            lines = ",\n".join("    " + json.dumps(item) for item in value)
            parts.append(f'  "{key}": [\n{lines}\n  ]')
        elif isinstance(value, dict):
            lines = ",\n".join(f"    {json.dumps(k)}: {json.dumps(v)}" for k, v in value.items())
            parts.append(f'  "{key}": {{\n{lines}\n  }}')
        else:
            parts.append(f'  "{key}": {json.dumps(value)}')
    return "{\n" + ",\n".join(parts) + "\n}"


def write_files(folder: Path, files: Files) -> None:
    """Write the kit to `folder`; files of an older kit are removed."""
    for path in _present(folder) - set(files):
        (folder / path).unlink()
    for name, data in files.items():
        target = folder / name
        target.parent.mkdir(parents=True, exist_ok=True)
        temporary = target.with_name(f".{target.name}.{os.getpid()}.partial")
        temporary.write_bytes(data)
        os.replace(temporary, target)


def differences(folder: Path, files: Files) -> list[str]:
    """A line for each file that is missing, too much or other than in `files`.

    What float64 libraries round in their own ways may differ in its last bits: expected values,
    the blocks, and what the index says of them.
    """
    present = _present(folder)
    lines = [f"{name}: missing" for name in sorted(set(files) - present)]
    lines += [f"{name}: not of the kit" for name in sorted(present - set(files))]
    for name in sorted(present & set(files)):
        actual, expected = (folder / name).read_bytes(), files[name]
        if actual != expected and not _alike(name, actual, expected):
            lines.append(f"{name}: stale; run python -m tests.conformance.kit")
    return lines


def _present(folder: Path) -> set[str]:
    files = (path for path in folder.rglob("*") if path.is_file())
    return {path.relative_to(folder).as_posix() for path in files} - BY_HAND


def _alike(name: str, actual: bytes, expected: bytes) -> bool:
    if name == INDEX:
        return _same_index(json.loads(actual), json.loads(expected))
    if len(actual) != len(expected) or not name.startswith(ROUNDED):
        return False
    dtype, close = ("<f8", 1e-6) if name.endswith("f64") else ("<f4", 1e-6)
    pair = (np.frombuffer(data, dtype) for data in (actual, expected))
    return np.allclose(*pair, rtol=close, atol=close * 1e-3, equal_nan=True)


def _same_index(actual: Any, expected: Any) -> bool:
    if isinstance(expected, dict):
        keys = set(expected) - {"sha256"}
        same = set(actual) - {"sha256"} == keys
        return same and all(_same_index(actual[key], expected[key]) for key in keys)
    if isinstance(expected, list):
        same = len(actual) == len(expected)
        return same and all(_same_index(a, b) for a, b in zip(actual, expected, strict=True))
    if isinstance(expected, float):
        return bool(np.isclose(actual, expected, rtol=1e-6))
    return bool(actual == expected)
