"""Planes of hair, finer with diffusion: trains and scores arms."""
import sys, json
from pathlib import Path
from rna_export.machine import keep_freed_memory
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.training.presets import PRESETS
from rna_export.training.training_run import Run, train
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.validation import score, shade
keep_freed_memory()
rays, out, steps, seed = Path(sys.argv[1]), Path(sys.argv[2]), int(sys.argv[3]), int(sys.argv[4])
part = Dataset(rays).only
for arm in sys.argv[5:]:
    res, ch, sm = arm.split(","); 
    preset = PRESETS["fiber"]["small"].with_model(resolution=int(res), channels=int(ch)).with_training(steps=steps, smoothing=float(sm))
    o = out/f"{arm}-s{seed}-{steps}"
    if (o/"score.json").is_file(): continue
    best = train(Run(part, preset, "small", o, seed, validations=4), say=lambda s: None, bars=lambda **k: __import__("tqdm").tqdm(disable=True, **k))
    views = part.validation_views(); m = load_checkpoint(o/"last.ckpt").model
    s = score([shade(m, v) for v in views], views)
    r = dict(arm=arm, seed=seed, steps=steps, psnr=round(s.psnr,3), clean=str(s.psnr_without_noise), flip=round(s.flip,4))
    (o/"score.json").write_text(json.dumps(r)); print(r, flush=True)
