"""The input blocks' formulas of spec/RNA.md, and code in other languages made of them."""
