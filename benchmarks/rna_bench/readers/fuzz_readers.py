"""Readers of packages, as `rna-bench fuzz` runs them: each takes numbered mutations."""

from __future__ import annotations

import json
import shutil
import signal
import struct
import subprocess
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package import Curves, Mesh, Package, Planes, Severity
from rna_sdk.package.issues import Code
from rna_sdk.package.validator import inspect
from rna_sdk.runtime.normal_maps import mapped_normals
from rna_sdk.runtime.transmittance_lookup import transmittance

SLOW_SECONDS = 20
WEB_READER = Path(__file__).parents[3] / "runtime" / "web" / "src" / "package"
_NODE_PROGRAM = Path(__file__).parent / "fuzz_viewer.mjs"
_HITS = 4
_NOT_OF_THE_C_HOST = {"EXTENSION_REQUIRED", "EXTENSION_UNKNOWN"}
"""Codes where the C host has not looked at what the extension holds."""


@dataclass
class Tally:
    """What became of some mutations.

    Attributes:
        refused: by the first error's code.
        failures: "SEED: what happened", for what no reader may do.
        disagreements: "python: CODES, C: CODES" -> seeds, where one accepts and one refuses.
    """

    mutations: int = 0
    accepted: int = 0
    refused: Counter[str] = field(default_factory=Counter)
    failures: list[str] = field(default_factory=list)
    disagreements: dict[str, list[int]] = field(default_factory=dict)

    def add(self, other: Tally) -> None:
        self.mutations += other.mutations
        self.accepted += other.accepted
        self.refused.update(other.refused)
        self.failures += other.failures
        for codes, seeds in other.disagreements.items():
            self.disagreements.setdefault(codes, []).extend(seeds)


@dataclass(frozen=True)
class Mutations:
    """Numbered mutations of packages.

    Attributes:
        programs: folder of the C host's `fuzz` and `mutations`.
        packages: good ones; mutation k is of package number k mod their count.
    """

    programs: Path
    packages: list[Path]

    def command(self, program: str, first: int, count: int) -> list[str]:
        return [str(self.programs / program), str(first), str(count), *map(str, self.packages)]

    def each(self, first: int, count: int) -> Iterator[tuple[int, bytes]]:
        """(seed, bytes) of `count` mutations from `first` on."""
        command = self.command("mutations", first, count)
        with subprocess.Popen(command, stdout=subprocess.PIPE) as process:
            assert process.stdout is not None
            for seed in range(first, first + count):
                (size,) = struct.unpack("<I", process.stdout.read(4))
                yield seed, process.stdout.read(size)


Reader = Callable[[Mutations, int, int, Path], Tally]
"""(mutations, first, count, folder for files on the way) -> tally."""


def run_c_host(mutations: Mutations, first: int, count: int, folder: Path) -> Tally:
    """Through the C host under AddressSanitizer and UBSan, which evaluates what it accepts."""
    command = mutations.command("fuzz", first, count)
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode:
        text = f"{first} to {first + count}: {result.stderr[-3000:]}"
        return Tally(mutations=count, failures=[text])
    found = json.loads(result.stdout)
    return Tally(found["mutations"], found["accepted"], Counter(found["refused"]))


def run_viewer(mutations: Mutations, first: int, count: int, folder: Path) -> Tally:
    """Through the reader of the viewer's page, in Node."""
    node = shutil.which("node") or "node"
    command = [node, str(_NODE_PROGRAM), str(WEB_READER)]
    with subprocess.Popen(
        mutations.command("mutations", first, count), stdout=subprocess.PIPE
    ) as source:
        result = subprocess.run(command, stdin=source.stdout, capture_output=True, text=True)
    if result.returncode:
        text = f"{first} to {first + count}: {result.stderr[-3000:]}"
        return Tally(mutations=count, failures=[text])
    found = json.loads(result.stdout)
    failures = [f"{first + number}: {text}" for number, text in found["failures"]]
    return Tally(found["mutations"], found["accepted"], Counter(found["refused"]), failures)


def run_python(mutations: Mutations, first: int, count: int, folder: Path) -> Tally:
    """Through the validator and all that `Package` reads; compares verdicts with the C host."""
    said = _verdicts_of_c_host(mutations, first, count, folder)
    tally, path = Tally(), folder / "mutation.rna"
    for seed, data in mutations.each(first, count):
        path.unlink(missing_ok=True)  # what is mapped stays as it is
        path.write_bytes(data)
        tally.mutations += 1
        try:
            with _time_limit():
                codes = _codes(path)
        except Exception as error:
            tally.failures.append(f"{seed}: {error!r}"[:300])
            continue
        errors = [code for code in codes if Code[code].severity is Severity.ERROR]
        tally.accepted += not errors
        tally.refused.update(errors[:1])
        other = said.get(seed)
        if other is None or _NOT_OF_THE_C_HOST.intersection(other):
            continue
        if _accepts(codes) != _accepts(other):
            key = f"python: {' '.join(codes) or 'valid'}, C: {' '.join(other) or 'valid'}"
            tally.disagreements.setdefault(key, []).append(seed)
    return tally


READERS: dict[str, Reader] = {"c-host": run_c_host, "python": run_python, "viewer": run_viewer}


def _codes(path: Path) -> list[str]:
    """Codes of the validator; a package without errors is read whole."""
    result = inspect(path)
    if not result.errors and result.container is not None and result.manifest is not None:
        with Package(result.container, result.manifest) as package:
            read_everything(package)
    return [issue.code for issue in result.issues]


def read_everything(package: Package) -> None:
    """Read all of a valid package, and look up its textures.

    Raises:
        ValueError, IndexError: an index, a range or a size does not fit.
    """
    for k in range(len(package.manifest.parts)):
        for pixels in (np.inf, *package.proxy_heights(k)):
            _check_geometry(package.geometry(k, pixels))
        geometry = package.geometry(k)
        if isinstance(geometry, Mesh):
            _look_up(package, k, geometry)
        for tier in package.manifest.tiers:
            part = tier.parts[k]
            _check_planes(package.planes(tier.name, k), part.resolution, part.channels)
            for own in part.decoders:
                package.decoder(tier.name, k, own.form.name)
    package.poster()


def _check_geometry(geometry: Mesh | Curves) -> None:
    if isinstance(geometry, Mesh):
        points, right = geometry.positions, geometry.positions.shape == geometry.normals.shape
        right &= bool(geometry.triangles.max() < len(points))
    else:
        points = geometry.points
        right = len(points) == len(geometry.radii) == geometry.offsets[-1]
    if not (right and np.isfinite(points).all()):
        raise ValueError("geometry whose arrays do not fit")


def _look_up(package: Package, part: int, mesh: Mesh) -> None:
    """Transmittance and normals at the first and the last triangle of each record."""
    u, v = np.array([[0, 1, 0.25, 0.75], [1, 0, 0.5, 0.125]], np.float32)
    down = np.tile(np.array([0, 0, 1], np.float32), (_HITS, 1))
    holes, maps = package.transmittance(part), package.normal_maps(part)
    for hole in holes:
        transmittance(mesh, holes, _ends(hole.first, hole.count, mesh), u, v, down)
    for normal_map in maps:
        mapped_normals(mesh, maps, _ends(normal_map.first, normal_map.count, mesh), u, v)


def _ends(first: int, count: int, mesh: Mesh) -> NDArray[np.int64]:
    """(_HITS,) the first and the last triangle of a record, by turns."""
    if not 0 < count <= len(mesh.triangles) - first:
        raise ValueError("a record past the mesh")
    return np.array([first, first + count - 1] * (_HITS // 2))


def _check_planes(planes: Planes, resolution: int, channels: int) -> None:
    texels = planes if isinstance(planes, np.ndarray) else planes.texels
    if texels.shape != (3, resolution, resolution, channels):
        raise ValueError("planes of another shape")


def _accepts(codes: list[str]) -> bool:
    return all(Code[code].severity is not Severity.ERROR for code in codes)


def _verdicts_of_c_host(
    mutations: Mutations, first: int, count: int, folder: Path
) -> dict[int, list[str]]:
    """Seed -> codes; none where the program ended at a report."""
    path = folder / "verdicts.txt"
    command = [*mutations.command("fuzz", first, count), "--verdicts", str(path)]
    if subprocess.run(command, capture_output=True).returncode:
        return {}
    lines = (line.split() for line in path.read_text().splitlines())
    return {int(line[0]): line[1:] for line in lines}


@contextmanager
def _time_limit() -> Iterator[None]:
    """Raises TimeoutError in what takes too long."""
    before = signal.signal(signal.SIGALRM, _too_slow)
    signal.alarm(SLOW_SECONDS)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)


def _too_slow(*_: object) -> None:
    raise TimeoutError(f"more than {SLOW_SECONDS} s")
