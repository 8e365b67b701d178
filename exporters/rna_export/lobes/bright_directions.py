"""Bright regions of an environment as a few directions, and the rest.

The sphere is cut into 64 rows of equal height along y and 128 columns, cells of equal solid angle.
Brightness is the mean of RGB. What a cell has above BRIGHT times the mean cell's flux is its
excess, in the cell's colour. Excess is collected in at most MOST directions: of the CANDIDATES
brightest cells left, the one with the most excess within RADIUS; moved to the mean direction of
this excess, everything within RADIUS of it is one cluster and is taken away; and so on. While there
are fewer than MOST clusters, the one with the largest flux x (1 - |mean direction|) is cut in two
at its mean, across the axis along which it is longest. A cluster is one direction, the mean of its
excess, with its flux. Excess in no cluster stays in the rest.
"""

from dataclasses import dataclass

import numpy as np

ROWS, COLUMNS = 64, 128
BRIGHT = 4.0  # times the mean flux of a cell
RADIUS = np.radians(15.0)
MOST = 8
CANDIDATES = 200


@dataclass(frozen=True, slots=True)
class SplitEnvironment:
    """An environment in cells, row 0 at +y, column 0 at the image's left edge.

    directions: (k, 3) float64, unit, k <= MOST, in the image's frame. flux: (k, 3) float64,
    irradiance on a plane that faces the direction. rest: (ROWS, COLUMNS, 3) float32, radiance times
    solid angle of what is left of each cell. share: (ROWS, COLUMNS) float32, from 0 to 1, the part
    of the cell's light that is left.
    """

    directions: np.ndarray
    flux: np.ndarray
    rest: np.ndarray
    share: np.ndarray


def split_environment(texels: np.ndarray) -> SplitEnvironment:
    """texels: (h, w, 3) float32, radiance of an EquirectangularImage at angle 0."""
    flux, directions = _cells(texels)
    brightness = flux.mean(axis=1)
    limit = BRIGHT * brightness.mean()
    above = np.clip(1.0 - limit / np.maximum(brightness, 1e-300), 0.0, 1.0)
    excess = above * brightness
    clusters = _cut(_collected(excess), excess)
    taken = np.zeros(len(flux), bool)
    for cells in clusters:
        taken |= cells
    share = np.where(taken, 1.0 - above, 1.0)
    means = [_mean(directions, excess * cells) for cells in clusters]
    fluxes = [(above[cells, None] * flux[cells]).sum(axis=0) for cells in clusters]
    return SplitEnvironment(
        np.array([mean / np.linalg.norm(mean) for mean in means]).reshape(-1, 3),
        np.array(fluxes).reshape(-1, 3),
        (share[:, None] * flux).reshape(ROWS, COLUMNS, 3).astype(np.float32),
        share.reshape(ROWS, COLUMNS).astype(np.float32),
    )


def cell_directions() -> np.ndarray:
    """The middle of each cell: (ROWS * COLUMNS, 3) float64, unit, in the image's frame."""
    y = 1.0 - 2.0 * (np.arange(ROWS) + 0.5) / ROWS
    turn = 2.0 * np.pi * ((np.arange(COLUMNS) + 0.5) / COLUMNS - 0.5)
    r = np.sqrt(1.0 - y * y)
    x, z = r[:, None] * np.sin(turn), -r[:, None] * np.cos(turn)
    return np.stack([x, np.tile(y[:, None], COLUMNS), z], axis=-1).reshape(-1, 3)


def _cells(texels: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Flux of each cell, (n, 3) float64, and the mean direction of its light, not of unit length.

    Of the image as it is looked up, bilinear between the middles of texels.
    """
    h, w, _ = texels.shape
    solid = _overlap(-np.cos(np.pi * np.arange(h + 1) / h), np.linspace(-1.0, 1.0, ROWS + 1))
    solid = _bilinear(np.pad(solid, ((0, 0), (1, 1)), "edge"))[:, 1:-1] * (2.0 * np.pi / w)
    across = _bilinear(_overlap(np.arange(w + 1) / w, np.linspace(0.0, 1.0, COLUMNS + 1))) * w
    theta = np.pi * (np.arange(h) + 0.5) / h
    turn = 2.0 * np.pi * ((np.arange(w) + 0.5) / w - 0.5)
    rgb = np.moveaxis(texels, -1, 0).astype(np.float64)
    flux = [solid @ channel @ across.T for channel in rgb]
    brightness = rgb.mean(axis=0)
    low = solid * np.sin(theta)
    moment = (
        low @ brightness @ (across * np.sin(turn)).T,
        (solid * np.cos(theta)) @ brightness @ across.T,
        -(low @ brightness @ (across * np.cos(turn)).T),
    )
    of_cell = np.stack(flux, axis=-1).reshape(-1, 3)
    total = np.maximum(of_cell.mean(axis=1, keepdims=True), 1e-300)
    return of_cell, np.stack(moment, axis=-1).reshape(-1, 3) / total


def _overlap(edges: np.ndarray, of_cells: np.ndarray) -> np.ndarray:
    """Length that each interval between edges has in each cell: (cells, intervals)."""
    low = np.maximum(edges[:-1], of_cells[:-1, None])
    return np.asarray(np.maximum(np.minimum(edges[1:], of_cells[1:, None]) - low, 0.0))


def _bilinear(weights: np.ndarray) -> np.ndarray:
    """Weights of texels' tents from weights of their boxes: a tent has 3/4 of it in its box."""
    around = np.roll(weights, 1, axis=1) + np.roll(weights, -1, axis=1)
    return np.asarray((6.0 * weights + around) / 8.0)


def _mean(directions: np.ndarray, weights: np.ndarray) -> np.ndarray:
    return np.asarray(weights @ directions / max(weights.sum(), 1e-300))


def _collected(excess: np.ndarray) -> list[np.ndarray]:
    """Clusters of cells with excess, (n,) bool each, by falling flux."""
    d, left, near = cell_directions(), excess.copy(), np.cos(RADIUS)
    clusters: list[np.ndarray] = []
    while len(clusters) < MOST and left.max() > 0.0:
        brightest = np.argsort(-left, kind="stable")[:CANDIDATES]
        within = (d[brightest] @ d.T > near) @ left
        best = d[brightest[np.argmax(within)]]
        centre = _mean(d, left * (d @ best > near))
        cells = (d @ (centre / np.linalg.norm(centre)) > near) & (left > 0.0)
        clusters.append(cells)
        left[cells] = 0.0
    return clusters


def _cut(clusters: list[np.ndarray], excess: np.ndarray) -> list[np.ndarray]:
    """The clusters, the widest cut in two until there are MOST, or no more than one cell each."""
    d, clusters = cell_directions(), list(clusters)

    def width(cells: np.ndarray) -> float:
        weights = excess * cells
        return float(weights.sum() * (1.0 - np.linalg.norm(_mean(d, weights))))

    while clusters and len(clusters) < MOST:
        widest = max(range(len(clusters)), key=lambda k: width(clusters[k]))
        cells = clusters[widest]
        if np.count_nonzero(cells) < 2:
            break
        offset = d - _mean(d, excess * cells)
        spread = offset.T @ (offset * (excess * cells)[:, None])
        along = offset @ np.linalg.eigh(spread)[1][:, -1]
        clusters[widest : widest + 1] = [cells & (along > 0.0), cells & (along <= 0.0)]
    return clusters
