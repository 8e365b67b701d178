"""The check of a capture against Cycles: do exported and rendered geometry agree?

Radiance is recorded at the hits of our own scene. Where Cycles shows another surface, or none,
the record is wrong, and nothing later can tell: training and validation know our hits alone.
"""

from dataclasses import dataclass, field

import numpy as np

from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.check.disagreement import (
    APART,
    ELSEWHERE,
    EXTRA,
    KINDS,
    MISSING,
    TURNED,
    Disagreement,
    other_hits,
)
from rna_export.capture.check.disagreement_picture import disagreement_picture
from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.capture.rays.traced_rays import HIT, TracedRays
from rna_export.capture.rays.view_rays import ViewRays, outside_rays
from rna_render import Camera
from rna_render.scene import CameraModel
from rna_sdk.package.manifest.manifest_fields import Region

PICTURE = "disagreement.png"
"""File of a dataset, only if something disagrees."""

WORTH_A_NOTE = 0.01
"""Share of rays from which a disagreement is reported."""

_WIDER = 1.2  # than the asset's sphere: what is not exported may stand beside it
_SIDES = 48, 128  # pixels, at least and at most
_COVERED = 0.4  # of a picture
_FOV = np.radians(40.0)
_CORNERS = np.array([[-1, -1], [-1, 1], [1, -1], [1, 1]])
_IN_FILTER = 0.5 + np.concatenate([0.0075 * _CORNERS, 0.015 * _CORNERS])
"""Places in a pixel that Cycles' narrowest filter reaches: a Gaussian of 3 x 0.01 pixels."""
_FROM = np.array([0.5, 0.4, 1.0])  # direction of the picture's camera, if all agrees
_CLUSTER = np.cos(np.radians(40.0))
_CANDIDATES = 64
_WORDS = {
    MISSING: "of the exported geometry is not in Cycles' images",
    EXTRA: "of the surfaces that Cycles shows is not exported",
    ELSEWHERE: "of the hits are elsewhere in Cycles",
    TURNED: "of the normals differ by more than 30 degrees",
}


@dataclass
class SelfCheck:
    """Compares Cycles with our scene, as it goes, during the first renders of a capture.

    samples: of each ray. normals: whether the exported ones are to be Cycles'. side: of the
    picture, pixels.
    """

    scene: AssetScene
    samples: int
    normals: bool
    side: int = _SIDES[1]
    rays: int = 0
    used_rays: int = 0
    shares: dict[str, float] = field(default_factory=lambda: dict.fromkeys(KINDS, 0.0))
    brightness: float = 1.0  # of Cycles' images, over what it should be
    picture: bytes | None = None  # a PNG, if there is something to mark
    _towards: list[np.ndarray] = field(default_factory=list)  # viewers of what differs, (n, 3)

    def render_card(self, worker: BlenderWorker) -> None:
        """Render a card of known radiance."""
        self.brightness = float(np.pi) * worker.render_card()

    def render_chords(
        self, worker: BlenderWorker, wi: np.ndarray, n: int, wo: Region, seed: int
    ) -> None:
        """Render n rays from all around, which need not hit, and compare them."""
        rays = outside_rays(self.scene, n, wo, np.random.default_rng(seed), _WIDER)
        rendered = worker.render_rays(
            rays.origins, rays.directions, wi, self.samples, seed, normals=self.normals
        )
        disagreement = Disagreement.of(self.scene, rays, rendered, self.samples, self.normals)
        self._note(disagreement.shares(), rays, disagreement.any)

    def add(self, traced: TracedRays) -> None:
        """Compare view rays as a capture traces them."""
        n, points, rendered = len(traced.rays), traced.points, traced.rendered
        self.rays += n
        self.used_rays += int(traced.valid.sum())
        elsewhere, turned = other_hits(self.scene, traced.rays, points, rendered, self.normals)
        masks = {ELSEWHERE: elsewhere, TURNED: turned}
        if not self.scene.transmits:  # else Cycles' rays start at the points
            masks[MISSING] = points.hit & (rendered.alpha < HIT)
        shares = {kind: float(rows.mean()) for kind, rows in masks.items()}
        self._note(shares, traced.rays, np.logical_or.reduce(list(masks.values())))

    def render_picture(self, worker: BlenderWorker, name: str) -> None:
        """Render an ordinary image of the whole source from where most differs, and compare it."""
        camera = self._camera()
        wi = _unit(camera.to_world[:3, 2] + 0.7 * camera.to_world[:3, 1]).astype(np.float32)
        side = self.side
        rendered = worker.render_pixel_centres(camera, wi, self.samples, seed=0)
        pixels = np.arange(side**2, dtype=np.uint32)
        directions = camera.directions(pixels, np.full((side**2, 2), 0.5))
        rays = ViewRays(np.tile(camera.position, (side**2, 1)), directions)
        disagreement = Disagreement.of(
            self.scene, rays, rendered, self.samples, self.normals, self._firm(camera, rays)
        )
        # Cycles takes a height's slope over a tenth of a pixel, which is wide in this image.
        self._note(disagreement.shares() | {TURNED: 0.0}, rays, disagreement.any)
        if self.worth_telling():
            self.picture = disagreement_picture(
                self.scene, rays, rendered, disagreement, name, self.worth_telling()
            )

    def _firm(self, camera: Camera, rays: ViewRays) -> np.ndarray:
        """Rays of a picture that answer the same everywhere in Cycles' narrowest filter, (n,)."""
        pixels = np.arange(len(rays.origins), dtype=np.uint32)
        distance = self.scene.distance(rays.origins, rays.directions)
        firm = np.ones(len(distance), bool)
        for place in _IN_FILTER:
            directions = camera.directions(pixels, np.tile(place, (len(pixels), 1)))
            other = self.scene.distance(rays.origins, directions)
            firm &= np.isclose(other, distance, rtol=0.0, atol=APART * self.scene.radius)
        return firm

    def _note(self, shares: dict[str, float], rays: ViewRays, differ: np.ndarray) -> None:
        for kind, share in shares.items():
            self.shares[kind] = max(self.shares[kind], share)
        if max(shares.values()) >= WORTH_A_NOTE:
            self._towards.append(-rays.directions[differ])

    def worth_telling(self) -> dict[str, str]:
        """Kinds of disagreement, and the words for each."""
        return {
            kind: f"{share:.1%} {_WORDS[kind]}"
            for kind, share in self.shares.items()
            if share >= WORTH_A_NOTE
        }

    def note(self) -> str | None:
        """A sentence on the differences, None if all agrees."""
        differs = "; ".join(self.worth_telling().values())
        said = [f"the exported geometry differs from Cycles' renders: {differs}"] if differs else []
        if abs(self.brightness - 1.0) >= WORTH_A_NOTE:
            said.append(
                f"a white card is {self.brightness:.3g} times as bright as it should be: a setting "
                "of the file changes the light"
            )
        return "; ".join(said) or None

    def _camera(self) -> Camera:
        axis = _unit(self._busiest())
        radius = 1.25 * self.scene.radius
        up = (0.0, 1.0, 0.0) if abs(axis[1]) < 0.99 else (0.0, 0.0, 1.0)
        model = CameraModel(
            position=tuple(self.scene.centre + axis * radius / np.sin(_FOV / 2.0)),
            look_at=tuple(self.scene.centre.astype(np.float64)),
            up=up,
            vertical_fov_deg=np.degrees(_FOV),
        )
        return Camera(model, (self.side, self.side))

    def _busiest(self) -> np.ndarray:
        """The direction around which most viewers see something that differs, (3,)."""
        towards = np.concatenate([np.zeros((0, 3), np.float32), *self._towards])
        if not len(towards):
            return _FROM
        candidates = towards[:: max(len(towards) // _CANDIDATES, 1)]
        return np.asarray(candidates[np.argmax((candidates @ towards.T > _CLUSTER).sum(axis=1))])


def picture_side(rays: int) -> int:
    """Pixels of a picture that costs no more than a render of so many view rays."""
    least, most = _SIDES
    return int(np.clip(np.sqrt(rays / _COVERED), least, most))


def _unit(vector: np.ndarray) -> np.ndarray:
    return np.asarray(vector / np.linalg.norm(vector))
