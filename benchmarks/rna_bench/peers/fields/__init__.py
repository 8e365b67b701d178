"""Neural Reflectance Fields (Bi et al. 2020)."""
