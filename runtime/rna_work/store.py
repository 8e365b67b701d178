"""Object storage for clusters without a shared file system."""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from uuid import uuid4

from rna_sdk.errors import WorkError

_INSTALL = {"s3": "s3fs", "gs": "gcsfs", "gcs": "gcsfs", "abfs": "adlfs", "az": "adlfs"}


def add_store_option(parser: argparse.ArgumentParser, what: str) -> None:
    """The option `--store`; what: the files that workers put there."""
    parser.add_argument(
        "--store",
        type=Store,
        metavar="URL",
        help=f"object storage for {what} if cluster nodes share no file system with this machine, "
        "such as s3://bucket/folder (URL, default: shared file system)",
    )


@dataclass(frozen=True)
class Store:
    """Files below an address that fsspec knows: s3://, gs://, abfs://, file://, ...

    Objects are written atomically.
    """

    url: str

    def put(self, local: Path, name: str) -> None:
        """Send a file. Raises WorkError if that fails."""
        system, root = self._opened()
        try:
            system.makedirs(f"{root}/{name}".rpartition("/")[0], exist_ok=True)
            system.put_file(str(local), f"{root}/{name}")
        except Exception as error:  # of whichever library speaks to the storage
            raise self._failed(name, error) from error

    def get(self, name: str, local: Path) -> None:
        """Fetch a file, which is written atomically. Raises WorkError if that fails."""
        system, root = self._opened()
        local.parent.mkdir(parents=True, exist_ok=True)
        temporary = local.with_name(f"{local.name}.{uuid4().hex[:12]}.part")
        try:
            system.get_file(f"{root}/{name}", str(temporary))
            temporary.replace(local)
        except Exception as error:
            raise self._failed(name, error) from error
        finally:
            temporary.unlink(missing_ok=True)

    def remove(self, name: str) -> None:
        """Remove a file, if it is there. Raises WorkError if that fails."""
        system, root = self._opened()
        try:
            system.rm_file(f"{root}/{name}")
        except FileNotFoundError:
            pass
        except Exception as error:
            raise self._failed(name, error) from error

    def names(self) -> set[str]:
        """Names of all files."""
        system, root = self._opened()
        try:
            system.invalidate_cache()
            found = system.find(root)
        except FileNotFoundError:
            return set()
        except Exception as error:
            raise self._failed("", error) from error
        return {str(path)[len(root) :].lstrip("/") for path in found}

    def below(self, folder: str) -> Store:
        """The same, from a folder on."""
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

    def _failed(self, name: str, error: Exception) -> WorkError:
        line = " ".join(f"{type(error).__name__}: {error}".split())
        return WorkError(f"{self.url}/{name}: {line}")
