"""`rna-view`: an asset or a scene in a browser page."""

import argparse
import sys
import webbrowser
from collections.abc import Sequence
from html import escape
from pathlib import Path

from rna_sdk.commands.console import command_parser, run_command
from rna_view.page_server import PageServer
from rna_view.site_export import ELEMENT_LINE, EMBED, SERVE_NOTE, export_site
from rna_view.site_files import LIGHT, Site
from rna_view.site_source import gallery_for, site_for


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns the exit status."""
    options = _parser().parse_args(arguments)
    return run_command(lambda: _run(options), options.debug, "the page has ended", extra="render")


def _run(options: argparse.Namespace) -> None:
    first, *others = options.source
    site = gallery_for(options.source, options.env) if others else site_for(first, options.env)
    for note in site.notes:
        print(f"note: {note}", file=sys.stderr)
    if options.export is not None:
        written = export_site(site, options.export)
        size = sum(path.stat().st_size for path in written) / 1e6
        print(f"wrote {options.export}: {len(written)} files, {size:.2f} MB; {SERVE_NOTE}")
        print(f"try it: python3 -m http.server --bind 127.0.0.1 --directory {options.export}")
        if others:
            return
        names = {"address": "https://example.org/site/", "title": escape(first.stem)}
        attributes = site.written_attributes(names["address"])
        attributes += "" if "scene" in site.attributes else LIGHT
        print(f"embed it: {EMBED.format(**names)}")
        print(f"or as an element: {ELEMENT_LINE.format(**names, attributes=attributes)}")
        return
    _serve(site, options)


def _serve(site: Site, options: argparse.Namespace) -> None:
    with PageServer(site, options.port) as server:
        print(f"{' '.join(map(str, options.source))} at {server.url}\nCtrl-C ends it", flush=True)
        if not options.no_browser:
            webbrowser.open(server.url)
        try:
            server.serve_forever()
        except KeyboardInterrupt:
            print("\nthe page has ended")


def _parser() -> argparse.ArgumentParser:
    parser = command_parser(
        "rna-view", "View an .rna package or a scene file in the browser.", "rna-view asset.rna"
    )
    parser.add_argument(
        "source",
        type=Path,
        nargs="+",
        metavar="FILE",
        help="package or scene file (path); of several packages one page, a gallery",
    )
    parser.add_argument(
        "--env", type=Path, help="environment map, .hdr or .exr (path, default: built in)"
    )
    parser.add_argument(
        "--export",
        type=Path,
        metavar="FOLDER",
        help="write a static site to this folder instead of serving it (path, default: serve)",
    )
    parser.add_argument("--port", type=int, default=0, help="port (int, default: a free port)")
    parser.add_argument(
        "--no-browser", action="store_true", help="do not open a browser (default: off)"
    )
    return parser


if __name__ == "__main__":
    sys.exit(main())
