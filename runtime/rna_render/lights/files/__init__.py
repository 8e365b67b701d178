"""Environment files: OpenEXR and Radiance HDR."""
