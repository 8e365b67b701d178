"""How a batch of queries is run: tiles, and decoders compiled or in onnxruntime."""
