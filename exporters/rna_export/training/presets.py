"""Models and their training: the paper's two presets and ours."""

from __future__ import annotations

from typing import Any, Literal, get_args

from pydantic import (
    BaseModel,
    Field,
    SerializerFunctionWrapHandler,
    field_validator,
    model_serializer,
)

from rna_sdk.package.decoder.decoder_form import NEARBY_LENGTHS

# Kind of asset -> decoder inputs; the paper's are those of its section 3.2.
_PAPER_INPUTS = {
    "surface": ("features", "normal", "wo", "wi"),
    "fiber": ("features", "tangent", "h", "wo", "wi"),
}
# Position tells places apart that share texels of a plane (docs/decisions/model.md).
_SURFACE_INPUTS = ("features", "position", "normal", "wo", "wi")
_OUR_INPUTS = {
    "surface": (*_SURFACE_INPUTS, "half_vector", "highlight", "learned_normal"),
    "fiber": (*_PAPER_INPUTS["fiber"], "fiber_angles", "fiber_lobes"),
}


Loss = Literal["auto", "log", "unbiased"]
LOSSES: tuple[Loss, ...] = get_args(Loss)


NEARBY_MODES = ("off", "auto", "on")
"""Whether nearby light is counted: never, where an asset gains by it, or always."""


Optimizer = Literal["adam", "muon"]
OPTIMIZERS: tuple[Optimizer, ...] = get_args(Optimizer)


Material = Literal["learned", "gltf"]


MAX_MODEL_WIDTH = 8192
MAX_HIDDEN_LAYERS = 64
MAX_MODEL_RESOLUTION = 8192
MAX_MODEL_CHANNELS = 4096
"""Limits of a model, far beyond those that train: a checkpoint may come from anywhere."""


class ModelConfig(BaseModel, extra="forbid", frozen=True):
    """The shape of a model; stored in its checkpoints and, from them, in packages."""

    inputs: tuple[str, ...] = Field(description="decoder input blocks, in column order")
    width: int = Field(gt=0, le=MAX_MODEL_WIDTH, description="neurons of a hidden layer")
    hidden_layers: int = Field(4, gt=0, le=MAX_HIDDEN_LAYERS)
    resolution: int = Field(
        gt=0, le=MAX_MODEL_RESOLUTION, description="texels along a plane's side"
    )
    channels: int = Field(8, gt=0, le=MAX_MODEL_CHANNELS)
    separates_direct: bool = Field(
        False, description="direct and scattered light are outputs of their own, summed at the end"
    )
    material: Material = Field(
        "learned",
        description="meaning of the decoder's outputs: colours, or parameters of glTF's material, "
        "whose shadows are black: to bake it; packages have no such decoder",
    )
    uses_base_color: bool = Field(
        False, description="each colour is a sum of two, of which the base colour multiplies one"
    )
    shadow_width: int = Field(
        0,
        ge=0,
        le=MAX_MODEL_WIDTH,
        description="neurons of a hidden layer of a decoder for shadowed light; 0: it has none",
    )
    shadow_inputs: tuple[str, ...] = Field((), description="input blocks of that decoder")
    emission_inputs: tuple[str, ...] = Field(
        (), description="blocks of the decoder of emission; none where the asset emits nothing"
    )

    nearby: tuple[float, ...] = Field(
        (),
        description="lengths of nearby light, metres, which each scattered colour counts linearly; "
        "none: it does not",
    )

    @field_validator("nearby")
    @classmethod
    def _all_or_none(cls, value: tuple[float, ...]) -> tuple[float, ...]:
        if value and (len(value) != NEARBY_LENGTHS or not 0.0 < value[0] < value[1] < value[2]):
            raise ValueError(f"{NEARBY_LENGTHS} ascending lengths, or none")
        return value

    @model_serializer(mode="wrap")
    def _without_nothing_nearby(self, handler: SerializerFunctionWrapHandler) -> dict[str, Any]:
        members: dict[str, Any] = handler(self)
        if not self.nearby:
            del members["nearby"]
        return members

    @property
    def counts_nearby(self) -> tuple[bool, ...]:
        """Whether each colour counts nearby light, if any does: direct light knows none."""
        return (not self.separates_direct, *[True] * (len(self.colour_sums[0]) - 1))

    @property
    def packageable(self) -> bool:
        """Whether the format can hold it."""
        return self.material == "learned"

    @property
    def colour_sums(self) -> tuple[tuple[int, ...], tuple[int, ...]]:
        """Weights of the decoder's colours in the visible and in the shadowed transport."""
        return ((1, 1, 0), (0, 0, 1)) if self.separates_direct else ((1, 0), (0, 1))


class TrainingConfig(BaseModel, extra="forbid", frozen=True):
    """Settings of a training."""

    steps: int = Field(gt=0, description="length of the run; --steps and --minutes replace it")
    batch: int = Field(gt=0, description="samples a step")
    optimizer: Optimizer = Field(
        "adam", description="of the decoder's matrices but the last; Adam has all else"
    )
    learning_rate: float = Field(description="of the decoder under Adam, at the start")
    muon_learning_rate: float = Field(0.015, gt=0.0, description="of Muon, at the start")
    plane_learning_rate: float = Field(description="of the planes, at the start")
    schedule: Literal["halving", "cosine"] = Field(
        description="halving: by half every fifth of the run (the paper's). cosine: to zero"
    )
    unit: Literal["one", "usual"] = Field(
        description="radiance that the loss calls 1, in log(x / unit + 1). one: the paper's. "
        "usual: the asset's median lit radiance, so that dark materials count"
    )
    loss: Loss = Field(
        "log",
        description="log: of log(x / unit + 1). unbiased: relative, so that neither noise in the "
        "targets nor what the model cannot tell apart darkens it. auto: unbiased where noise would "
        "darken the other by more than 5%",
    )
    shadow_weight: float = Field(
        1.0,
        gt=0.0,
        allow_inf_nan=False,
        description="weight of samples in shadow beside those in light, in the loss of a model "
        "without an output for direct light",
    )
    unbiased_share: float = Field(
        0.0,
        description="part of the run, at its end, with the unbiased loss: sharp highlights are "
        "learnt by the log loss, the brightness is put right at the end",
    )
    blur: float = Field(
        description="footprint in texels that planes are blurred with at first; decays to 1, "
        "no blur, over the first fifth of the run"
    )
    smoothing: float = Field(
        0.0,
        ge=0.0,
        description="diffusion of the planes, beside Adam: times the rate, the share of the "
        "difference to its neighbours that a texel loses a step. Where samples are noisy texels "
        "then average, and what is sharp and well seen stays",
    )
    products: Literal["auto", "float32"] = Field(
        "auto",
        description="arithmetic of the matrix products of hidden layers. auto: bfloat16 for 128 "
        "neurons or more, where the processor has instructions for it",
    )


class Preset(BaseModel, extra="forbid", frozen=True):
    """A named pair of both."""

    model: ModelConfig
    training: TrainingConfig
    knows_base_color: bool = Field(
        True, description="whether captured base colour may be a factor; not in the paper"
    )

    @property
    def may_count_nearby(self) -> bool:
        """Whether nearby light may be counted where it is not asked for; not in the paper."""
        return self.knows_base_color

    def with_model(self, **fields: Any) -> Preset:
        """This preset with changed fields of `ModelConfig`."""
        return self.model_copy(update={"model": self.model.model_copy(update=fields)})

    def with_training(self, **fields: Any) -> Preset:
        """This preset with changed fields of `TrainingConfig`."""
        return self.model_copy(update={"training": self.training.model_copy(update=fields)})

    def with_base_color(self, has_images: bool) -> Preset:
        """This preset for a part with base colour, of which some is images or all are plain.

        Base colour is a factor, but of plain colours for narrow decoders alone: wide ones learn
        them better. Planes beside images hold no print, and may be smoother.
        """
        learns_plain = not has_images and self.model.width >= _KNOWS_PLAIN_COLORS
        if learns_plain or not self.knows_base_color:
            return self
        preset = self.with_model(uses_base_color=True)
        if not (has_images and self.training.smoothing):
            return preset
        return preset.with_training(smoothing=_SMOOTHING_BESIDE_PRINT)

    def for_rows(self, rows: int) -> Preset:
        """This preset for so many samples: smoothed planes are smoothed more if they are few.

        Otherwise texels learn single samples (docs/decisions/training.md).
        """
        usual = self.training.smoothing
        wanted = usual * _ROWS_OF_SMOOTHING / rows
        return self.with_training(smoothing=max(usual, min(wanted, _MOST_SMOOTHING)))

    def on_device(self, device: str) -> Preset:
        """This preset, on "cuda" with the batch that is usual there."""
        return self.with_training(batch=BATCH["cuda"]) if device == "cuda" else self


BATCH = {"cpu": 2048, "cuda": 16_384}
"""Device -> samples a step.

A batch in the paper is an image slice, several 100,000 samples. A CPU takes too few such steps to
learn anything, and steps count more than samples (docs/decisions/training.md). A GPU takes 16,384
in 1.5 times the time of 2,048.
"""


def _paper(kind: str, width: int) -> Preset:
    # The paper, sections 3.2 and 4.2.
    return Preset(
        model=ModelConfig(inputs=_PAPER_INPUTS[kind], width=width, resolution=512),
        training=TrainingConfig(
            steps=100_000,
            batch=BATCH["cpu"],
            learning_rate=1e-3,
            plane_learning_rate=1e-3,
            schedule="halving",
            unit="one",
            blur=4.0,
        ),
        knows_base_color=False,
    )


# Fine planes learn the noise of hair's scattered light (docs/decisions/fibers.md).
_PLANES = {"surface": (256, 8), "fiber": (32, 16)}
# Measured on surfaces alone (docs/decisions/training.md).
_SMOOTHING = {"surface": 0.25, "fiber": 0.0}
_ROWS_OF_SMOOTHING = 6.4e6
_MOST_SMOOTHING = 2.0
_SMOOTHING_BESIDE_PRINT = 2.0
_KNOWS_PLAIN_COLORS = 128  # neurons
# Measured on curls (docs/decisions/training.md).
_MUON_RATE = {"surface": 0.015, "fiber": 0.005}
# A decoder of shadowed light has a unit a tenth as large (docs/decisions/model.md).
_SHADOW_WEIGHT = {"surface": 0.1, "fiber": 1.0}
# For assets that are small in the image.
_TINY_PLANES = {"surface": (128, 8), "fiber": (16, 16)}


def _ours(
    kind: str,
    width: int,
    steps: int,
    learning_rate: float,
    hidden_layers: int = 4,
    planes: dict[str, tuple[int, int]] = _PLANES,
    shadow_width: int = 64,
) -> Preset:
    resolution, channels = planes[kind]
    return Preset(
        model=ModelConfig(
            inputs=_OUR_INPUTS[kind],
            width=width,
            hidden_layers=hidden_layers,
            resolution=resolution,
            channels=channels,
            separates_direct=kind == "fiber",
            shadow_width=shadow_width if kind == "surface" else 0,
            shadow_inputs=_SURFACE_INPUTS if kind == "surface" else (),
        ),
        training=TrainingConfig(
            steps=steps,
            batch=BATCH["cpu"],
            optimizer="muon",
            learning_rate=learning_rate,
            muon_learning_rate=_MUON_RATE[kind],
            plane_learning_rate=1e-2,
            schedule="cosine",
            unit="usual",
            loss="log" if kind == "fiber" else "auto",
            shadow_weight=_SHADOW_WEIGHT[kind],
            unbiased_share=0.1,
            blur=4.0,
            smoothing=_SMOOTHING[kind],
        ),
    )


PRESETS = {
    kind: {
        "tiny": _ours(kind, 32, 20_000, 4e-3, 2, _TINY_PLANES, shadow_width=16),
        "small": _ours(kind, 64, 20_000, 4e-3),
        "hq": _ours(kind, 256, 20_000, 2e-3, shadow_width=128),
        "paper-small": _paper(kind, 64),
        "paper-hq": _paper(kind, 512),
    }
    for kind in ("surface", "fiber")
}
"""Kind of asset -> name -> preset."""


ANALYTIC_NAME = "analytic"
ANALYTIC = (
    PRESETS["surface"]["small"]
    .with_model(
        material="gltf",
        inputs=("features", "normal"),
        hidden_layers=2,
        shadow_width=0,
        shadow_inputs=(),
    )
    .with_training(shadow_weight=1.0)
    .model_copy(update={"knows_base_color": False})
)
"""The material of surfaces that can be baked, fitted as well as it can be."""


def named_preset(kind: str, name: str) -> Preset:
    """The preset of that name, `ANALYTIC_NAME` of surfaces among them; KeyError for none."""
    return ANALYTIC if (kind, name) == ("surface", ANALYTIC_NAME) else PRESETS[kind][name]
