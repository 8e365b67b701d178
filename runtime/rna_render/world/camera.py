"""The camera, a pinhole or a thin lens: from points of the image to rays."""

import numpy as np

from rna_render.scene.scene_model import CameraModel
from rna_sdk.machine.compiled import compiled


class Camera:
    """World-space rays through the pixels of an image; row 0 is at the top.

    model: where it stands and looks. resolution: width, height in pixels. samples: of a pixel.

    to_world: (4, 4) float64, from the camera's space, which looks along -z with +y up. fov_y:
    radians.
    corner, step_x, step_y: (3,) float64, direction through the image's top left corner, and the
    steps of a pixel. has_lens: whether rays start all over a lens.
    lens_x, lens_y: (3,) float64, to the right and up, as long as the lens's radius. focus: distance
    of the sharp plane, metres.
    spread: width of what a sample of a pixel stands for, over the distance to it. Textures are
    averaged over it, as in PBRT: a pixel's width, over the square root of its samples.
    """

    def __init__(self, model: CameraModel, resolution: tuple[int, int], samples: int = 1) -> None:
        self.width, self.height = resolution
        self.fov_y = float(np.radians(model.vertical_fov_deg))
        self._half_height = np.tan(self.fov_y / 2.0)
        self.position = np.asarray(model.position, np.float32)
        forward = _unit(np.subtract(model.look_at, model.position))
        right = _unit(np.cross(forward, model.up))
        up = np.cross(right, forward)
        self.to_world = np.eye(4)
        self.to_world[:3] = np.stack([right, up, -forward, model.position], axis=1)
        half_height = self._half_height
        half_width = half_height * self.width / self.height
        self.corner = forward - half_width * right + half_height * up
        self.step_x = right * (2.0 * half_width / self.width)
        self.spread = 2.0 * half_height / self.height / max(samples, 1) ** 0.5
        self.step_y = -up * (2.0 * half_height / self.height)
        radius, self.focus = model.aperture / 2.0, model.focus_distance
        self.lens_x, self.lens_y, self.has_lens = radius * right, radius * up, radius > 0.0

    def directions(self, pixels: np.ndarray, u: np.ndarray) -> np.ndarray:
        """Unit directions through points of pixels: (n, 3) float32.

        pixels: (n,) uint32, row * width + column. u: (n, 2) in [0, 1), place in the pixel from
        its top left corner; uniform points give a box filter one pixel wide.
        """
        result = np.empty((len(pixels), 3), np.float32)
        _directions(pixels, u, self.width, self.corner, self.step_x, self.step_y, result)
        return result

    def through_lens(self, directions: np.ndarray, u: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Rays of a thin lens: origins and unit directions, (n, 3) float32 each.

        directions: (n, 3), of the pinhole, whose rays they meet on the sharp plane. u: (n, 2) in
        [0, 1), place on the lens by Shirley and Chiu's concentric map (Journal of Graphics Tools
        2(3), 1997).
        """
        back, at = self.to_world[:3, 2], _on_disk(u)
        offset = at[:, :1] * self.lens_x + at[:, 1:] * self.lens_y
        sharp = directions * (self.focus / -(directions @ back))[:, None]
        through = sharp - offset
        through /= np.linalg.norm(through, axis=1, keepdims=True)
        return (self.position + offset).astype(np.float32), through.astype(np.float32)

    def project(self, points: np.ndarray) -> np.ndarray:
        """Where points of the world are in the image: (n, 2) float64, pixels from its top left.

        points: (n, 3). NaN for those that are not in front of the camera.
        """
        x, y, z = self.to_world[:3, :3].T @ (points - self.to_world[:3, 3]).T
        depth = np.where(z < 0.0, -z, np.nan) * self._half_height * 2.0 / self.height
        return np.stack([self.width / 2 + x / depth, self.height / 2 - y / depth], axis=1)

    def motion_to(self, after: "Camera", points: np.ndarray, moved: np.ndarray) -> np.ndarray:
        """Pixels to the right and down that points move by in the image: (n, 2) float32.

        after: the camera of the next frame. points, moved: (n, 3), now and then. 0 where a point is
        not in front of both.
        """
        way = after.project(moved) - self.project(points)
        return np.asarray(np.nan_to_num(way), np.float32)

    def heights(self, centres: np.ndarray, radii: np.ndarray) -> np.ndarray:
        """Heights of spheres in the image, (n,) pixels: 0 outside it, inf around the camera.

        centres: (n, 3), world space. radii: (n,).
        """
        to_camera = self.to_world[:3, :3].T
        x, y, z = to_camera @ (centres - self.to_world[:3, 3]).T
        half = np.array([self._half_height * self.width / self.height, self._half_height])
        # Distance beyond the nearer of two opposite edges of the image, in world units.
        beyond = (np.abs([x, y]) + z * half[:, None]) / np.sqrt(1.0 + half**2)[:, None]
        seen = (beyond.max(axis=0) < radii) & (-z > -radii)
        around = -z <= radii
        away = np.where(around, radii + 1.0, -z)
        pixels = self.height * radii / np.sqrt(away**2 - radii**2) / self._half_height
        return np.where(seen, np.where(around, np.inf, pixels), 0.0)


def _on_disk(u: np.ndarray) -> np.ndarray:
    """Points of the unit disk, uniform by area, of points of the unit square: (n, 2) each."""
    a, b = 2.0 * u.T - 1.0
    wide = np.abs(a) > np.abs(b)
    r = np.where(wide, a, b)
    with np.errstate(divide="ignore", invalid="ignore"):
        angle = np.where(wide, np.pi / 4 * (b / a), np.pi / 2 - np.pi / 4 * (a / b))
    angle = np.where(r == 0.0, 0.0, angle)
    return np.stack([r * np.cos(angle), r * np.sin(angle)], axis=1)


def _unit(vector: np.ndarray) -> np.ndarray:
    return np.asarray(vector / np.linalg.norm(vector))


@compiled(rows="pixels u result", fastmath=())
def _directions(
    pixels: np.ndarray,
    u: np.ndarray,
    width: int,
    corner: np.ndarray,
    step_x: np.ndarray,
    step_y: np.ndarray,
    result: np.ndarray,
) -> None:
    for i in range(len(pixels)):
        x = pixels[i] % width + u[i, 0]
        y = pixels[i] // width + u[i, 1]
        dx = corner[0] + x * step_x[0] + y * step_y[0]
        dy = corner[1] + x * step_x[1] + y * step_y[1]
        dz = corner[2] + x * step_x[2] + y * step_y[2]
        scale = 1.0 / np.sqrt(dx * dx + dy * dy + dz * dz)
        result[i, 0], result[i, 1], result[i, 2] = dx * scale, dy * scale, dz * scale
