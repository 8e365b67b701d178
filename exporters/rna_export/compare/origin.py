"""Origin of a package, for a comparison: source, training, recorded error."""

import hashlib
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rna_export.capture.orientation import AXES
from rna_sdk.package import Package, Tier, Validation

SOURCE_SHA256 = "sourceSha256"
"""Member of `provenance.capture`: of the file that was captured."""

_IN_TEXT = re.compile(r"\(sha256 ([0-9a-f]{64})\)")


@dataclass(frozen=True)
class Origin:
    """Origin of one tier of a package.

    source: its credit. sha256: of the file that was captured; None where the package does not say.
    front, up: axes that rna-capture was given. rest_frame: of the source, that the geometry is of;
    None where the package does not say. glass: see CaptureSettings. steps: of training, the fewest
    of all parts. lights: captured directions. validation: the recorded error.
    """

    source: str
    sha256: str | None
    front: str | None
    up: str | None
    rest_frame: int | None
    glass: str
    steps: int | None
    lights: int | None
    tier: str
    validation: Validation | None

    @classmethod
    def of(cls, package: Path, tier: str | None) -> "Origin":
        """tier: None for the first."""
        with Package.open(package) as opened:
            manifest = opened.manifest
        chosen = manifest.tiers[0] if tier is None else opened.tier(tier)
        provenance = manifest.provenance
        capture, in_text = provenance.capture, _IN_TEXT.search(provenance.source)
        sha256 = capture.get(SOURCE_SHA256) or (in_text and in_text[1])
        front, up = (axis if axis in AXES else None for axis in map(capture.get, ("front", "up")))
        lights = capture.get("lights")
        return cls(
            source=provenance.source,
            sha256=sha256 if isinstance(sha256, str) else None,
            front=front,
            up=up,
            rest_frame=provenance.rest_frame,
            glass="keep" if capture.get("glass") == "keep" else "leave",
            steps=_steps(provenance.training, chosen),
            lights=lights if isinstance(lights, int) else None,
            tier=chosen.name,
            validation=chosen.validation,
        )

    def doubt(self, source: Path) -> str | None:
        """Why a comparison with this file may say nothing of the package; None if it is the one."""
        name = source.name
        if self.sha256 is None:
            return (
                f"note: the package does not record which file it was captured from; {name} may be "
                "another one"
            )
        with source.open("rb") as file:
            digest = hashlib.file_digest(file, "sha256").hexdigest()
        if digest == self.sha256:
            return None
        return (
            f"warning: {name} is not the file that the package was captured from, or was changed "
            f"since: found SHA-256 {digest[:12]}..., expected {self.sha256[:12]}...; differences "
            "may come from the files"
        )


def _steps(training: dict[str, Any], tier: Tier) -> int | None:
    """Steps of the tier's training: a run, or runs by part, under its preset's name."""
    names = [name for name in training if f"{tier.name}-".startswith(f"{name}-")]
    runs = training[max(names, key=len)] if names else None
    if not isinstance(runs, dict):
        return None
    of_parts = [runs] if "steps" in runs else [r for r in runs.values() if isinstance(r, dict)]
    steps = [run["steps"] for run in of_parts if isinstance(run.get("steps"), int)]
    return min(steps, default=None)
