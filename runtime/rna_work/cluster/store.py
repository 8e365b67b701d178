"""Object storage for clusters without a shared file system."""

import argparse
import shutil
from dataclasses import dataclass
from pathlib import Path, PureWindowsPath
from typing import Any
from uuid import uuid4

from rna_sdk.errors import WorkError
from rna_sdk.files.atomic_file import atomic_file, is_temporary

_INSTALL = {"s3": "s3fs", "gs": "gcsfs", "gcs": "gcsfs", "abfs": "adlfs", "az": "adlfs"}


def add_store_option(parser: argparse.ArgumentParser) -> None:
    """The option `--store`."""
    parser.add_argument(
        "--store",
        type=Store,
        metavar="URL",
        help="object storage for rays if cluster nodes share no file system with this machine, "
        "such as s3://bucket/folder (URL, default: shared file system)",
    )


@dataclass(frozen=True)
class Store:
    """Files below an address that fsspec knows: s3://, gs://, abfs://, file://, ...

    Objects are written atomically. Whoever may write to the storage may put any object there: names
    that lead out of a folder raise WorkError.
    """

    url: str

    def put(self, local: Path, name: str) -> None:
        """Send a file. Raises WorkError if that fails."""
        system, root = self._opened()
        path = f"{root}/{self._checked(name)}"
        try:
            system.makedirs(path.rpartition("/")[0], exist_ok=True)
            if "file" in system.protocol:  # the others show an object when it is whole
                with atomic_file(Path(path)) as temporary:
                    shutil.copyfile(local, temporary)
            else:
                system.put_file(str(local), path)
        except Exception as error:  # of whichever library speaks to the storage
            raise self._failed(name, error) from error

    def get(self, name: str, local: Path) -> None:
        """Fetch a file, atomically. Raises WorkError if that fails; `local` is then as it was."""
        system, root = self._opened()
        path = f"{root}/{self._checked(name)}"
        local.parent.mkdir(parents=True, exist_ok=True)
        try:
            with atomic_file(local) as temporary:
                system.get_file(path, str(temporary))
        except Exception as error:
            raise self._failed(name, error) from error

    def remove(self, name: str) -> None:
        """Remove a file, if it is there. Raises WorkError if that fails."""
        system, root = self._opened()
        path = f"{root}/{self._checked(name)}"
        try:
            system.rm_file(path)
        except FileNotFoundError:
            pass
        except Exception as error:
            raise self._failed(name, error) from error

    def names(self) -> set[str]:
        """Names of all files. Raises WorkError, also if one leads out of the folder."""
        system, root = self._opened()
        try:
            system.invalidate_cache()
            paths = system.find(root)
        except FileNotFoundError:
            return set()
        except Exception as error:
            raise self._failed("", error) from error
        names = (str(path)[len(root) :].lstrip("/") for path in paths)
        return {self._checked(name) for name in names if not is_temporary(Path(name))}

    def below(self, folder: str) -> "Store":
        """The part of the store from a folder on."""
        return Store(f"{self.url.rstrip('/')}/{folder}")

    def check(self) -> None:
        """Raises WorkError where this machine cannot write there, before work begins."""
        system, root = self._opened()
        probe = f"{root}/.probe-{uuid4().hex[:8]}"
        try:
            system.makedirs(root, exist_ok=True)
            system.pipe_file(probe, b"")
            system.rm_file(probe)
        except Exception as error:
            raise self._failed("", error) from error

    def _opened(self) -> tuple[Any, str]:
        try:
            import fsspec

            system, root = fsspec.core.url_to_fs(self.url)
        except ImportError as error:
            package = _INSTALL.get(self.url.partition(":")[0], "fsspec")
            raise WorkError(f"--store {self.url}: pip install {package}") from error
        except ValueError as error:
            raise WorkError(f"--store {self.url}: {error}") from error
        return system, str(root).rstrip("/")

    def _checked(self, name: str) -> str:
        """The name; raises WorkError if it leads out of a folder, on any system."""
        parts = PureWindowsPath(name)
        if not name or name != parts.as_posix() or parts.anchor or ".." in parts.parts:
            raise WorkError(
                f"{self.url}: an object named {name!r}, expected a relative path without '..'; "
                "somebody else put it there: remove it, or use another --store"
            )
        return name

    def _failed(self, name: str, error: Exception) -> WorkError:
        line = " ".join(f"{type(error).__name__}: {error}".split())
        return WorkError(f"{self.url}/{name}: {line}")
