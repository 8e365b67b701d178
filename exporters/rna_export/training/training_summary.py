"""Last lines of a training: the error of the model, and its training."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from rna_export.albedo import albedo
from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.outcome.outcome import Outcome
from rna_export.training.asset_error import worse_error
from rna_export.training.checkpoint import Trained, load_checkpoint
from rna_export.training.presets import named_preset
from rna_export.training.report import read_curves
from rna_export.training.validation import reference_warnings, shade, shade_emission
from rna_sdk.commands.error_words import GOOD, albedo_text

_LITTLE = 0.1  # of what is usual


@dataclass(frozen=True)
class Effort:
    """Training steps and captured lights of a model, and the usual numbers of its kind."""

    steps: int
    usual_steps: int
    lights: int
    usual_lights: int

    @classmethod
    def of(cls, trained: Sequence[Trained], dataset: Dataset) -> "Effort":
        """Effort of the models of all parts in one preset; steps of the part with the fewest."""
        least = min(trained, key=lambda one: one.steps)
        kinds = {part.kind for part in dataset.parts}
        usual = CaptureSettings.usual(kinds.pop() if len(kinds) == 1 else "both")
        kind = dataset.part(least.part).kind
        steps = named_preset(kind, least.preset_name).training.steps
        return cls(least.steps, steps, dataset.lights_finished(), usual.lights)

    def __str__(self) -> str:
        return f"{self.steps_text}, {self.lights_text}"

    @property
    def steps_text(self) -> str:
        """As "98 of 40,000 steps"."""
        return _told(self.steps, self.usual_steps, "steps")

    @property
    def lights_text(self) -> str:
        """As "16 of 2,000 lights"."""
        return _told(self.lights, self.usual_lights, "lights")

    @property
    def is_little(self) -> bool:
        """Whether less than a tenth of the usual was done."""
        return bool(self._few)

    @property
    def _few(self) -> list[str]:
        """Numbers that are less than a tenth of the usual ones."""
        shares = [
            (self.steps < _LITTLE * self.usual_steps, self.steps_text),
            (self.lights < _LITTLE * self.usual_lights, self.lights_text),
        ]
        return [text for is_little, text in shares if is_little]

    def warnings(self, flip: float | None) -> list[str]:
        """A line where less than a tenth of the usual was done.

        flip: the model's error; None where it is not known.
        """
        few = " and ".join(self._few)
        if not few:
            return []
        if flip is not None and flip < GOOD:
            return [f"note: {few}, less than a tenth of the usual, were enough for this error"]
        return [f"warning: {few}, less than a tenth of the usual: a sketch; give it more time"]


def _told(done: int, usual: int, what: str) -> str:
    return f"{done:,} of {usual:,} {what}" if done < usual else f"{done:,} {what}"


def closing_lines(best: Path, part: DatasetPart) -> list[str]:
    """Error, albedo, steps and lights of a part's best checkpoint, warnings, and the outcome.

    Writes `worst.png` beside the checkpoint: see `Outcome`.
    """
    rows, trained = read_curves(best.parent), load_checkpoint(best)
    effort, views = Effort.of([trained], part.dataset), part.validation_views()
    radiance = [shade(trained.model, view) for view in views]
    emitted = [(shade_emission(trained.model, view), view) for view in part.emission_views()]
    outcome, lines = Outcome.of(radiance, views, part.dataset), []
    error = worse_error(outcome.error, emitted)
    if rows:
        psnr = max(row["psnr"] for row in rows)
        lines.append(f"{trained.preset_name}: {error}, PSNR {psnr:.2f} dB; {effort}")
    if (white := part.white_view()) is not None:
        returned = albedo([(shade(trained.model, white), white)])
        if returned is not None:
            text = albedo_text(returned.ratio, returned.at80)
            lines.append(f"{trained.preset_name}: {text}")
    lines += outcome.told(best.parent / "worst.png", is_sketch=effort.is_little)
    return [*lines, *reference_warnings(views), *effort.warnings(error.mean)]
