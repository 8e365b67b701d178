"""What stands in a scene: assets, meshes and lights, loaded and placed."""
