"""The decoder: the profile of its ONNX graph, read and checked without onnxruntime."""
