"""References: the specification's formulas in plain numpy, which every fast form is tested with.

Gather (spec/RNA.md, 6.1): `queries.triplane_features`. Fast forms:
    numba, 16 lanes      rna_sdk/runtime/kernels/texels.py
    numba, training      rna_export/training/optimization/plane_kernels.py, of blurred planes
    torch                rna_export/training/model/triplane.py
    shaders              planes.wgsl
    Mitsuba              rna_mitsuba/planes.py

Input blocks (6.2): `queries.queries_reference`, `queries.fiber_queries_reference`. Fast forms:
    numba, 16 lanes      rna_sdk/runtime/kernels/surface_blocks.py, fiber_blocks.py and
                         block_columns.py, for the runtime and for training
    torch                rna_export/training/model/inputs.py
    shaders              blocks.wgsl, surface_blocks.wgsl, fiber_blocks.wgsl
    Mitsuba              rna_mitsuba/blocks.py

Lobes (12, RNA_environment): `lobes.py`. Fast form:
    numba                rna_sdk/runtime/kernels/lobe_kernels.py

Base colour (4.6): `base_color.py`. Fast forms:
    numba                rna_sdk/runtime/kernels/base_color_kernel.py
    shaders              images.wgsl

Constants are declared here from the specification, not taken from a fast form. The twin reader of
`tests/conformance` answers with these references.
"""
