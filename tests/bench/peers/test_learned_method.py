"""Training of peers: resuming, budgets, records, rays of cameras."""

import numpy as np
import pytest
import torch
from torch import Tensor, nn

from rna_bench.peers.learned_method import LearnedMethod, Rays, Targets
from rna_bench.peers.method import Budget
from rna_bench.peers.views import PeerCamera, Views
from rna_sdk.errors import TrainingError

COLOUR = (0.2, 0.5, 0.7)


class Plain(LearnedMethod):
    """The same colour everywhere."""

    def __init__(self, seed: int = 0) -> None:
        torch.manual_seed(seed)
        super().__init__(nn.Linear(3, 3), 32, 0.05, seed)

    def loss(self, targets: Targets, progress: float) -> Tensor:
        return (self.radiance(targets.rays) - targets.colour).square().mean()

    def radiance(self, rays: Rays) -> Tensor:
        return self.model(0.01 * rays.directions)


@pytest.fixture
def views():
    rgba = np.ones((2, 4, 6, 4), np.float32)
    rgba[..., :3] = COLOUR
    to_world = np.stack([np.eye(4), np.eye(4)])
    to_world[:, 2, 3] = 4.5
    return Views(rgba, None, to_world, np.float32([[0, 4, 0], [4, 0, 0]]), 0.7)


def test_a_training_that_stopped_goes_on_as_if_it_had_not(views, tmp_path):
    whole, halved = Plain(), Plain()
    halved.model.load_state_dict(whole.model.state_dict())
    there = whole.train(views, Budget(60.0, 60.0, steps=150), tmp_path / "whole")
    halved.train(views, Budget(60.0, 60.0, steps=25), tmp_path / "halved")
    again = Plain(seed=9)
    done = again.train(views, Budget(60.0, 60.0, steps=150), tmp_path / "halved")
    for a, b in zip(whole.model.parameters(), again.model.parameters(), strict=True):
        assert torch.equal(a, b)
    assert (done.steps, done.samples) == (there.steps, there.samples) == (150, 150 * 32)
    assert [point.steps for point in done.curve][-1] == 150 and done.curve[0].loss > 0.1
    image = again.render(views.camera(0), views.lights[0])
    assert image.shape == (4, 6, 3) and image.dtype == np.float32
    np.testing.assert_allclose(image, np.broadcast_to(COLOUR, image.shape), atol=0.02)


def test_a_budget_of_time_ends_a_training(views, tmp_path):
    done = Plain().train(views, Budget(0.1, 0.1), tmp_path)
    assert done.steps >= 1 and 0.1 <= done.seconds < 1.0
    assert Plain().train(views, Budget(0.1, 0.1), tmp_path) == done


def test_a_loss_that_is_no_number_ends_with_one_line(views, tmp_path):
    method = Plain()
    nn.init.constant_(method.model.bias, np.nan)
    with pytest.raises(TrainingError, match="found loss nan"):
        method.train(views, Budget(1.0, 1.0, steps=2), tmp_path)
    (tmp_path / "last.ckpt").write_bytes(b"PK")
    with pytest.raises(TrainingError, match=r"last\.ckpt: not a checkpoint"):
        Plain().train(views, Budget(1.0, 1.0, steps=2), tmp_path)


def test_rays_go_through_the_middles_of_pixels():
    turned = np.eye(4)
    turned[:3, :3] = [[0, 0, 1], [0, 1, 0], [-1, 0, 0]]  # looks along -x
    turned[:3, 3] = [4.5, 0, 0]
    camera = PeerCamera(turned, 2 * np.arctan(0.5), (2, 4))
    origins, directions = camera.rays()
    assert (origins == np.float32([4.5, 0, 0])).all()
    slopes = directions / -directions[:, :1]
    np.testing.assert_allclose(slopes[:2, 2], [0.25, -0.25], atol=1e-6)  # -z is to the right
    np.testing.assert_allclose(slopes[::2, 1], [0.75, 0.25, -0.25, -0.75], atol=1e-6)
    assert np.tan(camera.fov_y / 2) == pytest.approx(1.0)
    views = Views(np.zeros((1, 4, 2, 4), np.float32), None, turned[None], np.ones((1, 3)), 0.9273)
    batch = views.batch(np.arange(8))
    np.testing.assert_allclose(batch.directions, directions, atol=1e-4)
