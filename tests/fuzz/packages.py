"""Mutated packages through the readers, which may refuse them, but not crash.

    python -m tests.fuzz.packages --reader c-host --first 0 --count 100000

Mutations by number of small packages with all that the format has: parts, textures, normal maps,
base colour, emission, quantised geometry, proxies, coded entries. Readers:

- `c-host`: the C host under AddressSanitizer and UBSan, each entry in a block of its own size; it
  evaluates and traces what it accepts. Needs `cc`;
- `python`: the validator and all that a package reads; verdicts are compared with the C host's;
- `viewer`: the reader of the viewer's page, in Node.
"""

import argparse
import json
import struct
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package import Curves, Mesh, Package, Planes, Severity
from rna_sdk.package.issues import Code
from rna_sdk.package.validator import inspect
from rna_sdk.runtime.base_color import BaseColorMaps
from rna_sdk.runtime.normal_maps import mapped_normals
from rna_sdk.runtime.transmittance_lookup import transmittance
from tests.conftest import REPOSITORY
from tests.fuzz.package_mutations import mutation
from tests.hosts.c_host import SOURCES
from tests.hosts.packages import write_fuzz_packages
from tests.time_limit import time_limit

SLOW_SECONDS = 20
BATCH = 1000
HERE = Path(__file__).parent
WEB_READER = REPOSITORY / "runtime" / "web" / "src" / "package"
C_FLAGS = [
    *("-std=c11", "-fno-math-errno", "-ffp-contract=off", "-g", "-O1"),
    *("-fsanitize=address,undefined", "-fno-sanitize-recover=all"),
    *("-DRNA_EXACT_ENTRIES", "-D_POSIX_C_SOURCE=200809L"),  # each entry in a block of its own size
]
_HITS = 4
_MOST_TEXELS = 2**18  # of images that are looked up, for the time
_NOT_OF_THE_C_HOST = {"EXTENSION_REQUIRED", "EXTENSION_UNKNOWN"}
"""Codes where the C host has not looked into the extension."""


@dataclass
class Tally:
    """What became of some mutations.

    Attributes:
        refused: by the first error's code.
        failures: "NUMBER: what happened", for what no reader may do.
        disagreements: "python: CODES, C: CODES" -> numbers, where one accepts and one refuses.
    """

    accepted: int = 0
    refused: Counter[str] = field(default_factory=Counter)
    failures: list[str] = field(default_factory=list)
    disagreements: dict[str, list[int]] = field(default_factory=dict)

    def judge(self, codes: list[str]) -> None:
        errors = [code for code in codes if not _accepts([code])]
        self.accepted += not errors
        self.refused.update(errors[:1])


@dataclass(frozen=True)
class Mutations:
    """Mutations `first` to `first + count` of good packages."""

    packages: list[Path]
    first: int
    count: int

    def each(self) -> Iterator[tuple[int, bytes]]:
        for number in range(self.first, self.first + self.count):
            yield number, mutation(self.packages, number)

    def stream(self) -> bytes:
        """All of them, each behind its size in four bytes."""
        return stream(data for _, data in self.each())


def stream(packages: Iterable[bytes]) -> bytes:
    """The packages, each behind its size in four bytes."""
    return b"".join(struct.pack("<I", len(data)) + data for data in packages)


def build(folder: Path, sources: Path = SOURCES) -> Path:
    """The program of c_host.c with the C host of a folder."""
    program = folder / "c_host"
    files = [HERE / "c_host.c", *(sources / f"{name}.c" for name in ("rna", "trace", "png"))]
    command = ["cc", *C_FLAGS, f"-I{sources}", *map(str, files), "-o", str(program), "-lm"]
    subprocess.run(command, check=True, capture_output=True)
    return program


def run_c_host(mutations: Mutations, folder: Path) -> Tally:
    """Through the C host, whose program is built into the folder where it is not there."""
    tally, (verdicts, error) = Tally(), _of_c_host(mutations, folder)
    for codes in verdicts:
        tally.judge(codes)
    if error:
        tally.failures.append(f"{mutations.first + len(verdicts)}: {error[-3000:]}")
    return tally


def _of_c_host(mutations: Mutations, folder: Path) -> tuple[list[list[str]], str]:
    """Codes of each mutation as far as the program came, and the error that it ended with."""
    program = folder / "c_host"
    if not program.is_file():
        build(folder)
    done = subprocess.run([program], input=mutations.stream(), capture_output=True)
    error = done.stderr.decode(errors="replace") if done.returncode else ""
    return [line.split() for line in done.stdout.decode().splitlines()], error


def run_viewer(mutations: Mutations, folder: Path) -> Tally:
    """Through the reader of the viewer's page, in Node."""
    actual, tally = viewer_verdicts(mutations.stream()), Tally()
    for verdict in actual["verdicts"]:
        tally.accepted += verdict == "accepted"
        tally.refused.update([verdict] if verdict not in ("accepted", "failed") else [])
    tally.failures = [f"{mutations.first + k}: {text}" for k, text in actual["failures"]]
    return tally


def viewer_verdicts(packages: bytes) -> dict[str, list]:
    """What viewer.mjs says of a stream of packages."""
    command = ["node", str(HERE / "viewer.mjs"), str(WEB_READER)]
    done = subprocess.run(command, input=packages, stdout=subprocess.PIPE, check=True)
    return json.loads(done.stdout)


def run_python(mutations: Mutations, folder: Path) -> Tally:
    """Through the validator and all that `Package` reads; compares verdicts with the C host's."""
    said, tally, path = _verdicts_of_c_host(mutations, folder), Tally(), folder / "mutation.rna"
    for number, data in mutations.each():
        path.unlink(missing_ok=True)  # what is mapped stays as it is
        path.write_bytes(data)
        try:
            with time_limit(SLOW_SECONDS):
                codes = _codes(path)
        except Exception as error:
            tally.failures.append(f"{number}: {error!r}"[:300])
            continue
        tally.judge(codes)
        other = said.get(number)
        if other is None or _NOT_OF_THE_C_HOST.intersection(other):
            continue
        if codes == ["BASE_COLOR_IMAGE"] and _accepts(other):
            continue  # an image whose header alone is right
        if _accepts(codes) != _accepts(other):
            key = f"python: {' '.join(codes) or 'valid'}, C: {' '.join(other) or 'valid'}"
            tally.disagreements.setdefault(key, []).append(number)
    return tally


Reader = Callable[[Mutations, Path], Tally]
"""(mutations, folder for files on the way) -> tally."""

READERS: dict[str, Reader] = {"c-host": run_c_host, "python": run_python, "viewer": run_viewer}


def _verdicts_of_c_host(mutations: Mutations, folder: Path) -> dict[int, list[str]]:
    """Number -> codes."""
    return dict(enumerate(_of_c_host(mutations, folder)[0], mutations.first))


def _accepts(codes: list[str]) -> bool:
    return all(Code[code].severity is not Severity.ERROR for code in codes)


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
            for decoder in part.decoders:
                package.decoder(tier.name, k, decoder.form.name)
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
    """Transmittance, normals and base colour at the first and the last triangle of each record."""
    u, v = np.array([[0, 1, 0.25, 0.75], [1, 0, 0.5, 0.125]], np.float32)
    down = np.tile(np.array([0, 0, 1], np.float32), (_HITS, 1))
    holes, maps, colors = (
        *(package.transmittance(part), package.normal_maps(part)),
        package.base_color(part),
    )
    for hole in holes:
        transmittance(mesh, holes, _ends(hole.first, hole.count, mesh), u, v, down)
    for normal_map in maps:
        mapped_normals(mesh, maps, _ends(normal_map.first, normal_map.count, mesh), u, v)
    if sum(color.image is not None and color.image.size > _MOST_TEXELS for color in colors):
        return
    for color in colors:
        looked_up = BaseColorMaps(mesh, colors).at(
            _ends(color.first, color.count, mesh), u, v, 0.01
        )
        if not (
            np.isfinite(looked_up).all() and looked_up.min() >= 0.0 and looked_up.max() <= 1.0001
        ):
            raise ValueError("base colours that are not from 0 to 1")


def _ends(first: int, count: int, mesh: Mesh) -> NDArray[np.int64]:
    """(_HITS,) the first and the last triangle of a record, by turns."""
    if not 0 < count <= len(mesh.triangles) - first:
        raise ValueError("a record past the mesh")
    return np.array([first, first + count - 1] * (_HITS // 2))


def _check_planes(planes: Planes, resolution: int, channels: int) -> None:
    texels = planes if isinstance(planes, np.ndarray) else planes.texels
    if texels.shape != (3, resolution, resolution, channels):
        raise ValueError("planes of another shape")


def main() -> int:
    parser = argparse.ArgumentParser(
        "python -m tests.fuzz.packages", description=(__doc__ or "").splitlines()[0]
    )
    parser.add_argument("--reader", choices=READERS, default="c-host", help="what reads them")
    parser.add_argument("--first", type=int, default=0, help="number of the first mutation")
    parser.add_argument("--count", type=int, default=20_000, help="number of mutations")
    args = parser.parse_args()
    failed, end = 0, args.first + args.count
    with tempfile.TemporaryDirectory() as name:
        packages = write_fuzz_packages(Path(name))
        for first in range(args.first, end, BATCH):
            mutations = Mutations(packages, first, min(BATCH, end - first))
            tally = READERS[args.reader](mutations, Path(name))
            failed += len(tally.failures) + len(tally.disagreements)
            print(first, tally, flush=True)
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
