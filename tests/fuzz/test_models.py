"""Some hostile models; `tests.fuzz.models` opens some 300."""

import pytest

from tests.fuzz.model_seeds import SCRIPTS, write_hostile, write_models
from tests.fuzz.models import check_all, mutations

pytestmark = pytest.mark.blender

# Some of each kind of answer: of a file that is fine, of an exception in an importer's Python, of
# its own words, and of Blender's end.
NAMED = {
    *(SCRIPTS, "name-of-control-characters.gltf", "indices-out-of-range.gltf", "magic.glb"),
    *("skin-of-no-node.gltf", "deep.gltf", "version-3.gltf", "layers-in-a-loop.usda"),
    *("counts-huge.usda", "indices-beyond.obj", "face-of-200.ply", "header.blend"),
}


def test_hostile_models_are_opened_or_refused_in_one_line(blender_python, tmp_path):
    seeds = write_models(blender_python, tmp_path)
    paths = [path for path in write_hostile(tmp_path) if path.name in NAMED]
    assert len(paths) == len(NAMED)
    mutated = mutations(0, 2 * len(seeds), seeds)
    counts, lines = check_all(blender_python, [*paths, *mutated], tmp_path)
    assert not [line for line in lines if line.startswith("failed")]
    verdicts = {line.split()[0] for line in lines}
    assert verdicts == {"accepted", "refused", "ended"}, counts
