import time

from mip_protocol import Answer, Client, TimedOut, base

client = Client()
port.write(client.send(base.GetDeviceInfo(), now=time.monotonic()))
while client.pending:
    for event in client.receive(port.read(256), now=time.monotonic()):
        if isinstance(event, Answer) and event.response:
            print(event.response)
        elif isinstance(event, Answer):
            print("refused" if not event.accepted else "done", event.code.name, event.error or "")
        elif isinstance(event, TimedOut):
            print("no answer to", event.command)
        else:
            print("data:", event.packet)
