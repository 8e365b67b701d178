"""Ends a training when its time is up, and validates it in between."""

from __future__ import annotations

import sys
from typing import Any

import lightning
from lightning.pytorch.callbacks import Callback

from rna_export.training.pace import TimePace

NEVER = sys.maxsize
"""As Lightning's val_check_interval."""


class Timekeeper(Callback):
    """Validations at equal parts of the run's progress, the last one at its end."""

    def __init__(self, pace: TimePace, validations: int):
        self._pace, self._validations = pace, validations
        self._done = self._due()

    def on_train_batch_start(self, *_: Any) -> None:
        self._pace.step_begins()

    def on_train_batch_end(self, trainer: lightning.Trainer, *_: Any) -> None:
        self._pace.advance()
        due = self._due()
        trainer.val_check_batch = 1 if due > self._done else NEVER  # Lightning asks next
        trainer.should_stop = due == self._validations
        self._done = due

    def on_validation_start(self, *_: Any) -> None:
        self._pace.validation_begins()

    def _due(self) -> int:
        return int(self._pace.progress(0) * self._validations + 1e-9)
