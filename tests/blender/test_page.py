"""docs/blender.md: its Python runs in Blender, word for word except the user's folders."""

import re
import subprocess
import sys

import pytest

from tests.conftest import REPOSITORY

TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"
PAGE = (REPOSITORY / "docs" / "blender.md").read_text()
BAKE = REPOSITORY / "exporters" / "blender_extension" / "sdk_side" / "bake.py"


@pytest.mark.blender
def test_the_python_of_the_page(run_in_blender, extension_zip, tmp_path):
    blocks = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
    environment = {
        "/home/you/rna-sdk/out/rna_sdk-0.1.0.zip": extension_zip,
        "/home/you/toy.rna": TOY,
        "/home/you": tmp_path,
    }
    for name, path in environment.items():
        assert any(name in block for block in blocks)
        blocks = [block.replace(name, str(path)) for block in blocks]
    install, imported, bake, more = blocks
    stand_in = tmp_path / "python"
    stand_in.write_text(
        f"#!{sys.executable}\nimport pathlib, shutil, sys\n"
        f"shutil.copy({str(TOY)!r}, sys.argv[3])\n"
        "folder = pathlib.Path(sys.argv[4])\n"
        "(folder / 'make' / 'rays').mkdir(parents=True, exist_ok=True)\n"
        "for name in ('make/make.json', 'make/rays/manifest.json', 'made'):\n"
        "    (folder / name).touch()\n"
        "print(*sys.argv[5:], 'bake finished', sep='\\n')\n"
    )
    stand_in.chmod(0o755)
    (engine,) = re.findall(r"`(bpy\.context\.scene\.render\.engine = .*?)`", PAGE)
    object_ = "bpy.ops.mesh.primitive_monkey_add()"
    code = "print('SEEN', bpy.context.scene.render.engine, 'Suzanne' in bpy.data.objects)"
    log = f"print('LOG', open({str(tmp_path / 'suzanne.bake' / 'log')!r}).read())"
    script = "\n".join([install, object_, engine, bake, more, code, log])
    printed = run_in_blender(script, python=str(stand_in))
    assert "SEEN RNA True" in printed and "--more=10" in printed
    assert (tmp_path / "suzanne.rna").is_file()
    printed = run_in_blender(f"{imported}\nprint('SEEN', bpy.context.object.name)")
    assert "SEEN toy" in printed


def test_a_bake_in_an_environment_for_rendering_names_the_button(tmp_path):
    without = "import runpy, sys; sys.modules['torch'] = None; sys.argv.pop(0); "
    command = [sys.executable, "-c", f"{without}runpy.run_path(sys.argv[0], run_name='__main__')"]
    done = subprocess.run(
        [*command, BAKE, "source.blend", tmp_path / "out.rna", tmp_path],
        capture_output=True,
        text=True,
    )
    assert done.returncode == 1 and not list(tmp_path.iterdir())
    assert done.stderr == (
        "error: this environment of the SDK cannot bake: press Set Up for Baking, Too in the "
        "preferences of the extension (no PyTorch)\n"
    )
