"""Which geometric hint explains the residual of scattered light? Trees on training rows, tested on validation views."""
import sys
import numpy as np, torch
torch.set_num_threads(1)
from pathlib import Path
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.capture_tasks import *
from rna_export.training.checkpoint import load_checkpoint
from rna_trace.parts_scene import PartsScene
ds = Dataset(Path(sys.argv[1])); part = ds.parts[0]
N = int(sys.argv[3]) if len(sys.argv) > 3 else 400_000
model = load_checkpoint(Path(sys.argv[2])).model.eval()
geo = part.geometry()
scene = PartsScene([geo])
R = float(np.median(geo.radii)); print("radius", R, "points", len(geo.points))
pi = np.pi

def pred(s):
    out = []
    q = {k: s[k] for k in ("position", "tangent", "h", "wo", "wi")}
    with torch.no_grad():
        for f in range(0, len(s["h"]), 65536):
            at = {k: torch.from_numpy(np.ascontiguousarray(x[f:f+65536])) for k, x in q.items()}
            out.append(model.colours(model(at)).numpy())
    c = np.concatenate(out)
    vis = s["visible"].astype(bool)[:, None]
    return np.where(vis, c[:, 0], 0), np.where(vis, c[:, 1], c[:, 2]), c

def walk(o, d, most):
    """number of strands crossed (entries), first distances"""
    n = len(o); count = np.zeros(n, np.float32); t1 = np.full(n, 10., np.float32); t2 = t1.copy()
    near = np.full(n, 2.2*R, np.float32); left = np.arange(n); first = None
    for k in range(most):
        h = scene.intersect(np.ascontiguousarray(o[left]), np.ascontiguousarray(d[left]), near[left].copy())
        hit = h.part >= 0
        if k == 0:
            first = h
            t1[left[hit]] = h.t[hit]
        if k == 1: t2[left[hit]] = h.t[hit]
        count[left[hit]] += 1
        near[left] = h.t + 2.0*R
        left = left[hit]
        if not len(left): break
    return count, t1, t2, first

def features(s):
    D, S, c = pred(s)
    wo, wi, t, x = s["wo"], s["wi"], s["tangent"], s["position"]
    so, si = (t*wo).sum(1), (t*wi).sum(1)
    F = {}
    F["base"] = np.column_stack([np.log(S.mean(1)+1e-4), np.log(c.mean(2)+1e-4), s["visible"], s["h"], np.abs(s["h"]), si, so, (wo*wi).sum(1), x, wo, wi])
    nl, a1, a2, _ = walk(x, wi, 12)
    F["light"] = np.column_stack([nl, np.log(a1), np.log(a2)])
    nb, b1, b2, first = walk(x, -wo, 12)
    F["behind count"] = np.column_stack([nb, np.log(b1), np.log(b2)])
    hit = np.flatnonzero(first.part >= 0)
    litb = np.zeros(len(x), np.float32); Db = np.zeros(len(x), np.float32); Tb = Db.copy()
    p = scene.points(0, first.primitive[hit], first.u[hit], first.v[hit], first.normals[hit])
    from rna_sdk.runtime import offset_across
    v = scene.visible(0, p, np.ascontiguousarray(wi[hit]))
    s2 = {"position": p.x, "tangent": p.tangent, "wo": wo[hit], "wi": wi[hit], "h": offset_across(p.n, p.tangent, np.ascontiguousarray(wo[hit])), "visible": v}
    d2, S2, _ = pred(s2)
    litb[hit] = v; Db[hit] = d2.mean(1); Tb[hit] = (d2+S2).mean(1)
    F["behind lit"] = np.column_stack([litb, np.log(Db+1e-3), np.log(Tb+1e-3)])
    # ambient: free distances around, six directions in the fibre frame of wo
    b = np.cross(t, wo); b /= np.linalg.norm(b, axis=1, keepdims=True)+1e-9
    f = np.cross(b, t)
    amb = []
    for k in range(6):
        a = k*np.pi/3
        d = (np.cos(a)*f + np.sin(a)*b).astype(np.float32)
        h = scene.intersect(x, np.ascontiguousarray(d), np.full(len(x), 2.2*R, np.float32))
        amb.append(np.log(np.minimum(h.t, 10)))
    F["around"] = np.column_stack(amb)
    # light of neighbours around: visibility of the nearest neighbours in 6 directions
    return F, S

def load():
    paths = ds.finished_shards()
    s = part.samples_of(paths[:max(1, len(paths)//4)])
    n = len(s["h"]); rng = np.random.default_rng(0); i = rng.permutation(n)[:N]
    return {k: np.ascontiguousarray(v[i]) for k, v in s.items()}
s = load()
F, S = features(s)
target = pi*((s["radiance"] - s["direct"]) - S).mean(1)
tests = []
for v in part.validation_views():
    Fv, Sv = features(v.samples)
    D = v.samples["direct"]
    r0, r1 = (pi*(h - D - Sv).mean(1) for h in v.halves)
    tests.append((Fv, r0, r1))
from sklearn.ensemble import HistGradientBoostingRegressor as H
def fit(names):
    X = np.column_stack([F[n] for n in names])
    m = H(max_iter=200, max_leaf_nodes=63, min_samples_leaf=200, learning_rate=.06, l2_regularization=1.).fit(X, np.clip(target, -3, 3))
    out = []
    for Fv, r0, r1 in tests:
        g = m.predict(np.column_stack([Fv[n] for n in names]))
        out.append(((r0-g)*(r1-g)).mean() / (r0*r1).mean())
    print(f"{'+'.join(names):60s} error left", np.round(out, 3), "mean dB %.2f" % (-10*np.log10(np.mean(out))), flush=True)
for names in (["base"], ["base","light"], ["base","behind lit"], ["base","light","behind count","behind lit","around"]):
    fit(names)
