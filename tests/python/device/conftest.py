"""What tests of devices have: each kind of device, the other end of a connection, and a server."""

from __future__ import annotations

import socket
from collections.abc import Iterator

import pytest
from both import Kind, Peer
from support import PATIENCE


@pytest.fixture(params=["threads", "asyncio"])
def kind(request: pytest.FixtureRequest) -> Kind:
    return Kind(request.param)


@pytest.fixture
def peer() -> Iterator[Peer]:
    made = Peer()
    yield made
    made.close()


@pytest.fixture
def server() -> Iterator[socket.socket]:
    with socket.create_server(("localhost", 0)) as made:
        made.settimeout(PATIENCE)
        yield made
