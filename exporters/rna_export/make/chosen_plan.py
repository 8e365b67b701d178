"""The plan of a run of `rna-make`, by its options and by earlier work."""

import math

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.make.make_options import MakeOptions
from rna_export.make.plan import FixedPlan, MorePlan, OpenPlan, Plan, TimedPlan
from rna_export.make.state import State
from rna_export.training.presets import PRESETS


def chosen_plan(options: MakeOptions, state: State, dataset: Dataset) -> Plan:
    """The plan of a run; state: of its earlier work."""
    lights, more = state.lights, state.more
    shard = dataset.manifest.settings.lights_per_shard
    if more is not None:
        whole, tiers = end_of(options, state), len(options.presets)
        return MorePlan(
            shard,
            60.0 * more.minutes,
            state.capture_seconds,
            state.rounds[more.rounds - 1].lights,
            more.rounds,
            options.share_of(whole),
            whole,
            tiers,
        )
    if options.minutes is not None:
        seconds, tiers = 60.0 * options.minutes, len(options.presets)
        share, has_goal = options.capture_share, options.goal is not None
        return TimedPlan(lights, shard, seconds, tiers, has_goal, share, options.overlaps)
    if options.fixes_lights:
        return FixedPlan(lights, options.steps)
    lead, kinds = max(options.presets, key=decoder_size), {part.kind for part in dataset.parts}
    usual = max(PRESETS[kind][lead].training.steps for kind in kinds)
    return OpenPlan(lights, shard, options.steps or usual)


def end_of(options: MakeOptions, state: State) -> float:
    """Seconds spent in all when the time is up; infinite without a limit."""
    if state.more is not None:
        return state.more.begun + 60.0 * state.more.minutes
    return math.inf if options.minutes is None else 60.0 * options.minutes


def plan_text(plan: Plan, options: MakeOptions, state: State, dataset: Dataset) -> str:
    """The planned work, in a line."""
    rounds, presets = plan.rounds, " and ".join(options.presets)
    settings, more = dataset.manifest.settings, state.more
    if more is not None:
        had = state.rounds[more.rounds - 1].lights
        text = f"{more.minutes:g} more minutes after {more.begun / 60:.1f}: rays of more lights"
        return f"plan: {text} than the {had:,} so far, then the last training of {presets}"
    rays = f"{state.lights:,} lights x {settings.rays:,} view rays"
    if not options.fixes_lights:
        rays += " are usual" if options.minutes is None else " fit into the time"
    if rounds is None:
        goal = "" if options.goal is None else f"the goal is met ({options.goal}) or "
        until = f"until {goal}the error stops falling"
        text = f"rounds of rendering in Cycles and training, {until}"
    elif rounds == 1:
        text = "rendering in Cycles"
    else:
        text = f"{rounds} rounds of rendering in Cycles and training"
    return f"plan: {text} ({rays}); then the last training of {presets}, and the package"


def decoder_size(preset: str) -> int:
    """Weights of the hidden layers, about."""
    model = PRESETS["surface"][preset].model
    return model.hidden_layers * model.width**2
