"""The mesh of a glTF 2.0 file in motion: nodes, morph targets and skins, at any time."""

import math
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from rna_render.materials.files.gltf_file import (
    corner_count,
    triangle_primitives,
    triangles_of,
    vertex_values,
)
from rna_render.materials.files.mesh_parts import check_mesh_size
from rna_render.motion.gltf_clip import Track, clip_names, duration, read_clip
from rna_render.scene.gltf_container import GltfContainer, open_gltf, reason_of
from rna_render.scene.gltf_nodes import local_matrix, roots
from rna_render.scene.limits import MAX_NUMBER
from rna_sdk.errors import MotionError, SceneError


@dataclass(frozen=True, slots=True, eq=False)
class _Piece:
    """A primitive of a node, at rest in its own space.

    positions: (v, 3) float64. targets: (k, v, 3), of its morph. weights: (k,), where nothing moves
    them. joints, shares: (v, j) of its skin, whose number is `skin`; None for none.
    """

    node: int
    positions: np.ndarray
    targets: np.ndarray
    weights: np.ndarray
    skin: int | None
    joints: np.ndarray
    shares: np.ndarray


class GltfMotion:
    """The triangles of a .gltf or .glb file while one of its animations plays.

    path: the file. clip: name of the animation; None for the first. rate: frames a second.

    Attributes:
        frames: how many there are from time 0 to the first at or after the last key.
        triangles: (t, 3) int64, of all the primitives' vertices.

    Raises MotionError where the file cannot be read or is not valid, or has no such animation.
    """

    def __init__(self, path: Path, clip: str | None = None, rate: float = 24.0) -> None:
        self.path, self.rate = path, rate
        with self._valid():
            self._container = open_gltf(path)
            self._tracks = self._read(clip)
            self.frames = math.ceil(duration(self._tracks) * rate - 1e-6) + 1

    def positions(self, frame: float) -> np.ndarray:
        """All vertices in the scene's space: (w, 3) float64. Raises MotionError as the class."""
        time = frame / self.rate
        with self._valid():
            moved = {(track.node, track.path): track.at(time) for track in self._tracks}
        return self._posed(moved)

    def rest_poses(self, captured: int | None = None) -> Iterator[np.ndarray]:
        """Poses that a package may have been made from, the likeliest first: (w, 3) each.

        As the nodes stand; without skins and morphs; the animation's start; the frame of Blender's
        at which the package was captured.
        """
        yield self._posed({})
        yield self._posed({}, bare=True)
        yield self.positions(0)
        if captured is not None:
            yield self.positions(self.rate * captured / 24.0)

    def _read(self, clip: str | None) -> list[Track]:
        container, names = self._container, clip_names(self._container)
        if not names:
            raise MotionError(f"{self.path}: has no animation")
        if clip is not None and clip not in names:
            raise MotionError(f"{self.path}: has no clip {clip!r}; it has {', '.join(names)}")
        self._nodes = container.json.get("nodes", [])
        skins = container.json.get("skins", [])
        self._order = list(_parents_first(container))
        shown = [(n, data) for n, _ in self._order for data in _primitives(container, n)]
        _check_size(container, skins, [data for _, data in shown])
        self._skins = [_skin(container, skin) for skin in skins]
        self._pieces = [_piece(container, self._skins, *item) for item in shown]
        starts = np.cumsum([0, *(len(piece.positions) for piece in self._pieces)])
        triangles = [
            triangles_of(container, data, len(piece.positions)) + start
            for (_, data), piece, start in zip(shown, self._pieces, starts[:-1], strict=True)
        ]
        if not any(map(len, triangles)):
            raise MotionError(f"{self.path}: has no triangles")
        self.triangles = np.concatenate(triangles)
        if not self.triangles.max() < starts[-1]:
            raise ValueError("a triangle names a vertex that is not there")
        return read_clip(container, 0 if clip is None else names.index(clip))

    @contextmanager
    def _valid(self) -> Iterator[None]:
        """MotionError for whatever a file that is not valid makes Python raise."""
        try:
            with np.errstate(all="ignore"):
                yield
        except (MotionError, SceneError, MemoryError):
            raise
        except OSError as error:
            raise MotionError(f"{self.path}: {error.strerror or error}") from error
        except Exception as error:
            raise MotionError(f"{self.path}: is no valid glTF file: {reason_of(error)}") from error

    def _posed(self, moved: dict[tuple[int, str], np.ndarray], bare: bool = False) -> np.ndarray:
        """The vertices with some properties of nodes moved. bare: no skins and morphs."""
        with self._valid():
            world = self._matrices(moved)
            parts = [self._posed_piece(piece, world, moved, bare) for piece in self._pieces]
            result = np.concatenate(parts)
            if not (np.abs(result) <= MAX_NUMBER).all():
                raise ValueError(f"positions that are not at most {MAX_NUMBER:g}")
            return result

    def _posed_piece(
        self,
        piece: _Piece,
        world: dict[int, np.ndarray],
        moved: dict[tuple[int, str], np.ndarray],
        bare: bool,
    ) -> np.ndarray:
        p = piece.positions
        if len(piece.targets) and not bare:
            weights = moved.get((piece.node, "weights"), piece.weights)[: len(piece.targets)]
            if len(weights) < len(piece.targets):
                raise ValueError(f"{len(weights)} weights for {len(piece.targets)} morph targets")
            p = p + np.einsum("k,kvc->vc", weights, piece.targets)
        if piece.skin is None or bare:
            matrix = world[piece.node]
            return np.asarray(p @ matrix[:3, :3].T + matrix[:3, 3])
        joints, inverse = self._skins[piece.skin]
        return _skinned(p, np.array([world[j] for j in joints]) @ inverse, piece)

    def _matrices(self, moved: dict[tuple[int, str], np.ndarray]) -> dict[int, np.ndarray]:
        world: dict[int, np.ndarray] = {}
        for number, parent in self._order:
            node = self._nodes[number]
            local_matrices = {
                path: value
                for path in ("translation", "rotation", "scale")
                if (value := moved.get((number, path))) is not None
            }
            if local_matrices:  # section 3.11: a node that is animated has no matrix
                node = {**{k: v for k, v in node.items() if k != "matrix"}, **local_matrices}
            local = local_matrix(node)
            world[number] = local if parent is None else world[parent] @ local
        return world


def _parents_first(container: GltfContainer) -> Iterator[tuple[int, int | None]]:
    """Each node of the scene and its parent, after that; joints outside the scene as well."""
    document, seen = container.json, set[int]()
    joints = [j for skin in document.get("skins", []) for j in skin["joints"]]
    parents = {
        c: k for k, node in enumerate(document.get("nodes", ())) for c in node.get("children", ())
    }

    def top(number: int) -> int:
        """The root above, or a node below the root above an earlier joint."""
        while number in parents:
            number = parents.pop(number)
        return number

    first = roots(container)
    stack: list[tuple[int, int | None]] = [(r, None) for r in (*first, *map(top, joints))]
    stack.reverse()
    while stack:
        number, parent = stack.pop()
        if number in seen and parent is not None:
            raise ValueError(f"node {number} is in its scene twice")
        if number not in seen:
            seen.add(number)
            yield number, parent
            stack += [
                (child, number)
                for child in reversed(container.item("nodes", number).get("children", ()))
            ]


def _primitives(container: GltfContainer, number: int) -> Iterable[dict[str, Any]]:
    """The primitives of a node that are triangles."""
    node = container.json["nodes"][number]
    return (
        triangle_primitives(container.json["meshes"][node["mesh"]], set()) if "mesh" in node else ()
    )


def _check_size(
    container: GltfContainer, skins: list[dict[str, Any]], primitives: list[dict[str, Any]]
) -> None:
    """Refuses, before reading it, a file that is too large with a copy for each node.

    Morph targets and influences of joints count as vertices, and a skin's matrices as four.
    """
    matrices = [s["inverseBindMatrices"] for s in skins if "inverseBindMatrices" in s]
    vertices, corners = 4 * sum(map(container.count, matrices)), 0
    for data in primitives:
        attributes = data["attributes"]
        copies = 1 + len(data.get("targets", ())) + sum(name[:6] == "JOINTS" for name in attributes)
        vertices += copies * container.count(attributes["POSITION"])
        corners += corner_count(container, data)
    check_mesh_size(vertices, corners // 3)


def _skin(container: GltfContainer, skin: dict[str, Any]) -> tuple[list[int], np.ndarray]:
    """Joints, and their inverse bind matrices (j, 4, 4)."""
    joints: list[int] = skin["joints"]
    if "inverseBindMatrices" not in skin:
        return joints, np.tile(np.eye(4), (len(joints), 1, 1))
    values = container.accessor(skin["inverseBindMatrices"])[: len(joints)].astype(np.float64)
    return joints, values.reshape(len(joints), 4, 4).transpose(0, 2, 1)


def _piece(
    container: GltfContainer,
    skins: list[tuple[list[int], np.ndarray]],
    number: int,
    data: dict[str, Any],
) -> _Piece:
    """A primitive of a node."""
    node = container.json["nodes"][number]
    mesh, attributes = container.json["meshes"][node["mesh"]], data["attributes"]
    shape = container.count(attributes["POSITION"]), 3
    positions = vertex_values(container, attributes["POSITION"], shape)
    targets = [
        vertex_values(container, target["POSITION"], shape)
        if "POSITION" in target
        else np.zeros(shape)
        for target in data.get("targets", ())
    ]
    weights = np.array(node.get("weights", mesh.get("weights", [0.0] * len(targets))), float)
    joints, shares = _influences(container, attributes, len(positions))
    skin = node.get("skin") if joints.size else None
    if skin is not None and not 0 <= joints.min() <= joints.max() < len(skins[skin][0]):
        raise ValueError(f"a vertex names a joint that is not one of {len(skins[skin][0])}")
    shaped = np.array(targets).reshape(len(targets), len(positions), 3)
    return _Piece(number, positions, shaped, weights, skin, joints, shares)


def _influences(
    container: GltfContainer, attributes: dict[str, int], count: int
) -> tuple[np.ndarray, np.ndarray]:
    """Joints and shares of each vertex, (v, 4 k), shares of sum 1; (v, 0) without a skin."""
    joints, shares = [np.zeros((count, 0), np.int64)], [np.zeros((count, 0))]
    while f"JOINTS_{(k := len(joints) - 1)}" in attributes:
        named = vertex_values(container, attributes[f"JOINTS_{k}"], (count, 4))
        joints.append(named.astype(np.int64))
        shares.append(vertex_values(container, attributes[f"WEIGHTS_{k}"], (count, 4)))
    share = np.concatenate(shares, axis=1)
    total = share.sum(axis=1, keepdims=True)
    return np.concatenate(joints, axis=1), share / np.where(total > 0, total, 1.0)


def _skinned(p: np.ndarray, bones: np.ndarray, piece: _Piece) -> np.ndarray:
    """Section 3.7.3.3: the mean of each vertex under the joints' matrices."""
    result = np.zeros_like(p)
    for k in range(piece.joints.shape[1]):
        matrices = bones[piece.joints[:, k]]
        turned = np.einsum("vij,vj->vi", matrices[:, :3, :3], p) + matrices[:, :3, 3]
        result += piece.shares[:, k : k + 1] * turned
    return result
