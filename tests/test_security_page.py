"""docs/security.md: its limits are those of the code."""

import importlib
import re

import pytest

from tests.conftest import REPOSITORY

PAGE = (REPOSITORY / "docs" / "security.md").read_text()
ROWS = re.findall(r"^\|[^|]*\|[^|]*\| ([^|]+) \| `([\w.]+)` \|$", PAGE, re.MULTILINE)


@pytest.mark.parametrize(("text", "name"), ROWS, ids=[name for _, name in ROWS])
def test_limits_are_those_of_the_code(text, name):
    power, _, less = text.partition(" - ")
    base, _, exponent = power.partition("^")
    value = float(base) ** int(exponent or 1) - int(less or 0)
    module, _, constant = name.rpartition(".")
    assert getattr(importlib.import_module(module), constant) == value


def test_the_table_is_read():
    assert len(ROWS) == len(re.findall(r"`rna_\w+(?:\.\w+)+\.MAX_\w+`", PAGE)) > 20


def test_the_policy_at_the_root_leads_to_the_page():
    policy = (REPOSITORY / "SECURITY.md").read_text()
    assert "(docs/security.md#report-a-fault)" in policy and "## Report a fault" in PAGE
