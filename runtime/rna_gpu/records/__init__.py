"""The records that Python packs and shaders read, each declared once.

`python -m rna_gpu.records.write_records` writes their WGSL and their offsets for JavaScript.
"""
