"""Reads, writes and saves the settings of a connected device."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from ..binding import AckCode, Device, MipError, NoAnswer, PortClosed, Refused, info
from ..devices.codes import SAVE
from ..errors import Failure
from ..files import signals
from ..ports import connection, device_file, listing
from .settings import (
    Place,
    can,
    ends_talk,
    in_order,
    listed_profile,
    own_parameters,
    requested_places,
    response_names,
    saves_all,
    stored_settings,
)

if TYPE_CHECKING:
    from ..binding import DeviceAtPort

#: A device that is silent for this many seconds need not be set to idle: infrequent data does not disturb commands.
QUIET = 0.3
#: Seconds that a device needs to change its baud rate.
SETTLE = 0.3
#: The number of attempts to send a command without a reply.
ATTEMPTS = 2
#: How often settings are written again because writing other settings has changed them.
ROUNDS = 3

#: Settings with their values: the commands that would write them.
Settings = dict[Place, Any]


class Talk:
    """Reads and writes the settings of a device."""

    def __init__(
        self, link: DeviceAtPort, port: str, complain: Callable[[str], None], device: str | None = None
    ) -> None:
        """Identifies the device, unless the user named it. Raises Failure."""
        self.link, self.port, self.complain = link, port, complain
        self.listing = listing.read_identity(link, port, complain)
        self.model = device_file.named(self.listing, device, complain)
        self.profile: Device = listed_profile(self.model.profile, self.listing.title, self.listing.descriptors)

    # ----------------------------------------------------------------- reading

    def pull(self) -> Settings:
        """Reads all settings."""
        settings: Settings = {}
        for kind in stored_settings(self.profile):
            for place, open_end in requested_places(kind, self.profile):
                setting = self.read(place)
                if setting is not None:
                    settings[place] = setting
                elif open_end:
                    break
        return settings

    def read_all(self, wanted: Settings) -> dict[Place, Any]:
        """Reads the current values of these settings, in the form of the wanted ones; None if the device lacks one."""
        return {place: self.read(place, value) for place, value in wanted.items()}

    def read(self, place: Place, beside: Any = None) -> Any:
        """Reads a setting. Returns the command that would write it; None if the device does not have it."""
        command = place.reading(beside)
        try:
            response = self.request(command)
        except Refused:
            return None
        except MipError as error:  # a reply without the setting
            self.complain(f"{command.NAME} is left out: {error.detail}")
            return None
        return None if response is None else written(place, response)

    def request(self, command: Any) -> Any:
        """Requests a response. Raises Failure if there is no reply, and MipError if the reply cannot be used."""
        for attempt in range(ATTEMPTS):
            try:
                return self.link.request(command)
            except NoAnswer:
                if attempt == ATTEMPTS - 1:
                    raise
            except PortClosed as error:
                raise Failure(f"{self.port}: {error}") from None
        return None

    # ----------------------------------------------------------------- writing

    def push(self, wanted: Settings) -> Pushed:
        """Writes these settings to the device in a safe order, except those that it already has.

        A setting that the device rejects is tried again after the others, on which it may depend. A setting that
        another one has changed is written again.
        """
        done = Pushed()
        ordered = in_order(wanted)
        for _ in range(ROUNDS):
            if not self._write([place for place in ordered if not ends_talk(place)], wanted, done):
                break
        self._write([place for place in ordered if ends_talk(place)], wanted, done)
        now = self.read_all({place: wanted[place] for place in done.written})
        done.read_differently = {p: x for p, x in now.items() if differs(x, wanted[p]) and p not in done.refused}
        return done

    def _write(self, places: list[Place], wanted: Settings, done: Pushed) -> bool:
        """Writes the settings that the device does not have yet. Did it accept any?"""
        now = self.read_all({place: wanted[place] for place in places})
        changes = [place for place in places if differs(now[place], wanted[place])]
        return any([self._change(place, wanted[place], now[place], done) for place in changes])

    def _change(self, place: Place, command: Any, before: Any, done: Pushed) -> bool:
        """Writes one setting. Did the device accept it?"""
        try:
            if ends_talk(place):
                self._change_link(command, before)
            else:
                self.request(command)
        except Refused as error:
            done.refused[place] = nack_text(error)
            return False
        except (Lost, MipError) as error:
            done.refused[place] = str(error)
            return False
        done.refused.pop(place, None)
        done.written.add(place)
        return True

    def _change_link(self, command: Any, before: Any) -> None:
        """Changes a setting of the connection, and restores the former value if the device stops answering.

        An interrupt waits until this is done. Raises Refused, Lost if the former value was restored, and Failure if the
        device remains silent.
        """
        interrupts = signals.Deferred()
        with signals.handled(interrupts):
            heard = self._changed_link(command, before)
            if not heard and not self._taken_back(before):
                message = f"{self.port} has not answered since {command.NAME} was written, not even after restoring it"
                raise Failure(f"{message}; power-cycle the device: nothing has been saved", listing.SILENT)
        if interrupts.waits:
            raise KeyboardInterrupt
        if not heard:
            raise Lost("the device stopped answering; the former value was restored")

    def _changed_link(self, command: Any, before: Any) -> bool:
        """Writes a setting of the connection. Does the device still answer?"""
        rate, old = getattr(command, "baud", None), self.link.baud
        if rate is not None and old is not None:
            return self._changed_baud(command, before, rate, old)
        try:
            self.link.request(command)
        except NoAnswer:  # the change may have spoiled the reply
            pass
        return self.heard()

    def _changed_baud(self, command: Any, before: Any, rate: int, old: int) -> bool:
        try:  # before the command is sent: does the host's port support this rate?
            self.link.baud = rate
            self.link.baud = old
        except (OSError, ValueError) as error:
            raise Lost(f"{self.port} does not support {rate} Bd: {connection.reason(error)}") from None
        try:
            self.link.change_baud(command)
            return True
        except NoAnswer:  # it may receive at the new rate although its replies are lost
            self.link.baud = rate
            self.link.send(before)
            time.sleep(SETTLE)
            self.link.baud = old
            return False

    def _taken_back(self, before: Any) -> bool:
        """Writes the former value. If no reply arrives, the device may still have received it."""
        for _ in range(ATTEMPTS):
            self.link.send(before)
            if self.heard():
                return True
        return False

    def heard(self) -> bool:
        for _ in range(ATTEMPTS):
            try:
                self.link.request(listing.command_type("base.ping")())
            except Refused:
                return True
            except NoAnswer:
                continue
            return True
        return False

    # ----------------------------------------------------------------- flash memory

    def save(self) -> tuple[int | None, dict[Place, str]]:
        """Saves all current settings. Returns their number (None: all at once), and the reasons for rejected ones."""
        whole = saves_all(self.profile)
        if whole is not None:
            try:
                self.request(whole.save())
            except Refused as error:
                raise Failure(f"the device rejected {whole.NAME}: {nack_text(error)}", listing.REFUSED) from None
            return None, {}
        refused: dict[Place, str] = {}
        saved = 0
        for place in self.pull():
            if can(place.kind, self.profile, SAVE):
                try:
                    self.request(place.saving())
                    saved += 1
                except Refused as error:
                    refused[place] = nack_text(error)
        return saved, refused

    # ----------------------------------------------------------------- streams

    @staticmethod
    @contextmanager
    def idle(link: DeviceAtPort, port: str, complain: Callable[[str], None]) -> Iterator[None]:
        """Sets a device that sends data to idle, and resumes it afterwards; does nothing to other devices."""
        if link.next(timeout=QUIET) is None:
            yield
            return
        with listing.idle(link, port, complain):
            yield


class Lost(Exception):
    """A change that was undone because the device no longer answered."""


class Pushed:
    """The outcome of writing settings."""

    def __init__(self) -> None:
        self.written: set[Place] = set()
        self.refused: dict[Place, str] = {}
        self.read_differently: dict[Place, Any] = {}  # the values read back, if they differ from the written ones


def nack_text(error: Refused) -> str:
    """Describes the reason for a NACK."""
    number = int(error.code)
    code = next((v for v in info(AckCode).values if v.value == number), None)
    cause = error.cause.text if error.cause else code.text if code else ""
    return ": ".join([f"{code.name} ({number})" if code else f"code {number}", *([cause] if cause else [])])


def written(place: Place, response: Any) -> Any:
    """Makes the command that would write the values of a response."""
    names = response_names(type(response))
    values: dict[str, Any] = {}
    for p in own_parameters(place.kind):
        name = names.get(p.name, p.name)
        value = getattr(response, info(type(response))[name].attribute)
        if value is not None or p.kind == "switch":
            values[p.attribute] = value
    return place.kind.write(**values)


def differs(a: Any, b: Any) -> bool:
    """Do two values of a setting differ? They are compared as bytes on the wire."""
    return a is None or b is None or bool(a.encode() != b.encode())
