"""Light from all around: one colour, or an image."""

import numpy as np

from rna_render.lights.base import InfiniteLight, Light, LightSamples, light_numbers
from rna_render.lights.directions import cone_direction, luminance
from rna_render.lights.equirectangular import EquirectangularImage
from rna_render.lights.files.environment_file import environment_image
from rna_render.lights.image_kernels import IMAGE_NUMBERS, look_up_image_batch, sample_image_batch
from rna_render.scene.light_models import EnvironmentModel
from rna_sdk.machine.compiled import compiled

_SPHERE_PDF = 1.0 / (4.0 * np.pi)


def make(model: EnvironmentModel) -> Light:
    """An EnvironmentLight, or an EnvironmentImageLight where the model names an image."""
    if model.path is None:
        return EnvironmentLight(model)
    return EnvironmentImageLight(model, environment_image(model.path))


class EnvironmentLight(InfiniteLight):
    """Equal radiance from everywhere, sampled uniformly over the sphere."""

    kind = "uniform"
    NUMBERS = light_numbers()

    def __init__(self, model: EnvironmentModel) -> None:
        super().__init__(model.group, colour=np.asarray(model.radiance, np.float32))
        self.visible_to_camera = model.visible_to_camera
        self.model = model

    def power(self, scene_radius: float) -> float:
        return float(4.0 * np.pi**2 * scene_radius**2 * luminance(self.colour))

    def _fill(self, x_world: np.ndarray, u: np.ndarray, samples: LightSamples) -> None:
        _sample_sphere(u, samples.wi_world)
        samples.radiance[:], samples.distance[:], samples.pdf[:] = self.colour, np.inf, _SPHERE_PDF

    def eval_environment(self, d_world: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        n = len(d_world)
        return np.tile(self.colour.astype(np.float32), (n, 1)), np.full(n, _SPHERE_PDF, np.float32)


class EnvironmentImageLight(InfiniteLight):
    """Radiance of an equirectangular image, sampled in proportion to its luminance.

    image: at angle 0, not yet multiplied by the model's radiance.

    Attributes:
        model: what the scene file says of it.
        image: the image at its angle.
    """

    kind = "image"
    NUMBERS = light_numbers(*((name, ()) for name in (*IMAGE_NUMBERS, "rows", "columns")))
    # Squared error times time, of a toy on a ground: 0.75 of that with 2 samples, and 0.87 with 8.
    samples = 4

    def __init__(self, model: EnvironmentModel, image: EquirectangularImage) -> None:
        self.image = image.turned(np.radians(model.rotation_deg))
        colour = np.asarray(model.radiance, np.float32)
        super().__init__(model.group, colour=colour, **self.image.members)
        self.visible_to_camera = model.visible_to_camera
        self.model, self._image = model, image

    def power(self, scene_radius: float) -> float:
        return float(np.pi * scene_radius**2 * self.image.total * luminance(self.colour))

    def mis_compensated(self) -> Light:
        return EnvironmentImageLight(self.model, self._image.compensated())

    def _fill(self, x_world: np.ndarray, u: np.ndarray, samples: LightSamples) -> None:
        sample_image_batch(
            self.colour,
            self.image.numbers,
            self.image.words,
            u,
            samples.wi_world,
            samples.radiance,
            samples.pdf,
        )
        samples.distance[:] = np.inf

    def eval_environment(self, d_world: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        numbers, words = self.image.numbers, self.image.words
        radiance, pdf = np.empty_like(d_world, np.float32), np.empty(len(d_world), np.float32)
        look_up_image_batch(self.colour, numbers, words, d_world, radiance, pdf)
        return radiance, pdf


@compiled(fastmath=())
def _sample_sphere(u: np.ndarray, wi_world: np.ndarray) -> None:
    for i in range(len(u)):
        wi = cone_direction(0.0, 0.0, 1.0, 2.0, u[i, 0], u[i, 1])
        wi_world[i, 0], wi_world[i, 1], wi_world[i, 2] = wi
