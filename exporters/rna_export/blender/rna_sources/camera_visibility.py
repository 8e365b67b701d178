"""Objects that camera rays do not see: they light and shadow the asset, and are no part of it."""

import bpy
from listing import listed
from rna_geometry.shown_objects import HAIR, SURFACES


def leave_out_unseen() -> list[str]:
    """Make holdouts and shadow catchers invisible to camera rays alone.

    Before, it would cut holes into what lies behind it. Returns a note for each reason.
    """
    result: dict[str, list[str]] = {}
    layer = bpy.context.view_layer
    for item in bpy.data.objects:
        reason = _reason(item, layer)
        if reason is not None:
            shows = item.type in (*SURFACES, HAIR) or item.instance_type != "NONE"
            if shows and not item.hide_render:
                result.setdefault(reason, []).append(item.name)
            item.visible_camera = False
    for item in bpy.data.objects:
        item.is_holdout = item.is_shadow_catcher = False
    collections = [layer.layer_collection]
    for collection in collections:  # grows as it goes
        collection.holdout = collection.indirect_only = False
        collections += collection.children
    return [
        f"{_listed(names)}: {reason}; lights and shadows the asset, but is no part of the package"
        for reason, names in result.items()
    ]


def _reason(item: bpy.types.Object, layer: bpy.types.ViewLayer) -> str | None:
    """The reason why camera rays do not see an object; None if they do."""
    if item.is_shadow_catcher:
        return "a shadow catcher"
    if item.holdout_get(view_layer=layer):
        return "a holdout"
    if item.indirect_only_get(view_layer=layer):
        return "in a collection that is Indirect Only"
    if not item.visible_camera:
        return "not visible to camera rays"
    return None


def _listed(names: list[str]) -> str:
    return f"object{'s' if len(names) > 1 else ''} {listed([*map(repr, names)])}"
