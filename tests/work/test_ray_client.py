"""Commands on a cluster elsewhere, by its ray:// address and with its token."""

import os
import random
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import pytest

from rna_render.command.rna_run import main as render
from tests.conftest import REPOSITORY
from tests.render.assets import sphere
from tests.render.packages import write_lambert_package
from tests.render.test_sequence import SCENE

pytest.importorskip("ray", reason="ray is not installed: pip install -e '.[cluster]'")
pytest.importorskip("grpc", reason="grpcio is not installed: pip install -e '.[cluster]'")

SECONDS = 180.0


def free_port() -> int:
    """Below those that Ray gives to its workers and those that the system gives away."""
    for _ in range(50):
        port = random.randrange(20_000, 32_000)
        with socket.socket() as probe:
            if probe.connect_ex(("127.0.0.1", port)):
                return port
    raise RuntimeError("no free port was found")


@pytest.fixture(scope="module")
def environment(tmp_path_factory):
    """Environment of the cluster's processes; with its token also of the commands."""
    home = tmp_path_factory.mktemp("home")
    named = {"RAY_AUTH_TOKEN": random.randbytes(32).hex(), "HOME": str(home)}
    cache = os.environ.get("XDG_CACHE_HOME", str(Path.home() / ".cache"))
    path = os.pathsep.join(map(str, [REPOSITORY, *sys.path]))
    return {**os.environ, **named, "PYTHONPATH": path, "XDG_CACHE_HOME": cache}


@pytest.fixture(scope="module")
def address(environment, tmp_path_factory):
    """Address of a head with two cores, in another process."""
    log = tmp_path_factory.mktemp("head") / "log"
    port, head_port = free_port(), free_port()
    environment["HEAD"] = f"127.0.0.1:{head_port}"
    ray = Path(sys.executable).with_name("ray")
    options = f"--head --port {head_port} --ray-client-server-port {port} --num-cpus 2 --block"
    temporary = tempfile.mkdtemp(prefix="rna-")  # short: sockets have it in their names
    more = ["--include-dashboard=false", "--temp-dir", temporary]
    arguments = [ray, "start", *options.split(), *more]
    started = {**environment, "RAY_AUTH_MODE": "token", "RAY_worker_niceness": "0"}
    with log.open("w") as out:
        head = subprocess.Popen(arguments, stdout=out, stderr=out, env=started)
    try:
        deadline = time.monotonic() + SECONDS
        while "runtime started" not in log.read_text():
            assert head.poll() is None and time.monotonic() < deadline, log.read_text()
            time.sleep(0.2)
        yield f"ray://127.0.0.1:{port}"
    finally:
        head.terminate()
        head.wait()
        shutil.rmtree(temporary, ignore_errors=True)


@pytest.fixture
def scene(tmp_path):
    write_lambert_package(tmp_path / "ball.rna", sphere(4))
    path = tmp_path / "scene.yaml"
    path.write_text(SCENE)
    return path


def run(environment: dict[str, str], *arguments: object) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "rna_render.command.rna_run", *map(str, arguments)]
    return subprocess.run(command, env=environment, capture_output=True, text=True, timeout=SECONDS)


def test_an_image_has_the_same_bits(address, environment, scene, tmp_path):
    one, other = tmp_path / "a.exr", tmp_path / "b.exr"
    assert render([str(scene), "--out", str(one)]) == 0
    done = run(environment, scene, "--out", other, "--cluster", address)
    assert done.returncode == 0, done.stderr
    assert one.read_bytes() == other.read_bytes()
    assert not (tmp_path / "b.exr.pieces").exists()


def test_without_its_token_a_line_says_so(address, environment, scene, tmp_path):
    without = {name: value for name, value in environment.items() if name != "RAY_AUTH_TOKEN"}
    done = run(without, scene, "--out", tmp_path / "a.exr", "--cluster", address)
    assert done.returncode == 1
    assert done.stderr.startswith(f"error: --cluster {address}: requires a token: ")


def test_a_head_itself_asks_for_its_token(address, environment, scene, tmp_path):
    head = environment["HEAD"]
    without = {name: value for name, value in environment.items() if name != "RAY_AUTH_TOKEN"}
    done = run(without, scene, "--out", tmp_path / "a.exr", "--cluster", head)
    assert done.returncode == 1
    assert done.stderr.startswith(f"error: --cluster {head}: requires a token: ")
