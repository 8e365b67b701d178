"""Find the package in a hostile binary glTF: spec/RNA_relightable_asset.md."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, TypeGuard

from rna_sdk.package.container.glb_chunks import CHUNK, CHUNK_BIN, CHUNK_JSON, HEADER, MAGIC
from rna_sdk.package.container.strict_json import parse_object, pointer
from rna_sdk.package.issues import Code, Issue, refuse
from rna_sdk.package.limits import ALIGNMENT, MAX_CARRIER_JSON_BYTES

EXTENSION = "RNA_relightable_asset"
MIME_TYPE = "model/vnd.rna"

_INSTANCING = "EXT_mesh_gpu_instancing"
_PLACE = "an offset and a length inside the binary chunk"


@dataclass(frozen=True)
class Carrier:
    """A binary glTF and the one package that it carries.

    Attributes:
        document: its JSON.
        nodes: numbers of the nodes that carry the package.
        package: the package's bytes in the file.
    """

    document: dict[str, Any]
    nodes: tuple[int, ...]
    package: slice

    @property
    def instances(self) -> int:
        """How often the file shows the package."""
        return sum(map(self._instances, self.nodes))

    def facts(self) -> dict[str, Any]:
        """The package's number of instances in the file, and its fallback: JSON's types alone."""
        below = [node for number in self.nodes for node in self._fallback(number)]
        record = _members(self.document["nodes"][self.nodes[0]]["extensions"], EXTENSION)
        flip = record.get("fallbackFlip")
        return {
            "instances": self.instances,
            "fallback_meshes": len({str(node["mesh"]) for node in below if "mesh" in node}),
            "fallback_skinned": any("skin" in node for node in below),
            "fallback_flip": flip if _is_share(flip) else None,
        }

    def warnings(self) -> Iterator[Issue]:
        """Faults of the file beside the package."""
        listed = (self.document.get(f"extensions{use}") for use in ("Used", "Required"))
        used, required = (isinstance(names, list) and EXTENSION in names for names in listed)
        if not used or required:
            found = f"used: {used}, required: {required}"
            expected = f"{EXTENSION} used and not required"
            yield Issue.of(Code.GLB_DECLARATION, "/extensionsUsed", found, expected)
        for number in self.nodes:
            below = self._fallback(number)
            if not any("mesh" in node for node in below):
                found = "no mesh at the node, and none below it"
                yield Issue.of(Code.GLB_FALLBACK, pointer("nodes", number), found, "a fallback")
            if any(_record(node) is not None for node in below[1:]):
                found, expected = "a package below another one's node", "nodes beside each other"
                yield Issue.of(Code.GLB_FALLBACK, pointer("nodes", number), found, expected)

    def _instances(self, number: int) -> int:
        """Instances of a node: 1, or the items of its attributes; 0 if they are malformed."""
        data = _members(_members(self.document["nodes"][number], "extensions"), _INSTANCING)
        counts = [
            accessor.get("count")
            for index in _members(data, "attributes").values()
            if (accessor := _item(self.document, "accessors", index)) is not None
        ]
        return next((n for n in counts if isinstance(n, int)), 0) if data else 1

    def _fallback(self, number: int) -> list[dict[str, Any]]:
        """A node and its descendants, each once."""
        found: dict[int, dict[str, Any]] = {}
        pending: list[object] = [number]
        while pending:
            index = pending.pop()
            node = _item(self.document, "nodes", index)
            if node is not None and isinstance(index, int) and index not in found:
                found[index] = node
                children = node.get("children")
                pending += children if isinstance(children, list) else []
        return list(found.values())


def is_glb(data: memoryview) -> bool:
    """Whether a file begins as a binary glTF does."""
    return bytes(data[:4]) == MAGIC


def read_carrier(data: memoryview) -> Carrier:
    """The package of a binary glTF. The package itself is not read.

    Raises:
        PackageError: the first GLB_* or JSON_* issue found.
    """
    document, blob = split_carrier(data)
    nodes = document.get("nodes", [])
    if not isinstance(nodes, list):
        refuse(Code.GLB_CONTAINER, "/nodes", type(nodes).__name__, "an array")
    records = {i: record for i, node in enumerate(nodes) if (record := _record(node)) is not None}
    packages = {i: _view_number(i, record) for i, record in records.items()}
    if not packages:
        refuse(Code.GLB_NO_PACKAGE, "/nodes", "an ordinary glTF", f"a node with {EXTENSION}")
    first, *others = dict.fromkeys(packages.values())
    if others:
        expected = "one package, or several nodes that name one buffer view"
        refuse(Code.GLB_SEVERAL, "/nodes", f"{1 + len(others)} packages", expected)
    return Carrier(document, tuple(packages), _span(document, first, blob))


def split_carrier(data: memoryview) -> tuple[dict[str, Any], slice]:
    """The JSON of a binary glTF, and the bytes of its binary chunk; an empty slice without one.

    Raises:
        PackageError: GLB_CONTAINER, or a JSON_* issue.
    """
    if len(data) < HEADER.size + CHUNK.size:
        refuse(Code.GLB_CONTAINER, 0, f"{len(data)} bytes", "a header and a JSON chunk")
    header = HEADER.unpack_from(data)
    if header != (MAGIC, 2, len(data)):
        found = f"version {header[1]}, {header[2]} bytes"
        refuse(Code.GLB_CONTAINER, 0, found, f"version 2, the file's {len(data)} bytes")
    json_chunk, behind = _chunk(data, HEADER.size, CHUNK_JSON)
    size = json_chunk.stop - json_chunk.start
    if size > MAX_CARRIER_JSON_BYTES:
        expected = f"at most {MAX_CARRIER_JSON_BYTES}"
        refuse(Code.GLB_CONTAINER, HEADER.size, f"JSON of {size} bytes", expected)
    document = parse_object(bytes(data[json_chunk]), "JSON chunk", Code.GLB_CONTAINER)
    if behind == len(data):
        return document, slice(behind, behind)
    return document, _chunk(data, behind, CHUNK_BIN)[0]


def _chunk(data: memoryview, start: int, kind: bytes) -> tuple[slice, int]:
    """The bytes of the chunk at `start`, and where the next one is."""
    if start + CHUNK.size > len(data):
        refuse(Code.GLB_CONTAINER, start, "a chunk cut short", "a chunk")
    size, found = CHUNK.unpack_from(data, start)
    end = start + CHUNK.size + size
    if found != kind or end > len(data):
        seen = f"{found!r} of {size} bytes"
        refuse(Code.GLB_CONTAINER, start, seen, f"{kind!r} that ends within the file")
    return slice(start + CHUNK.size, end), end


def _record(node: object) -> object:
    """The extension of a node; None if it has none."""
    extensions = node.get("extensions") if isinstance(node, dict) else None
    return extensions.get(EXTENSION) if isinstance(extensions, dict) else None


def _view_number(node: int, record: object) -> int:
    """The buffer view that a node's extension names."""
    where = pointer("nodes", node, "extensions", EXTENSION)
    if not isinstance(record, dict):
        refuse(Code.GLB_PACKAGE, where, type(record).__name__, "an object")
    if record.get("mimeType") != MIME_TYPE:
        refuse(Code.GLB_PACKAGE, f"{where}/mimeType", record.get("mimeType"), MIME_TYPE)
    number = record.get("package")
    if not _is_size(number):
        refuse(Code.GLB_PACKAGE, f"{where}/package", repr(number), "a buffer view's number")
    return number


def _span(document: dict[str, Any], number: int, blob: slice) -> slice:
    """The bytes of a buffer view in the file, which are aligned."""
    view, where = _item(document, "bufferViews", number), pointer("bufferViews", number)
    if view is None:
        refuse(Code.GLB_PACKAGE, where, "no such buffer view", "an existing one")
    buffer = _item(document, "buffers", 0)
    named = view.get("buffer")
    if not _is_size(named) or named or buffer is None or "uri" in buffer:
        refuse(Code.GLB_PACKAGE, f"{where}/buffer", named, "the binary chunk, 0")
    start, size = view.get("byteOffset", 0), view.get("byteLength")
    sizes = _is_size(start) and _is_size(size)
    if not (sizes and size and start + size <= blob.stop - blob.start):
        found = f"{size} bytes at {start} of {blob.stop - blob.start}"
        refuse(Code.GLB_PACKAGE, where, found, _PLACE)
    place = blob.start + start
    if place % ALIGNMENT:
        expected = f"a multiple of {ALIGNMENT}"
        refuse(Code.GLB_ALIGNMENT, where, f"byte {place} of the file", expected)
    return slice(place, place + size)


def _is_size(value: object) -> TypeGuard[int]:
    return isinstance(value, int) and not isinstance(value, bool) and value >= 0


def _is_share(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and 0 <= value <= 1


def _item(document: dict[str, Any], name: str, number: object) -> dict[str, Any] | None:
    """An object of one of the document's arrays; None where there is none."""
    items = document.get(name)
    if not isinstance(items, list) or not isinstance(number, int) or not 0 <= number < len(items):
        return None
    return items[number] if isinstance(items[number], dict) else None


def _members(parent: dict[str, Any], name: str) -> dict[str, Any]:
    """An object inside another one; empty where there is none."""
    value = parent.get(name)
    return value if isinstance(value, dict) else {}
