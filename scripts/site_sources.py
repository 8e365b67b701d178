"""Gathers the site's sources: every page of the repository, and the files that pages link to.

    python scripts/site_sources.py FOLDER

The pages keep their places, so that links between them hold on the site as they do in the
repository. A page of all commands' help is added.
"""

import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

REPOSITORY = Path(__file__).parents[1]
_LINK = re.compile(r"\]\((?!https?:|#)([^)#\s]+)|src=\"(?!https?:)([^\"]+)\"")


def main(folder: Path) -> None:
    shutil.rmtree(folder, ignore_errors=True)
    for page in _pages():
        _copy(page, folder)
        for link in _links(page):
            _copy(link, folder)
    (folder / "docs" / "reference" / "commands.md").write_text(_commands())


def _pages() -> list[Path]:
    """The Markdown that is part of the repository, or about to be."""
    command = ["git", "ls-files", "--cached", "--others", "--exclude-standard", "*.md"]
    names = subprocess.run(command, cwd=REPOSITORY, check=True, capture_output=True, text=True)
    return [REPOSITORY / name for name in names.stdout.splitlines()]


def _links(page: Path) -> list[Path]:
    """Files that a page links to or shows, but other pages."""
    result = ((page.parent / (a or b)).resolve() for a, b in _LINK.findall(page.read_text()))
    return [path for path in result if path.is_file() and path.suffix != ".md"]


def _copy(path: Path, folder: Path) -> None:
    target = folder / path.relative_to(REPOSITORY)
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copy(path, target)


def _commands() -> str:
    """A page of all commands' help."""
    scripts = tomllib.loads((REPOSITORY / "pyproject.toml").read_text())["project"]["scripts"]
    parts = ["# Commands\n\nThe `--help` text of each command.\n"]
    for name, entry in sorted(scripts.items()):
        command = [sys.executable, "-m", entry.partition(":")[0], "--help"]
        shown = subprocess.run(command, check=True, capture_output=True, text=True).stdout
        parts.append(f"## {name}\n\n```text\n{shown}```\n")
    return "\n".join(parts)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
