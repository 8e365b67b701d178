"""From a file that a person names to the page that shows it."""

from collections.abc import Sequence
from pathlib import Path

from rna_sdk.errors import ViewError
from rna_sdk.files.file_kinds import glass_of, kind_of, not_a
from rna_view.site_files import Gallery, Site


def site_for(source: Path, environment: Path | None = None) -> Site:
    """The page for a package or a scene file.

    Raises:
        ViewError: a file that is not there, or of another kind.
        RnaError: of a scene file or a package, what is wrong with it.
    """
    if not source.is_file():
        raise ViewError(f"{source}: no such file")
    kind = kind_of(source)
    if kind == "scene":
        from rna_view.scene_page import scene_site  # which needs the renderer

        site = scene_site(source)
    elif kind == "package":
        site = Site()
        site.attributes["src"] = site.add_package(source)
        if (glass := glass_of(source)).is_file():
            site.add_glass(glass)
    else:
        wrong = not_a("package", source) or "expected a package (.rna, .glb) or a .yaml scene file"
        raise ViewError(f"{source}: {wrong}")
    if environment is not None:
        _light(site, environment)
    return site


def gallery_for(sources: Sequence[Path], environment: Path | None = None) -> Gallery:
    """The page for several packages, under one light. Raises the errors of site_for.

    Raises:
        ViewError: a scene file, which has a light and a camera of its own.
    """
    gallery = Gallery()
    for source in sources:
        if source.is_file() and kind_of(source) == "scene":
            raise ViewError(f"{source}: expected only packages, since there are several files")
        gallery.add(source.stem, site_for(source))
    if environment is not None:
        _light(gallery, environment)
    return gallery


def _light(site: Site, environment: Path) -> None:
    if not environment.is_file():
        raise ViewError(f"{environment}: no such file")
    from rna_render import read_environment

    read_environment(environment)  # the whole file, as a visitor's browser will
    site.attributes["environment"] = site.add_image(environment)
