"""Assets in motion: glTF animation, and the shape of an asset at a frame."""
