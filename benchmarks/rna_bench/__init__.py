"""The project's benchmarks, one command each: `rna-bench NAME`. See commands.py."""
