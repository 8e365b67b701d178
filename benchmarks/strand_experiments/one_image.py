"""One validation image alone: what planes and decoder can hold of it, and what its neighbours tell."""
import sys, numpy as np, torch
torch.set_num_threads(1)
from pathlib import Path
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.optimization.losses import unbiased_l2, sample_loss
from rna_export.training.training_run import padded_bounds
ds = Dataset(Path(sys.argv[1])).parts[0]; t = load_checkpoint(Path(sys.argv[2])); k = int(sys.argv[3]); steps = int(sys.argv[4])
v = ds.validation_views()[k]; h0, h1 = v.halves; pi = np.pi
var1 = ((h0-h1)**2).mean()/2*pi*pi
rng = np.random.default_rng(0); test = rng.random(len(h0)) < .25
print("view", k, "rows", len(h0), "db", )
base = t.model.eval()
def truth(p, sel):
    s = np.clip(pi*p[sel], 0, 1); a, b = pi*h0[sel], pi*h1[sel]; w = ((a <= 1)*1. + (b <= 1)*1.)/2
    return -10*np.log10((w*(s-a)*(s-b)).mean())
at = {n: torch.from_numpy(np.ascontiguousarray(a)) for n, a in v.queries.items()}
vis = v.visible.astype(bool)
def out(m):
    with torch.no_grad(): c = m.colours(m(at)).numpy()
    return np.where(vis[:, None], c[:, 0]+c[:, 1], c[:, 2])
print("usual training:", truth(out(base), ~test), truth(out(base), test))
D = v.samples["direct"]
for res, ch in ((32,16),(128,16),(512,16)):
    torch.manual_seed(0)
    m = NeuralAsset(t.preset.model.model_copy(update=dict(resolution=res, channels=ch)), padded_bounds(ds))
    m.ceiling.copy_(base.ceiling); m.unit.copy_(base.unit)
    o = torch.optim.Adam([dict(params=m.decoder.parameters(), lr=4e-3), dict(params=m.triplane.parameters(), lr=1e-2)])
    rows = np.flatnonzero(~test)
    for s in range(steps):
        for g, lr in zip(o.param_groups, (4e-3, 1e-2)): g["lr"] = lr*.5*(1+np.cos(np.pi*s/steps))
        i = torch.from_numpy(rng.choice(rows, 1024))
        a = {n: x[i] for n, x in at.items()}
        a["visible"] = torch.from_numpy(vis.astype(np.float32))[i]; a["radiance"] = torch.from_numpy(h0)[i]; a["direct"] = torch.from_numpy(D)[i]
        loss = sample_loss(m, a, 1.0, "unbiased"); o.zero_grad(); loss.backward(); o.step()
    p = out(m)
    s = np.clip(pi*p, 0, 1)
    fit = ((s-pi*np.clip(h1,0,1/pi))**2)
    print(f"planes {res} x {ch}: of its own pixels, noise removed {-10*np.log10(max(1e-9, fit[~test].mean()-var1)):.2f} dB; of pixels left out {truth(p, test):.2f} dB", flush=True)
