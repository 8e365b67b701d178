"""References: the specification's formulas in plain numpy, which every fast form is tested with.

Gather (spec/RNA.md, 6.1) and input blocks (6.3): `examples/hosts/minimal.py`, by hand in numpy,
which `tests/reference/queries.py` asks. Fast forms of input blocks are generated; of the gather:
    numba, 16 lanes      rna_sdk/runtime/kernels/texels.py
    numba, training      rna_export/training/optimization/plane_kernels.py, of blurred planes
    torch                rna_export/training/model/triplane.py
    shaders              planes.wgsl
    Mitsuba              rna_mitsuba/planes.py

Lobes (12, RNA_environment): `lobes.py`. Fast form:
    numba                rna_sdk/runtime/kernels/lobe_kernels.py

Base colour (4.6): `base_color.py`. Fast forms:
    numba                rna_sdk/runtime/kernels/base_color_kernel.py
    shaders              images.wgsl

Constants are declared here from the specification, not taken from a fast form. The twin reader of
`tests/conformance` answers with these references.
"""
