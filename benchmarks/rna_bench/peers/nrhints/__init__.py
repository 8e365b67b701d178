"""NRHints (Zeng et al. 2023), its variants with depth and alpha losses, and on known geometry."""
