"""Formulas of input blocks: what a new block takes, and mistakes in them."""

import pytest

from rna_sdk.package.formulas.block_formulas import SPECIFICATION, BlockFormulas
from rna_sdk.package.write_blocks import files

TEXT = SPECIFICATION.read_text(encoding="utf-8")
ROW = "| `fiber_angles` |"
TERM = "aside = cross(n, m)\n"


def with_block(row: str, term: str = "") -> BlockFormulas:
    return BlockFormulas(TEXT.replace(ROW, f"{row}\n{ROW}").replace(TERM, TERM + term))


def test_a_new_block_is_in_every_language():
    new = with_block("| `gloss` | 2 | surface | `dot(n, wi) / 3`, `rim` |", "rim = length(aside)\n")
    written = files(new)
    told = {
        path.rsplit("/", 1)[1]: text for path, text in written.items() if "GLOSS" in text.upper()
    }
    assert told.keys() == {path.rsplit("/", 1)[1] for path in written} - {"fiber_blocks.wgsl"}
    assert (
        '{"name": "gloss", "width": 2, "kinds": ["surface"], "light": true}' in told["blocks.json"]
    )
    assert 'blocks["gloss"] = (of.dot(n, wi) / 3.0, rim,)' in told["array_blocks.py"]
    lanes = "put(queries, row, columns[GLOSS], (dot(n, wi) * (1.0 / 3.0), rim,))"
    assert lanes in told["input_blocks.py"]
    slot = "rna_put(rna_slot(RNA_BLOCK_GLOSS), vec4f(dot(n, wi) / 3.0, rim, 0.0, 0.0));"
    assert slot in told["surface_blocks.wgsl"]
    assert "PUT(GLOSS, 0, dot(n, wi) * (1.0 / 3.0));" in told["block_formulas.h"]
    assert told["block_formulas.h"].count("const double rim = length(aside);") == 1
    # What two blocks need is computed once.
    assert told["surface_blocks.wgsl"].count("let aside = cross(n, m);") == 1


@pytest.mark.parametrize(
    ("row", "error", "message"),
    [
        ("| `gloss` | 3 | surface | `dot(n, wi)` |", ValueError, "gloss: found .*3.* expected .*1"),
        ("| `gloss` | 1 | both | `dot(n, wi)` |", ValueError, "expected .*surface"),
        ("| `gloss` | 1 | surface | `dot(n, what)` |", KeyError, "what"),
        ("| `gloss` | 1 | surface | `sine(n)` |", KeyError, "sine"),
    ],
)
def test_wrong_rows_are_refused(row, error, message):
    with pytest.raises(error, match=message):
        with_block(row)


def test_vectors_in_calls_have_names():
    with pytest.raises(ValueError, match="expected named vectors"):
        files(with_block("| `gloss` | 1 | surface | `dot(n + wi, wo)` |"))
