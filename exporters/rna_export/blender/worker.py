"""The capture worker: runs inside Blender's Python, with `bpy` and numpy and nothing else of ours.

    python worker.py THREADS PARENT

Requests come as one JSON object a line on standard input; each is answered by one line on
standard output that begins with `RNA `. Whatever else Blender prints there is not for us.
"""

import ctypes
import json
import os
import signal
import sys
import traceback
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parent))

from few_cores import few_cores

THREADS, PARENT = map(int, sys.argv[1:])
_PR_SET_PDEATHSIG = 1  # prctl(2)


def end_with_parent() -> None:
    """Linux: a Blender that is at work reads no end of input; it is to end with its parent."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)
        if os.getppid() != PARENT:
            sys.exit(1)


end_with_parent()

with few_cores(THREADS):
    import bpy
    from rna_geometry import curves_export, mesh_export, scene_parts
    from rna_geometry.shown_objects import as_rendered
    from rna_materials import base_colors, object_materials, surface_textures
    from rna_preflight import changing_materials, material_facts, smooth_glass
    from rna_renders import least_roughness, ray_render, render_settings, scene_render, white_card
    from rna_sources import gltf_variants, read_files, shown_frame, source_scene

_last_opened: dict[str, Any] = {}  # the request


def open_scene(request: dict[str, Any]) -> dict[str, Any]:
    read_files.watch()
    _last_opened.update(request)
    shown_frame.opening()
    gltf_variants.opening()
    notes = source_scene.load(
        request["source"], request["arguments"], request["frame"], request["front"], request["up"]
    )
    render_settings.apply()
    object_materials.override()
    notes += source_scene.keep_only_the_asset()
    glass = smooth_glass.leave_to_hosts(request["glass"])
    if glass and as_rendered(scene_parts.is_empty):
        names = ", ".join(repr(each["name"]) for each in glass)
        raise ValueError(f"all of it is smooth glass ({names}), which is left to the host")
    parts, materials = as_rendered(
        lambda: (scene_parts.find_parts(request["parts"]), material_facts.facts())
    )
    for each in [*materials, *glass]:
        (each["name"],) = printable([each["name"]])
    least_roughness.keep_above(request["leastRoughness"])
    has_hair = any(part["kind"] == "fiber" for part in parts)
    emitters = ray_render.configure(
        THREADS, request["clampDirect"], request["clampIndirect"], separate_direct=has_hair
    )
    return {
        "parts": parts,
        "notes": printable(notes),
        "blender": source_scene.blender_version(),
        "emitters": printable(emitters),
        "materials": materials,
        "changing": printable(as_rendered(changing_materials.changing)),
        "glass": glass,
        "variants": gltf_variants.found(),
        "files": read_files.files_of(request["source"]),
        "frame": bpy.context.scene.frame_current,
    }


def show_frame(request: dict[str, Any]) -> None:
    if shown_frame.is_fixed():
        open_scene({**_last_opened, "frame": request["frame"]})
    else:
        bpy.context.scene.frame_set(request["frame"])


HANDLERS = {
    "open": open_scene,
    "exportBaseColors": lambda r: base_colors.export_base_colors(
        r["out"], r["charts"], base_colors.Wish.of(r)
    ),
    "exportCurves": lambda r: as_rendered(
        lambda: curves_export.export_curves(r["out"], r["owner"])
    ),
    "exportMesh": lambda r: as_rendered(
        lambda: mesh_export.export_mesh(r["out"], r["owner"], r["charts"], r["ofHosts"])
    ),
    "exportTextures": lambda r: surface_textures.export_textures(r["out"], r["side"]),
    "frameSpan": lambda _: shown_frame.span(),
    "renderCard": white_card.render_card,
    "renderRays": ray_render.render_rays,
    "renderScene": scene_render.render_scene,
    "renderView": ray_render.render_view,
    "showFrame": show_frame,
    "showVariant": lambda r: gltf_variants.show(r["name"]),
}


def printable(texts: list[str]) -> list[str]:
    """The texts, escaped where they would end a line, move a cursor or are not UTF-8, as names."""
    return ["".join(c if c.isprintable() else ascii(c)[1:-1] for c in text) for text in texts]


def said_by(error: Exception) -> str:
    """One line."""
    text = str(error)
    if "Traceback (most recent call last)" in text:  # of an operator that is in Python
        outer = [line for line in text.splitlines() if line.strip() and not line[0].isspace()]
        cause = [line for line in outer if not line.startswith("Location:")][-1]
        return f"Blender cannot open it ({cause}); the file may be damaged"
    line = " ".join(text.split())  # Blender's are of several
    is_ours = type(error) is ValueError  # else Blender's, or a script's
    return line if is_ours else f"Blender says: {type(error).__name__}: {line}"


def reply(message: dict[str, Any]) -> None:
    sys.stdout.write("\nRNA " + json.dumps(message) + "\n")
    sys.stdout.flush()


def main() -> None:
    for line in sys.stdin:
        request = json.loads(line)
        try:
            reply({"ok": True, **(HANDLERS[request["op"]](request) or {})})
        except Exception as error:
            traceback.print_exc()
            (says,) = printable([said_by(error)])
            reply({"ok": False, "error": says})
    os._exit(0)  # bpy may crash while it unloads; every result is already a file


if __name__ == "__main__":
    main()
