"""Feature planes, and textures over the surface: transmittance and normal maps."""
