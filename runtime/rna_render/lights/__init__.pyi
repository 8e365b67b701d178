"""Public names of `rna_render.lights`."""

from .base import InfiniteLight as InfiniteLight
from .base import Light as Light
from .base import LightSamples as LightSamples
from .base import PlacedLight as PlacedLight
from .base import ShapeLight as ShapeLight
from .directions import LUMINANCE as LUMINANCE
from .equirectangular import EquirectangularImage as EquirectangularImage
from .kinds.asset import AssetEmission as AssetEmission
from .kinds.asset import AssetLight as AssetLight
from .kinds.environment import EnvironmentImageLight as EnvironmentImageLight
from .kinds.environment import EnvironmentLight as EnvironmentLight
from .kinds.mesh import MeshLight as MeshLight
from .light_kinds import kinds_of_lights as kinds_of_lights
from .light_kinds import make_light as make_light
from .light_kinds import number_places as number_places
from .selection import LightSelection as LightSelection
