"""A trial: one model of a grid, by name."""

from typing import Literal

from pydantic import BaseModel, Field

from rna_export.training.presets import Preset

Family = Literal["ours", "paper", "opponent", "ablation"]


class Trial(BaseModel, extra="forbid", frozen=True):
    """A model to train, and its role in a comparison."""

    name: str = Field(pattern=r"^[a-z0-9][a-z0-9-]*$", description="unique in a grid; a folder")
    family: Family = Field(
        description="ours: fit for use. paper: as published. opponent: a network by others. "
        "ablation: neither"
    )
    preset: Preset
    has_planes: bool = Field(
        True,
        description="whether features come from planes, as in packages; else from NRHints' network",
    )
    tables: tuple[str, ...] = Field((), description="comparisons that it is a row of")
    cost_as: str | None = Field(
        None, description="trial whose decode cost it has, for a model without planes"
    )
    seed: int = 0

    def of_length(self, steps: int) -> "Trial":
        """This trial with another number of steps."""
        return self.model_copy(update={"preset": self.preset.with_training(steps=steps)})


def name_of(preset: Preset) -> str:
    """Width, hidden layers, planes and channels as a name."""
    m = preset.model
    return f"w{m.width}-l{m.hidden_layers}-p{m.resolution}-c{m.channels}"
