"""`rna-export`: makes an `.rna` package from trained checkpoints."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from rna_export.export.credit import add_credit
from rna_export.export.precision import MAX_LOSS, PRECISIONS
from rna_sdk.console import command_parser, run_command


def parser() -> argparse.ArgumentParser:
    """The options of `rna-export`."""
    p = command_parser(
        "rna-export",
        "Write trained checkpoints as one .rna package, a tier each.",
        "rna-export runs/helmet --out helmet.rna",
    )
    p.add_argument(
        "checkpoints",
        nargs="+",
        type=Path,
        help="of rna-train, one a tier, or its folders; the first is the package's default tier. "
        "An asset of several parts needs one of each part, which a folder gives (paths)",
    )
    p.add_argument("--out", type=Path, required=True, help="the package to write")
    p.add_argument(
        "--dataset",
        type=Path,
        help="folder of rna-capture (default: where the first checkpoint was trained)",
    )
    p.add_argument(
        "--precision",
        nargs="+",
        choices=list(PRECISIONS),
        default=["float32"],
        help="a tier of each checkpoint for each: float32 decoder; int8 decoder, whose tier has "
        "-int8 in its name; both with int8 planes; or float32-float16, with planes of twice the "
        "bytes (default: float32)",
    )
    p.add_argument(
        "--max-loss",
        type=float,
        default=MAX_LOSS,
        metavar="DB",
        help="PSNR that a tier may lose against the trained model, dB; the export is refused "
        "beyond it (float, default: %(default)s)",
    )
    p.add_argument(
        "--poster",
        type=Path,
        metavar="PNG",
        help="picture of the asset that the package keeps for file browsers and the like (path, "
        "default: one rendered from the front)",
    )
    p.add_argument(
        "--proxies",
        nargs="+",
        type=int,
        default=[],
        metavar="PIXELS",
        help="add coarser meshes for an asset that is at most so high in the image, which rna-run "
        "takes in scenes with a quality (int, one or more, default: none)",
    )
    p.add_argument(
        "--coding",
        choices=["raw", "deflate"],
        default="raw",
        help="deflate: entries are stored coded, without loss; readers that do not know "
        "RNA_deflate refuse the package (default: %(default)s)",
    )
    add_credit(p)
    p.add_argument(
        "--debug", action="store_true", help="show the traceback of an error (default: off)"
    )
    return p


def main(argv: list[str] | None = None) -> int:
    """Entry point; returns the exit status."""
    options = parser()
    args = options.parse_args(argv)
    if any(pixels < 1 for pixels in args.proxies):
        options.error(f"argument --proxies: expected 1 or more, found {min(args.proxies)}")
    return run_command(lambda: _run(args), args.debug, "nothing was written", "train")


def _run(args: argparse.Namespace) -> None:
    from rna_export.capture.cut import as_cut
    from rna_export.capture.dataset import Dataset
    from rna_export.export.build import build_package
    from rna_export.export.dressing import dress
    from rna_export.export.trained_tiers import checkpoint_paths
    from rna_export.training.checkpoint import load_checkpoint

    trained = [load_checkpoint(path) for path in checkpoint_paths(args.checkpoints)]
    dataset = as_cut(Dataset(args.dataset or trained[0].dataset), trained[0].cut)
    precisions = [PRECISIONS[name] for name in dict.fromkeys(args.precision)]
    build_package(
        trained,
        dataset,
        args.out,
        args.source,
        args.license,
        print,
        precisions,
        max_loss=args.max_loss,
    )
    proxies = sorted(set(args.proxies), reverse=True)
    dress(args.out, dataset, args.poster, proxies, args.coding == "deflate", print)
    size = args.out.stat().st_size / 1e6
    print(f"wrote {args.out}, {size:.2f} MB\nnext: rna-validate {args.out}")


if __name__ == "__main__":
    sys.exit(main())
