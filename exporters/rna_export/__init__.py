"""From a Blender scene to an `.rna` package: capture, training, export, comparison."""
