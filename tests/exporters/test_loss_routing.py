"""The loss touches only the output that matches the sample's visibility."""

import pytest
import torch

from rna_export.capture.dataset.dataset_manifest import SAMPLE_FIELDS
from rna_export.training.optimization.fitting import Fitting
from rna_export.training.optimization.losses import sample_loss
from rna_export.training.optimization.samples import columns
from rna_export.training.presets import PRESETS
from tests.exporters.synthetic import tiny

ALL = [(kind, preset) for kind in PRESETS for preset in PRESETS[kind]]
BOUNDS = torch.tensor([[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]])


def gradient_of_the_outputs(kind: str, preset: str, visible: float) -> tuple[float, float]:
    """Largest gradient at the last layer's rows of the visible outputs and of the shadowed one."""
    torch.manual_seed(0)
    fields = SAMPLE_FIELDS[kind]
    fitting = Fitting(tiny(preset, kind, loss="log"), BOUNDS, 1.0, 1.0, fields)
    rows = torch.rand(64, sum(fields.values()))
    rows[:, -1] = visible
    sample_loss(fitting.model, columns(rows, fields), 4.0).backward()
    gradient = fitting.model.decoder[-1].weight.grad.abs()
    if (shadow := fitting.model.shadow) is not None:
        return gradient.max().item(), shadow.decoder[-1].weight.grad.abs().max().item()
    return gradient[:-3].max().item(), gradient[-3:].max().item()


@pytest.mark.parametrize(("kind", "preset"), ALL)
def test_visible_samples_leave_the_shadowed_output_alone(kind, preset):
    lit, shadowed = gradient_of_the_outputs(kind, preset, 1.0)
    assert lit > 0.0 and shadowed == 0.0


@pytest.mark.parametrize(("kind", "preset"), ALL)
def test_shadowed_samples_leave_the_visible_output_alone(kind, preset):
    lit, shadowed = gradient_of_the_outputs(kind, preset, 0.0)
    assert lit == 0.0 and shadowed > 0.0


@pytest.mark.parametrize("loss", ["log", "unbiased"])
@pytest.mark.parametrize("preset", ["small", "hq"])
def test_decoders_that_see_their_own_samples_learn_the_same(preset, loss):
    """As those that see all samples, of whose outputs the loss takes one."""
    torch.manual_seed(0)
    fields, lit = SAMPLE_FIELDS["surface"], 23
    rows = torch.rand(64, sum(fields.values()))
    rows[:, -1] = (torch.arange(64) < lit).float()
    results = []
    for given in (None, lit):
        torch.manual_seed(1)
        model = Fitting(tiny(preset, loss=loss), BOUNDS, 9.0, 1.0, fields).model
        value = sample_loss(model, columns(rows, fields), 1.0, loss, 1.0, given)
        value.backward()
        results.append([value, *(p.grad for p in model.parameters())])
    for one, other in zip(*results, strict=True):
        torch.testing.assert_close(one, other, rtol=1e-4, atol=1e-7)


@pytest.mark.parametrize("turned", [False, True])
def test_behind_the_normal_errors_of_light_count_as_in_shadow(turned):
    """They are relative above a tenth of the unit, not above the unit."""
    torch.manual_seed(0)
    fields = SAMPLE_FIELDS["surface"]
    model = Fitting(tiny("small", loss="unbiased"), BOUNDS, 9.0, 1.0, fields).model
    at = columns(torch.rand(64, sum(fields.values())), fields)
    at["visible"], at["wi"] = torch.ones(64), -at["normal"] if turned else at["normal"]
    x = torch.expm1(model(at)[:, 0].detach())
    relative = (x - at["radiance"]) / (x.clamp(min=0.0) + (0.1 if turned else 1.0))
    loss = sample_loss(model, at, 1.0, "unbiased")
    assert loss.item() == pytest.approx(relative.square().mean().item(), rel=1e-4)


def test_behind_the_normal_answers_far_off_have_a_loss():
    """Their radiance is beyond float32."""
    fields = SAMPLE_FIELDS["surface"]
    model = Fitting(tiny("small", loss="log"), BOUNDS, 9.0, 1.0, fields).model
    torch.nn.init.constant_(model.decoder[-1].bias, 100.0)
    at = columns(torch.rand(64, sum(fields.values())), fields)
    at["visible"], at["wi"] = torch.ones(64), -at["normal"]
    assert torch.isfinite(sample_loss(model, at, 1.0, "log"))


@pytest.mark.parametrize(("loss", "learnt"), [("log", 5.0**0.25 - 1.0), ("unbiased", 1.0)])
def test_the_loss_that_a_preset_names_decides_what_noise_does(loss, learnt):
    """Light that is 4 in one sample of four and else 0: its logarithm's mean is far below."""
    torch.manual_seed(0)
    fields = SAMPLE_FIELDS["surface"]
    preset = tiny("small", "surface", loss=loss)
    fitting = Fitting(preset, BOUNDS, 10.0, 1.0, fields)
    rows = torch.rand(1, sum(fields.values())).repeat(64, 1)
    rows[:, -4:-1] = 4.0 * (torch.arange(64) % 4 == 0)[:, None]
    rows[:, -1] = 1.0
    for _ in range(300):
        fitting.step(rows, 0.5)
    at = {"position": rows[:1, :3], "normal": rows[:1, 3:6], "wo": rows[:1, 6:9]}
    y = fitting.model({**at, "wi": rows[:1, 9:12]})
    mean = fitting.model.transport(y)[0, 0].mean().item()
    assert mean == pytest.approx(learnt, rel=0.05)


@pytest.mark.parametrize("weight", [1.0, 10.0])
def test_shadows_count_as_often_as_their_weight(weight):
    """A batch of light and shadow: its loss is the mean of both, weighted."""
    torch.manual_seed(0)
    fields = SAMPLE_FIELDS["surface"]
    preset = tiny("paper-small", "surface", shadow_weight=weight)
    rows = torch.rand(64, sum(fields.values()))
    rows[:, -1] = (torch.arange(64) % 4 == 0).float()

    def loss(rows: torch.Tensor) -> torch.Tensor:
        torch.manual_seed(1)
        return Fitting(preset, BOUNDS, 10.0, 1.0, fields).step(rows, 0.0)  # before it descends

    lit, shadowed = (loss(rows[rows[:, -1] == v]) for v in (1.0, 0.0))
    expected = (lit + 3.0 * weight * shadowed) / (1.0 + 3.0 * weight)
    assert torch.allclose(loss(rows), expected, rtol=1e-5)
    assert not torch.allclose(lit, shadowed, rtol=0.1)
