"""Images of an asset from known cameras under known point lights."""

import math
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class PeerCamera:
    """A pinhole camera with square pixels.

    to_world: (4, 4), camera (looks along -z, +y up) to world. fov_x: radians. size: width, height.
    """

    to_world: np.ndarray
    fov_x: float
    size: tuple[int, int]

    @property
    def width(self) -> int:
        """Pixels."""
        return self.size[0]

    @property
    def height(self) -> int:
        """Pixels."""
        return self.size[1]

    @property
    def fov_y(self) -> float:
        """Radians."""
        width, height = self.size
        return float(2.0 * np.arctan(np.tan(self.fov_x / 2.0) * height / width))

    def rays(self, pixels: np.ndarray | None = None) -> tuple[np.ndarray, np.ndarray]:
        """Origins and unit directions, (n, 3) float32 each, through the centres of pixels.

        pixels: numbers, by rows from the top; None for all.
        """
        width, height = self.size
        if pixels is None:
            pixels = np.arange(width * height)
        focal = 0.5 * width / np.tan(self.fov_x / 2.0)
        x = (pixels % width + 0.5 - 0.5 * width) / focal
        y = -(pixels // width + 0.5 - 0.5 * height) / focal
        local = np.stack([x, y, -np.ones_like(x)], axis=1)
        local /= np.linalg.norm(local, axis=1, keepdims=True)
        directions = (local @ self.to_world[:3, :3].T).astype(np.float32)
        origins = np.broadcast_to(self.to_world[:3, 3], directions.shape)
        return origins.astype(np.float32), directions


@dataclass(frozen=True)
class PixelBatch:
    """Pixels with their rays, n rows of float32.

    lights: (n, 3) positions. colour: (n, 3) linear radiance, times alpha. alpha: (n,). depth: (n,)
    from the camera along the ray, 0 where alpha is 0; None where there is none.
    """

    origins: np.ndarray
    directions: np.ndarray
    lights: np.ndarray
    colour: np.ndarray
    alpha: np.ndarray
    depth: np.ndarray | None


@dataclass(frozen=True)
class Views:
    """v images of one size, of an asset within the unit sphere.

    rgba: (v, h, w, 4) float32 linear, colour times alpha, radiance 1 is white. depth: (v, h, w)
    float32 along the rays, or None. to_world: (v, 4, 4). lights: (v, 3). fov_x: radians. centre,
    radius: of the asset's bounding sphere in its own space; a point there is `centre + radius * p`.
    intensity: of the lights, W/sr in units of the sphere; None where it is not known.
    """

    rgba: np.ndarray
    depth: np.ndarray | None
    to_world: np.ndarray
    lights: np.ndarray
    fov_x: float
    centre: tuple[float, float, float] = (0.0, 0.0, 0.0)
    radius: float = 1.0
    intensity: float | None = None

    def __len__(self) -> int:
        return len(self.rgba)

    @property
    def size(self) -> tuple[int, int]:
        """Width and height."""
        return self.rgba.shape[2], self.rgba.shape[1]

    @property
    def pixels(self) -> int:
        """Number of pixels of all images."""
        return int(np.prod(self.rgba.shape[:3]))

    @property
    def shown_intensity(self) -> float:
        """Intensity of the lights; by default a white point at the centre is displayed white."""
        return self.intensity or math.pi * float((self.lights**2).sum(axis=1).mean())

    def camera(self, view: int) -> PeerCamera:
        """The camera of one image."""
        return PeerCamera(self.to_world[view], self.fov_x, self.size)

    def batch(self, numbers: np.ndarray) -> PixelBatch:
        """Pixels by their numbers among all images, by images, then rows."""
        width, height = self.size
        view, pixel = np.divmod(numbers, width * height)
        _, local = PeerCamera(np.eye(4), self.fov_x, self.size).rays(pixel)
        rgba = self.rgba.reshape(-1, 4)[numbers]
        turned = np.einsum("nij,nj->ni", self.to_world[view, :3, :3], local)
        return PixelBatch(
            self.to_world[view, :3, 3].astype(np.float32),
            turned.astype(np.float32),
            self.lights[view].astype(np.float32),
            rgba[:, :3],
            rgba[:, 3],
            None if self.depth is None else self.depth.reshape(-1)[numbers],
        )
