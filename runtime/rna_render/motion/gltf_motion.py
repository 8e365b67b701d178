"""The mesh of a glTF 2.0 file in motion: nodes, morph targets and skins, at any time."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from rna_render.materials.files.gltf_container import GltfContainer, open_gltf
from rna_render.materials.files.gltf_file import (
    FAN,
    STRIP,
    TRIANGLES,
    local_matrix,
    roots,
    triangles_of,
)
from rna_render.motion.gltf_clip import Track, clip_names, duration, read_clip
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
        frames: how many there are from time 0 to the last key, both included.
        triangles: (t, 3) int64, of all the primitives' vertices.

    Raises MotionError where the file cannot be read or is not valid, or has no such animation.
    """

    def __init__(self, path: Path, clip: str | None = None, rate: float = 24.0) -> None:
        self.path, self.rate = path, rate
        try:
            self._container = open_gltf(path)
            self._tracks = self._read(clip)
        except (MotionError, SceneError):
            raise
        except OSError as error:
            raise MotionError(f"{path}: {error.strerror or error}") from error
        except Exception as error:  # whatever Python raises for a file that is not valid
            what = f"{type(error).__name__}: {error}"
            raise MotionError(f"{path}: is no valid glTF file: {what}") from error
        self.frames = int(duration(self._tracks) * rate + 1e-6) + 1

    def positions(self, frame: float) -> np.ndarray:
        """All vertices in the scene's space: (w, 3) float64. Raises MotionError if not finite."""
        time = frame / self.rate
        moved = {(track.node, track.path): track.at(time) for track in self._tracks}
        result = self._posed(moved)
        if not np.isfinite(result).all():
            raise MotionError(f"{self.path}: frame {frame:g} has positions that are not finite")
        return result

    def rest_poses(self, captured: int | None = None) -> Iterator[np.ndarray]:
        """Poses that a package may have been made from, the likeliest first: (w, 3) each.

        As the nodes stand; without skins and morphs; the animation's start, and 1/24 s later, where
        Blender's first frame is; the frame of Blender's at which the package was captured.
        """
        yield self._posed({})
        yield self._posed({}, bare=True)
        yield self.positions(0)
        yield self.positions(self.rate / 24.0)
        if captured is not None:
            yield self.positions(self.rate * captured / 24.0)

    def _read(self, clip: str | None) -> list[Track]:
        container, names = self._container, clip_names(self._container)
        if not names:
            raise MotionError(f"{self.path}: has no animation")
        if clip is not None and clip not in names:
            raise MotionError(f"{self.path}: has no clip {clip!r}; it has {', '.join(names)}")
        nodes = container.json.get("nodes", [])
        self._nodes = nodes
        self._order = list(_parents_first(container.json, nodes))
        self._skins = [_skin(container, skin) for skin in container.json.get("skins", [])]
        pieces = [piece for number, _ in self._order for piece in _pieces(container, number)]
        if not pieces:
            raise MotionError(f"{self.path}: has no triangles")
        self._pieces = [piece for piece, _ in pieces]
        starts = np.cumsum([0, *(len(piece.positions) for piece in self._pieces)])
        shifted = [t + start for (_, t), start in zip(pieces, starts[:-1], strict=True)]
        self.triangles = np.concatenate(shifted)
        if (
            self.triangles.size
            and not 0 <= self.triangles.min() <= self.triangles.max() < starts[-1]
        ):
            raise ValueError("a triangle names a vertex that is not there")
        return read_clip(container, 0 if clip is None else names.index(clip))

    def _posed(self, moved: dict[tuple[int, str], np.ndarray], bare: bool = False) -> np.ndarray:
        """The vertices with some properties of nodes moved. bare: no skins and morphs."""
        world = self._matrices(moved)
        parts = []
        for piece in self._pieces:
            p = piece.positions
            if len(piece.targets) and not bare:
                weights = moved.get((piece.node, "weights"), piece.weights)
                p = p + np.einsum("k,kvc->vc", weights[: len(piece.targets)], piece.targets)
            if piece.skin is None or bare:
                matrix = world[piece.node]
                parts.append(p @ matrix[:3, :3].T + matrix[:3, 3])
            else:
                joints, inverse = self._skins[piece.skin]
                bones = np.array([world[j] for j in joints]) @ inverse
                parts.append(_skinned(p, bones, piece))
        return np.concatenate(parts)

    def _matrices(self, moved: dict[tuple[int, str], np.ndarray]) -> dict[int, np.ndarray]:
        world: dict[int, np.ndarray] = {}
        for number, parent in self._order:
            node = self._nodes[number]
            own = {
                path: value
                for path in ("translation", "rotation", "scale")
                if (value := moved.get((number, path))) is not None
            }
            if own:  # section 3.11: a node that is animated has no matrix
                node = {**{k: v for k, v in node.items() if k != "matrix"}, **own}
            local = local_matrix(node)
            world[number] = local if parent is None else world[parent] @ local
        return world


def _parents_first(
    document: dict[str, Any], nodes: list[dict[str, Any]]
) -> Iterator[tuple[int, int | None]]:
    """Each node of the scene and its parent, after that; joints outside the scene as well."""
    seen: set[int] = set()
    joints = [j for skin in document.get("skins", []) for j in skin["joints"]]
    children = {c: k for k, node in enumerate(nodes) for c in node.get("children", ())}

    def top(number: int) -> int:
        for _ in nodes:
            if number not in children:
                return number
            number = children[number]
        raise ValueError(f"node {number} is its own parent")

    first = roots(document, nodes)
    stack: list[tuple[int, int | None]] = [(r, None) for r in (*first, *map(top, joints))]
    stack.reverse()
    while stack:
        number, parent = stack.pop()
        if number in seen and parent is not None:
            raise ValueError(f"node {number} is in its scene twice")
        if number not in seen:
            seen.add(number)
            yield number, parent
            stack += [(child, number) for child in reversed(nodes[number].get("children", ()))]


def _skin(container: GltfContainer, skin: dict[str, Any]) -> tuple[list[int], np.ndarray]:
    """Joints, and their inverse bind matrices (j, 4, 4)."""
    joints: list[int] = skin["joints"]
    if "inverseBindMatrices" not in skin:
        return joints, np.tile(np.eye(4), (len(joints), 1, 1))
    values = container.accessor(skin["inverseBindMatrices"]).astype(np.float64)
    return joints, values.reshape(-1, 4, 4).transpose(0, 2, 1)[: len(joints)]


def _pieces(container: GltfContainer, number: int) -> Iterator[tuple[_Piece, np.ndarray]]:
    """The primitives of a node, with their triangles (t, 3) int64."""
    node = container.json["nodes"][number]
    if "mesh" not in node:
        return
    mesh = container.json["meshes"][node["mesh"]]
    for data in mesh["primitives"]:
        attributes = data["attributes"]
        if (
            data.get("mode", TRIANGLES) not in (TRIANGLES, STRIP, FAN)
            or "POSITION" not in attributes
        ):
            continue
        positions = container.accessor(attributes["POSITION"]).astype(np.float64)
        targets = [
            container.accessor(target["POSITION"]).astype(np.float64)
            if "POSITION" in target
            else np.zeros_like(positions)
            for target in data.get("targets", ())
        ]
        weights = np.array(node.get("weights", mesh.get("weights", [0.0] * len(targets))), float)
        joints, shares = _influences(container, attributes, len(positions))
        skin = node.get("skin") if joints.size else None
        shaped = np.array(targets).reshape(len(targets), *positions.shape)
        piece = _Piece(number, positions, shaped, weights, skin, joints, shares)
        yield piece, _corners(container, data, len(positions))


def _corners(container: GltfContainer, data: dict[str, Any], count: int) -> np.ndarray:
    numbers = np.arange(count)
    if "indices" in data:
        numbers = container.accessor(data["indices"])[:, 0].astype(np.int64)
    return triangles_of(numbers, data.get("mode", TRIANGLES))


def _influences(
    container: GltfContainer, attributes: dict[str, int], count: int
) -> tuple[np.ndarray, np.ndarray]:
    """Joints and shares of each vertex, (v, 4 k), shares of sum 1; (v, 0) without a skin."""
    joints, shares = [np.zeros((count, 0), np.int64)], [np.zeros((count, 0))]
    while f"JOINTS_{(k := len(joints) - 1)}" in attributes:
        joints.append(container.accessor(attributes[f"JOINTS_{k}"]).astype(np.int64))
        shares.append(container.accessor(attributes[f"WEIGHTS_{k}"]).astype(np.float64))
    share = np.concatenate(shares, axis=1)
    total = share.sum(axis=1, keepdims=True)
    return np.concatenate(joints, axis=1), share / np.where(total > 0, total, 1.0)


def _skinned(p: np.ndarray, bones: np.ndarray, piece: _Piece) -> np.ndarray:
    """Section 3.7.3.3: the mean of what the joints' matrices make of each vertex."""
    result = np.zeros_like(p)
    for k in range(piece.joints.shape[1]):
        matrices = bones[piece.joints[:, k]]
        turned = np.einsum("vij,vj->vi", matrices[:, :3, :3], p) + matrices[:, :3, 3]
        result += piece.shares[:, k : k + 1] * turned
    return result
