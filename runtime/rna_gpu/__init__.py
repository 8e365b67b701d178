"""Relightable neural assets on any GPU, by WGSL and `wgpu`.

>>> asset = rna_gpu.load("toy.rna")
>>> visible, shadowed = asset.evaluate(positions, normals, wo, wi, color)

Arguments and results are those of `rna_sdk.runtime`. `asset.evaluate_on_gpu` reads and writes GPU
buffers, without a copy to the CPU. The web viewer uses the same shaders, `wgsl/`.
"""

from rna_gpu.asset import GpuAsset, GpuFiber, GpuPart, GpuSurface
from rna_gpu.device import Device, open_device
from rna_gpu.evaluator import GpuRows
from rna_gpu.loading import load
from rna_sdk.errors import DeviceLostError, GpuError

__all__ = [
    "Device",
    "DeviceLostError",
    "GpuAsset",
    "GpuError",
    "GpuFiber",
    "GpuPart",
    "GpuRows",
    "GpuSurface",
    "load",
    "open_device",
]
