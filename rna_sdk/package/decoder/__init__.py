"""The decoder: what an ONNX graph may be, read and checked without onnxruntime."""
