"""Stand-ins for object storage."""

import importlib.util
from collections.abc import Iterator
from contextlib import contextmanager
from uuid import uuid4

import pytest

from rna_work.cluster.store import Store

HAS_MOTO = all(map(importlib.util.find_spec, ("moto", "s3fs", "flask")))


@contextmanager
def s3() -> Iterator[Store]:
    """A bucket that this process, and those that it starts, find; skips where it cannot be had."""
    if not HAS_MOTO:
        pytest.skip("no stand-in for S3: pip install s3fs 'moto[server]'")
    from moto.server import ThreadedMotoServer

    server = ThreadedMotoServer(port=0)
    server.start()
    host, port = server.get_host_and_port()
    address = {"AWS_ENDPOINT_URL": f"http://{host}:{port}", "AWS_ACCESS_KEY_ID": "none"}
    with pytest.MonkeyPatch.context() as patch:
        for name, value in {**address, "AWS_SECRET_ACCESS_KEY": "none"}.items():
            patch.setenv(name, value)
        import s3fs

        s3fs.S3FileSystem.clear_instance_cache()
        bucket = f"bucket-{uuid4().hex[:8]}"
        s3fs.S3FileSystem().mkdir(bucket)
        yield Store(f"s3://{bucket}/captures")
    server.stop()
