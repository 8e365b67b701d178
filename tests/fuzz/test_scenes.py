"""Some hundred mutations of meshes, pictures and scenes; `rna-bench fuzz-scenes` runs many more."""

from __future__ import annotations

import json
import sys
from collections import Counter

import pytest

from rna_bench.readers import scene_checks
from rna_bench.readers.fuzz_scenes import check_all, mutations, run_batch, warm_up
from rna_bench.readers.scene_seeds import ENVIRONMENTS, MESHES, SCENES, TEXTURES

COUNT = 400
KINDS = (MESHES, ENVIRONMENTS, TEXTURES, SCENES)


def test_mutated_files_are_read_or_refused_in_one_line(tmp_path):
    warm_up(tmp_path)
    found = check_all(0, COUNT, tmp_path)
    assert found["failures"] == []
    for kind in KINDS:  # not all of one verdict, or it would test little
        assert all(found["counts"][f"{kind} {verdict}"] for verdict in ("accepted", "refused"))


def test_mutations_are_the_same_by_number(tmp_path):
    def contents(first, end):
        return [path.read_bytes() for _, _, path in mutations(first, end, tmp_path)]

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
    found = check_all(0, 4, tmp_path)
    assert found["counts"][f"{MESHES} failed"] == 1
    assert found["failures"][0].startswith(f"0 {MESHES}, ")


def test_a_crash_is_counted_and_the_batch_goes_on(tmp_path, monkeypatch):
    """A program in the place of Python dies of a signal at number 3, then runs to the end."""
    program = tmp_path / "python"
    states = [
        {"at": 3, "file": "a.gltf", "counts": {"meshes refused": 3}},
        {"at": 9, "counts": {"meshes refused": 6}},
    ]
    first, second = (json.dumps(state) for state in states)
    program.write_text(
        "#!/bin/sh\n"
        f"if [ $3 = 0 ]; then echo '{first}' > $6/state.json; kill -SEGV $$; fi\n"
        f"test $3 = 4 && echo '{second}' > $6/state.json\n"
    )
    program.chmod(0o755)
    monkeypatch.setattr(sys, "executable", str(program))
    counts, failures = run_batch((0, 10), 1.0)
    assert counts == Counter({"meshes refused": 9})
    assert len(failures) == 1 and failures[0].startswith("3 a.gltf: ended by -11")
