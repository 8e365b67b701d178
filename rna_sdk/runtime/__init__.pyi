"""Public names of `rna_sdk.runtime`."""

from .asset import Asset as Asset
from .asset import CompositeAsset as CompositeAsset
from .base_color import base_color_levels as base_color_levels
from .deformation import DeformedCurves as DeformedCurves
from .deformation import DeformedMesh as DeformedMesh
from .deformation import RestPoints as RestPoints
from .domain import in_region as in_region
from .fiber_asset import FiberAsset as FiberAsset
from .fiber_offset import offset_across as offset_across
from .loading import load as load
from .normal_maps import mapped_normals as mapped_normals
from .surface_asset import SurfaceAsset as SurfaceAsset
from .tiers import choose_tier as choose_tier
from .tiers import expected_error as expected_error
from .tiers import is_no_worse as is_no_worse
from .transforms import Transform as Transform
from .transmittance_lookup import transmittance as transmittance
