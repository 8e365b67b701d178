"""Which dependencies have wheels for Windows and macOS, as a table for docs/installation.md.

    python scripts/wheels.py

Asks pip, for the versions in constraints.txt and Python 3.11, and downloads nothing.
"""

import json
import os
import re
import subprocess
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[1]
EXTRAS = ("render", "gpu", "capture", "train", "mitsuba", "cluster")
SYSTEMS = {
    "Windows, x86-64": ("win_amd64",),
    "macOS, Apple silicon": tuple(f"macosx_{version}_0_arm64" for version in (11, 12, 13, 14)),
    "macOS, Intel": tuple(
        f"macosx_{version}_x86_64" for version in ("10_9", "10_13", "11_0", "12_0", "13_0", "14_0")
    ),
}
NONE = re.compile(r"No matching distribution found for ([A-Za-z0-9._-]+)==")


def versions() -> dict[str, str]:
    """Direct dependency -> the version that the tests run with."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    lists = [project["dependencies"], *(project["optional-dependencies"][e] for e in EXTRAS)]
    names = {re.split(r"[\[<>=; ]", line)[0].lower() for part in lists for line in part}
    lines = (ROOT / "constraints.txt").read_text().splitlines()
    pinned = dict(line.split("==") for line in lines if "==" in line)
    named = {name.lower().replace("_", "-"): version for name, version in pinned.items()}
    return {name: named[name] for name in sorted(names - {"rna-sdk"})}


def wheels(wanted: dict[str, str], platforms: tuple[str, ...]) -> set[str]:
    """The packages of which there is a wheel; pip names one that has none at a time."""
    left = dict(wanted)
    while True:
        options = [word for tag in platforms for word in ("--platform", tag)]
        command = [
            *(sys.executable, "-m", "pip", "install", "--dry-run", "--no-deps", "--quiet"),
            *("--ignore-installed", "--target", "unused", "--python-version", "3.11"),
            *("--only-binary", ":all:", "--report", "-", *options),
        ]
        lines = [f"{name}=={version}" for name, version in left.items()]
        plain = {**os.environ, "PIP_CONFIG_FILE": os.devnull, "PIP_FIND_LINKS": ""}
        done = subprocess.run([*command, *lines], capture_output=True, text=True, env=plain)
        if done.returncode == 0:
            found = json.loads(done.stdout)["install"]
            return {one["metadata"]["name"].lower().replace("_", "-") for one in found}
        missing = NONE.search(done.stderr)
        if missing is None:
            sys.exit(done.stderr)
        del left[missing[1].lower()]


def main() -> None:
    wanted = versions()
    found = [wheels(wanted, platforms) for platforms in SYSTEMS.values()]
    print("| package | version |", *(f" {system} |" for system in SYSTEMS), sep="")
    print("| --- " * (2 + len(SYSTEMS)) + "|")
    for name, version in wanted.items():
        marks = ["yes" if name in one else "**no**" for one in found]
        print(f"| {name} | {version} | {' | '.join(marks)} |")


if __name__ == "__main__":
    main()
