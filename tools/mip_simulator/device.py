"""A simulated device, which answers every command of a profile and streams data, in simulated time.

    device = VirtualDevice("3dm-cv7-gnss-ins")
    link = device.connect()
    link.write(bytes(Ping().packet()))
    link.read()          # the acknowledge
    device.advance(0.5)  # half a second passes
    link.read()          # the data of that time

Nothing happens by itself: the caller supplies bytes and time, so the same calls always result in the same bytes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from mip_tools.binding import Command, Device, Packet, RawField, registry
from mip_tools.devices import views
from mip_tools.devices.codes import DEFAULT, LOAD, SAVE
from mip_tools.devices.facts import COMMANDS
from mip_tools.devices.profiles import device_named, port_named
from mip_tools.devices.settings import Place, Settings, asking, command_type, instance_keys, is_setting, stored_by
from mip_tools.geometry.earth import SECOND

from .commands import ports
from .commands.dispatch import carry_out
from .commands.effects import act
from .commands.filter_effects import FILTER_EFFECTS
from .faults import Faults
from .link import Link
from .motion import Motion, Standing, parse_motion
from .script import Script, ScriptedEvent
from .state import DeviceState, Encoder
from .streams import formats, nmea, values
from .streams.stream import Stream, combined_answers, combined_fields
from .world.world import World

#: The start-up time of a device, during which it does not reply.
BOOT_TIME = SECOND // 2

#: The longest pause of a host inside a packet; after it, the device searches the received bytes for another packet.
SILENCE = SECOND // 10

#: The number of command packets that may wait while a command takes long; further ones are lost.
MOST_WAITING = 32

#: The interval at which disturbances may happen.
DISTURBANCE_TIME = SECOND // 10


class VirtualDevice(DeviceState):
    """One device. Times are in nanoseconds since the start unless said to be in seconds."""

    def __init__(
        self,
        profile: Device | str,
        *,
        motion: Motion | str | None = None,
        seed: int = 0,
        noise: float = 1.0,
        start: int | None = None,
        sync: bool | None = None,
        storage: Path | None = None,
        faults: Faults | None = None,
        events: Iterable[ScriptedEvent] = (),
        trace: Callable[[str, bytes], None] | None = None,
    ) -> None:
        """`motion`: an object, or a text as for `mip simulate --motion`: "circle:radius=20,speed=5".

        `noise`: scales the noise of the sensors and the errors of the filter; 0 leaves only constant biases.

        `start`: nanoseconds since the GPS epoch. `storage`: the file of saved settings.

        `sync`: whether the device has a time. True: a pulse per second and its time arrive from outside. False: they do
        not, and receivers have no reception. By default, only receivers have a time, and a replayed log that has dates.

        `events`: scripted events, such as a GNSS outage.

        `trace` is called for every packet, before faults, with "command", "answer" or "data", and the bytes.
        """
        moving = parse_motion(motion) if isinstance(motion, str) else motion
        events = tuple(events)
        if faults is None and any(event.event == "faults" for event in events):
            faults = Faults(seed=seed)
        profile = device_named(profile) if isinstance(profile, str) else profile
        world = World(moving or Standing(), seed=seed, start=start, noise=noise)
        world.senses = values.senses(profile)
        world.outside = getattr(moving, "start", None) is not None if sync is None else sync
        super().__init__(profile, Settings(profile, storage), world, faults, seed)
        self.outdoors = sync is not False
        world.gnss = self.outdoors and not any(e.event == "gnss_outage" and e.at == 0 for e in events)
        self._busy_until: int | None = None  # the end of a command that takes long; others wait
        self._waiting: list[tuple[Link, Packet]] = []
        self._behind: list[Callable[[], None]] = []  # actions to run after the answer to this command
        self.trace = trace
        self._streams: list[Stream] = []
        self._encoders: dict[tuple[int, int], Encoder] = {}
        self._disturbed = DISTURBANCE_TIME
        self.script = Script(self, events)
        self._settle()

    # ----------------------------------------------------------------------- the host's side

    def connect(self, port: str | None = None, capacity: int | None = None) -> Link:
        """Connects a host to a port, by default the first one of the profile. Hosts may share a port.

        `capacity`: how many bytes may wait until the host reads them; the device drops packets that do not fit.
        By default there is no limit: a host that no longer reads should `disconnect`. Raises ConnectionError while a
        scripted event has unplugged the device.
        """
        if not self.plugged:
            raise ConnectionError("the device is unplugged; connect when it is plugged in again")
        if port is not None:
            port = port_named(self.profile, port).name
        name = port or next((p.name for p in self.profile.ports), "Main")
        link = Link(name, self._receive, capacity)
        self.links.append(link)
        ports.arrange(self)
        return link

    def disconnect(self, link: Link) -> None:
        link.closed = True
        if self.faults is not None:
            self.faults.forget(self.now, link)
        self.links = [other for other in self.links if other is not link]

    @property
    def plugged(self) -> bool:
        """Can hosts connect? Not while a scripted event has unplugged the device."""
        return self.script.plugged

    def unplug(self) -> None:
        """Ends all connections."""
        for link in list(self.links):
            self.disconnect(link)

    def advance(self, seconds: float) -> None:
        """Lets time pass."""
        self.run_until(self.now + round(seconds * SECOND))

    def run_until(self, time: int) -> None:
        """Advances time to this moment, and does everything that is due by then."""
        while (due := self.next) is not None and due <= time:
            self._move(due)
            self.script.run(due)
            for link in list(self.links):
                if link.parser.pending and link.heard + SILENCE <= due:
                    self._taken(link, link.parser.flush())
                link.arrive(due)
                for data in link.due(due):
                    self._transmit(link, data)
            if self._busy_until is not None and self._busy_until <= due:
                self._go_on()
            for stream in list(self._streams):
                if stream.next <= due and stream in self._streams:
                    stream.fire()
            if self.faults is not None and self._disturbed <= due:
                self._disturb()
        self._move(max(self.now, time))

    @property
    def next(self) -> int | None:
        """Returns the time of the next event that the host does not cause; None if there is none."""
        times = [stream.next for stream in self._streams]
        times += [link.next for link in self.links if link.next is not None]
        times += [link.heard + SILENCE for link in self.links if link.parser.pending]
        times += [t for t in (self._busy_until, self.script.next) if t is not None]
        if self.faults is not None:
            times.append(self._disturbed)
        return min(times, default=None)

    @property
    def busy(self) -> bool:
        """Will the device send something without a command?"""
        late = any(link.next is not None for link in self.links)
        return self.plugged and (bool(self._streams) or late or self._busy_until is not None)

    def reset(self) -> None:
        """Restarts the device with its saved settings."""
        for link in self.links:
            link.clear()
        self.settings.restart()
        self._busy_until = None
        self._waiting.clear()
        self._behind.clear()
        self.idle = self.direct = False
        self.world.pins.clear()
        self.world.pulled_up.clear()
        self.booted = self.now
        self.ready_at = self.now + BOOT_TIME
        self._settle()

    def _move(self, time: int) -> None:
        self.now = time
        self.world.move_to(time)

    def _disturb(self) -> None:
        assert self.faults is not None
        self._disturbed += DISTURBANCE_TIME
        event = self.faults.event(self.now)
        if event == "reset":
            self.reset()
        elif event == "disconnect":
            self.unplug()

    # ----------------------------------------------------------------------- commands

    def _receive(self, link: Link, data: bytes) -> None:
        self.bytes_received += len(data)
        if self.faults is not None:
            data = self.faults.receive(self.now, data)
        if self.now < self.ready_at:
            return
        if link.takes & ports.RTCM and (frames := link.rtcm.feed(data)):
            self.rtcm_frames += len(frames)
            self.world.corrected = self.now
        if link.takes & ports.MIP:
            link.heard = self.now
            self._taken(link, link.parser.feed(data))

    def _taken(self, link: Link, packets: Iterable[Packet]) -> None:
        for packet in packets:
            if packet.set < 0x80:
                self._answer(link, packet)

    def _answer(self, link: Link, packet: Packet) -> None:
        """Carries out the commands of a packet in order. Actions that follow a command run after its answer."""
        if self._busy_until is not None:
            if len(self._waiting) < MOST_WAITING:
                self._waiting.append((link, packet))
            return
        self._tell("command", bytes(packet))
        groups: list[Sequence[RawField]] = []
        behind: list[Callable[[], None]] = []
        delay = busy = 0
        for raw, group, outcome in carry_out(self, link, packet):
            if group and self.faults is not None:
                late, group = self.faults.answer(self.now, raw, list(group))
                delay = max(delay, late)
            if group:
                groups.append(group)
            busy = max(busy, outcome.delay)
            if outcome.after is not None:
                behind.append(outcome.after)
        for data in combined_answers(packet.set, groups):
            self._tell("answer", data)
            self._transmit(link, data, max(delay, busy, link.reply_delay(self.now)))  # keeps the order of answers
        self._behind += behind
        if busy > 0:
            self._busy_until = self.now + busy
        else:
            self._go_on()

    def _go_on(self) -> None:
        """Runs the actions that follow an answered command, then the commands that wait."""
        self._busy_until = None
        while self._behind:
            self._behind.pop(0)()
        while self._waiting and self._busy_until is None:
            self._answer(*self._waiting.pop(0))

    def pause(self, time: int) -> None:
        """Sends no data for some time."""
        for stream in self._streams:
            stream.skip(self.now + time)

    # ----------------------------------------------------------------------- settings

    def apply(self, at: Place, kept: Command | None) -> None:
        """Runs the effect of a setting that changed without a write command."""
        command = kept if kept is not None else self.settings.factory(command_type(at[0]), asking(*at))
        outcome = act(self, command, None, None)
        if outcome.after is not None:
            outcome.after()

    def restore(self, at: Place, saved: bool) -> None:
        """Restores the saved value of a setting, or its factory default."""
        kept = self.settings.load(at) if saved else None
        if not saved:
            self.settings.reset(at)
        self.apply(at, kept)

    def all_settings(self, function: int) -> None:
        places = self.settings.everything()
        if function == SAVE:
            self.settings.save(places)
        for at in places if function in (LOAD, DEFAULT) else ():
            self.restore(at, saved=function == LOAD)

    def _settle(self) -> None:
        """Runs all effects of the settings that the device starts with."""
        self.world.restart()
        self.world.synchronize()
        for name, behavior in COMMANDS.items():
            if self.knows(name) and (behavior.effect in views.ORIENTATIONS or behavior.effect in FILTER_EFFECTS):
                kind = command_type(name)
                if is_setting(kind) and not instance_keys(kind):
                    self.apply((stored_by(kind).NAME, ()), None)
        for at, kept in list(self.settings.items()):
            self.apply(at, kept)
        self.world.started = True
        ports.arrange(self)
        self.arrange()

    def disable_trigger(self, instance: int) -> None:
        for name, behavior in COMMANDS.items():
            if behavior.effect == "trigger_mode":
                self.settings.reset((name, (instance,)))

    # ----------------------------------------------------------------------- streams

    def arrange(self) -> None:
        """Starts the streams that the settings define, and no others."""
        quiet = self.idle or self.direct
        self._streams = [] if quiet else formats.streams(self, max(self.now, self.ready_at))

    def encoder(self, set_number: int, descriptor: int) -> Encoder:
        """Returns the encoder of a field."""
        encoder = self._encoders.get((set_number, descriptor))
        if encoder is None:
            kind = registry.types(set_number, descriptor)[0]
            encode = values.encoder(kind, self.profile, self.world, set_number)
            encoder = partial(_fields, set_number, descriptor, encode)
            self._encoders[set_number, descriptor] = encoder
        return encoder

    def send_data(self, set_number: int, wanted: Iterable[int], link: Link | None = None) -> None:
        """Sends fields of a data set by their descriptors, without those that the device does not have."""
        self.send_fields(set_number, [self.encoder(set_number, x) for x in wanted if self.sends(set_number, x)], link)

    def send_fields(self, set_number: int, encoders: Iterable[Encoder], link: Link | None = None) -> None:
        fields = [field for encode in encoders for field in encode()]
        if self.faults is not None:
            fields = self.faults.data(self.now, set_number, fields)
        for data in combined_fields(set_number, fields) if fields else ():
            self._send(data, link, ports.MIP)

    def send_sentences(self, entries: Iterable[Any], link: Link | None = None) -> None:
        text = nmea.compose_sentences(entries, self.world)
        if text:
            self._send(text, link, ports.NMEA)

    # ----------------------------------------------------------------------- bytes

    def _send(self, data: bytes, link: Link | None, protocol: int) -> None:
        """Sends data to one host, or to all hosts at ports that send this protocol."""
        self._tell("data", data)
        for other in self.links if link is None else (link,):
            if other.gives & protocol or link is not None:
                self._transmit(other, data)

    def _transmit(self, link: Link, data: bytes, delay: int = 0) -> None:
        """Sends bytes, now or delayed. Delayed bytes get their faults when they are sent, which keeps the order."""
        if delay > 0:
            link.hold(self.now + delay, data)
            return
        self.bytes_sent += len(data)
        parts = [(0, data)] if self.faults is None else self.faults.transmit(self.now, data, link)
        link.send(self.now, parts)

    def _tell(self, what: str, data: bytes) -> None:
        if self.trace is not None:
            self.trace(what, data)


def _fields(set_number: int, descriptor: int, encode: Callable[[], list[bytes]]) -> list[RawField]:
    return [RawField(set_number, descriptor, data) for data in encode()]
