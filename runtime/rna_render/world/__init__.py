"""Contents of a scene: assets, meshes and lights, loaded and placed."""
