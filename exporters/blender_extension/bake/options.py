"""Options of a bake: the options of rna-make that name neither files nor machines.

A .blend file stores them, and may be a stranger's.
"""

import shlex

FLAGS = ("--discard", "--exact-geometry")
LISTS = ("--precision",)
VALUES = (
    "--device",
    "--domain",
    "--front",
    "--lights",
    "--max-error",
    "--normal-texels",
    "--parts",
    "--poses",
    "--rays",
    "--rest-frame",
    "--samples",
    "--seed",
    "--sharpest",
    "--source",
    "--steps",
    "--texture-size",
    "--up",
    "--validation-resolution",
    "--validation-samples",
    "--validation-views",
    "--workers",
)
"""By the words that follow: none, any number, one."""
_LENGTHS = ("--lights", "--max-error", "--minutes", "--steps")


def parsed(text):
    """The arguments of the options in a line of text. Raises ValueError for any other option."""
    words, result = shlex.split(text), []
    while words:
        name, equals, value = words.pop(0).partition("=")
        if name in FLAGS and not equals:
            result.append(name)
        elif name in LISTS and not equals:
            result.append(name)
            while words and not words[0].startswith("-"):
                result.append(words.pop(0))
        elif name in VALUES:
            if not equals and (not words or words[0].startswith("--")):
                raise ValueError(f"Options: {name} has no value")
            result.append(f"{name}={value if equals else words.pop(0)}")
        else:
            allowed = ", ".join(sorted([*FLAGS, *LISTS, *VALUES]))
            raise ValueError(f"Options: found {name}, expected any of {allowed}")
    return result


def lasting(arguments):
    """Those that hold for more minutes, too, which have a length of their own."""
    return [one for one in arguments if one.partition("=")[0] not in _LENGTHS]
