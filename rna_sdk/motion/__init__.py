"""Motions of packages: positions of their geometry, frame by frame.

A motion file, by convention `.rnam`, is a cache: positions of every vertex or point of a package at
every frame, ready to be mapped into memory. `Binding` makes them from another mesh that moves.

Examples:
    >>> mesh = load("toy.rna").mesh
    >>> frames = ([mesh.positions + np.float32([0, k / 10, 0])] for k in range(3))
    >>> write_motion("rise.rnam", [mesh], frames, count=3, rate=24.0)
    >>> motion = open_motion("rise.rnam", [mesh])
    >>> motion.frames, motion.positions(2)[0].shape == mesh.positions.shape
    (3, True)
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
