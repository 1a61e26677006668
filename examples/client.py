import time

import serial  # pyserial
from mip_protocol import Answer, Client, Received, TimedOut, base

client = Client()
port = serial.Serial("/dev/ttyACM0", 115200)
port.write(client.send(base.GetDeviceInfo(), now=time.monotonic()))
while client.pending:
    time.sleep(0.002)
    received = port.read(port.in_waiting)  # received bytes: `read` does not wait
    for event in client.receive(received, now=time.monotonic()):
        if isinstance(event, Answer) and event.response:
            print(event.response)
        elif isinstance(event, Answer):
            print("refused" if not event.accepted else "done", event.code.name, event.error or "")
        elif isinstance(event, TimedOut):
            print("no answer to", event.command.NAME)
        elif isinstance(event, Received):
            print("data:", event.packet)
