"""Meshes and curves, and their files: GLB and tensors, quantised or float32."""
