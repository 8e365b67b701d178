"""A scene of Blender as a scene file of rna-run."""
