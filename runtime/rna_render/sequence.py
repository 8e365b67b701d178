"""Sequences: the frames of a scene's animation, each written as it is finished."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from pydantic import BaseModel

from rna_render.animation import frame_scene
from rna_render.output import Output
from rna_render.render import load_world
from rna_render.scene_file import SceneFile
from rna_render.terminal import Interrupt, render_with_bar, tell_tiers
from rna_sdk.console import INTERRUPTED


def frame_numbers(scene_file: SceneFile, first: int, last: int | None) -> range:
    """The frames from `first` to `last`, both included; None for the scene's last one.

    Raises SceneError if the scene has no such frames.
    """
    animation = scene_file.scene.animation
    if animation is None:
        raise scene_file.error(("animation",), "is missing, and --frames needs it")
    end = animation.frames - 1 if last is None else last
    if end >= animation.frames:
        message = f"the scene has frames 0 to {animation.frames - 1}, and no frame {end}"
        raise scene_file.error(("animation", "frames"), message)
    return range(first, end + 1)


def render_sequence(
    scene_file: SceneFile, numbers: range, output: Output, threads: int, started: float
) -> int:
    """Render the frames that are not there yet. Returns the exit status.

    output: names with a place for the number. started: when the program did, as perf_counter.
    A frame that Ctrl-C ends is not written.
    """
    changed = _last_change(scene_file)
    world, seconds = None, []
    with Interrupt() as interrupt:
        for place, number in enumerate(numbers, 1):
            if interrupt.requested():
                return _stopped(number)
            scene, files = frame_scene(scene_file.scene, number), output.frame(number)
            if files.is_there(scene, changed):
                print(f"frame {number}: is there already")
                continue
            files.check()
            start = time.perf_counter()
            if world is None:
                views = [frame_scene(scene_file.scene, n) for n in numbers]
                world = load_world(scene_file, views)
                tell_tiers(scene_file, world)
                start = time.perf_counter()
                print(f"assets loaded after {start - started:.2f} s", file=sys.stderr)
            what = f"frame {number} ({place} of {len(numbers)})"
            film = render_with_bar(
                replace(scene_file, scene=scene), world, interrupt.requested, what
            )
            if interrupt.requested() and film.samples < scene.samples:
                return _stopped(number)
            files.write(scene, film)
            seconds.append(time.perf_counter() - start)
            paths = ", ".join(str(path) for path in files.paths())
            left = _in_words(sum(seconds) / len(seconds) * (len(numbers) - place))
            print(f"{what}: wrote {paths} in {seconds[-1]:.1f} s; about {left} left", flush=True)
    return 0


def _stopped(number: int) -> int:
    print(f"stopped before the end of frame {number}; the same command goes on", file=sys.stderr)
    return INTERRUPTED


def _last_change(scene_file: SceneFile) -> float:
    """When the newest of the files that the scene names was changed; for ever if one is missing."""
    paths = (scene_file.resolve(path) for path in _named_paths(scene_file.scene))
    try:
        return max((path.stat().st_mtime for path in paths), default=0.0)
    except OSError:
        return float("inf")


def _named_paths(value: object) -> Iterator[Path]:
    """All paths anywhere in a part of a scene."""
    if isinstance(value, Path):
        yield value
    elif isinstance(value, BaseModel):
        for _, part in value:
            yield from _named_paths(part)
    elif isinstance(value, tuple):
        for part in value:
            yield from _named_paths(part)


def _in_words(seconds: float) -> str:
    return f"{seconds:.0f} s" if seconds < 100 else f"{seconds / 60:.0f} min"
