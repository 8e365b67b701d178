"""The animation of a glTF 2.0 file: its nodes and weights at a time (section 3.11)."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from rna_render.scene.gltf_container import GltfContainer
from rna_render.scene.limits import MAX_VERTICES

_WIDTHS = {"translation": 3, "rotation": 4, "scale": 3}
_KINDS = ("LINEAR", "STEP", "CUBICSPLINE")


@dataclass(frozen=True, slots=True, eq=False)
class Track:
    """The keys that move one property of a node.

    path: translation, rotation, scale or weights. times: (k,) float64, seconds, ascending.
    values: (k, 1, width), or (k, 3, width) of CUBICSPLINE: tangents in, values, tangents out.
    """

    node: int
    path: str
    kind: str
    times: np.ndarray
    values: np.ndarray

    def at(self, time: float) -> np.ndarray:
        """Its value, (width,) float64; before the first and after the last key those of these."""
        after = int(np.searchsorted(self.times, time, side="right"))
        if after == 0 or after == len(self.times):
            return self._unit(self._key(min(after, len(self.times) - 1)))
        before = after - 1
        length = self.times[after] - self.times[before]
        t = (time - self.times[before]) / length
        a, b = self._key(before), self._key(after)
        if self.kind == "STEP":
            return a
        if self.kind == "CUBICSPLINE":  # appendix C.5
            leaving, arriving = length * self.values[before, 2], length * self.values[after, 0]
            s, c = t * t, t * t * t
            mixed = (2 * c - 3 * s + 1) * a + (c - 2 * s + t) * leaving
            return self._unit(mixed + (3 * s - 2 * c) * b + (c - s) * arriving)
        if self.path == "rotation":
            return _slerp(a, b, t)
        return np.asarray((1 - t) * a + t * b)

    def _key(self, k: int) -> np.ndarray:
        value: np.ndarray = self.values[k, self.values.shape[1] // 2]
        return value

    def _unit(self, value: np.ndarray) -> np.ndarray:
        if self.path != "rotation":
            return value
        return value / max(float(np.linalg.norm(value)), 1e-30)


def _slerp(a: np.ndarray, b: np.ndarray, t: float) -> np.ndarray:
    """Appendix C.4: along the shorter way."""
    cosine = float(a @ b)
    b, cosine = (-b, -cosine) if cosine < 0 else (b, cosine)
    angle = np.arccos(min(cosine, 1.0))
    if angle < 1e-6:
        mixed = (1 - t) * a + t * b
    else:
        mixed = (np.sin((1 - t) * angle) * a + np.sin(t * angle) * b) / np.sin(angle)
    return mixed / max(float(np.linalg.norm(mixed)), 1e-30)


def clip_names(container: GltfContainer) -> list[str]:
    """Names of the file's animations; numbers of those without."""
    animations = container.json.get("animations", [])
    return [str(a.get("name", k)) for k, a in enumerate(animations)]


def read_clip(container: GltfContainer, number: int) -> list[Track]:
    """The tracks of an animation. Raises whatever Python raises for one that is not valid."""
    animation = container.json["animations"][number]
    moving = [
        (channel["target"], animation["samplers"][channel["sampler"]])
        for channel in animation["channels"]
        if "node" in channel["target"] and channel["target"]["path"] in (*_WIDTHS, "weights")
    ]
    keys = sum(container.count(s["input"]) + container.count(s["output"]) for _, s in moving)
    if keys > MAX_VERTICES:
        raise ValueError(f"an animation has {keys} times and values; at most {MAX_VERTICES}")
    return [_track(container, target, sampler) for target, sampler in moving]


def duration(tracks: Sequence[Track]) -> float:
    """Seconds to the last key."""
    return max((float(track.times[-1]) for track in tracks), default=0.0)


def _track(container: GltfContainer, target: dict[str, Any], sampler: dict[str, Any]) -> Track:
    kind = sampler.get("interpolation", "LINEAR")
    if kind not in _KINDS:
        raise ValueError(f"an animation has the interpolation {kind!r}")
    times = container.accessor(sampler["input"])[:, 0].astype(np.float64)
    if not (len(times) and np.isfinite(times).all() and (np.diff(times, prepend=-1e-9) > 0).all()):
        raise ValueError("the times of an animation do not ascend from 0 or later")
    values = container.accessor(sampler["output"]).astype(np.float64)
    keys = 3 if kind == "CUBICSPLINE" else 1
    width = _WIDTHS.get(target["path"]) or values.size // (keys * len(times))
    if values.size != keys * len(times) * width or not np.isfinite(values).all():
        raise ValueError(f"an animation has {values.size} numbers for {len(times)} keys")
    shaped = values.reshape(len(times), keys, width)
    return Track(target["node"], target["path"], kind, times, shaped)
