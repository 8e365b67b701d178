"""libembree4 through ctypes: the shared library, its device and its objects.

The library is the one that the wheel of `embreex` carries, with the whole of Embree's public
C API (https://github.com/RenderKit/embree, include/embree4). Only set-up goes through ctypes;
rays are traced by the compiled loops of `kernels`.
"""

import ctypes
import functools
import importlib.util
import os
import weakref
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from rna_sdk.commands.console import install_hint
from rna_sdk.errors import SceneError

# Enumerators of rtcore_common.h, rtcore_buffer.h, rtcore_geometry.h and rtcore_scene.h.
FORMAT_UCHAR = 0x1001
FORMAT_UINT = 0x5001
FORMAT_UINT3 = 0x5003
FORMAT_FLOAT3 = 0x9003
FORMAT_FLOAT4 = 0x9004
FORMAT_FLOAT3X4_ROW_MAJOR = 0x9134
BUFFER_INDEX = 0
BUFFER_VERTEX = 1
BUFFER_NORMAL = 3
BUFFER_FLAGS = 32
CURVE_NEIGHBOUR_LEFT = 1 << 0
CURVE_NEIGHBOUR_RIGHT = 1 << 1
GEOMETRY_TRIANGLE = 0
GEOMETRY_ROUND_LINEAR_CURVE = 16
GEOMETRY_SPHERE_POINT = 50
GEOMETRY_ORIENTED_DISC_POINT = 52
GEOMETRY_INSTANCE = 121
SCENE_ROBUST = 1 << 2
SCENE_FILTER_IN_ARGUMENTS = 1 << 3

_pointer, _uint, _int, _size = ctypes.c_void_p, ctypes.c_uint, ctypes.c_int, ctypes.c_size_t

# function: (result, arguments)
_SIGNATURES = {
    "rtcNewDevice": (_pointer, [ctypes.c_char_p]),
    "rtcReleaseDevice": (None, [_pointer]),
    "rtcGetDeviceError": (_int, [_pointer]),
    "rtcGetDeviceLastErrorMessage": (ctypes.c_char_p, [_pointer]),
    "rtcNewScene": (_pointer, [_pointer]),
    "rtcReleaseScene": (None, [_pointer]),
    "rtcSetSceneFlags": (None, [_pointer, _int]),
    "rtcCommitScene": (None, [_pointer]),
    "rtcNewGeometry": (_pointer, [_pointer, _int]),
    "rtcReleaseGeometry": (None, [_pointer]),
    "rtcCommitGeometry": (None, [_pointer]),
    "rtcAttachGeometryByID": (None, [_pointer, _pointer, _uint]),
    "rtcSetNewGeometryBuffer": (_pointer, [_pointer, _int, _uint, _int, _size, _size]),
    "rtcSetGeometryUserData": (None, [_pointer, _pointer]),
    "rtcSetGeometryInstancedScene": (None, [_pointer, _pointer]),
    "rtcSetGeometryMask": (None, [_pointer, _uint]),
    "rtcSetGeometryTransform": (None, [_pointer, _uint, _int, _pointer]),
}


@functools.cache
def library() -> ctypes.CDLL:
    """The loaded library, with the signatures of the functions used here.

    Raises SceneError when `embreex` is not installed or carries no libembree4.
    """
    spec = importlib.util.find_spec("embreex")
    if spec is None or spec.origin is None:
        raise SceneError(f"Embree is not installed: {install_hint('render')}")
    package = Path(spec.origin).parent
    folders = [package.with_name("embreex.libs"), package, package / ".dylibs"]
    results = [path for folder in folders for path in sorted(folder.glob("*embree4*"))]
    if not results:
        searched = ", ".join(str(folder) for folder in folders)
        raise SceneError(f"embreex carries no libembree4; searched {searched}")
    loaded = ctypes.CDLL(str(results[0]))
    for name, (result, arguments) in _SIGNATURES.items():
        function = getattr(loaded, name)
        function.restype, function.argtypes = result, arguments
    return loaded


def function_address(name: str) -> int:
    """Address of a function of the library, for the compiled kernels."""
    return ctypes.cast(getattr(library(), name), _pointer).value or 0


CONFIG_VARIABLE = "RNA_EMBREE_CONFIG"
"""Environment variable of settings for Embree (API documentation, rtcNewDevice): `isa=avx2` takes
its kernels for a processor without AVX-512, and `isa=sse4.2` those for one without AVX."""


class Device:
    """An Embree device; it lives as long as an object that was made with it."""

    def __init__(self) -> None:
        embree = library()
        config = os.environ.get(CONFIG_VARIABLE, "")
        self.handle = embree.rtcNewDevice(config.encode())
        if not self.handle:
            code = embree.rtcGetDeviceError(None)
            settings = f" with {CONFIG_VARIABLE}={config}" if config else ""
            raise SceneError(f"Embree made no device{settings} (error {code})")
        _release_with(self, "rtcReleaseDevice", self.handle)

    def check(self, doing: str) -> None:
        """Raise SceneError if Embree has reported an error since the last call of check."""
        code = library().rtcGetDeviceError(self.handle)
        if code:
            message = library().rtcGetDeviceLastErrorMessage(self.handle) or b""
            raise SceneError(f"Embree failed while {doing}: error {code} {message.decode()}")


class SceneHandle:
    """An Embree scene that is filled with geometries, committed once, and then traced."""

    def __init__(self, device: Device) -> None:
        self.device = device
        self.handle = library().rtcNewScene(device.handle)
        _release_with(self, "rtcReleaseScene", self.handle, keep=device)
        library().rtcSetSceneFlags(self.handle, SCENE_ROBUST | SCENE_FILTER_IN_ARGUMENTS)

    def add(
        self,
        kind: int,
        geometry_id: int,
        buffers: Sequence[tuple[int, int, np.ndarray]],
        user_data: int = 0,
    ) -> None:
        """Add a geometry made of buffers, which Embree copies.

        kind: a GEOMETRY_*. buffers: for each its BUFFER_*, its FORMAT_* and its rows, at least
        one. user_data: address that filters are told.
        """
        embree = library()
        geometry = embree.rtcNewGeometry(self.device.handle, kind)
        for buffer, layout, values in buffers:
            rows = np.ascontiguousarray(values)
            stride = rows.nbytes // len(rows)
            # Memory that Embree allocates has the padding that its 16-byte loads need.
            to = embree.rtcSetNewGeometryBuffer(geometry, buffer, 0, layout, stride, len(rows))
            self.device.check(f"copying geometry {geometry_id}")
            ctypes.memmove(to, rows.ctypes.data, rows.nbytes)
        embree.rtcSetGeometryUserData(geometry, user_data)
        # What an instance is hidden from, it says itself; the default would hide this from most.
        embree.rtcSetGeometryMask(geometry, 0xFFFFFFFF)
        self.attach(geometry, geometry_id)

    def attach(self, geometry: int, geometry_id: int) -> None:
        """Commit `geometry` and hand its ownership to this scene."""
        library().rtcCommitGeometry(geometry)
        library().rtcAttachGeometryByID(self.handle, geometry, geometry_id)
        library().rtcReleaseGeometry(geometry)
        self.device.check(f"adding geometry {geometry_id}")

    def commit(self) -> None:
        """Build the acceleration structure; the scene is not changed after that."""
        library().rtcCommitScene(self.handle)
        self.device.check("building the scene")


_current_device: weakref.ref[Device] | None = None


def shared_device() -> Device:
    """The process's device: scenes that instance one another must share it."""
    global _current_device
    device = _current_device() if _current_device else None
    if device is None:
        device = Device()
        _current_device = weakref.ref(device)
    return device


def _release_with(owner: object, function: str, handle: int, keep: object = None) -> None:
    """Release `handle` when `owner` goes, and hold `keep` until then."""

    def release(_kept: object = keep) -> None:
        getattr(library(), function)(handle)

    # The system takes everything back when the process ends; Embree's own threads may be gone.
    weakref.finalize(owner, release).atexit = False
