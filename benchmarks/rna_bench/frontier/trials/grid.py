"""The grids of models: our shapes, the paper's tables, ablations."""

from itertools import product

from rna_bench.frontier.trials.trial import Family, Trial, name_of
from rna_export.training.presets import PRESETS, Preset

FULL_STEPS, SHORT_STEPS = 20_000, 5_000
"""Steps per training: of our presets, and of 40 minutes on 2 cores."""

PAPER_ARCHITECTURES = (
    *((4, width) for width in (16, 32, 64, 128, 256)),
    *((layers, 512) for layers in (2, 3, 4, 5)),
    (4, 1024),
)
"""(hidden layers, neurons): the paper's table "Ablation on the MLP architecture", row for row."""

PAPER_CHANNELS = (4, 8, 16, 32)
"""The paper's table "Ablation on Feature Grid Channels", of 4 layers of 512, row for row."""

_PLANES = {"surface": (256, (128, 512, 1024)), "fiber": (32, (16, 64, 128))}
_CHANNELS = {"surface": (8, (4, 16, 32)), "fiber": (16, (4, 8, 32))}
"""Kind -> the kind of our presets, and the others."""

_WIDTHS = (16, 32, 64, 128, 256, 512, 1024)
_LAYERS = (2, 3, 4, 5)


def full_grid(kind: str, steps: int = FULL_STEPS) -> list[Trial]:
    """Every model; made for a GPU."""
    shapes = [ours(kind, width, layers) for width, layers in product(_WIDTHS, _LAYERS)]
    shapes.append(ours(kind, 32, 2, planes=_PLANES[kind][1][0]))  # the preset `tiny`
    for width in (16, 64, 256):
        shapes += [ours(kind, width, planes=planes) for planes in _PLANES[kind][1]]
        shapes += [ours(kind, width, channels=channels) for channels in _CHANNELS[kind][1]]
    paper = [paper_model(kind, *shape) for shape in PAPER_ARCHITECTURES]
    paper += [paper_model(kind, 4, 512, channels) for channels in PAPER_CHANNELS]
    return _with_steps([*shapes, *paper, *ablations(kind, (64, 256)), *short_grid(kind)], steps)


def short_grid(kind: str, steps: int = SHORT_STEPS) -> list[Trial]:
    """Two dozen models that span the same range, except our widest."""
    planes, channels = _PLANES[kind][1][:2], _CHANNELS[kind][1][:2]
    smallest = {"planes": planes[0], "channels": channels[0]}
    shapes = [
        *(ours(kind, width) for width in (16, 32, 64, 128, 256)),
        *(ours(kind, 64, layers) for layers in (2, 3, 5)),
        *(ours(kind, 64, channels=count) for count in channels),
        *(ours(kind, 64, planes=count) for count in planes),
        ours(kind, 16, 2, **smallest),
        ours(kind, 16, planes=planes[0]),
        ours(kind, 32, 2),
        ours(kind, 32, 2, planes=planes[0]),  # the preset `tiny`
        ours(kind, 128, 2),
    ]
    paper = [paper_model(kind, 4, 64), paper_model(kind, 4, 512), nrhints(kind)]
    paper += [with_our_optimizer(trial) for trial in paper]
    return _with_steps([*shapes, *paper, *ablations(kind, (64,))], steps)


def ours(
    kind: str, width: int, layers: int = 4, planes: int | None = None, channels: int | None = None
) -> Trial:
    """A model of our inputs and training; planes and channels as in our presets if not given."""
    preset = PRESETS[kind]["small"].with_model(
        width=width,
        hidden_layers=layers,
        resolution=planes or _PLANES[kind][0],
        channels=channels or _CHANNELS[kind][0],
    )
    # Through the rates of our presets: 4e-3 at width 64, 2e-3 at 256.
    rate = min(4e-3, 4e-3 * (64 / width) ** 0.5)
    return _trial("ours", preset.with_training(learning_rate=rate), name=name_of(preset))


def paper_model(kind: str, layers: int, width: int, channels: int = 8) -> Trial:
    """A model of the paper's inputs, planes and training."""
    preset = PRESETS[kind]["paper-hq"].with_model(
        hidden_layers=layers, width=width, channels=channels
    )
    shape = layers, width
    tables = ["architecture"] * (shape in PAPER_ARCHITECTURES and channels == 8)
    tables += ["channels"] * (shape == (4, 512))
    usual = {(4, 64, 8): "paper-small", (4, 512, 8): "paper-hq"}
    name = usual.get((*shape, channels), f"paper-{name_of(preset)}")
    return _trial("paper", preset, name, *tables)


def nrhints(kind: str) -> Trial:
    """The paper's opponent with known geometry: our queries and hint, NRHints' network and rate.

    Its features and its decoder take as many multiply-adds as `paper-hq`, 0.8 M.
    """
    paper = PRESETS[kind]["paper-hq"]
    inputs = ("features", "position", *paper.model.inputs[1:])
    preset = paper.with_model(inputs=inputs, width=256, resolution=1, channels=304).with_training(
        learning_rate=5e-4, schedule="cosine"
    )
    named = {"cost_as": "paper-hq", "has_planes": False}
    return _trial("opponent", preset, "nrhints").model_copy(update=named)


def with_our_optimizer(trial: Trial) -> Trial:
    """A model of others under Muon: the gain by Muon is neither its own nor ours."""
    preset = trial.preset.with_training(optimizer="muon")
    named = {"name": f"{trial.name}-muon", "family": "ablation", "tables": ("our-optimizer",)}
    return trial.model_copy(update={"preset": preset, **named})


def ablations(kind: str, widths: tuple[int, ...]) -> list[Trial]:
    """Our preset's shape at these widths, without additions of ours or the paper's."""
    trials = []
    for width in widths:
        preset = ours(kind, width).preset
        paper = PRESETS[kind]["paper-small"].model.inputs
        variants = {"paper-inputs": preset.with_model(inputs=paper)}
        if kind == "fiber":
            without = tuple(b for b in preset.model.inputs if b not in ("h", "fiber_lobes"))
            variants["no-h"] = preset.with_model(inputs=without)
        else:
            without = tuple(b for b in preset.model.inputs if b != "learned_normal")
            variants["no-learned-normal"] = preset.with_model(inputs=without)
        trials += [
            _trial("ablation", changed, f"w{width}-{variant}", variant)
            for variant, changed in variants.items()
        ]
    return trials


def _trial(family: Family, preset: Preset, name: str, *tables: str) -> Trial:
    return Trial(name=name, family=family, preset=preset, tables=tables)


def _with_steps(trials: list[Trial], steps: int) -> list[Trial]:
    """Each once, all trained for as many steps."""
    once = {trial.name: trial for trial in trials}.values()
    return [trial.of_length(steps) for trial in once]
