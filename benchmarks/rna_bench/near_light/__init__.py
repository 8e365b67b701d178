"""Whether models that are told how near the light is answer lamps better; commands in the record.

rna-capture toy.py --lights 3520 --out toy.rays
rna-capture toy.py --lights 992 --near-lights 1 --out near.rays
python -m rna_bench.near_light.arms toy.rays near.rays toy --shards 62
rna-train toy-far --preset small --steps 8000 --out runs/far        # and toy-mixed, toy-untold
python -m rna_bench.near_light.references toy.rays toy.py references.npz
python -m rna_bench.near_light.far_limit toy.rays toy.py references.npz limit.npz
python -m rna_bench.near_light.scores references.npz runs/*/best.ckpt --limit limit.npz
"""
