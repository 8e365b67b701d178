"""A method that is a PyTorch module: its training, checkpoints and rendering."""

import math
import time
from abc import abstractmethod
from dataclasses import asdict, dataclass, replace
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
import torch
from torch import Tensor, nn

from rna_bench.peers.method import Budget, LossPoint, Training
from rna_bench.peers.views import PeerCamera, PixelBatch, Views
from rna_sdk.errors import TrainingError
from rna_sdk.files.atomic_file import write_atomically

_SAVED_EVERY = 60.0  # seconds of training between checkpoints
_POINTS = 200  # of a curve in a planned training
CHECKPOINT = "last.ckpt"


@dataclass(frozen=True)
class Rays:
    """n rays and the point light of each, (n, 3) float32 tensors; directions are unit."""

    origins: Tensor
    directions: Tensor
    lights: Tensor


@dataclass(frozen=True)
class Targets:
    """Pixels on the device: their rays and colours; shapes as in `PixelBatch`."""

    rays: Rays
    colour: Tensor
    alpha: Tensor
    depth: Tensor | None

    @classmethod
    def of(cls, batch: PixelBatch, device: torch.device) -> "Targets":
        def there(array: np.ndarray) -> Tensor:
            return torch.from_numpy(np.ascontiguousarray(array)).to(device)

        rays = Rays(there(batch.origins), there(batch.directions), there(batch.lights))
        depth = None if batch.depth is None else there(batch.depth)
        return cls(rays, there(batch.colour), there(batch.alpha), depth)


class LearnedMethod:
    """Trains its model with Adam on random pixels of all images.

    model: on `device`. batch: pixels a step. rate: of Adam, times `rate_factor`. seed: of the
    pixels and of what the loss draws; the model's own initialisation is the maker's.
    """

    chunk = 2048
    """Rays of a rendered batch."""

    def __init__(self, model: nn.Module, batch: int, rate: float, seed: int, device: str = "cpu"):
        self.device = torch.device(device)
        self.model = model.to(self.device)
        self.batch, self.rate = batch, rate
        self.generator = torch.Generator().manual_seed(seed)

    @abstractmethod
    def loss(self, targets: Targets, progress: float) -> Tensor:
        """A scalar; progress: share of the planned training, 0 to 1."""

    @abstractmethod
    def radiance(self, rays: Rays) -> Tensor:
        """Radiance (n, 3), linear, over black."""

    def rate_factor(self, progress: float, steps: int) -> float:
        """Factor of the rate at a share `progress` of the training, after `steps` steps."""
        return 1.0

    @property
    def parameter_count(self) -> int:
        """Number of parameters that are trained."""
        return sum(p.numel() for p in self.model.parameters() if p.requires_grad)

    def train(self, data: Views, budget: Budget, work: Path) -> Training:
        """As `Method.train`; files in `work` must belong to the same model."""
        optimizer = torch.optim.Adam(self.model.parameters(), lr=self.rate)
        done = self._resume(optimizer, work)
        clock = time.perf_counter if self.device.type == "cuda" else time.process_time
        start, saved_at = clock() - done.seconds, done.seconds
        losses: list[Tensor] = []
        while not _is_over(done, budget):
            progress = _progress(done, budget)
            optimizer.param_groups[0]["lr"] = self.rate * self.rate_factor(progress, done.steps)
            losses.append(self._step(data, optimizer, progress))
            spent, steps = clock() - start, done.steps + 1
            done = replace(done, seconds=spent, steps=steps, samples=steps * self.batch)
            last = done.curve[-1] if done.curve else LossPoint(0.0, 0, 0, 0.0)
            if _share(done, budget) - _share(last, budget) >= 1.0 / _POINTS:
                done, losses = _with_point(done, losses), []
            if spent - saved_at >= _SAVED_EVERY:
                self._keep(optimizer, done, work)
                saved_at = spent
        if losses:
            done = _with_point(done, losses)
        if done.seconds > saved_at:
            self._keep(optimizer, done, work)
        return done

    def _step(self, data: Views, optimizer: torch.optim.Adam, progress: float) -> Tensor:
        numbers = torch.randint(data.pixels, (self.batch,), generator=self.generator)
        loss = self.loss(Targets.of(data.batch(numbers.numpy()), self.device), progress)
        optimizer.zero_grad(set_to_none=True)
        loss.backward()
        optimizer.step()
        return loss.detach()

    def load(self, work: Path) -> Training:
        """Take the model of a training as far as it has come; TrainingError without one."""
        saved = _read(work / CHECKPOINT)
        self.model.load_state_dict(saved["model"])
        return _training(saved["training"])

    def _resume(self, optimizer: torch.optim.Adam, work: Path) -> Training:
        path = work / CHECKPOINT
        if not path.is_file():
            return Training()
        saved = _read(path)
        try:
            self.model.load_state_dict(saved["model"])
        except RuntimeError as error:
            raise TrainingError(f"{path}: of another model; choose another folder") from error
        optimizer.load_state_dict(saved["optimizer"])
        self.generator.set_state(saved["generator"])
        return _training(saved["training"])

    def _keep(self, optimizer: torch.optim.Adam, done: Training, work: Path) -> None:
        work.mkdir(parents=True, exist_ok=True)
        data = BytesIO()
        saved = {
            "model": self.model.state_dict(),
            "optimizer": optimizer.state_dict(),
            "generator": self.generator.get_state(),
            "training": asdict(done),
        }
        torch.save(saved, data)
        write_atomically(work / CHECKPOINT, data.getvalue())

    def render(self, camera: PeerCamera, light: np.ndarray) -> np.ndarray:
        """As `Method.render`."""
        origins, directions = (torch.from_numpy(a) for a in camera.rays())
        lights = torch.from_numpy(np.asarray(light, np.float32)).expand_as(origins)
        chunks = zip(*(a.split(self.chunk) for a in (origins, directions, lights)), strict=True)
        with torch.no_grad():
            rows = [self.radiance(Rays(*(a.to(self.device) for a in c))).cpu() for c in chunks]
        width, height = camera.size
        return torch.cat(rows).numpy().reshape(height, width, 3)


def _share(point: Training | LossPoint, budget: Budget) -> float:
    if budget.steps is not None:
        return point.steps / budget.steps
    return point.seconds / budget.planned


def _progress(done: Training, budget: Budget) -> float:
    return min(1.0, _share(done, budget))


def _is_over(done: Training, budget: Budget) -> bool:
    if budget.steps is not None and done.steps >= budget.steps:
        return True
    return done.seconds >= budget.until


def _with_point(done: Training, losses: list[Tensor]) -> Training:
    """The training with a point of its curve; TrainingError where the loss is no number."""
    loss = float(torch.stack(losses).mean())
    if not math.isfinite(loss):
        raise TrainingError(f"step {done.steps}: found loss {loss}, expected a finite one")
    point = LossPoint(round(done.seconds, 2), done.steps, done.samples, loss)
    return replace(done, curve=(*done.curve, point))


def _read(path: Path) -> dict[str, Any]:
    if not path.is_file():
        raise TrainingError(f"{path}: no such file")
    try:
        saved: dict[str, Any] = torch.load(path, map_location="cpu", weights_only=True)
        return saved
    except Exception as error:  # whatever torch makes of damaged bytes
        raise TrainingError(f"{path}: not a checkpoint of rna-bench peers") from error


def _training(saved: dict[str, Any]) -> Training:
    return Training(**{**saved, "curve": tuple(LossPoint(**point) for point in saved["curve"])})
