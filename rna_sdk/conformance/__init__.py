"""Conformance tests of `.rna` readers: the kit, and `rna-conform`."""
