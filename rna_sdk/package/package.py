"""An opened package: the public way to read a `.rna` file."""

from __future__ import annotations

from os import PathLike
from types import TracebackType

from rna_sdk.errors import PackageError, QueryError
from rna_sdk.package.container import Container
from rna_sdk.package.curves import Curves
from rna_sdk.package.geometry import Geometry, geometry_from_bytes
from rna_sdk.package.manifest import Manifest, Tier
from rna_sdk.package.mesh import Mesh
from rna_sdk.package.planes import Planes, planes_from_bytes
from rna_sdk.package.validator import inspect


class Package:
    """A valid package, mapped into memory; make one with `Package.open`.

    Arrays it hands out are read-only views of the file. They stay good after `close`: the map
    goes away with the last of them. The file must not be changed in place meanwhile.

    Attributes:
        manifest: the manifest, immutable.
    """

    def __init__(self, container: Container, manifest: Manifest) -> None:
        self._container: Container | None = container
        self.manifest = manifest

    @classmethod
    def open(cls, path: str | PathLike[str]) -> Package:
        """Map and fully validate the file at `path`.

        Raises:
            PackageError: the file cannot be read or breaks the format; `issues` tells how.
        """
        result = inspect(path)
        if result.errors or result.container is None or result.manifest is None:
            raise PackageError(result.errors, path)
        return cls(result.container, result.manifest)

    def close(self) -> None:
        """Let go of the file. Calling it twice is fine."""
        self._container = None

    def __enter__(self) -> Package:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        value: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self.close()

    def tier(self, name: str) -> Tier:
        """The tier's record in the manifest.

        Raises:
            QueryError: the package has no tier of this name.
        """
        for tier in self.manifest.tiers:
            if tier.name == name:
                return tier
        names = ", ".join(tier.name for tier in self.manifest.tiers)
        raise QueryError(f"no tier {name!r}; this package has: {names}")

    def geometry(self) -> Geometry:
        """The mesh or the curves, as the manifest's kind says; object space, metres.

        Raises:
            QueryError: the package is closed.
        """
        name = self.manifest.geometry
        return geometry_from_bytes(self._view(name), name, self.manifest.kind)

    def mesh(self) -> Mesh:
        """The geometry of a surface asset, in object space and metres.

        Raises:
            QueryError: the asset is of another kind, or the package is closed.
        """
        geometry = self.geometry()
        if not isinstance(geometry, Mesh):
            raise QueryError(f"a {self.manifest.kind} asset has no mesh; ask for its curves()")
        return geometry

    def curves(self) -> Curves:
        """The geometry of a fiber asset, in object space and metres.

        Raises:
            QueryError: the asset is of another kind, or the package is closed.
        """
        geometry = self.geometry()
        if not isinstance(geometry, Curves):
            raise QueryError(f"a {self.manifest.kind} asset has no curves; ask for its mesh()")
        return geometry

    def planes(self, tier: str) -> Planes:
        """The tier's triplane, (3, R, R, C), planes XY, YZ, ZX: an array, or Int8Planes.

        Raises:
            QueryError: the package has no tier of this name, or is closed.
        """
        record = self.tier(tier)
        return planes_from_bytes(self._view(record.planes), record)

    def decoder(self, tier: str) -> memoryview:
        """The tier's ONNX model, as read-only bytes.

        Raises:
            QueryError: the package has no tier of this name, or is closed.
        """
        return self._view(self.tier(tier).decoder)

    def _view(self, entry: str) -> memoryview:
        if self._container is None:
            raise QueryError("the package is closed")
        return self._container.view(entry)
