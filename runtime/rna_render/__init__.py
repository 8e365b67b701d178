"""The reference path tracer for relightable neural assets, and `rna-run`.

What other packages use of it; `rna_render.scene` has what a scene file says.

Examples:
    >>> scene_file = read_scene("scene.yaml")
    >>> scene, world = scene_file.resolved, load_world(scene_file)
    >>> film = render(scene, make_integrator(scene, world))
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
