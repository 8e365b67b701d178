"""Public names of `rna_render.lights`."""

from .asset import AssetEmission as AssetEmission
from .asset import AssetLight as AssetLight
from .base import InfiniteLight as InfiniteLight
from .base import Light as Light
from .base import LightSamples as LightSamples
from .base import PlacedLight as PlacedLight
from .base import ShapeLight as ShapeLight
from .directions import LUMINANCE as LUMINANCE
from .environment import EnvironmentImageLight as EnvironmentImageLight
from .environment import EnvironmentLight as EnvironmentLight
from .equirectangular import EquirectangularImage as EquirectangularImage
from .kinds import LIGHT_ROWS as LIGHT_ROWS
from .kinds import ROW_NUMBERS as ROW_NUMBERS
from .kinds import row_places as row_places
from .mesh import MeshLight as MeshLight
from .selection import LightSelection as LightSelection
from .split.bright_directions import SplitEnvironment as SplitEnvironment
from .split.bright_directions import cell_directions as cell_directions
from .split.bright_directions import split_environment as split_environment
from .split.prefilter import PrefilteredEnvironment as PrefilteredEnvironment
from .table import make_light as make_light
