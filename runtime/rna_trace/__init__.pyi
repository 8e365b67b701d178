"""Public names of `rna_trace`."""

from .asset_parts import mesh_transmittance as mesh_transmittance
from .asset_parts import part_geometry as part_geometry
from .asset_parts import part_normal_maps as part_normal_maps
from .asset_parts import part_transmittance as part_transmittance
from .embree.instances import CAMERA_RAY as CAMERA_RAY
from .embree.instances import INDIRECT_RAY as INDIRECT_RAY
from .embree.instances import SHADOW_RAY as SHADOW_RAY
from .embree.scenes import TriangleScene as TriangleScene
from .embree.tracing import ClosestHits as ClosestHits
from .fiber import FiberPoints as FiberPoints
from .fiber import tangents as tangents
from .nearby import R2 as R2
from .nearby import nearby_light as nearby_light
from .normal_maps import NormalMaps as NormalMaps
from .normal_maps import texture_numbers as texture_numbers
from .parts_scene import PartPoints as PartPoints
from .parts_scene import PartsScene as PartsScene
from .surface import SurfacePoints as SurfacePoints
from .surface import geometric_normals as geometric_normals
from .transmittance import TransmittanceTexture as TransmittanceTexture
