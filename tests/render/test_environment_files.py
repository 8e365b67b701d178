"""Environments as other programs write them, read by `rna-run`; tests/web has the viewer."""

import pytest

from rna_render.lights.files.environment_file import EnvironmentWarning, read_environment
from rna_sdk.errors import SceneError
from tests.render.environment_files import cases


def test_environments_of_other_programs(tmp_path):
    for case in cases(tmp_path):
        if case.texels is None:
            with pytest.raises(SceneError) as caught:
                read_environment(case.path)
            assert case.message in str(caught.value) and case.path.name in str(caught.value)
        elif "overflow" in case.path.name:
            with pytest.warns(EnvironmentWarning, match="in 1 texels is cut to 65,504"):
                case.check(read_environment(case.path))
        else:
            case.check(read_environment(case.path))
