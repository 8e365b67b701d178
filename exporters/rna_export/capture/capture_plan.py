"""Lines about the plan of a capture before it starts."""

from collections.abc import Mapping

import numpy as np

from rna_export.capture.capture_tasks import all_tasks
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.dataset_manifest import CaptureManifest
from rna_export.capture.rays.capture_directions import light_direction
from rna_sdk.package import Curves, Mesh
from rna_sdk.package.manifest.manifest_fields import Region
from rna_sdk.runtime import in_region

_COUNTED = 4096


def plan_lines(dataset: Dataset, geometries: Mapping[str, Mesh | Curves], rate: float) -> str:
    """The planned renders of a capture, and their time. rate: paths a second."""
    settings = dataset.manifest.settings
    paths = sum(task.paths_to_trace(dataset) for task in all_tasks(dataset))
    samples = settings.lights * settings.rays
    return (
        f"{parts_lines(dataset.manifest.name, geometries)}"
        f"{_domain_line(dataset.manifest)}"
        f"{_poses_line(dataset.manifest)}"
        f"{_prints_line(dataset.manifest)}"
        f"training: {settings.lights:,} lights x {settings.rays:,} view rays = "
        f"{samples / 1e6:.2f} M samples of {settings.samples} paths\n"
        f"validation: {settings.validation_views} images of {settings.validation_resolution}"
        f"x{settings.validation_resolution}, {settings.validation_samples} paths a pixel\n"
        f"about {paths / rate / 60.0:.1f} minutes at {rate / 1e6:.2f} M paths/s, "
        f"{samples * 4 * max(sum(part.fields.values()) for part in dataset.parts) / 1e6:,.0f} MB"
    )


def parts_lines(name: str, geometries: Mapping[str, Mesh | Curves]) -> str:
    """The contents of an asset: a line, or one a part, each with its end."""
    sizes = {part: _size(geometry) for part, geometry in geometries.items()}
    if len(sizes) == 1:
        return f"{name}: {next(iter(sizes.values()))}\n"
    lines = (f"  {part}: {size}\n" for part, size in sizes.items())
    return f"{name}, {len(sizes)} parts:\n{''.join(lines)}"


def _domain_line(manifest: CaptureManifest) -> str:
    """The remaining share of directions with --for; empty without it."""
    if manifest.scene_domain is None:
        return ""
    domain = manifest.scene_domain
    return f"of all directions: {_share(domain.wo)} of views, {_share(domain.wi)} of lights\n"


def _poses_line(manifest: CaptureManifest) -> str:
    """The poses by frame; empty for the rest frame alone."""
    frames = ", ".join(map(str, manifest.poses))
    return f"rays take turns at {manifest.pose_count} poses: frames {frames}\n" if frames else ""


def _prints_line(manifest: CaptureManifest) -> str:
    """The variants that are captured; empty for none."""
    names = [repr(manifest.variants[k]) for k in manifest.prints if k is not None]
    if not names:
        return ""
    return f"lights take turns at {len(names) + 1} prints: the source's own, {', '.join(names)}\n"


def _share(region: Region) -> str:
    """Fraction of the sphere, counted on evenly spread directions."""
    spread = np.array([light_direction(k, 0, "sphere") for k in range(_COUNTED)])
    return f"{in_region(region, spread).mean():.1%}"


def _size(geometry: Mesh | Curves) -> str:
    if isinstance(geometry, Curves):
        return f"{len(geometry.offsets) - 1:,} strands, {len(geometry.points):,} points"
    return f"{len(geometry.triangles):,} triangles"
