"""The conversation with a device about its settings."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from ..binding import AckCode, Device, MipError, NoAnswer, PortClosed, Refused, info
from ..cli import device_file, listing, ports, signals
from ..errors import Failure
from ..simulator.codes import SAVE
from .settings import Place, can, ends_talk, in_order, listed, of, parameters, places, response_names, saves_all

if TYPE_CHECKING:
    from ..binding import DeviceAtPort

#: A device that is silent for so many seconds need not be set to idle: rare data does not disturb the conversation.
QUIET = 0.3
#: Seconds until a device has changed its baud rate.
SETTLE = 0.3
#: The number of attempts to send a command without a reply.
ATTEMPTS = 2
#: The number of times that settings changed by others meanwhile are written again.
ROUNDS = 3

#: Settings and their values, as commands that would write them.
Held = dict[Place, Any]


class Talk:
    """Reads and writes the settings of a device."""

    def __init__(self, link: DeviceAtPort, port: str, complain: Callable[[str], None]) -> None:
        """Finds out which device it is. Raises Failure."""
        self.link, self.port, self.complain = link, port, complain
        self.told = listing.identity(link, port, complain)
        self.model = device_file.model(self.told)
        self.profile: Device = listed(self.model.profile, self.told.title, self.told.descriptors)

    # ----------------------------------------------------------------- reading

    def pull(self) -> Held:
        """All settings."""
        held: Held = {}
        for kind in of(self.profile):
            for place, open_end in places(kind, self.profile):
                found = self.read(place)
                if found is not None:
                    held[place] = found
                elif open_end:
                    break
        return held

    def read_all(self, wanted: Held) -> dict[Place, Any]:
        """The values that the device has now, in the form of those that are given; None where it has no setting."""
        return {place: self.read(place, value) for place, value in wanted.items()}

    def read(self, place: Place, beside: Any = None) -> Any:
        """The value of a setting as a command that would write it; None if the device does not have it."""
        command = place.reading(beside)
        try:
            response = self.request(command)
        except Refused:
            return None
        except MipError as error:  # a reply, but not one with the setting
            self.complain(f"{command.NAME} is left out: {error.detail}")
            return None
        return None if response is None else written(place, response)

    def request(self, command: Any) -> Any:
        """The response to a command. Raises Failure if there is no answer, and MipError for one that cannot be used."""
        for attempt in range(ATTEMPTS):
            try:
                return self.link.request(command)
            except NoAnswer:
                if attempt == ATTEMPTS - 1:
                    said = f"{self.port} did not answer {command.NAME}; check the line and --baud, and try again"
                    raise Failure(said, listing.SILENT) from None
            except PortClosed as error:
                raise Failure(f"{self.port}: {error}") from None
        return None

    # ----------------------------------------------------------------- writing

    def push(self, wanted: Held) -> Pushed:
        """Writes these settings to the device in a safe order, except those that it has already.

        Settings that the device rejects are tried again after others, on which they may depend; so are settings that
        others have changed.
        """
        done = Pushed()
        ordered = in_order(wanted)
        for _ in range(ROUNDS):
            if not self._write([place for place in ordered if not ends_talk(place)], wanted, done):
                break
        self._write([place for place in ordered if ends_talk(place)], wanted, done)
        now = self.read_all({place: wanted[place] for place in done.written})
        done.different = {p: x for p, x in now.items() if differs(x, wanted[p]) and p not in done.refused}
        return done

    def _write(self, places: list[Place], wanted: Held, done: Pushed) -> bool:
        """Writes those of the settings that the device does not have. Did it accept any?"""
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
            done.refused[place] = why(error)
            return False
        except (Lost, MipError) as error:
            done.refused[place] = str(error)
            return False
        done.refused.pop(place, None)
        done.written.add(place)
        return True

    def _change_link(self, command: Any, before: Any) -> None:
        """Changes a setting of the connection, and restores the former value if the device does not answer any more.

        An interrupt waits until this is settled. Raises Refused, Lost, and Failure if the device remains silent.
        """
        held = signals.Held()
        with signals.handled(held):
            heard = self._changed_link(command, before)
            if not heard and not self._taken_back(before):
                said = f"{self.port} has not answered since {command.NAME} was written, nor after it was written back"
                raise Failure(f"{said}; switch the device off and on: nothing has been saved", listing.SILENT)
        if held.waits:
            raise KeyboardInterrupt
        if not heard:
            raise Lost("the device did not answer any more; the former value is back")

    def _changed_link(self, command: Any, before: Any) -> bool:
        """Writes a setting of the line. Does the device still answer?"""
        rate, old = getattr(command, "baud", None), self.link.baud
        if rate is not None and old is not None:
            return self._changed_baud(command, before, rate, old)
        try:
            self.link.request(command)
        except NoAnswer:  # its answer may have been lost by the change
            pass
        return self.heard()

    def _changed_baud(self, command: Any, before: Any, rate: int, old: int) -> bool:
        try:  # before the command is sent: does the port support this rate?
            self.link.baud = rate
            self.link.baud = old
        except (OSError, ValueError) as error:
            raise Lost(f"{self.port} cannot have {rate} Bd: {ports.reason(error)}") from None
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
        """Writes the former value, also if no reply arrives: the device may still receive."""
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
        """Saves all current settings. Returns their number, None if all at once, and those that the device rejected,
        with the reason."""
        whole = saves_all(self.profile)
        if whole is not None:
            try:
                self.request(whole.save())
            except Refused as error:
                raise Failure(f"the device refused {whole.NAME}: {why(error)}", listing.REFUSED) from None
            return None, {}
        refused: dict[Place, str] = {}
        saved = 0
        for place in self.pull():
            if can(place.kind, self.profile, SAVE):
                try:
                    self.request(place.saving())
                    saved += 1
                except Refused as error:
                    refused[place] = why(error)
        return saved, refused

    # ----------------------------------------------------------------- streams

    @staticmethod
    @contextmanager
    def idle(link: DeviceAtPort, port: str, complain: Callable[[str], None]) -> Iterator[None]:
        """Sets a device that sends data to idle, and resumes it afterwards; leaves any other alone."""
        if link.next(timeout=QUIET) is None:
            yield
            return
        with listing.idle(link, port, complain):
            yield


class Lost(Exception):
    """A change that was taken back, because the device no longer answered."""


class Pushed:
    """The outcome of writing settings."""

    def __init__(self) -> None:
        self.written: set[Place] = set()
        self.refused: dict[Place, str] = {}
        self.different: dict[Place, Any] = {}  # the values read back, where they are not those written


def why(error: Refused) -> str:
    """The reason for a NACK, in words."""
    number = int(error.code)
    known = next((v for v in info(AckCode).values if v.value == number), None)
    return f"{known.name} ({number}): {known.text}" if known else f"code {number}"


def written(place: Place, response: Any) -> Any:
    """The command that would write the values of a response."""
    names = response_names(type(response))
    given: dict[str, Any] = {}
    for p in parameters(place.kind):
        name = names.get(p.name, p.name)
        value = getattr(response, info(type(response))[name].attribute)
        if value is not None or p.kind == "switch":
            given[p.attribute] = value
    return place.kind.write(**given)


def differs(a: Any, b: Any) -> bool:
    """Are these two different values of a setting? They are compared as bytes on the wire."""
    return a is None or b is None or bool(a.encode() != b.encode())
