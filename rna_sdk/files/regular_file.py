"""Input files have to be regular files: opening a pipe or a device may wait forever."""

import errno
import os
import stat
from pathlib import Path


def check_regular(path: Path) -> os.stat_result:
    """The state of a file, or of the file that a link leads to.

    Raises OSError, whose `strerror` says what is wrong: there is no such file, its name cannot be
    one, or it is a folder, a pipe, a socket or a device.
    """
    try:
        state = path.stat()
    except ValueError as error:  # a NUL character
        raise OSError(errno.EINVAL, "not a name that a file can have", str(path)) from error
    if stat.S_ISDIR(state.st_mode):
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(path))
    if not stat.S_ISREG(state.st_mode):
        raise OSError(errno.EINVAL, "is a pipe or a device, not a file", str(path))
    return state


def read_regular(path: Path) -> bytes:
    """The bytes of a file; raises the errors of `check_regular` and of reading."""
    check_regular(path)
    return path.read_bytes()
