"""Rewrites curves of a USD file so that Blender's importer reads them correctly.

It knows no curves that are pinned or whose widths are by strand (`uniform`) or by segment
(`varying`), and Cycles no splines and no closed strands. So such `BasisCurves` become polylines, in
a layer over the file.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from rna_sources import bundled
from rna_sources.usd_splines import Spline

if TYPE_CHECKING:
    from pxr import Sdf, Usd, UsdGeom, Vt


def prepared(path: Path, folder: Path, frame: int | None) -> Path:
    """The file to import: `path`, or one in `folder` with polylines for some of its curves.

    frame: whose points and widths these are; None: the first.
    """
    bundled.add_to_path()
    from pxr import Tf, Usd, UsdGeom

    try:
        stage = Usd.Stage.Open(str(path))
    except Tf.ErrorException:
        raise ValueError(f"{path.name}: not a USD file, or a damaged one") from None
    _make_uninstanced(stage, Usd, UsdGeom)
    result = [p for p in stage.TraverseAll() if p.IsA(UsdGeom.Curves) and _is_lost(p, UsdGeom)]
    if not result:
        return path
    layer = _layer_over(stage, folder / "curves.usda")
    over = Usd.Stage.Open(layer)
    _make_uninstanced(over, Usd, UsdGeom)
    time = Usd.TimeCode.EarliestTime() if frame is None else Usd.TimeCode(frame)
    for prim in result:
        _flatten(over.GetPrimAtPath(prim.GetPath()), UsdGeom, time, path.name)
    layer.Save()
    return folder / "curves.usda"


def frame_rate(path: Path) -> float:
    """Frames a second of a USD file: its time codes; 24 if it does not say."""
    from pxr import Usd

    return float(Usd.Stage.Open(str(path)).GetTimeCodesPerSecond())


def up_is_z(source: str) -> bool:
    """Whether a USD file's up is its z axis."""
    from pxr import Usd, UsdGeom

    return bool(UsdGeom.GetStageUpAxis(Usd.Stage.Open(source)) == "Z")


def _make_uninstanced(stage: Usd.Stage, usd: Any, geom: Any) -> None:
    """Makes instances with curves editable: prims below an instance cannot be changed."""
    for prim in list(stage.TraverseAll()):
        below = usd.PrimRange(prim, usd.TraverseInstanceProxies()) if prim.IsInstance() else ()
        if any(p.IsA(geom.Curves) for p in below):
            prim.SetInstanceable(False)


def _layer_over(stage: Usd.Stage, path: Path) -> Sdf.Layer:
    """A layer file that shows the stage as it is."""
    from pxr import Sdf, Usd, UsdGeom

    layer = Sdf.Layer.CreateNew(str(path))
    layer.subLayerPaths.append(stage.GetRootLayer().realPath)
    over = Usd.Stage.Open(layer)
    UsdGeom.SetStageUpAxis(over, UsdGeom.GetStageUpAxis(stage))
    UsdGeom.SetStageMetersPerUnit(over, UsdGeom.GetStageMetersPerUnit(stage))
    over.SetStartTimeCode(stage.GetStartTimeCode())
    over.SetEndTimeCode(stage.GetEndTimeCode())
    over.SetTimeCodesPerSecond(stage.GetTimeCodesPerSecond())
    if stage.GetDefaultPrim():
        over.SetDefaultPrim(over.GetPrimAtPath(stage.GetDefaultPrim().GetPath()))
    return layer


def _is_lost(prim: Usd.Prim, geom: Any) -> bool:
    curves = geom.Curves(prim)
    if curves.GetWidthsInterpolation() == "uniform":
        return True
    basis = geom.BasisCurves(prim)
    is_spline = basis.GetTypeAttr().Get() == "cubic"
    is_closed = basis.GetWrapAttr().Get() == "periodic"
    return bool(prim.IsA(geom.BasisCurves) and (is_spline or is_closed))


def _flatten(prim: Usd.Prim, geom: Any, time: Usd.TimeCode, name: str) -> None:
    """Author polylines with a width a point."""
    curves = geom.Curves(prim)
    counts = np.array(curves.GetCurveVertexCountsAttr().Get(time), np.int64)
    points = np.array(curves.GetPointsAttr().Get(time), np.float64).reshape(-1, 3)
    widths = curves.GetWidthsAttr().Get(time)
    widths = np.array([] if widths is None else widths, np.float64)
    where = f"{name}: {prim.GetPath()}"
    if counts.sum() != len(points):
        raise ValueError(f"{where}: found {len(points)} points, expected {counts.sum()}")
    if not prim.IsA(geom.BasisCurves):  # Blender reads the splines themselves
        _set_widths(curves, np.repeat(_sized(widths, len(counts), where), counts))
        return
    basis = geom.BasisCurves(prim)
    rules = [a.Get() for a in (basis.GetTypeAttr(), basis.GetBasisAttr(), basis.GetWrapAttr())]
    splines = [Spline(count, *rules) for count in counts]
    lines = [s.along(rows) for s, rows in zip(splines, _split(points, counts), strict=True)]
    if len(widths):
        parts = _widths_by_strand(curves.GetWidthsInterpolation(), widths, splines, where)
        _set_widths(curves, np.concatenate(parts))
    curves.GetPointsAttr().Set(_vectors(np.concatenate(lines)))
    curves.GetCurveVertexCountsAttr().Set([len(line) for line in lines])
    basis.GetTypeAttr().Set("linear")
    basis.GetWrapAttr().Set("nonperiodic")


def _widths_by_strand(
    interpolation: str, widths: np.ndarray, splines: list[Spline], where: str
) -> list[np.ndarray]:
    if interpolation == "constant":
        width = _sized(widths, 1, where)[0]
        return [np.full(spline.samples, width) for spline in splines]
    if interpolation == "uniform":
        by_strand = zip(splines, _sized(widths, len(splines), where), strict=True)
        return [np.full(spline.samples, width) for spline, width in by_strand]
    if interpolation == "varying":
        sizes = [spline.varying for spline in splines]
        parts = _split(_sized(widths, sum(sizes), where), sizes)
        return [s.between(part) for s, part in zip(splines, parts, strict=True)]
    sizes = [spline.n for spline in splines]
    parts = _split(_sized(widths, sum(sizes), where), sizes)
    return [s.along(part[:, None])[:, 0] for s, part in zip(splines, parts, strict=True)]


def _set_widths(curves: UsdGeom.Curves, widths: np.ndarray) -> None:
    from pxr import Vt

    curves.GetWidthsAttr().Set(Vt.FloatArray.FromNumpy(widths.astype(np.float32)))
    curves.SetWidthsInterpolation("vertex")


def _vectors(points: np.ndarray) -> Vt.Vec3fArray:
    from pxr import Vt

    return Vt.Vec3fArray.FromNumpy(np.ascontiguousarray(points, np.float32))


def _sized(widths: np.ndarray, size: int, where: str) -> np.ndarray:
    if len(widths) != size:
        raise ValueError(f"{where}: found {len(widths)} widths, expected {size}")
    return widths


def _split(rows: np.ndarray, counts: Sequence[int] | np.ndarray) -> list[np.ndarray]:
    return np.split(rows, np.cumsum(counts)[:-1])
