"""The passes of a render, from rna-run's channels."""

import bpy
import numpy as np

from .axes import to_blender
from .scene.camera import axes_of

OBJECT_INDEX = "Object Index" if bpy.app.version >= (5, 0) else "IndexOB"
FAR = 1e10
"""Depth where there is nothing, as in Cycles."""


def wanted_passes(view_layer):
    """(name, channel names, kind) of each pass of a view layer, Combined first."""
    passes = [("Combined", "RGBA", "COLOR")]
    if view_layer.use_pass_z:
        passes.append(("Depth", "Z", "VALUE"))
    if view_layer.use_pass_normal:
        passes.append(("Normal", "XYZ", "VECTOR"))
    if view_layer.use_pass_position:
        passes.append(("Position", "XYZ", "VECTOR"))
    if view_layer.use_pass_object_index:
        passes.append((OBJECT_INDEX, "X", "VALUE"))
    if view_layer.rna_passes.asset_index:
        passes.append(("Asset Index", "X", "VALUE"))
    if view_layer.rna_passes.visibility:
        passes.append(("Visibility", "X", "VALUE"))
    groups = [f"Combined_{group.name}" for group in view_layer.lightgroups]
    return [*passes, *((name, "RGB", "COLOR") for name in groups)]


class Channels:
    """An image of rna-run, and how it becomes Blender's passes.

    arrays: of the NPZ. camera: the object. exposure: factor on radiance. pass_indices: of the
    objects, in the order of `assetId` from 1.
    """

    def __init__(self, arrays, camera, exposure, pass_indices):
        self._arrays, self._exposure = arrays, exposure
        self._position, self._forward, _ = axes_of(camera)
        self._indices = np.array([0, *pass_indices], np.float32)

    @property
    def samples(self):
        """Number of samples accumulated."""
        return int(str(self._arrays["rnaSamples"]))

    def pass_(self, name):
        """Rows from the bottom up: (h, w, channels) float32."""
        values = self._MAKERS[name.partition("_")[0]](self, name)
        return np.ascontiguousarray(values[::-1], np.float32)

    def _combined(self, name):
        group = name.partition("_")[2]
        if group:
            if f"light.{group}.R" not in self._arrays:
                return np.zeros((*self._arrays["A"].shape, 3), np.float32)
            return self._stack(f"light.{group}.", "RGB") * self._exposure
        prefix = "denoised." if "denoised.R" in self._arrays else ""
        rgb = self._stack(prefix, "RGB") * self._exposure
        return np.concatenate([rgb, self._arrays["A"][..., None]], axis=-1)

    def _depth(self, name):
        along = (self._world() - np.float32(self._position)) @ np.float32(self._forward)
        return np.where(self._arrays["assetId"] > 0, along, FAR)[..., None]

    def _normal(self, name):
        return to_blender(self._stack("normal.", "XYZ"))

    def _position_(self, name):
        return self._world()

    def _object_index(self, name):
        return self._indices[np.minimum(self._arrays["assetId"], len(self._indices) - 1)][..., None]

    def _asset_index(self, name):
        return self._arrays["assetId"][..., None]

    def _visibility(self, name):
        return self._arrays["visibility"][..., None]

    def _world(self):
        return to_blender(self._stack("position.", "XYZ"))

    def _stack(self, prefix, letters):
        return np.stack([self._arrays[prefix + letter] for letter in letters], axis=-1)

    _MAKERS = {  # noqa: RUF012
        "Combined": _combined,
        "Depth": _depth,
        "Normal": _normal,
        "Position": _position_,
        OBJECT_INDEX: _object_index,
        "Asset Index": _asset_index,
        "Visibility": _visibility,
    }
