"""Decoder input blocks: on the CPU the runtime's compiled ones, else in PyTorch; spec 6.3."""

import torch
from torch import Tensor

from rna_export.training.model import tensor_vectors
from rna_export.training.model.input_kernels import Inputs
from rna_sdk.package import input_blocks
from rna_sdk.package.blocks import blocks_for

_OF_FIBERS = set(blocks_for("fiber")) - set(blocks_for("surface"))

Points = dict[str, Tensor]
"""Queries by name: position, wo, wi and normal or tangent, (k, 3) each; for fibers also h, (k,)."""


def in_box(position: Tensor, low: Tensor, high: Tensor) -> Tensor:
    """Positions (k, 3) in the box of the planes, from 0 to 1."""
    return ((position - low) / (high - low)).clamp(0.0, 1.0)


def assemble(blocks: tuple[str, ...], features: Tensor, p: Tensor, at: Points) -> Tensor:
    """The decoder's input (k, K). `features`: (k, C). `p`: position in the bounds, 0 to 1."""
    if features.device.type != "cpu":
        return assembled(blocks, features, p, at)
    if _OF_FIBERS.isdisjoint(blocks):
        axis, h = at["normal"], None
    else:
        axis, h = at["tangent"], at["h"]
    queries: Tensor = Inputs.apply(blocks, features, p, axis, h, at["wo"], at.get("wi"))  # type: ignore[no-untyped-call]
    return queries


def assembled(blocks: tuple[str, ...], features: Tensor, p: Tensor, at: Points) -> Tensor:
    """`assemble` in plain PyTorch: for GPUs, and the kernels' twin."""
    columns = input_blocks(
        tensor_vectors,
        blocks,
        p=p,
        n=at.get("normal"),
        t=at.get("tangent"),
        h=at["h"].clamp(-1.0, 1.0)[:, None] if "h" in at else None,
        f=torch.nn.functional.pad(features[:, :3], (0, max(0, 3 - features.shape[1]))),
        wo=at["wo"],
        wi=at.get("wi"),
    )
    columns["features"] = (features,)
    return torch.cat([values for block in blocks for values in columns[block]], dim=1)
