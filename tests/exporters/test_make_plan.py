"""When a make stops, and how it shares lights, steps and minutes among its rounds."""

import math
from itertools import pairwise

import pytest

from rna_export.make.plan import (
    CAPTURE,
    LEAST_GAIN_DB,
    MARGIN_DB,
    FixedPlan,
    Length,
    MorePlan,
    OpenPlan,
    TimedPlan,
    capture_share,
    verdict,
)

NONE = -math.inf


@pytest.mark.parametrize(
    ("psnr", "goal", "actual"),
    [
        ([], 36.0, None),
        ([30.0], 36.0, None),
        ([30.0, 35.0], 36.0, None),
        ([30.0, 36.0 + 2 * MARGIN_DB], 36.0, "goal met"),
        ([30.0, 36.0 + MARGIN_DB / 2], 36.0, None),  # a package loses a little
        ([30.0, 37.0, 35.0], 36.0, "goal met"),  # the best round is exported
        ([30.0, 30.1, 30.2], 36.0, "stopped falling"),
        ([30.0, 30.1, 30.1 + LEAST_GAIN_DB], 36.0, None),
        ([30.0, 33.0, 33.1, 33.2], None, "stopped falling"),
        ([30.0, 33.0, 33.1], None, None),
        ([33.0, 31.0, 31.0], None, "stopped falling"),
        ([30.0, 50.0], None, None),
    ],
)
def test_stop_rule(psnr, goal, actual):
    assert verdict([-x for x in psnr], NONE if goal is None else -goal) == actual


def test_rounds_grow_and_end_in_full_length():
    plan, lights, after = OpenPlan(2000, 16, 40_000), [], 0
    for k in range(8):
        after = plan.lights_of(k, after)
        lights.append(after)
        assert plan.capture_seconds(k, math.inf) is None
    assert lights[0] == 256 and all(n % 16 == 0 for n in lights)
    assert all(1.3 < b / a < 1.7 for a, b in pairwise(lights))
    assert all(b - a <= 1008 for a, b in pairwise(lights))  # half of the usual ones at most
    steps = [plan.phase(k, math.inf).steps for k in range(8)]
    assert steps[0] == 5000 and steps == sorted(steps) and max(steps) == 40_000
    assert plan.last_phase(math.inf, 2) == Length(steps=40_000)


def test_a_gpu_leaves_more_time_for_capture():
    assert capture_share(300.0, [64], "cuda") > capture_share(300.0, [64], "cpu")
    plans = [TimedPlan(2000, 16, 600.0, overlaps=overlaps) for overlaps in (False, True)]
    apart, beside = ([p.capture_seconds(k, 300.0) for k in range(4)] for p in plans)
    assert apart[0] == beside[0]
    assert all(a > b for a, b in zip(apart[1:], beside[1:], strict=True))  # of the same time left


def test_a_round_adds_a_shard_at_least():
    assert OpenPlan(8, 16, 100).lights_of(0, 0) == 16
    assert OpenPlan(8, 16, 100).lights_of(1, 16) == 32


@pytest.mark.parametrize(("minutes", "rounds"), [(2.0, 2), (30.0, 4)])
@pytest.mark.parametrize("tiers", [1, 2])
def test_stages_fill_the_time_and_leave_some_for_the_export(minutes, rounds, tiers):
    plan = TimedPlan(1000, 16, 60.0 * minutes, tiers)
    assert plan.rounds == rounds
    left, captured = 60.0 * minutes, 0.0
    for k in range(rounds):
        capture = plan.capture_seconds(k, left)
        captured += capture
        left -= capture
        phase = plan.phase(k, left)
        assert (phase is None) == (k == rounds - 1)
        left -= 60.0 * phase.minutes if phase else 0.0
    for k in range(tiers):
        left -= 60.0 * plan.last_phase(left, tiers - k).minutes
    export = tiers * min(30.0, 0.05 * 60.0 * minutes)
    assert left == pytest.approx(export, abs=0.5)
    assert captured == pytest.approx(CAPTURE * (60.0 * minutes - export), rel=0.01)


def test_without_a_goal_the_time_has_one_round():
    plan = TimedPlan(1000, 16, 600.0, has_goal=False)
    assert plan.rounds == 1 and plan.phase(0, 300.0) is None
    captured = plan.capture_seconds(0, 600.0)
    assert captured == pytest.approx(CAPTURE * (600.0 - 30.0))
    assert plan.last_phase(600.0 - captured, 1).minutes == pytest.approx(captured / 60.0, abs=0.01)


@pytest.mark.parametrize(
    ("minutes", "widths", "share"),
    [
        (2, [64], 0.5),
        (4, [64], 0.5),
        (5, [64], 0.6),
        (8, [64], 0.75),
        (60, [64], 0.75),
        (20, [64, 256], 0.5),
        (200, [64, 256], 0.75),
    ],
)
def test_training_has_two_minutes_then_capture_gets_more(minutes, widths, share):
    assert capture_share(60.0 * minutes, widths) == pytest.approx(share)
    plan = TimedPlan(1000, 16, 60.0 * minutes, has_goal=False, capture=share)
    captured = plan.capture_seconds(0, 60.0 * minutes)
    left = 60.0 * plan.last_phase(60.0 * minutes - captured, 1).minutes
    assert captured == pytest.approx(share * (captured + left), rel=1e-3)


@pytest.mark.parametrize("steps", [100_000, None])
def test_lights_that_are_asked_for_are_all_captured_at_once(steps):
    plan = FixedPlan(3520, steps)
    assert plan.rounds == 1 and plan.lights_of(0, 0) == 3520
    assert plan.capture_seconds(0, math.inf) is None and plan.phase(0, math.inf) is None
    assert plan.last_phase(math.inf, 2) == Length(steps=steps)


@pytest.mark.parametrize(
    ("before", "more", "capture"),
    [
        # A single run of 15 minutes has 225 s for training; half of the 150 s before are spared.
        (300.0, 600.0, 420.0),
        (180.0, 180.0, 96.0),
        (60.0, 1200.0, 870.0),
        (180.0, 60.0, 17.1),  # at least .3 of what is there
    ],
)
def test_more_minutes_leave_the_training_of_a_single_run_less_what_is_spared(before, more, capture):
    whole = before + more
    plan = MorePlan(16, more, 0.5 * before, 64, 1, capture_share(whole, [64]), whole)
    assert plan.rounds == 2 and plan.phase(1, more) is None
    seconds = plan.capture_seconds(1, more)
    assert seconds == pytest.approx(capture, rel=0.01)
    usable = more - min(30.0, 0.05 * more)
    assert plan.last_phase(more - seconds, 1).minutes == pytest.approx(
        (usable - seconds) / 60, abs=1e-3
    )


def test_more_lights_are_planned_than_the_time_is_for():
    plan = MorePlan(16, 600.0, 150.0, 320, 1, 0.5, 900.0)
    assert plan.lights_of(1, 320) == 320 + 1664  # 1.3 times those of 10 minutes, in shards
