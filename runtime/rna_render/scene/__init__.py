"""What a scene file says: its models, read or built, and scenes that we build ourselves."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rna_sdk.lazy_face import lazy_face

if TYPE_CHECKING:
    from rna_render.scene.animation import frame_scene
    from rna_render.scene.light_models import (
        DirectionalModel,
        EnvironmentModel,
        LightModel,
    )
    from rna_render.scene.material_models import DiffuseModel, MaterialModel
    from rna_render.scene.scene_file import SceneFile, read_scene
    from rna_render.scene.scene_model import (
        AssetModel,
        CameraModel,
        GroundModel,
        ObjectModel,
        Scene,
    )
    from rna_render.scene.scene_of_package import default_scene
    from rna_render.scene.transforms import world_from_object

__all__ = [
    "AssetModel",
    "CameraModel",
    "DiffuseModel",
    "DirectionalModel",
    "EnvironmentModel",
    "GroundModel",
    "LightModel",
    "MaterialModel",
    "ObjectModel",
    "Scene",
    "SceneFile",
    "default_scene",
    "frame_scene",
    "read_scene",
    "world_from_object",
]

__getattr__, __dir__ = lazy_face(__name__)
