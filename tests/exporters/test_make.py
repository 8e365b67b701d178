"""A make by turns, without Blender: rays of a known ball take the place of Cycles'."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from threading import Event
from typing import Any

import numpy as np
import pytest

from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.capture_run import CaptureWorkers
from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.capture_tasks import Task, TrainingShard, WhiteRays
from rna_export.capture.dataset.completeness import record_files
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.sample_files import write_parts
from rna_export.capture.time_plan import TimeLimit
from rna_export.make import capture_rounds as rays_module
from rna_export.make import make_run as run_module
from rna_export.make import phases as phases_module
from rna_export.make import plan as plan_module
from rna_export.make import training_floor
from rna_export.make.goal import Goal
from rna_export.make.make_options import MakeOptions
from rna_export.make.make_run import Made, Make
from rna_export.make.phases import Trainer
from rna_export.make.state import Score, read_state
from rna_export.training import report as report_module
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.presets import PRESETS
from rna_export.training.report import Curves
from rna_sdk.errors import CaptureError, TrainingError
from tests.exporters.synthetic import (
    RAYS,
    make_dataset,
    samples_of_light,
    tiny,
    white_samples,
    write_view,
)
from tests.runtime.points import unit_vectors

SHARD = 4  # lights


class Stopped(BaseException):
    """As Ctrl-C, wherever the test wants it."""


@dataclass
class Cycles:
    """What renders: writes shards of the ball, and knows what it was asked.

    stop_after: raises `Stopped` in the place of the shard with this number in all. images: paths a
    pixel of each validation image.
    """

    stop_after: float = math.inf
    shards: int = 0
    images: list[int] = field(default_factory=list)

    def begin(self, source: Source, requested: dict[str, Any], out: Path, *_: Any) -> Dataset:
        dataset = make_dataset(out, shards=1).dataset
        for path in (dataset.train_path(0), *(out / "validation").iterdir()):
            path.unlink()
        settings = dataset.manifest.settings
        settings = settings.model_copy(update={"lights": 64, "lights_per_shard": SHARD})
        dataset.manifest = dataset.manifest.model_copy(update={"settings": settings})
        dataset.plan_lights(64)
        return dataset

    def finish(
        self,
        dataset: Dataset,
        source: Source,
        workers: CaptureWorkers,
        limit: TimeLimit | None = None,
        say: object = None,
        tasks: Sequence[Task] = (),
        bars: object = None,
    ) -> None:
        for task in tasks:
            if task.path(dataset).is_file():
                continue
            if isinstance(task, WhiteRays):
                write_parts(task.path(dataset), {"asset": white_samples()})
                continue
            if not isinstance(task, TrainingShard):
                self.images.append(dataset.manifest.settings.validation_samples)
                write_view(dataset, task.view, np.random.default_rng([8, task.view]))
                continue
            if self.shards >= self.stop_after:
                raise Stopped
            self.shards += 1
            rng = np.random.default_rng([9, task.index])
            wi = np.repeat(unit_vectors(rng, SHARD), RAYS, axis=0)
            write_parts(task.path(dataset), {"asset": samples_of_light(rng, wi)})


@pytest.fixture
def make(monkeypatch, tmp_path):
    """Runs a make of tiny models in `<tmp_path>/work`."""
    for name, width in (("tiny", 16), ("small", 24)):
        preset = tiny(name, steps=80, optimizer="adam").with_model(width=width)
        monkeypatch.setitem(PRESETS["surface"], name, preset)
    monkeypatch.setattr(plan_module, "LEAST_GAIN_DB", 3.0)  # three rounds or four
    monkeypatch.setattr(Curves, "draw", lambda _: None)
    monkeypatch.setattr(report_module, "write_images", lambda *_: None)

    def run(
        presets: tuple[str, ...] = ("small",),
        goal: Goal | None = None,
        minutes: float | None = None,
        stop_after: float = math.inf,
        work: Path = tmp_path / "work",
        more: float | None = None,
        update: bool = False,
        text: str = "",
        **settings: Any,
    ) -> tuple[Made, Cycles]:
        cycles = Cycles(stop_after)
        monkeypatch.setattr(rays_module, "begin", cycles.begin)
        monkeypatch.setattr(rays_module, "finish", cycles.finish)
        workers = CaptureWorkers(Path("python"), tmp_path / "scratch", 1)
        source = Source(tmp_path / "ball.py")
        source.path.write_text(text)
        options = MakeOptions(
            source,
            settings,
            None,
            work,
            presets,
            goal,
            minutes,
            None,
            0,
            "cpu",
            "auto",
            workers,
            more=more,
            update=update,
        )
        return Make(options, run_module.monotonic(), print).run(), cycles

    return run


def test_without_a_goal_it_ends_when_the_error_stops_falling(make, tmp_path):
    made, _ = make(presets=("tiny", "small"))
    assert made.why == "stopped falling" and made.rounds >= 3
    assert made.lead == "small" and len(made.checkpoints) == 2
    tiny_folder, small_folder = made.checkpoints
    assert tiny_folder == tmp_path / "work" / "runs" / "tiny" / "last"
    assert load_checkpoint(tiny_folder / "best.ckpt").steps == 80
    assert small_folder.parent == tmp_path / "work" / "runs" / "small"
    lights = [int(p.stem) for p in (tmp_path / "work" / "rays" / "train").iterdir()]
    assert len(lights) * SHARD == made.dataset.manifest.settings.lights


@pytest.fixture(scope="module")
def whole_run():
    """Calls of `whole`, once it was made."""
    return []


@pytest.fixture
def whole(make, whole_run, tmp_path_factory):
    """A make without a goal that nothing stopped."""
    if not whole_run:
        whole_run.append(make(work=tmp_path_factory.mktemp("whole") / "work"))
    return whole_run[0]


def test_each_round_adds_rays(whole):
    made, cycles = whole
    assert cycles.shards > 4
    samples = made.dataset.only.training_samples()
    assert len(samples["visible"]) == cycles.shards * SHARD * RAYS


def test_images_are_small_in_rounds_and_as_large_as_there_was_time_for_at_the_end(
    whole,
):
    made, cycles = whole
    first, *_, last = cycles.images
    usual = CaptureSettings().validation_samples
    assert len(cycles.images) == 4 and first < usual / 2  # two, each rendered twice
    assert made.dataset.manifest.settings.validation_samples == last == usual
    state = read_state(made.dataset.folder.parent)
    assert state.images is None and all(round_.score is not None for round_ in state.rounds)


def test_a_goal_that_is_met_ends_the_rounds_and_spares_the_last_phase(make):
    made, _ = make(goal=Goal("min_psnr", 5.0))
    assert (made.why, made.rounds) == ("goal met", 1)
    assert made.checkpoints[0].name == "round-01"


def test_the_last_phase_is_longer_than_the_rounds(whole):
    made, _ = whole
    last = made.dataset.folder.parent / "runs" / "small" / "last"
    rounds = [load_checkpoint(f / "best.ckpt").steps for f in sorted(last.parent.glob("round-*"))]
    assert load_checkpoint(last / "best.ckpt").steps > max(rounds) >= 10


@pytest.mark.parametrize(("goal", "rounds"), [(None, 1), (Goal("min_psnr", 90.0), 2)])
def test_minutes_end_it(make, goal, rounds, capsys):
    made, _ = make(minutes=0.05, goal=goal)
    assert made.why == "time is up" and made.rounds == rounds
    output = capsys.readouterr().out
    assert " triangles\nplan: " in output
    assert f"(64 lights x {RAYS:,} view rays fit into the time); then the last training" in output
    assert made.checkpoints[0].name in ("round-01", "last")


@pytest.mark.parametrize("minutes", [None, 0.05])
def test_trainings_beside_captures_come_to_the_same_end(make, monkeypatch, minutes):
    """As with a GPU: the capture of a round begins before the training of the last has ended."""
    monkeypatch.setattr(MakeOptions, "overlaps", True)
    goal = None if minutes is None else Goal("min_psnr", 90.0)
    made, _ = make(minutes=minutes, goal=goal)
    assert made.why == ("stopped falling" if minutes is None else "time is up")
    rounds = sorted(path.name for path in made.checkpoints[0].parent.glob("round-*"))
    assert len(rounds) >= made.rounds - 1
    assert made.checkpoints[0].name in (*rounds, "last")


def test_lights_have_one_round_and_no_training_but_the_last(make):
    made, cycles = make(presets=("tiny", "small"), lights=64)
    assert (made.why, made.rounds) == ("lights used up", 1)
    assert cycles.shards * SHARD == 64
    assert [folder.name for folder in made.checkpoints] == ["last", "last"]
    assert [load_checkpoint(f / "best.ckpt").steps for f in made.checkpoints] == [80, 80]


@pytest.mark.parametrize("stage", ["rays 0", "rays 3", "train 2", "last"])
def test_a_make_stopped_at_any_stage_comes_to_the_same_end(stage, make, monkeypatch, whole):
    expected_made, _ = whole
    expected = load_checkpoint(expected_made.checkpoints[0] / "best.ckpt").model.state_dict()

    with monkeypatch.context() as patch, pytest.raises(Stopped):
        stop_in(stage, patch)
        make(stop_after=int(stage.split()[1]) if stage.startswith("rays") else math.inf)
    made, _ = make()
    actual = load_checkpoint(made.checkpoints[0] / "best.ckpt").model.state_dict()
    assert made.rounds == expected_made.rounds and made.why == expected_made.why
    assert made.checkpoints[0].name == expected_made.checkpoints[0].name
    for name, weights in expected.items():
        np.testing.assert_array_equal(actual[name], weights, name)


def test_rays_that_were_replaced_are_refused(make, tmp_path):
    with pytest.raises(Stopped):
        make(stop_after=1)
    (manifest,) = (tmp_path / "work").rglob("manifest.json")
    dataset = Dataset(manifest.parent)
    record_files(dataset)
    shard = dataset.train_path(0)
    shard.write_bytes(shard.read_bytes() + b" ")
    with pytest.raises(CaptureError, match=r"1 of \d+ files are replaced .*00000"):
        make()
    shard.unlink()
    with pytest.raises(Stopped):
        make(stop_after=1)


def stop_in(stage: str, patch: pytest.MonkeyPatch) -> None:
    """Raise `Stopped` in the training of a round, or in the last one."""
    if stage == "last":
        patch.setattr(run_module.Make, "_last_phase", stopping)
    elif stage.startswith("train"):
        train, count = phases_module.train, iter(range(int(stage.split()[1]) - 1))

        def counted(run: Any, *more: Any) -> Path:
            if next(count, None) is None:
                half_way(run, *more)
            return train(run, *more)

        def half_way(run: Any, table: Any, say: Any, _: Any) -> None:
            def bars(**options: Any) -> Any:
                return Bar(options["total"] // 2)

            train(run, table, say, bars)

        patch.setattr(phases_module, "train", counted)


class Bar:
    """Raises `Stopped` after so many steps."""

    def __init__(self, left: int):
        self._left = left

    def __enter__(self) -> "Bar":
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def update(self, n: int = 1) -> None:
        self._left -= n
        if self._left < 0:
            raise Stopped

    def set_postfix(self, **_: str) -> None:
        pass


def stopping(*_: Any, **__: Any) -> None:
    raise Stopped


def test_another_order_in_the_same_folder_is_refused(make):
    make(goal=Goal("min_psnr", 5.0))
    with pytest.raises(TrainingError, match="was started with goal"):
        make(goal=Goal("min_psnr", 6.0))


@pytest.fixture
def starts(monkeypatch):
    """Where each training starts from, in order."""
    noted: list[Path | None] = []
    train = phases_module.train

    def noting(run: Any, *more: Any) -> Path:
        noted.append(run.start)
        return train(run, *more)

    monkeypatch.setattr(phases_module, "train", noting)
    return noted


def test_more_minutes_go_on_from_the_rays_and_the_model(make, starts, tmp_path, capsys):
    first, cycles = make(minutes=0.05, goal=Goal("min_psnr", 90.0))
    before = sorted((tmp_path / "work" / "rays" / "train").iterdir())
    assert len(before) == cycles.shards and read_state(tmp_path / "work").is_finished
    assert starts == [None, None]  # of the first round and of the end
    made, more = make(minutes=0.05, more=0.05)
    assert starts[2:] == [tmp_path / "work" / "before" / "small" / "best.ckpt"]
    assert "0.05 more minutes" in capsys.readouterr().out
    assert made.why == "time is up" and made.rounds == first.rounds + 1
    after = sorted((tmp_path / "work" / "rays" / "train").iterdir())
    assert more.shards >= 1 and len(after) == len(before) + more.shards
    state = read_state(tmp_path / "work")
    assert state.is_finished and state.before["small"].psnr >= state.last["small"].score.psnr


def test_a_model_of_too_few_steps_is_no_package_and_its_rays_are_kept(make, monkeypatch, tmp_path):
    with monkeypatch.context() as patch, pytest.raises(TrainingError) as error:
        patch.setattr(training_floor, "_FLOOR", 1e6)
        make(minutes=0.05)
    lights = read_state(tmp_path / "work").rounds[-1].lights
    assert "expected 80,000,000 at least for a package" in str(error.value)
    assert f"{lights} lights are kept: --more " in str(error.value)
    made, _ = make(minutes=0.05, more=0.05)
    assert made.why == "time is up" and made.rounds == 2


@pytest.mark.parametrize("then", [0.05, 0.04])
def test_more_minutes_that_were_stopped_go_on(then, make, tmp_path):
    """They begin anew if another number is given, as after a typing error."""
    make(minutes=0.05)
    with pytest.raises(Stopped):
        make(minutes=0.05, more=0.05, stop_after=0)
    begun = read_state(tmp_path / "work").more
    made, _ = make(minutes=0.05, more=then)
    more = read_state(tmp_path / "work").more
    assert made.rounds == 2 and more.minutes == then and (more == begun) == (then == 0.05)


def test_the_better_model_is_kept(make, monkeypatch):
    """A few more seconds make a worse one: the package has that of before."""
    first, _ = make(minutes=0.05)
    expected = load_checkpoint(first.checkpoints[0] / "best.ckpt").model.state_dict()
    monkeypatch.setattr(run_module, "score", lambda *_: Score(psnr=1.0, flip=1.0))
    made, _ = make(minutes=0.05, more=0.03)
    actual = load_checkpoint(made.checkpoints[0] / "best.ckpt").model.state_dict()
    assert made.checkpoints[0].parent.name == "before"
    for name, weights in expected.items():
        np.testing.assert_array_equal(actual[name], weights, name)


def test_more_needs_rays(make):
    with pytest.raises(TrainingError, match="found no rays to continue with"):
        make(more=0.05)


def test_an_option_of_new_rays_may_change_with_more(make):
    make(minutes=0.05)
    with pytest.raises(TrainingError, match=r"ball\.py has changed since .*: --update captures"):
        make(minutes=0.05, text="red")
    with pytest.raises(TrainingError, match="--sharpest: is for new rays"):
        make(minutes=0.05, sharpest=0.05)
    with pytest.raises(TrainingError, match="was started with settings"):
        make(minutes=0.05, more=0.05, rays=9)
    made, _ = make(minutes=0.05, more=0.05, sharpest=0.05)
    assert made.dataset.manifest.settings.sharpest == 0.05


def test_an_update_starts_from_the_old_model_where_the_geometry_is_the_same(
    make, starts, tmp_path, capsys
):
    make(minutes=0.05)
    make(minutes=0.03, update=True, text="red")
    assert "asset has the same geometry" in capsys.readouterr().out
    assert starts == [None, tmp_path / "work" / "before" / "small" / "best.ckpt"]
    state = read_state(tmp_path / "work")
    assert state.is_finished and state.starts == ("asset",)
    (tmp_path / "work" / "rays" / "geometry" / "asset.safetensors").write_bytes(b"another")
    make(minutes=0.03, update=True, text="green")
    assert "asset has another geometry: its training starts anew" in capsys.readouterr().out
    assert starts[2:] == [None] and read_state(tmp_path / "work").starts == ()


def test_an_update_needs_something_to_start_from(make):
    with pytest.raises(TrainingError, match="starts from the rays and models of a finished"):
        make(minutes=0.03, update=True)


def test_a_damaged_state_is_one_line(make, tmp_path):
    make(goal=Goal("min_psnr", 5.0))
    (tmp_path / "work" / "make.json").write_text("{")
    with pytest.raises(TrainingError, match=r"make\.json"):
        make(goal=Goal("min_psnr", 5.0))


def test_beside_it_goes_on_until_the_next_one():
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
def test_an_error_of_a_training_is_raised_to_the_caller(beside):
    def fail() -> None:
        raise TrainingError("diverged")

    with Trainer(beside) as trainer, pytest.raises(TrainingError, match="diverged"):
        trainer.run(fail)
        trainer.wait()
