"""Addresses of clusters that cannot be."""

import pytest

from rna_sdk.errors import WorkError
from rna_work.cluster.ray_cluster import prepare


@pytest.mark.parametrize(
    "address", ["127.0.0.1:99999999", "ray://a..b:10001", "ray://[::1:10001", "\0:10001"]
)
def test_an_address_that_cannot_be_is_told(address):
    with pytest.raises(WorkError, match="no cluster answers"):
        prepare(address)


@pytest.mark.parametrize("address", ["auto", "host", "host:port", "host:\u00b2"])
def test_what_has_no_port_is_left_to_ray(address):
    prepare(address)
