"""Data through a pair of sockets, as a device sends them: prints MB/s of packets, and of decoded packets."""

import random
import socket
import threading
import time

import bench_python_objects
from mip_protocol import Device

SIZE = 2_000_000


def run(stream: bytes, count: int, decode: bool) -> float:
    near, far = socket.socketpair()
    sender = threading.Thread(target=far.sendall, args=(stream,), daemon=True)
    with Device(near, capacity=count) as device:
        begin = time.perf_counter()
        sender.start()
        for _ in range(count):
            arrival = device.next(10.0)
            assert arrival is not None
            if decode:
                arrival.decode()
        spent = time.perf_counter() - begin
    far.close()
    return len(stream) / spent / 1e6


def main() -> None:
    made, length = [], 0
    for packet in bench_python_objects.packets(random.Random(1)):
        made.append(packet)
        length += len(packet)
        if length > SIZE:
            break
    stream = b"".join(made)
    packets, decoded = (max(run(stream, len(made), decode) for _ in range(3)) for decode in (False, True))
    print(f"live data of a device through sockets: {packets:.1f} MB/s, with all objects {decoded:.1f} MB/s")


if __name__ == "__main__":
    main()
