"""Buffers and pipelines of the shaders in `wgsl/render/`."""

from collections.abc import Sequence
from typing import Any

from rna_gpu.device import Device
from rna_gpu.geometry import Geometry
from rna_gpu.shaders import compose
from rna_sdk.errors import GpuError

STRIDE = 256  # bytes: what offsets of uniforms are multiples of
_STORAGE_BUFFERS = 11  # that a step binds
_READ = "read-only-storage"
_PATH = ("uniform", "storage", "storage", "storage", _READ, _READ, "storage")


class Bindings:
    """Layouts of the groups of bindings, and pipelines by the names of their entry points.

    Group 0 holds the step's numbers, paths, tables and lists of paths; group 1 the rows of queries,
    pixels or the film; group 2 the geometry.
    """

    def __init__(self, device: Device, frame_bytes: int) -> None:
        """Raises GpuError: the device binds too few buffers to a shader."""
        most = device.limits["max-storage-buffers-per-shader-stage"]
        if most < _STORAGE_BUFFERS:
            needed = f"{_STORAGE_BUFFERS} storage buffers in a shader"
            raise GpuError(f"{device.name}: rendering takes {needed}, found {most}")
        self._device, self._frame_bytes = device, frame_bytes
        self.path, self.empty = device.layout(*_PATH), device.layout()
        self.pixels, self.film = device.layout(_READ), device.layout("storage")
        self.rows = device.layout(*["storage"] * 5)
        self.scene = device.layout(*[_READ] * 5)

    def pipeline(self, name: str, *layouts: Any, file: str = "") -> Any:
        """Pipeline of an entry point of wgsl/render/. file: its composition, if named otherwise."""
        source = compose({}, f"render/{file or name}")
        return self._device.pipeline(source, name, [self.path, *layouts])

    def group(self, layout: Any, buffers: Sequence[Any], uniform: Any = None) -> Any:
        """Bound buffers; steps read a row of the buffer `uniform`."""
        entries = [
            {
                "binding": k,
                "resource": {
                    "buffer": buffer,
                    "offset": 0,
                    "size": self._frame_bytes if buffer is uniform else buffer.size,
                },
            }
            for k, buffer in enumerate(buffers)
        ]
        return self._device.wgpu.create_bind_group(layout=layout, entries=entries)


def upload_geometry(device: Device, made: Geometry) -> list[Any]:
    """The buffers of group 2."""
    arrays = {
        "trees": made.nodes,
        "primitives": made.primitives,
        "points": made.points,
        "instances": made.instances,
        "normals": made.normals,
    }
    return [device.upload(values, "STORAGE", what=name) for name, values in arrays.items()]
