"""Public names of `rna_render.scene`."""

from .animation import frame_scene as frame_scene
from .gltf_container import open_gltf as open_gltf
from .light_models import DirectionalModel as DirectionalModel
from .light_models import EnvironmentModel as EnvironmentModel
from .light_models import LightModel as LightModel
from .material_models import DiffuseModel as DiffuseModel
from .material_models import MaterialModel as MaterialModel
from .scene_file import SceneFile as SceneFile
from .scene_file import read_scene as read_scene
from .scene_model import AssetModel as AssetModel
from .scene_model import CameraModel as CameraModel
from .scene_model import GroundModel as GroundModel
from .scene_model import ObjectModel as ObjectModel
from .scene_model import Scene as Scene
from .scene_of_package import default_scene as default_scene
from .scene_of_package import scene_text as scene_text
from .transforms import from_origin as from_origin
from .transforms import world_from_object as world_from_object
