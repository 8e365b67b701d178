"""Trainings by turns, and beside what comes next."""

from __future__ import annotations

from threading import Event

import pytest

from rna_export.make.phases import Trainer
from rna_sdk.errors import TrainingError


def test_by_turns_a_training_is_over_when_it_returns() -> None:
    done: list[int] = []
    with Trainer(beside=False) as trainer:
        trainer.run(lambda: done.append(1))
        assert done == [1]
        trainer.wait()


def test_beside_it_goes_on_until_the_next_one() -> None:
    done: list[int] = []
    go_on = Event()

    def first() -> None:
        assert go_on.wait(10.0)
        done.append(1)

    with Trainer(beside=True) as trainer:
        trainer.run(first)
        assert done == []
        go_on.set()
        trainer.run(lambda: done.append(2))
        trainer.wait()
        assert done == [1, 2]


@pytest.mark.parametrize("beside", [False, True])
def test_an_error_is_raised_to_the_caller(beside: bool) -> None:
    def fail() -> None:
        raise TrainingError("diverged")

    with Trainer(beside) as trainer, pytest.raises(TrainingError, match="diverged"):
        trainer.run(fail)
        trainer.wait()
