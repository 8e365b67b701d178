"""What does not fit into memory is refused before it is allocated."""

import pytest

from rna_render.image.film import Film
from rna_sdk.errors import RnaError
from rna_sdk.machine import memory


@pytest.mark.skipif(memory._memory() is None, reason="the system does not tell its memory")
def test_a_film_that_is_too_large_is_refused(tmp_path, monkeypatch):
    limit = tmp_path / "memory.max"
    monkeypatch.setattr(memory, "_OF_CONTAINER", limit)
    for text in ("max\n", "1000000\n"):
        limit.write_text(text)
        Film((64, 32))
    with pytest.raises(RnaError, match=r"^an image of 640 x 320 pixels: takes 0\.0\d+ GB"):
        Film((640, 320), ["sun"])
    limit.unlink()
    Film((640, 320), ["sun"])
