"""The standard cameras of a comparison; separate, so that --help imports nothing else."""

from __future__ import annotations

ORBITS = {"front": (35.0, 20.0, 1.0), "behind": (215.0, 30.0, 1.0), "close-up": (20.0, 25.0, 0.3)}
"""Name -> azimuth and elevation in degrees, and the part of the asset's size that is shown."""

CAMERAS = (*ORBITS, "strands")
"""All names; only fibers have the last."""
