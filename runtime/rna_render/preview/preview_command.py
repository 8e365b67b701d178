"""`rna-run --preview`, from a scene file to a page that is served until Ctrl-C."""

import sys
import threading
from importlib.util import find_spec
from pathlib import Path

from rna_render.image.denoise import Denoiser
from rna_render.paths.world_in_time import load_world
from rna_render.preview.lighting import lighting_choices
from rna_render.preview.server import PreviewServer
from rna_render.preview.session import Session
from rna_render.scene.scene_file import SceneFile
from rna_render.world.world_loading import warn_of_darkness
from rna_sdk.errors import SceneError


def preview(
    scene_file: SceneFile, threads: int, port: int = 0, environments: Path | None = None
) -> None:
    """Serve the scene's preview until Ctrl-C, and print its address once it is loaded.

    port: 0 for any that is free. environments: a folder with more images to light the scene with.
    Raises PreviewError for a port that is taken, and what load_world raises.
    """
    with PreviewServer(port) as server:
        world = load_world(scene_file)
        warn_of_darkness(scene_file.path, scene_file.scene.lights, world)
        choices = lighting_choices(scene_file.path, environments)
        denoiser = _denoiser(threads)
        session = server.session = Session(scene_file, world, choices, threads, denoiser)
        session.start()
        threading.Thread(target=server.serve_forever, name="server", daemon=True).start()
        try:
            address = f"preview of {scene_file.path} at {server.url}\n"
            print(f"{address}Ctrl-C ends it\n", end="", flush=True)
            session.join()
        except KeyboardInterrupt:
            print("\nthe preview has ended")
        finally:
            session.stop()
            server.shutdown()


def _denoiser(threads: int) -> Denoiser | None:
    """The preview's denoiser; None if none is installed."""
    if find_spec("pyoidn") is None:
        return None
    try:
        return Denoiser(threads, "fast")
    except SceneError as error:
        print(f"note: the preview does not denoise: {error}", file=sys.stderr)
        return None
