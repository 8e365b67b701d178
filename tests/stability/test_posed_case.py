"""The case of a part that moves: queries go back to rest, the rise is judged at 30 degrees."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from rna_bench.stability.cases import posed
from rna_bench.stability.fixtures import Fixtures, Subject

UNIT = np.eye(3, dtype=np.float32)


def posed_samples(angle_deg: float) -> dict[str, np.ndarray]:
    """Points of an arm that was turned, by what they were at rest: UNIT in every field."""
    turn = posed.rotation(angle_deg)
    directions = {name: (UNIT @ turn.T).astype(np.float32) for name in ("normal", "wo", "wi")}
    position = (UNIT - posed.SHOULDER) @ turn.T + posed.SHOULDER
    kept = {"visible": np.uint8([1, 0, 1]), "radiance": UNIT}
    return {"position": position.astype(np.float32), **directions, **kept}


@pytest.mark.parametrize("angle_deg", [0.0, 10.0, 60.0])
def test_a_turned_point_is_asked_where_it_was_at_rest(angle_deg: float) -> None:
    samples = posed.at_rest(posed_samples(angle_deg), angle_deg)
    for name in ("position", "normal", "wo", "wi"):
        np.testing.assert_allclose(samples[name], UNIT, atol=1e-6)
        assert samples[name].dtype == np.float32
    assert samples["visible"].tolist() == [1, 0, 1]


def test_the_arm_is_raised() -> None:
    np.testing.assert_allclose(posed.rotation(90.0) @ [0.0, -1.0, 0.0], [1.0, 0.0, 0.0], atol=1e-9)


@pytest.mark.parametrize(("error", "passes"), [(0.19, True), (0.21, False)])
def test_the_worse_part_is_judged_at_thirty_degrees(error: float, passes: bool) -> None:
    errors = {0.0: 0.1, 10.0: 0.11, 30.0: error, 60.0: 0.4}
    rows = [{"angle_deg": a, "where": "arm", "error": e} for a, e in errors.items()]
    rows += [{"angle_deg": a, "where": "body", "error": 0.05} for a in errors]
    verdict = posed.judge(rows)
    assert verdict.passed == passes
    assert "body +0%, +0%, +0%; arm +10%" in verdict.found and "+300%" in verdict.found


@pytest.mark.blender
def test_the_captured_arm_turns_as_the_case_says(tmp_path: Path) -> None:
    """A tiny capture of two poses: each arm, turned back, fills the same box; the body stays."""
    fixtures = Fixtures(tmp_path, Subject(), 10, 1, short=True)
    rest, moved = (posed.capture(fixtures, angle, lights=1, rays=64) for angle in (0.0, 60.0))
    assert [part.name for part in rest.parts] == list(posed.PARTS)
    positions = {
        name: [dataset.part(name).geometry().positions for dataset in (rest, moved)]
        for name in posed.PARTS
    }
    fields = dict.fromkeys(("normal", "wo", "wi"), np.zeros((1, 3), np.float32))
    back = posed.at_rest({"position": positions["arm"][1], **fields}, 60.0)["position"]
    for at_rest, turned_back in ((positions["arm"][0], back), positions["body"]):
        assert np.allclose(at_rest.min(axis=0), turned_back.min(axis=0), atol=1e-4)
        assert np.allclose(at_rest.max(axis=0), turned_back.max(axis=0), atol=1e-4)
    assert not np.allclose(
        positions["arm"][0].max(axis=0), positions["arm"][1].max(axis=0), atol=0.1
    )

    models = dict.fromkeys(posed.PARTS, lambda queries: (queries["wi"] * 0.0,) * 2)
    rows = posed.errors(models, moved, 60.0)
    assert {row["where"] for row in rows} == {"body", "arm", "both"}
    assert all(row["error"] > 0.9 and row["brightness"] == 0.0 for row in rows)
