"""Visibility, mapped normals and base colour at hits of a package on the GPU, for the kit."""

from os import PathLike
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_gpu.device import Device
from rna_gpu.geometry import Placed, build_geometry
from rna_gpu.records.scene import FRAME, PATH, TRANSMITS
from rna_gpu.scene.bindings import STRIDE, Bindings, upload_geometry
from rna_gpu.scene.scene_images import Images
from rna_gpu.scene.scene_surfaces import Surfaces
from rna_sdk.package import Mesh, Package


class Probe:
    """The geometry of a package on a GPU."""

    def __init__(self, path: str | PathLike[str], device: Device) -> None:
        """Raises PackageError for a broken package; GpuError: it does not fit."""
        parts = _parts(path)
        self._is_mesh = np.array([part.kind == "surface" for part in parts])
        self._starts = np.cumsum([0, *(part.count for part in parts)])
        surfaces = Surfaces(Images())
        shapes = surfaces.add(SimpleNamespace(parts=parts), 0, 0)
        geometry = build_geometry([shapes], [Placed(0, np.eye(4), 7)])
        self._places, self._device = geometry.places[0], device
        rows = surfaces.with_points(geometry.first_points)
        textures = surfaces.images.texture_rows()
        self._tables = np.concatenate([rows, textures]), surfaces.images.whole()
        self._frame = np.zeros(1, FRAME.dtype)
        self._frame["textures"] = len(rows)
        self._frame["flags"] = TRANSMITS * surfaces.transmits
        self._bindings = Bindings(device, FRAME.dtype.itemsize)
        self._scene = upload_geometry(device, geometry)

    def visibility(self, records: NDArray[np.uint32]) -> NDArray[np.float32]:
        """Visibility of light, (n, 3) float32, at (n, 8) hit records of the kit."""
        return self._run("visibility", self._hits(records))

    def normals(self, records: NDArray[np.uint32]) -> NDArray[np.float32]:
        """(n, 3) float32: the mapped normals at (n, 8) hit records of meshes."""
        return self._run("mapped", self._hits(records))

    def base_colors(
        self, records: NDArray[np.uint32], levels: NDArray[np.float32]
    ) -> NDArray[np.float32]:
        """(n, 3) float32, linear: at (n, 8) hit records of meshes, of the (n,) levels of images."""
        paths = self._hits(records)
        paths["t"] = levels
        return self._run("colored", paths)

    def _hits(self, records: NDArray[np.uint32]) -> NDArray[Any]:
        """Paths that have come to the hits and go on towards wi."""
        paths, part = np.zeros(len(records), PATH.dtype), records[:, 7]
        numbers = records.view("<f4")
        paths["primitive"] = self._places[self._starts[part] + records[:, 0]]
        mesh = self._is_mesh[part]
        paths["b1"][mesh], paths["b2"][mesh] = numbers[mesh, 1:3].T
        paths["direction"][mesh] = numbers[mesh, 3:6]
        paths["origin"][~mesh] = numbers[~mesh, 1:4]
        paths["direction"][~mesh] = numbers[~mesh, 4:7]
        return paths

    def _run(self, entry: str, paths: NDArray[Any]) -> NDArray[np.float32]:
        device, made = self._device, self._bindings
        self._frame["paths"] = len(paths)
        padded = np.zeros(STRIDE, np.uint8)
        padded[: FRAME.dtype.itemsize] = self._frame.view(np.uint8)
        uniform = device.upload(padded, "UNIFORM", what="steps")
        results = device.buffer(16 * len(paths), "STORAGE", what="results")
        buffers = [uniform, device.upload(paths, "STORAGE", what="hits"), results]
        buffers.append(device.buffer(16, "STORAGE", what="queries"))
        buffers += [device.upload(values, "STORAGE", what="tables") for values in self._tables]
        buffers.append(device.buffer(16, "STORAGE", what="lists of paths"))
        groups = [made.group(made.path, buffers, uniform), made.group(made.empty, [])]
        groups.append(made.group(made.scene, self._scene))
        with device.working():
            encoder = device.wgpu.create_command_encoder()
            run = encoder.begin_compute_pass()
            run.set_pipeline(made.pipeline(entry, made.empty, made.scene, file="probe"))
            for k, group in enumerate(groups):
                run.set_bind_group(k, group, [] if k else [0])
            device.groups(len(paths)).dispatch(run)
            run.end()
            device.wgpu.queue.submit([encoder.finish()])
        result = device.read(results, 16 * len(paths)).view(np.float32).reshape(-1, 4)
        return np.ascontiguousarray(result[:, :3])


def _parts(path: str | PathLike[str]) -> list[Any]:
    """The members of an asset's parts that `Surfaces` reads; count: of primitives."""
    parts = []
    with Package.open(path) as package:
        for number in range(len(package.manifest.parts)):
            geometry = package.geometry(number)
            common = {"emits": False, "sampling": package.sampling(number)}
            if isinstance(geometry, Mesh):
                records = {
                    "transmittance_records": package.transmittance(number),
                    "normal_maps": package.normal_maps(number),
                    "base_colors": package.base_color(number),
                }
                count = len(geometry.triangles)
                fields = {"kind": "surface", "mesh": geometry, "count": count}
                parts.append(SimpleNamespace(**fields, **records, **common))
            else:
                count = len(geometry.segments())
                fields = {"kind": "fiber", "curves": geometry, "count": count}
                parts.append(SimpleNamespace(**fields, **common))
    return parts
