"""Bake: the selected objects become a package, and are replaced by it."""

import re
from pathlib import Path

import bpy

from ..import_package import import_package
from ..properties import package_of
from ..sdk import SdkError
from . import options
from .job import Job
from .source import frame_of, with_children, write_source

_POLL = 1.0  # seconds


def job_of(item):
    """The bake of an object, or None: in the folder named for the package that the panel names."""
    try:
        return Job(_package_path(item).with_suffix(".bake")) if item is not None else None
    except SdkError:
        return None


class Bake(bpy.types.Operator):
    """Capture the selected objects with Cycles and train a neural asset, in the background"""

    bl_idname = "rna.bake"
    bl_label = "Bake Neural Asset"

    anew: bpy.props.BoolProperty(
        name="Anew", description="Forget an earlier bake of this object; else go on with it"
    )

    @classmethod
    def poll(cls, context):
        return context.object is not None and package_of(context.object) is None

    def execute(self, context):
        return _run(self, context.object, lambda *panel: self._begin(context, *panel))

    def _begin(self, context, item, job, out, options):
        """A new job, or that which was begun as the panel says."""
        if self.anew:
            job.remove()
        if job.is_begun():
            job.check_same(out, options)
        else:
            job.check_free()
            _begin(context, item, job, out, options)


class BakeMore(bpy.types.Operator):
    """Go on with the finished bake: more light from Cycles, and training from the model there is"""

    bl_idname = "rna.bake_more"
    bl_label = "Bake for More Minutes"

    @classmethod
    def poll(cls, context):
        job = job_of(context.object)
        return job is not None and job.is_begun()

    def execute(self, context):
        return _run(self, context.object, self._begin)

    def _begin(self, item, job, out, options):
        if item not in {one.item for one in item.rna_bake.originals}:
            raise SdkError(f"{out.name} was baked from another object: select that, or Bake Anew")
        job.begin_more(item.rna_bake.more, out, options)


def _run(operator, item, begin):
    """Start the job that `begin` begins, by the panel's options; returns `execute`'s result.

    begin: takes the object, its job, the package and the options. In background mode the operator
    waits for the end.
    """
    try:
        out, options, job = _package_path(item), _options(item.rna_bake), job_of(item)
        if job.is_running():
            raise SdkError("the bake is running")
        begin(item, job, out, options)
        job.start()
    except (SdkError, OSError) as error:
        operator.report({"ERROR"}, str(error))
        return {"CANCELLED"}
    if not bpy.app.background:
        _watch(item)
        return {"FINISHED"}
    job.wait()
    status = job.status()
    if status.state == "finished":
        operator.report({"INFO"}, status.text)
        return {"FINISHED"}
    operator.report({"ERROR"}, f"bake {status.state}: {status.text}")
    return {"CANCELLED"}


def _begin(context, item, job, out, options):
    """Write the selected objects and their children to a file for baking."""
    selected = [*context.selected_objects] if item in context.selected_objects else [item]
    items = with_children(selected)
    settings = item.rna_bake
    job.folder.mkdir(parents=True, exist_ok=True)
    source = job.source_of(bpy.data.filepath)
    write_source(source, context.scene, items, frame_of(item))
    settings.originals.clear()
    for one in items:
        settings.originals.add().item = one
    if not settings.out:  # by which the job is found again, whatever the object is called then
        settings.out = out.name
    job.begin(out, options, source, _asset_name(item))


def _asset_name(item):
    """Name of the object as one line, as rna-make takes it: imported ones may have controls."""
    return " ".join(
        re.sub(r"[\x00-\x1f\x7f-\x9f\u2028\u2029\ud800-\udfff]", " ", item.name).split()
    )


def _file_name(item):
    """File name for the name of an object: letters and digits of any script stay."""
    return re.sub(r"[^\w-]", "_", item.name)


def _package_path(item):
    """Path of the package: the given one, relative to the .blend file, or beside it."""
    given = item.rna_bake.out or f"{_file_name(item)}.rna"
    if not given.startswith("//") and not Path(given).is_absolute():
        given = f"//{given}"
    if given.startswith("//") and not bpy.data.filepath:
        raise SdkError("save the .blend file first, or name the package to write")
    path = Path(bpy.path.abspath(given)).resolve()
    return path if path.suffix in (".rna", ".glb") else path.with_name(f"{path.name}.rna")


def _options(settings):
    """Options of rna-make. Raises SdkError for options that a .blend file may not set."""
    result = ["--presets", *settings.presets.split()]
    if settings.minutes > 0.0:
        result.append(f"--minutes={settings.minutes:g}")
    if settings.goal != "NONE":
        result.append(f"--max-error={settings.goal}")
    if settings.license:
        result.append(f"--license={settings.license}")
    try:
        return [*result, *options.parsed(settings.options)]
    except ValueError as error:
        raise SdkError(str(error)) from None


def _watch(item):
    """Redraw panels while the bake runs."""

    def look():
        for window in bpy.context.window_manager.windows:
            for area in window.screen.areas:
                area.tag_redraw()
        job = job_of(bpy.data.objects.get(name))
        return _POLL if job is not None and job.is_running() else None

    name = item.name
    bpy.app.timers.register(look, first_interval=_POLL)


class StopBake(bpy.types.Operator):
    """Stop the bake; Bake goes on with it"""

    bl_idname = "rna.stop_bake"
    bl_label = "Stop"

    @classmethod
    def poll(cls, context):
        job = job_of(context.object)
        return job is not None and job.is_running()

    def execute(self, context):
        job_of(context.object).stop()
        return {"FINISHED"}


class ReplaceByAsset(bpy.types.Operator):
    """Put the neural asset where the baked objects are, and hide them"""

    bl_idname = "rna.replace"
    bl_label = "Replace by the Neural Asset"
    bl_options = {"REGISTER", "UNDO"}  # noqa: RUF012

    @classmethod
    def poll(cls, context):
        job = job_of(context.object)
        return job is not None and job.is_begun() and job.out.is_file()

    def execute(self, context):
        item = context.object
        try:
            asset = import_package(context, job_of(item).out.resolve())
        except SdkError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        asset.matrix_world = frame_of(item)
        for record in item.rna_bake.originals:
            if record.item is not None:
                record.item.hide_render = record.item.hide_viewport = True
        return {"FINISHED"}


class ShowErrors(bpy.types.Operator):
    """Load the pictures of the asset beside Cycles: ours, Cycles, difference x 4, FLIP"""

    bl_idname = "rna.show_errors"
    bl_label = "Show beside Cycles"

    @classmethod
    def poll(cls, context):
        job = job_of(context.object)
        return job is not None and job.is_begun() and job.sheet.is_file()

    def execute(self, context):
        job = job_of(context.object)
        image = bpy.data.images.load(str(job.sheet), check_existing=True)
        image.name = f"{job.out.stem} beside Cycles"
        image.reload()
        if not bpy.app.background:
            bpy.ops.wm.window_new()
            area = context.window_manager.windows[-1].screen.areas[0]
            area.type = "IMAGE_EDITOR"
            area.spaces.active.image = image
        return {"FINISHED"}


class RnaOriginal(bpy.types.PropertyGroup):
    """An object that was baked."""

    item: bpy.props.PointerProperty(type=bpy.types.Object)


class RnaBake(bpy.types.PropertyGroup):
    """Bake of an object."""

    out: bpy.props.StringProperty(
        name="Package",
        description="The .rna file to write, or a .glb that other viewers open, too; if left "
        "empty, beside the .blend file",
        subtype="FILE_PATH",
        options={"PATH_SUPPORTS_BLEND_RELATIVE"},
    )
    minutes: bpy.props.FloatProperty(
        name="Minutes",
        description="Time until the package is there; 0 for no limit. Nine pictures beside Cycles "
        "follow",
        default=20.0,
        min=0.0,
    )
    more: bpy.props.FloatProperty(
        name="More Minutes",
        description="Time to go on with the finished bake; pictures beside Cycles follow",
        default=10.0,
        min=0.1,
    )
    goal: bpy.props.EnumProperty(
        name="Goal",
        description="The error that is good enough: mean FLIP of the asset's pixels. Without a "
        "goal the bake goes on until the time is up, or the error stops falling",
        items=(
            ("NONE", "As Good as Time Allows", "No goal"),
            ("0.04", "Very Good", "FLIP below 0.04: hard to tell from the original"),
            ("0.07", "Good", "FLIP below 0.07: differences show in close-ups"),
            ("0.11", "Fair", "FLIP below 0.11: differences show beside the original"),
        ),
        default="NONE",
    )
    presets: bpy.props.EnumProperty(
        name="Tiers",
        items=(
            ("small", "Small", "4 layers of 64: fast"),
            ("tiny", "Tiny", "2 layers of 32: for assets that are small in the image"),
            ("hq", "HQ", "4 layers of 256: accurate"),
            ("small hq", "Small and HQ", "Both in one package"),
        ),
        default="small",
    )
    license: bpy.props.StringProperty(name="License", description="SPDX expression of the asset")
    options: bpy.props.StringProperty(
        name="Options",
        description="More options of rna-make, such as --domain hemisphere; none that name files",
    )
    originals: bpy.props.CollectionProperty(type=RnaOriginal)


CLASSES = (RnaOriginal, RnaBake, Bake, BakeMore, StopBake, ReplaceByAsset, ShowErrors)
_register_classes, _unregister_classes = bpy.utils.register_classes_factory(CLASSES)


def register():
    _register_classes()
    bpy.types.Object.rna_bake = bpy.props.PointerProperty(type=RnaBake)


def unregister():
    del bpy.types.Object.rna_bake
    _unregister_classes()
