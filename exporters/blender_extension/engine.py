"""The render engine: rna-run in a process, its image handed to Blender while it converges."""

import shutil
import tempfile
import time
from pathlib import Path
from zipfile import BadZipFile

import bpy
import numpy as np

from .passes import Channels, wanted_passes
from .scene.description import write_scene
from .sdk import SdkError
from .sdk_command import Command

_LOOK = 0.1  # seconds between looks at the process
_TIMEOUT = 10.0  # seconds that a cancelled render may take to write what it has
_EVERY = 0.5  # seconds between images, and of large ones more:
_PIXELS_A_SECOND = 4e5  # to write and to show without slowing the render much


class RnaEngine(bpy.types.RenderEngine):
    """Renders relightable neural assets, and their surroundings, with rna-run."""

    bl_idname = "RNA"
    bl_label = "RNA"
    bl_use_preview = False
    bl_use_postprocess = True
    bl_use_eevee_viewport = True

    def update_render_passes(self, scene=None, renderlayer=None):
        for name, channels, kind in wanted_passes(renderlayer):
            self.register_pass(scene, renderlayer, name, len(channels), channels, kind)

    def render(self, depsgraph):
        folder = Path(tempfile.mkdtemp(prefix="rna-render-"))
        try:
            self._render(depsgraph, folder)
        except SdkError as error:
            self.report({"ERROR"}, str(error))
        finally:
            shutil.rmtree(folder, ignore_errors=True)

    def _render(self, depsgraph, folder):
        size = size_of(depsgraph.scene.render)
        self.update_stats("", "writing the scene")
        described = write_scene(depsgraph, folder, size)
        for line in described.notes:
            self.report({"WARNING"}, line)
        view = _View(self, depsgraph, described, size)
        command = Command(_arguments(depsgraph.scene, folder, size), folder / "log")
        cancelled = self._follow(command, folder / "image.npz", view)
        for line in command.lines():
            if line.startswith("warning: "):
                self.report({"WARNING"}, line.removeprefix("warning: "))
        try:
            if not cancelled:
                command.check()
        except SdkError as error:
            raise SdkError(described.in_blenders_words(str(error))) from None

    def is_cancelled(self):
        """Whether the user has pressed Escape."""
        return self.test_break()

    def _follow(self, command, image, view):
        """Show images as they come; returns whether the user has cancelled."""
        shown, cancelled = 0, False
        try:
            while command.is_running() and not cancelled:
                shown = view.show_newer(image, shown)
                time.sleep(_LOOK)
                cancelled = self.is_cancelled()
        finally:
            command.end(_TIMEOUT)  # it writes the mean of the samples that it has
        view.show_newer(image, shown)
        return cancelled


class _View:
    """Puts images into Blender's render result."""

    def __init__(self, engine, depsgraph, described, size):
        self._engine, self._described, self._size = engine, described, size
        self._layer = depsgraph.view_layer_eval
        self._camera = depsgraph.scene.camera.evaluated_get(depsgraph)
        self._total = depsgraph.scene.rna_render.samples
        self._exposure = _film_exposure(depsgraph.scene)
        self._region = _region(depsgraph.scene.render, size)
        self._passes = wanted_passes(self._layer)
        for name, channels, _ in self._passes[1:]:
            engine.add_pass(name, len(channels), channels, layer=self._layer.name)
        engine.update_stats("", "loading")

    def show_newer(self, path, shown):
        """Show the image if it is there and newer; returns when it was written, ns."""
        try:
            stamp = path.stat().st_mtime_ns
            if stamp == shown:
                return shown
            with np.load(path) as arrays:
                result = dict(arrays)
        except (FileNotFoundError, BadZipFile):
            return shown
        indices = self._described.pass_indices
        channels = Channels(result, self._camera, self._exposure, indices)
        self._put(channels)
        self._engine.update_progress(channels.samples / self._total)
        self._engine.update_stats("", f"sample {channels.samples} of {self._total}")
        return stamp

    def _put(self, channels):
        left, bottom, width, height = self._region
        engine = self._engine
        result = engine.begin_result(0, 0, width, height, layer=self._layer.name)
        wanted = {name for name, _, _ in self._passes}
        for one in result.layers[0].passes:
            if one.name in wanted:
                values = channels.pass_(one.name)[bottom : bottom + height, left : left + width]
                one.rect.foreach_set(values.reshape(-1))
        engine.end_result(result)


def _arguments(scene, folder, size):
    settings = scene.rna_render
    more = ["--threads", settings.threads] if settings.threads else []
    more += ["--denoise"] if settings.denoise else []
    every = max(_EVERY, size[0] * size[1] / _PIXELS_A_SECOND)
    out = ["--out", folder / "image.npz", "--every", every]
    return ["-m", "rna_render.command.rna_run", folder / "scene.yaml", *out, *more]


def size_of(render):
    """Width and height of the whole image, pixels."""
    share = render.resolution_percentage / 100.0
    return int(render.resolution_x * share), int(render.resolution_y * share)


def _film_exposure(scene):
    """Cycles' own setting, Film > Exposure, so that both engines give one picture."""
    cycles = getattr(scene, "cycles", None)
    return cycles.film_exposure if cycles is not None else 1.0


def _region(render, size):
    """The render region: left, bottom, width, height in pixels."""
    if not render.use_border:
        return 0, 0, *size
    edges = (
        round(render.border_min_x * size[0]),
        round(render.border_max_x * size[0]),
        round(render.border_min_y * size[1]),
        round(render.border_max_y * size[1]),
    )
    left, right, bottom, top = edges
    return left, bottom, right - left, top - bottom


register, unregister = bpy.utils.register_classes_factory((RnaEngine,))
