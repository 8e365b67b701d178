"""Screenshots of the extension in Blender, for docs/blender.md.

    scripts/blender-extension out/rna_sdk.zip
    RNA_SDK_PYTHON=$PWD/.venv/bin/python xvfb-run -s "-screen 0 1280x800x24" blender \
        --factory-startup --python scripts/blender_pictures.py -- out/rna_sdk.zip docs/images

Needs a Blender with a window, 4.5 or later, and ImageMagick.
"""

import subprocess
import sys
from pathlib import Path

import bpy

ROOT = Path(__file__).resolve().parent.parent
ZIP, OUT = (Path(name).resolve() for name in sys.argv[sys.argv.index("--") + 1 :])
WORKSPACE = "1050x694+0+27"  # the picture's part of the window
PAUSE = 4.0  # seconds, for Blender to draw

bpy.context.preferences.view.show_splash = False


def area_of(kind):
    """The largest editor of a kind."""
    areas = [area for area in bpy.context.screen.areas if area.type == kind]
    return max(areas, key=lambda area: area.width * area.height)


def shoot(name, part=WORKSPACE):
    """Save a part of the window."""
    bpy.ops.wm.redraw_timer(type="DRAW_WIN_SWAP", iterations=3)
    path = OUT / f"blender-{name}.png"
    command = [
        "import",
        "-window",
        "root",
        "-crop",
        part,
        "+repage",
        "+dither",
        "-colors",
        "200",
        f"png8:{path}",
    ]
    subprocess.run(command, check=True)


def lay_out():
    """A wide properties editor beside the 3D view, with the bake panel open."""
    area = area_of("VIEW_3D")
    with bpy.context.temp_override(area=area):
        bpy.ops.screen.area_split(direction="VERTICAL", factor=0.6)
    new = max((a for a in bpy.context.screen.areas if a.type == "VIEW_3D"), key=lambda a: a.x)
    new.type = "PROPERTIES"
    panel = bpy.types.OBJECT_PT_rna_bake  # open it
    bpy.utils.unregister_class(panel)
    panel.bl_options = set()
    bpy.utils.register_class(panel)


def scroll(pixels):
    """Scroll the properties down."""
    area = area_of("PROPERTIES")
    region = next(region for region in area.regions if region.type == "WINDOW")
    with bpy.context.temp_override(area=area, region=region):
        for _ in range(pixels // 40):
            bpy.ops.view2d.scroll_down(deltax=0, deltay=40)


def look_at_it():
    """The 3D view shows what is selected, in the colours of its vertices."""
    area = area_of("VIEW_3D")
    region = next(region for region in area.regions if region.type == "WINDOW")
    area.spaces.active.shading.color_type = "VERTEX"
    with bpy.context.temp_override(area=area, region=region):
        bpy.ops.view3d.view_selected()


def bake():
    bpy.ops.object.delete()  # the cube
    bpy.ops.mesh.primitive_monkey_add()
    bpy.ops.object.shade_smooth()
    area_of("PROPERTIES").spaces.active.context = "OBJECT"
    look_at_it()


def asset():
    bpy.ops.object.delete()
    bpy.ops.rna.import_package(filepath=str(ROOT / "examples" / "quickstart" / "toy.rna"))
    look_at_it()


def engine():
    scene, area = bpy.context.scene, area_of("VIEW_3D")
    area_of("PROPERTIES").spaces.active.context = "RENDER"
    region = next(region for region in area.regions if region.type == "WINDOW")
    with bpy.context.temp_override(area=area, region=region):
        bpy.ops.view3d.camera_to_view()
    lamp = scene.objects["Light"]
    lamp.location = (1.2, -0.6, 1.2)
    lamp.data.energy, lamp.data.shadow_soft_size = 80.0, 0.1
    bpy.ops.mesh.primitive_plane_add(size=20)
    scene.render.engine, scene.rna_render.samples = "RNA", 32
    scene.render.resolution_x, scene.render.resolution_y = 420, 560
    bpy.ops.render.render()
    area.type = "IMAGE_EDITOR"
    area.spaces.active.image = bpy.data.images["Render Result"]


def preferences():
    area_of("IMAGE_EDITOR").type = "PREFERENCES"
    bpy.context.preferences.active_section = "ADDONS"
    bpy.context.window_manager.addon_search = "Relightable"
    bpy.ops.preferences.addon_expand(module="bl_ext.user_default.rna_sdk")


def install():
    bpy.ops.extensions.package_install_files(
        filepath=str(ZIP), repo="user_default", enable_on_install=True
    )


STEPS = [
    install,
    lay_out,
    *(bake, lambda: scroll(440), lambda: shoot("bake")),
    *(asset, lambda: scroll(440), lambda: shoot("asset")),
    *(engine, lambda: shoot("engine")),
    *(preferences, lambda: shoot("set-up", "418x380+632+27")),
]


def step():
    try:
        STEPS.pop(0)()
    except Exception as error:
        print("failed:", repr(error), flush=True)
    if STEPS:
        return PAUSE
    bpy.ops.wm.quit_blender()
    return None


bpy.app.timers.register(step, first_interval=PAUSE)
