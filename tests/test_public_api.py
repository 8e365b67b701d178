"""Public names: what renderers may import of the SDK, and other packages of renderers.

Any other renderer has the same of the SDK, and the inside of a package can change alone.
"""

import ast
import importlib

import pytest

from tests.conftest import REPOSITORY

PUBLIC = {
    "rna_sdk",
    "rna_sdk.errors",
    "rna_sdk.motion",
    "rna_sdk.package",
    "rna_sdk.runtime",
    "rna_sdk.conformance.reader",
    "rna_sdk.conformance.reader_program",
}
"""Modules for everybody; of those with `__all__`, the names in it."""
OUR_TOOLS = {"rna_sdk.arrays"} | {
    f"rna_sdk.{path.parent.name}.{path.stem}"
    for room in ("commands", "files", "machine")
    for path in (REPOSITORY / "rna_sdk" / room).glob("*.py")
}
"""How our own commands check arrays, read, write, are compiled, threaded, and talk."""
OTHER_HALF = {
    "rna_render.lights",
    "rna_render.materials",
    "rna_render.paths.integrator_factory",
    "rna_render.paths.sampling",
    "rna_render.world.domain_watch",
}
"""What rna_gpu alone may import of the renderer, for the same lights, materials and paths."""
EXPORTED = {"rna_render.lights", "rna_render.materials", "rna_render.world.neural_sampling"}
"""Where the exporter measures lobes as renderers use them, with the brightest directions apart,
trains them along directions that paths would take, and fits the material of meshes."""
USERS = {
    "runtime/rna_gpu": OTHER_HALF,
    "runtime/rna_view": set(),
    "exporters/rna_export": EXPORTED,
    "benchmarks/rna_bench": set(),
}
RENDERERS = {"rna_trace": OUR_TOOLS, "rna_render": OUR_TOOLS, "rna_mitsuba": set()}


def imports(source: str) -> list[tuple[str, str]]:
    """(module, name) of each `from module import name`; name is "" of `import module`."""
    actual = []
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            actual += [(alias.name, "") for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.module:
            actual += [(node.module, alias.name) for alias in node.names]
    return actual


def strangers(source: str, tools: set[str]) -> list[str]:
    """Imports of the SDK that are no public names."""
    return private_names(source, {"rna_sdk"}, PUBLIC, tools)


def private_names(
    source: str, packages: set[str], public: set[str], excepted: set[str]
) -> list[str]:
    """Imports of the packages that are no public names, modules in `excepted` excepted."""
    wrong = []
    for module, name in imports(source):
        if module.split(".")[0] not in packages or module in excepted:
            continue
        names = getattr(importlib.import_module(module), "__all__", None)
        if module not in public or (names is not None and name not in names):
            wrong.append(f"{module}: {name}")
    return wrong


@pytest.mark.parametrize("renderer", RENDERERS)
def test_renderers_import_public_names_alone(renderer):
    files = sorted((REPOSITORY / "runtime" / renderer).rglob("*.py"))
    actual = {str(f): strangers(f.read_text(), RENDERERS[renderer]) for f in files}
    assert files and {file: names for file, names in actual.items() if names} == {}


@pytest.mark.parametrize("folder", USERS)
def test_other_packages_import_faces_of_renderers_alone(folder):
    public = {"rna_render", "rna_render.scene", "rna_trace"}
    files = sorted((REPOSITORY / folder).rglob("*.py"))
    actual = {
        str(f): private_names(f.read_text(), {"rna_render", "rna_trace"}, public, USERS[folder])
        for f in files
    }
    assert files and {file: names for file, names in actual.items() if names} == {}


@pytest.mark.parametrize("folder", USERS)
def test_no_exception_is_out_of_use(folder):
    files = sorted((REPOSITORY / folder).rglob("*.py"))
    assert USERS[folder] <= {module for f in files for module, _ in imports(f.read_text())}


@pytest.mark.parametrize("face", ["rna_render", "rna_render.scene", "rna_trace"])
def test_faces_are_small(face):
    assert len(importlib.import_module(face).__all__) <= 20


@pytest.mark.parametrize(
    "line",
    [
        "from rna_sdk.runtime.transforms import Transform",
        "from rna_sdk.package.manifest.extensions import Proxy",
        "from rna_sdk.package import Container",
        "import rna_sdk.package.manifest.manifest_model",
        "from rna_sdk.machine.compiled import compiled",
    ],
)
def test_other_imports_are_noticed(line):
    assert len(strangers(line, set())) == 1


@pytest.mark.parametrize(
    ("line", "count"),
    [
        ("from rna_render import World", 0),
        ("from rna_render.world.world import World", 1),
        ("from rna_render import integrator", 1),
        ("import rna_trace.embree.kernels", 1),
    ],
)
def test_insides_of_renderers_are_noticed(line, count):
    public = {"rna_render", "rna_trace"}
    assert len(private_names(line, public, public, set())) == count


def test_tests_of_the_product_need_no_benchmarks():
    """Except those of the pages that name commands of `rna-bench`."""
    own = [REPOSITORY / "tests" / name for name in ("bench", "frontier", "stability")]
    excepted = {"test_tutorials.py"}
    found = [
        str(path)
        for path in (REPOSITORY / "tests").rglob("*.py")
        if not any(map(path.is_relative_to, own)) and path.name not in excepted
        for module, _ in imports(path.read_text())
        if module.split(".")[0] == "rna_bench"
    ]
    assert found == []
