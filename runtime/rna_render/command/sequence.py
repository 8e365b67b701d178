"""Sequences: the frames of a scene's animation, each written as it is finished."""

import sys
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, closing
from dataclasses import replace
from functools import partial
from pathlib import Path

from rna_render.command.frame_worker import Frame, FrameFiles, FrameJob, FrameWorker
from rna_render.image.output import Output
from rna_render.paths.integrator_factory import CPU
from rna_render.paths.world_in_time import QualityWarning
from rna_render.scene.animation import frame_scene
from rna_render.scene.scene_file import SceneFile
from rna_render.scene.scene_model import AnimationModel, Scene, TurnModel
from rna_render.world.scene_sources import carried_scene, contents_key, files_of
from rna_sdk.commands.console import INTERRUPTED
from rna_sdk.errors import SceneError
from rna_work.executors import Executor, check_shared
from rna_work.pool import Pool
from rna_work.progress import Progress
from rna_work.threads import HERE
from rna_work.workers import Outcome


def frame_numbers(scene_file: SceneFile, first: int, last: int | None) -> range:
    """The frames from `first` to `last`, both included; None for the scene's last one.

    Raises SceneError if the scene has no such frames.
    """
    animation = scene_file.scene.animation
    if animation is None:
        message = "is missing, and --frames all needs it; --frames 0-47 needs none"
        raise scene_file.error(("animation",), message)
    end = animation.frames - 1 if last is None else last
    if end >= animation.frames:
        message = f"the scene has frames 0 to {animation.frames - 1}, and no frame {end}"
        raise scene_file.error(("animation", "frames"), message)
    return range(first, end + 1)


def animated(scene_file: SceneFile, last: int | None) -> SceneFile:
    """The scene, and if it has no animation, one that ends with frame `last`.

    Its assets' motions play; without any, the camera makes a whole turn. None for no end, which
    leaves the scene as it is.
    """
    scene = scene_file.scene
    if scene.animation is not None or last is None:
        return scene_file
    moves = any(asset.motion is not None for asset in scene.assets)
    turn = None if moves else TurnModel()
    return scene_file.with_changes(animation=AnimationModel(frames=last + 1, turntable=turn))


def render_sequence(
    scene_file: SceneFile,
    numbers: range,
    output: Output,
    threads: int | None,
    started: float,
    executor: Executor,
    device: str = CPU,
) -> int:
    """Render the frames that are not there yet. Returns the exit status.

    output: names with a place for the number. threads: of a worker; None for all of its machine.
    started: when the program did, as perf_counter. device: of `devices`. A frame that Ctrl-C ends
    is not written.
    """
    output = replace(output, contents=_contents(scene_file))
    missing = _missing(scene_file.scene, files_of(scene_file), numbers, output)
    if not missing:
        return 0
    check_shared(executor, output.paths()[0].parent)
    backend, threads = executor.whole_machines(threads, needs_gpu=device != CPU)
    files = carried_scene(scene_file, executor)
    absolute = output.absolute() if executor.far else output
    job = FrameJob(scene_file, files, numbers, absolute, threads, started, device)
    try:
        tell = partial(print, flush=True)
        pool: Pool[Frame, FrameFiles] = Pool(backend, partial(FrameWorker, job), tell=tell)
        with pool:
            _take(pool, missing, executor)
    except KeyboardInterrupt:
        print(
            f"stopped: {_there(scene_file.scene, numbers, output)}; frames under way were not "
            "written; the same command goes on",
            file=sys.stderr,
        )
        return INTERRUPTED
    return 0


def _take(pool: Pool[Frame, FrameFiles], missing: list[Frame], executor: Executor) -> None:
    """Say of each frame that it is finished; on a cluster below a bar of the whole."""
    seconds: list[float] = []
    with ExitStack() as stack:
        running = stack.enter_context(closing(pool.run(missing)))
        outcomes: Iterator[Outcome[Frame, FrameFiles]] = running
        tell: Callable[[str], None] = partial(print, flush=True)
        if executor.far:  # this machine's own worker has a bar for each frame
            progress = stack.enter_context(Progress(len(missing), "frame", "frames"))
            outcomes, tell = progress.of(pool, outcomes), progress.tell
        for outcome in outcomes:
            frame = outcome.value()
            seconds.append(frame.seconds)
            for line in frame.warnings:
                warnings.warn(line, QualityWarning, stacklevel=1)
            workers = max(1, pool.nodes().total())
            left = (len(missing) - len(seconds)) / workers * sum(seconds) / len(seconds)
            tell(f"{_outcome_text(outcome, frame)}; about {_in_words(left)} left")


def _missing(scene: Scene, inputs: Sequence[Path], numbers: range, output: Output) -> list[Frame]:
    """The frames that are not there; raises RnaError if one of them cannot be written.

    inputs: files that the scene reads, which no frame may replace.
    """
    missing = []
    for index, number in enumerate(numbers, 1):
        files = output.frame(number)
        if files.is_there(frame_scene(scene, number)):
            print(f"frame {number}: is there already")
        else:
            files.check(inputs)
            missing.append(Frame(number, f"frame {number} ({index} of {len(numbers)})"))
    return missing


def _there(scene: Scene, numbers: range, output: Output) -> str:
    """How many frames the files on disk have, and of how many samples each is the mean."""
    frames = ((n, output.frame(n)) for n in numbers)
    there = ((n, files) for n, files in frames if files.paths()[-1].is_file())  # written last
    count = sum(files.is_there(frame_scene(scene, n)) for n, files in there)
    limited = scene.quality is not None and scene.quality.seconds is not None
    of = f"at most {scene.samples}" if limited else str(scene.samples)
    return f"{count} of {len(numbers)} frames are written, each of {of} samples"


def _outcome_text(outcome: Outcome[Frame, FrameFiles], frame: FrameFiles) -> str:
    paths = ", ".join(str(path) for path in frame.paths)
    on = "" if outcome.node == HERE else f" on {outcome.node}"
    return f"{outcome.item.what}: wrote {paths} in {frame.seconds:.1f} s{on}"


def _contents(scene_file: SceneFile) -> str | None:
    """Key of the files that the scene reads; None if one is missing, which its loading tells."""
    try:
        return contents_key(scene_file)
    except SceneError:
        return None


def _in_words(seconds: float) -> str:
    return f"{seconds:.0f} s" if seconds < 100 else f"{seconds / 60:.0f} min"
