"""Some hundred mutations of meshes, pictures and scenes; `tests.fuzz.scenes` runs many more."""

import pytest

from tests.fuzz import scene_checks
from tests.fuzz.motion_files import GLTF_MOTIONS, MOTION_FILES
from tests.fuzz.scene_seeds import ENVIRONMENTS, MESHES, SCENES, TEXTURES
from tests.fuzz.scenes import check_all, mutations, seeds_of, warm_up
from tests.fuzz.training_files import CHECKPOINTS, MANIFESTS

COUNT = 400
KINDS = (
    *(MESHES, ENVIRONMENTS, TEXTURES, SCENES),
    *(GLTF_MOTIONS, MOTION_FILES, CHECKPOINTS, MANIFESTS),
)


def test_mutated_files_are_read_or_refused_in_one_line(tmp_path):
    seeds = seeds_of(tmp_path)
    warm_up(seeds)
    counts, failures = check_all(0, COUNT, tmp_path, seeds)
    assert failures == []
    for kind in KINDS:  # not all of one verdict, or it would test little
        assert all(counts[f"{kind} {verdict}"] for verdict in ("accepted", "refused"))


def test_mutations_are_the_same_by_number(tmp_path):
    def contents(first, end):
        seeds = seeds_of(tmp_path, (MESHES, SCENES, GLTF_MOTIONS))
        return [path.read_bytes() for _, _, path in mutations(first, end, seeds)]

    assert contents(0, 12)[8:] == contents(8, 12)


PLANTED = {
    "exception": lambda path: {}["key"],
    "message": lambda path: scene_checks._check_message("a\nb"),
    "memory": lambda path: scene_checks._check_message("it cannot be read: MemoryError"),
    "value": lambda path: scene_checks._finite("texels", scene_checks.np.array([float("nan")])),
}


@pytest.mark.parametrize("bug", PLANTED)
def test_what_a_reader_should_not_do_is_a_failure(bug, tmp_path, monkeypatch):
    monkeypatch.setitem(scene_checks._CHECKS, MESHES, PLANTED[bug])
    counts, failures = check_all(0, 4, tmp_path, seeds_of(tmp_path, (MESHES, SCENES)))
    assert counts[f"{MESHES} failed"] == 2
    assert failures[0].startswith(f"0 {MESHES}, ")
