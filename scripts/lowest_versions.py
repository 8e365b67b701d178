"""Print the lowest versions that pyproject.toml names, as constraints for pip.

python scripts/lowest_versions.py > lowest.txt
"""

import re
import sys
import tomllib
from pathlib import Path

_REQUIREMENT = re.compile(r"(?P<name>[\w.-]+)>=(?P<version>[\w.]+)(?P<marker>; .+)?")


def pins(requirements: list[str]) -> list[str]:
    """`name==version` of each `name>=version`, with its marker if it has one; sorted.

    Raises ValueError for any other form.
    """
    result = []
    for requirement in requirements:
        if requirement.startswith("rna-sdk["):
            continue  # the extras that an extra holds
        match = _REQUIREMENT.fullmatch(requirement)
        if match is None:
            raise ValueError(f"pyproject.toml: found {requirement!r}, expected name>=version")
        result.append(f"{match['name']}=={match['version']}{match['marker'] or ''}")
    return sorted(result, key=str.lower)


def main() -> None:
    """Print them."""
    path = Path(__file__).parent.parent / "pyproject.toml"
    project = tomllib.loads(path.read_text())["project"]
    extras = project["optional-dependencies"].values()
    try:
        print("\n".join(pins(project["dependencies"] + [r for extra in extras for r in extra])))
    except ValueError as error:
        sys.exit(f"error: {error}")


if __name__ == "__main__":
    main()
