"""Remedies for a glTF whose compression a reader lacks: commands that make a readable file."""

_REMEDIES = {
    "KHR_texture_basisu": ("ktxdecompress", "with PNG in place of its KTX2 textures"),
    "EXT_meshopt_compression": ("cp", "without meshopt's compression"),
    "KHR_draco_mesh_compression": ("cp", "without Draco's compression"),
}
"""Extension -> command of glTF Transform (gltf-transform.dev), and its output."""


def with_remedy(error: str) -> str:
    """An error's text; where it names one of these extensions, with the command that helps."""
    for name, (command, result) in _REMEDIES.items():
        if name in error:
            return f"{error}; gltf-transform {command} IN.glb OUT.glb writes it {result}"
    return error
