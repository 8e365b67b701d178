"""A Blender scene as a scene file of rna-run, with the files beside it."""

import re
from dataclasses import dataclass
from pathlib import Path

import bpy

from ..properties import package_of
from ..sdk import SdkError
from .camera import describe_camera
from .lights import describe_light
from .meshes import Meshes
from .motion import is_deformed, parts_of, write_motion
from .notes import Notes
from .placement import is_similarity, nearest_similarity, transform
from .world import describe_world
from .yaml_text import to_yaml

_SURFACES = ("MESH", "CURVE", "SURFACE", "FONT", "META")
_NOT_SHOWN = {
    "CURVES": "hair that is no neural asset is left out",
    "VOLUME": "volumes are left out",
    "POINTCLOUD": "point clouds are left out",
    "GREASEPENCIL": "grease pencil is left out",
}


@dataclass(frozen=True)
class Description:
    """A scene file that was written.

    path: of it. names: of the objects, by the lists `assets` and `objects`. pass_indices: theirs,
    in the order of `assetId` from 1. notes: what it cannot say, a line each.
    """

    path: Path
    names: dict[str, list[str]]
    pass_indices: list[int]
    notes: list[str]

    def in_blenders_words(self, message):
        """An error of rna-run about the file, naming the object instead of `assets[0]`."""
        message = re.sub(rf"{re.escape(str(self.path))}(:\d+)?: ", "", message)
        return re.sub(
            r"\b(assets|objects)\[(\d+)\]\.?",
            lambda place: f"object {self.names[place[1]][int(place[2])]!r}: ",
            message,
        )


class _SceneObjects:
    """The lists of the scene file, as objects are added."""

    def __init__(self, depsgraph, folder, notes):
        self._depsgraph, self._folder, self._notes = depsgraph, folder, notes
        self._meshes = Meshes(folder, notes)
        self.assets, self.objects, self.lights = [], [], []
        self.placed = {"assets": [], "objects": []}  # (name, pass index) of each

    def add(self, instance):
        item, matrix = instance.object, instance.matrix_world.copy()
        record = package_of(item.original)  # modifiers may make data without it
        if record is not None:
            self._add_asset(item, record, matrix)
        elif item.type in _SURFACES:
            self._add_mesh(item, matrix)
        elif item.type == "LIGHT":
            light = describe_light(item, matrix, self._notes)
            self.lights += [] if light is None else [light]
        elif item.type in _NOT_SHOWN:
            self._notes.add(_NOT_SHOWN[item.type], item.name)

    def _add_asset(self, item, record, matrix):
        if record.part:
            self._check_part(item, matrix)
            return
        if matrix.determinant() == 0.0:
            self._notes.add("an asset without volume is left out: its scale is 0", item.name)
            return
        if not is_similarity(matrix):
            self._notes.add("an asset has one scale: rendered with the mean of three", item.name)
            matrix = nearest_similarity(matrix)
        path = Path(bpy.path.abspath(record.path, library=item.original.data.library)).resolve()
        if not path.is_file():
            raise SdkError(f"object {item.name!r}: there is no package {path}")
        settings = item.original.rna_instance
        asset = {"path": str(path), "transform": transform(matrix)}
        if path.suffix.lower() == ".glb":
            asset["alone"] = True  # as it was imported
        if settings.tier:
            asset["tier"] = settings.tier
        if settings.emission != 1.0:
            asset["emission"] = settings.emission
        self._add_motion(item, asset)
        self.assets.append(asset)
        self.placed["assets"].append((item.name, item.pass_index))

    def _add_motion(self, item, asset):
        """Poses and other deformations, of this frame."""
        parts = parts_of(item, self._depsgraph)
        if not any(map(is_deformed, parts)):
            return
        name = f"motion-{len(self.assets)}.rnam"
        why_not = write_motion(parts, self._folder / name)
        if why_not is None:
            asset["motion"] = name
        else:
            self._notes.add(why_not, item.name)

    def _check_part(self, item, matrix):
        """Parts are rendered with the first one, which they are children of."""
        first = item.parent
        moved = first is None or (first.matrix_world.inverted() @ item.matrix_world).is_identity
        if first is None or package_of(first.original) is None:
            self._notes.add("a part of an asset without its first part is left out", item.name)
        elif not moved:
            self._notes.add("a part of an asset is rendered where its first part is", item.name)

    def _add_mesh(self, item, matrix):
        if item.is_holdout:
            self._notes.add("a holdout is rendered as a mesh", item.name)
        if not item.visible_camera:
            self._notes.add("objects hidden from the camera are rendered nevertheless", item.name)
        even = is_similarity(matrix)
        name = self._meshes.write(item, None if even else matrix)
        if name is None:
            return
        scene_object = {"path": name}
        if even:
            scene_object["transform"] = transform(matrix)
        if item.is_shadow_catcher:
            scene_object["material"] = {"type": "shadow_catcher"}
        self.objects.append(scene_object)
        self.placed["objects"].append((item.name, item.pass_index))


def write_scene(depsgraph, folder, resolution):
    """Write `scene.yaml` and the meshes and images that it names into `folder`.

    depsgraph: evaluated, for a render. resolution: width and height, pixels. Raises SdkError for
    a scene that cannot be rendered at all.
    """
    notes, scene = Notes(), depsgraph.scene
    scene_objects = _SceneObjects(depsgraph, folder, notes)
    for instance in depsgraph.object_instances:
        if _is_shown(instance):
            scene_objects.add(instance)
    if not scene_objects.assets and not scene_objects.objects:
        raise SdkError("nothing to render: the scene has no assets and no meshes")
    described = {
        "assets": scene_objects.assets,
        "objects": scene_objects.objects,
        "camera": describe_camera(depsgraph, resolution, notes),
        "lights": [*scene_objects.lights, *describe_world(scene, folder, notes)],
        **_settings(scene, resolution, notes),
    }
    path = folder / "scene.yaml"
    path.write_text(to_yaml({key: value for key, value in described.items() if value != []}))
    names = {kind: [name for name, _ in placed] for kind, placed in scene_objects.placed.items()}
    indices = [index for placed in scene_objects.placed.values() for _, index in placed]
    return Description(path, names, indices, notes.lines())


def _is_shown(instance):
    """Whether renders show it: neither hidden nor shown only as instances of its parent."""
    item = instance.object.original
    if not instance.show_self or (item.hide_render and not instance.is_instance):
        return False
    parent = item.parent
    return instance.is_instance or parent is None or parent.instance_type not in ("VERTS", "FACES")


def _settings(scene, resolution, notes):
    rna_settings = scene.rna_render
    if scene.render.use_motion_blur:
        notes.add("motion blur is left out")
    space = getattr(bpy.data, "colorspace", None)  # since Blender 5
    if space is not None and space.working_space != "Linear Rec.709":
        notes.add("colours are taken as linear Rec.709, which is not this file's working space")
    settings = {
        "resolution": list(resolution),
        "samples": rna_settings.samples,
        "max_depth": rna_settings.max_depth,
        "seed": rna_settings.seed + (scene.frame_current if rna_settings.animate_seed else 0),
    }
    if not rna_settings.auto_clamp:
        settings["clamp_indirect"] = rna_settings.clamp_indirect or None
    if rna_settings.max_error > 0.0:
        settings["quality"] = {"max_error": rna_settings.max_error}
    return settings
