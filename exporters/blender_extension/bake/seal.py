"""Distinguishes a bake that this user began from one that came with somebody else's files.

What a bake's folder says is sealed with a key of the user, which no other file has.
"""

import hashlib
import hmac
import os
import secrets
from pathlib import Path

_BYTES = 32


def seal_of(text):
    """The seal of a text, by this user."""
    return hmac.new(_key(), text.encode(), hashlib.sha256).hexdigest()


def is_sealed(text, seal):
    """Whether `seal` is this user's seal of the text."""
    return isinstance(seal, str) and hmac.compare_digest(seal.encode(), seal_of(text).encode())


def key_path():
    """The file with the key, which is made when it is first needed."""
    data = Path(os.environ.get("XDG_DATA_HOME", Path.home() / ".local" / "share"))
    return data / "rna-sdk" / "bakes.key"


def _key():
    path = key_path()
    if not path.is_file() or path.stat().st_size != _BYTES:
        path.parent.mkdir(parents=True, exist_ok=True)
        temporary = path.with_name(f"{path.name}.{os.getpid()}")
        temporary.touch(mode=0o600)
        temporary.write_bytes(secrets.token_bytes(_BYTES))
        temporary.replace(path)
    return path.read_bytes()
