"""Makes curves of a USD file such that Blender's importer reads all of them right.

It knows no curves that are pinned or whose widths are by strand (`uniform`) or by segment
(`varying`), and Cycles no splines and no closed strands. So such `BasisCurves` become polylines, in
a layer over the file.
"""

import bundled
import numpy as np
from usd_splines import Spline


def prepared(path, folder, frame):
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
    found = [p for p in stage.TraverseAll() if p.IsA(UsdGeom.Curves) and _is_lost(p, UsdGeom)]
    if not found:
        return path
    layer = _layer_over(stage, folder / "curves.usda")
    over = Usd.Stage.Open(layer)
    _make_uninstanced(over, Usd, UsdGeom)
    time = Usd.TimeCode.EarliestTime() if frame is None else Usd.TimeCode(frame)
    for prim in found:
        _flatten(over.GetPrimAtPath(prim.GetPath()), UsdGeom, time, path.name)
    layer.Save()
    return folder / "curves.usda"


def up_is_z(source):
    """Whether a USD file's up is its z axis."""
    from pxr import Usd, UsdGeom

    return UsdGeom.GetStageUpAxis(Usd.Stage.Open(source)) == "Z"


def _make_uninstanced(stage, usd, geom):
    """What is below an instance cannot be changed."""
    for prim in list(stage.TraverseAll()):
        below = usd.PrimRange(prim, usd.TraverseInstanceProxies()) if prim.IsInstance() else ()
        if any(p.IsA(geom.Curves) for p in below):
            prim.SetInstanceable(False)


def _layer_over(stage, path):
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


def _is_lost(prim, geom):
    curves = geom.Curves(prim)
    if curves.GetWidthsInterpolation() == "uniform":
        return True
    basis = geom.BasisCurves(prim)
    return prim.IsA(geom.BasisCurves) and (
        basis.GetTypeAttr().Get() == "cubic" or basis.GetWrapAttr().Get() == "periodic"
    )


def _flatten(prim, geom, time, name):
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


def _widths_by_strand(interpolation, widths, splines, where):
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


def _set_widths(curves, widths):
    from pxr import Vt

    curves.GetWidthsAttr().Set(Vt.FloatArray.FromNumpy(widths.astype(np.float32)))
    curves.SetWidthsInterpolation("vertex")


def _vectors(points):
    from pxr import Vt

    return Vt.Vec3fArray.FromNumpy(np.ascontiguousarray(points, np.float32))


def _sized(widths, size, where):
    if len(widths) != size:
        raise ValueError(f"{where}: found {len(widths)} widths, expected {size}")
    return widths


def _split(rows, counts):
    return np.split(rows, np.cumsum(counts)[:-1])
