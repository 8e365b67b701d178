"""What `rna-bench` measures: speed against accuracy, and where the method breaks."""
