"""Options of an `rna-make` that continues an earlier one: omitted options keep their values."""

import argparse
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rna_export.make.state import State, read_state
from rna_sdk.errors import TrainingError

_PRESETS = ("small",)
_UPDATE = 1 / 3  # of the time that was spent
_LEAST = 0.1  # minutes that are worth going on for


@dataclass(frozen=True)
class CarriedOptions:
    """Options that a run takes over: see `MakeOptions`. settings: all except the given ones."""

    presets: tuple[str, ...]
    arguments: tuple[str, ...]
    settings: dict[str, Any]
    seed: int
    minutes: float | None
    more: float | None


def carried_options(
    args: argparse.Namespace, work: Path, arguments: tuple[str, ...], elsewhere: float = 0.0
) -> CarriedOptions:
    """The options of this command, with the options of the run that it continues.

    `--minutes` above those of the run there are more minutes for it. elsewhere: of the given
    minutes, those that are not for rays and models. Raises `TrainingError` for a damaged run, and
    where no time is left.
    """
    state, given = read_state(work), tuple(args.presets or ())
    total, more = (None if m is None else m - elsewhere for m in (args.minutes, args.more))
    if state is not None and more is None and not args.update:
        more = _more(total, state)
    if state is None or not (more or args.update):
        return CarriedOptions(given or _PRESETS, arguments, {}, args.seed, total, more)
    before = state.settings
    minutes = before.minutes
    if args.update and (state.is_finished or total is not None):
        minutes = total or round(max(1.0, _UPDATE * state.seconds / 60.0), 2)
    return CarriedOptions(
        given or before.presets,
        arguments or before.arguments,
        {k: v for k, v in before.settings.items() if k != "lights" or not args.update},
        args.seed or before.seed,
        minutes,
        more,
    )


def _more(total: float | None, state: State) -> float | None:
    """Minutes to go on for; None where none are due. total: minutes in all."""
    before = state.settings.minutes
    if total is None or before is None or total == before:
        return None
    spent = state.seconds / 60.0
    if state.more is not None and not state.is_finished:
        spent = state.more.begun / 60.0
    if total < spent + _LEAST:
        raise TrainingError(
            f"--minutes {total:g}: {spent:.1f} are spent already, expected more; --more 10 goes on "
            "for another 10"
        )
    return total - spent
