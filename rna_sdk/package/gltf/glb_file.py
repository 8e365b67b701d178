"""The file in which a package travels, by its name: a `.rna`, or a `.glb` with a fallback."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from rna_sdk.files.atomic_file import write_atomically
from rna_sdk.files.file_kinds import glass_of
from rna_sdk.package.gltf.carrier_writer import with_package
from rna_sdk.package.gltf.fallback import VertexColors, glb_of
from rna_sdk.package.gltf.fallback_glow import Palette, palette_of
from rna_sdk.package.manifest.extensions import Standin, of_part
from rna_sdk.package.package import Package


def write_glb(
    package: Path, out: Path, fallback: Path | None = None, nodes: Sequence[str] = ()
) -> None:
    """Write a .glb that carries a package, atomically.

    fallback: a .glb that becomes the fallback, as `with_package`; None for one of the package's
    geometry with its stand-in materials.

    Raises:
        PackageError: a broken package.
        RnaError: a fallback that cannot carry it.
        OSError: the file cannot be written.
    """
    with Package.open(package) as opened:
        if fallback is None:
            data = glb_of(opened, *_looks(package, opened))
        else:
            data = with_package(fallback, opened, nodes)
    write_atomically(out, data)


@contextmanager
def package_to_write(out: Path) -> Iterator[Path]:
    """The `.rna` to write for an output: `out`, or a temporary one that becomes the .glb `out`.

    Smooth glass that is written beside the package goes beside the output.
    """
    if out.suffix.lower() != ".glb":
        yield out
        return
    with TemporaryDirectory() as folder:
        package = Path(folder) / f"{out.stem}.rna"
        yield package
        write_glb(package, out)
        if (glass := glass_of(package)).is_file():
            write_atomically(glass_of(out), glass.read_bytes())


def _looks(path: Path, package: Package) -> tuple[dict[int, VertexColors], dict[int, Palette]]:
    """Looks of the first tier by part: the reflectance at the vertices of surfaces that are not
    metal, and the emission at those of surfaces; of strands its mean."""
    from rna_sdk.runtime import SurfaceAsset, load  # slow to import
    from rna_sdk.runtime.standin_colors import (
        fiber_emission,
        surface_albedo,
        surface_emission,
        vertex_base_colors,
    )

    colors, glows = {}, {}
    for i, part in enumerate(load(path).parts):
        light, triangles = np.zeros((1, 3), np.float32), np.zeros((0, 3), np.uint32)
        if isinstance(part, SurfaceAsset):
            standin = of_part(package.manifest, Standin, i)
            if not (standin and standin.metallic):
                colors[i] = VertexColors(surface_albedo(part), vertex_base_colors(part))
            if part.emits:
                light, triangles = surface_emission(part), part.mesh.triangles
        elif part.emits:
            light = fiber_emission(part, package.curves(i)).mean(axis=0, keepdims=True)
        if (palette := palette_of(light, triangles)) is not None:
            glows[i] = palette
    return colors, glows
