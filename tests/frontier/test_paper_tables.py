"""The paper's tables beside ours: each row where it belongs."""

from rna_bench.frontier.paper_tables import paper_tables
from rna_bench.frontier.trials.grid import full_grid
from rna_bench.frontier.trials.trial import Trial


def points_of(trials: list[Trial]) -> list[dict[str, object]]:
    """As `points_of` of the frontier makes them; the PSNR is the trial's place in the grid."""
    return [
        {
            **trial.preset.model.model_dump(),
            "name": trial.name,
            "family": trial.family,
            "tables": trial.tables,
            "precision": precision,
            "psnr": float(place) + offset,
            "flip": 0.1,
            "p99": 0.2,
        }
        for place, trial in enumerate(trials)
        for precision, offset in (("float32-float16", 0.0), ("int8-int8", 0.5))
    ]


def test_rows_are_the_papers_in_its_order():
    architecture, channels, _ = paper_tables(points_of(full_grid("surface")))
    assert [row[0] for row in architecture["rows"]][:2] == ["4 x 16", "4 x 32"]
    assert [row[0] for row in architecture["rows"]][-1] == "4 x 1024"
    assert [row[2] for row in architecture["rows"]][-1] == "34.90"
    assert [row[0] for row in channels["rows"]] == ["4", "8", "16", "32"]
    assert channels["rows"][1][2] == "34.09"
    assert architecture["points"][2] == "paper-small/float32-float16"
    assert all(row[1].endswith(".00") for row in architecture["rows"])  # not those of int8


def test_ablations_stand_below_the_model_that_they_change():
    for kind, names in (("surface", ("no-learned-normal",)), ("fiber", ("no-h",))):
        rows = [row[0] for row in paper_tables(points_of(full_grid(kind)))[2]["rows"]]
        planes = 256 if kind == "surface" else 32
        whole = rows.index(f"w64-l4-p{planes}-c{8 if kind == 'surface' else 16}")
        assert rows[whole + 1].startswith("w64-paper-inputs: with the paper's inputs")
        assert all(any(row.startswith(f"w64-{name}: ") for row in rows) for name in names)
