"""The ZIP container, and the encodings of its entries: safetensors and strict JSON."""
