"""Lobes of the transport for light from whole environments: `rna-bench lobes`."""
