"""The frame of the source that is shown, and whether it can be changed in an opened source."""

from typing import Any

import bpy

_fixed: dict[str, bool] = {"frame": False}


def opening() -> None:
    """A source is opened: nothing of it is kept at a frame."""
    _fixed["frame"] = False


def keep() -> None:
    """Something that the source moves was copied as it is at this frame."""
    _fixed["frame"] = True


def is_fixed() -> bool:
    """Whether another frame needs the source to be opened again."""
    return _fixed["frame"]


def go_to(frame: int | None) -> list[str]:
    """Show a frame, None for the shown one; returns notes for the user."""
    scene = bpy.context.scene
    if frame is None:
        return []
    scene.frame_set(frame)
    first, last = scene.frame_start, scene.frame_end
    if first <= frame <= last:
        return []
    return [
        f"frame {frame} is outside the scene's frames {first} to {last}: its animation goes on "
        "there as in Blender"
    ]


def span() -> dict[str, Any]:
    """First and last frame of the scene, and frames a second."""
    scene = bpy.context.scene
    rate = scene.render.fps / scene.render.fps_base
    return {"first": scene.frame_start, "last": scene.frame_end, "rate": rate}
