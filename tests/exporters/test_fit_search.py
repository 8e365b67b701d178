"""The search for the cheapest model that suffices, on errors that follow known laws."""

from __future__ import annotations

from collections import Counter

import pytest

from rna_export.fit.goal import Goal
from rna_export.fit.search import Candidate, search
from rna_export.metrics import NoiselessPsnr
from rna_export.trials.scores import ModelScores
from rna_export.trials.trial import Trial
from rna_sdk.errors import TrainingError
from tests.exporters.synthetic import tiny

STEPS = 1600


def scores(psnr: float) -> ModelScores:
    return ModelScores(
        psnr=psnr,
        psnr_without_noise=NoiselessPsnr(psnr, psnr, psnr),
        flip=10.0 ** (-psnr / 20.0),
        p99=0.1,
        relative_mse=0.1,
        views=(),
    )


class Lab:
    """Models whose PSNR after `steps` is `best - lag (STEPS / steps)^0.3`; it counts trainings."""

    def __init__(self, laws: list[tuple[float, float, float]]) -> None:
        """laws: (ns, best, lag) of each model."""
        self.laws, self.cost = {}, Counter()
        self.candidates = []
        for number, (ns, best, lag) in enumerate(laws):
            trial = Trial(name=f"m{number}", family="ours", preset=tiny())
            self.laws[trial.name] = best, lag
            self.candidates.append(Candidate(trial, "float32-float16", ns))

    def train(self, wanted: list[Candidate], steps: int) -> None:
        for candidate in wanted:
            if steps not in candidate.scores:
                best, lag = self.laws[candidate.trial.name]
                candidate.scores[steps] = scores(best - lag * (STEPS / steps) ** 0.3)
                self.cost[steps] += 1

    def search(self, goal: Goal, width: int = 1) -> Candidate:
        return search(self.candidates, goal, STEPS, self.train, width)


def ladder() -> Lab:
    """Sixteen models, each a tenth dearer and half a decibel better than the one before."""
    return Lab([(10.0 * 1.1**k, 30.0 + 0.5 * k, 3.0) for k in range(16)])


@pytest.mark.parametrize("limit", [26.0, 27.2, 30.1, 34.4])
@pytest.mark.parametrize("width", [1, 2, 4])
def test_it_finds_the_cheapest_that_suffices(limit: float, width: int) -> None:
    lab = ladder()
    chosen = lab.search(Goal("min_psnr", limit), width)
    enough = [c for c in lab.candidates if lab.laws[c.trial.name][0] - 3.0 >= limit]
    assert chosen is min(enough, key=lambda c: c.ns)
    assert lab.cost[STEPS] <= 3 and lab.cost[STEPS // 4] <= 9
    assert "chosen" in chosen.verdict
    assert all(c.verdict for c in lab.candidates if c is not chosen)


def test_limit_on_flip_and_on_psnr_agree() -> None:
    limit = 30.1
    by_psnr = ladder().search(Goal("min_psnr", limit))
    by_flip = ladder().search(Goal("max_error", 10.0 ** (-limit / 20.0)))
    assert by_psnr.trial.name == by_flip.trial.name


def test_lax_limit_leaves_dear_models_untrained() -> None:
    lab = ladder()
    assert lab.search(Goal("min_psnr", 15.0)).trial.name == "m0"
    assert lab.cost.total() <= 4


def test_dear_and_bad_models_are_dropped_on_the_first_rung() -> None:
    lab = Lab([(10, 30, 3), (20, 25, 3), (30, 32, 3)])
    assert lab.search(Goal("min_psnr", 28.5)).trial.name == "m2"
    assert "m0" in lab.candidates[1].verdict
    assert list(lab.candidates[1].scores) == [STEPS // 16]


def test_slow_learner_is_not_ruled_out_by_its_first_rungs() -> None:
    lab = Lab([(10, 30, 3), (20, 36, 6), (40, 36.5, 3)])
    assert lab.search(Goal("min_psnr", 29.5)).trial.name == "m1"


def test_limit_out_of_reach_says_what_was_found() -> None:
    with pytest.raises(TrainingError, match=r"no model has a PSNR of at least 50 dB.* dB$"):
        ladder().search(Goal("min_psnr", 50.0))


def test_best_within_a_cost() -> None:
    lab = ladder()
    chosen = lab.search(Goal("budget", 20.0))
    assert chosen.ns == max(c.ns for c in lab.candidates if c.ns <= 20.0)
    assert lab.cost[STEPS] == 1
    with pytest.raises(TrainingError, match="the cheapest, m0"):
        ladder().search(Goal("budget", 5.0))
