"""The list of issue codes; `python -m rna_sdk.package.issue_list` writes it."""

import sys

from rna_sdk.package.generated import generate
from rna_sdk.package.issues import Code

ISSUES_FILE = "spec/ISSUES.md"

_INTRODUCTION = """\
# Issue codes

The codes that `rna-validate` and `rna_sdk.package.validate` report. A published code keeps its
meaning. An error makes a reader refuse the package; a warning does not. Generated from
`rna_sdk/package/issues.py` by `python -m rna_sdk.package.issue_list`.

| code | severity | meaning |
| --- | --- | --- |
"""


def issue_list() -> str:
    """The table of every code, as the text of the file."""
    rows = (f"| `{code.name}` | {code.severity.value} | {code.meaning} |\n" for code in Code)
    return _INTRODUCTION + "".join(rows)


if __name__ == "__main__":
    sys.exit(generate({ISSUES_FILE: issue_list()}, "rna_sdk.package.issue_list"))
