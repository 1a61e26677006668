"""The settings of a device: current, saved and factory values of each instance.

A setting is stored as the command that would write it. Several commands may access the same setting, such as the
mounting of the sensor in three forms, or a message format with its old and its new command.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator, Sequence
from enum import IntEnum
from functools import cache
from pathlib import Path
from typing import Any, cast

from ..binding import Command, Device, MipError, OpenEnum, Parameter, Structure, meant, reflection, registry
from ..errors import Failure
from . import views
from .checks import NOTHING
from .codes import DEFAULT, LOAD, READ, SAVE, SETS
from .facts import COMMANDS, difference_on

Key = tuple[int, ...]
Place = tuple[str, Key]


@cache
def command_type(name: str) -> type[Command]:
    """Finds a command by its full name."""
    return next(t for _, t in registry.all_types() if name == t.NAME and issubclass(t, Command))


def is_setting(kind: type[Command]) -> bool:
    return any(function in kind.REQUIRED for function in SETS)


def stored_by(kind: type[Command]) -> type[Command]:
    """Returns the command that stores the setting: this one, or another one."""
    other = COMMANDS.get(kind.NAME, NOTHING).setting
    return command_type(other) if other else kind


def instance_keys(kind: type[Command]) -> tuple[str, ...]:
    """Returns the parameters that select an instance: those that functions without values require."""
    return _keys(kind.NAME)


@cache
def _keys(name: str) -> tuple[str, ...]:
    kind = command_type(name)
    required = next((kind.REQUIRED[f] for f in (SAVE, LOAD, DEFAULT, READ) if f in kind.REQUIRED), 0)
    return tuple(p.attribute for p in _parameters(kind)[:required] if p.kind not in ("constant", "counter"))


def _parameters(kind: type[Structure]) -> list[Parameter]:
    """Returns the parameters after the function selector."""
    return [p for p in reflection.info(kind).parameters if p.name != "function"]


def _stored_members(kind: type[Structure]) -> list[Parameter]:
    return [p for p in _parameters(kind) if p.kind not in ("constant", "counter")]


def storage_place(command: Command) -> Place:
    """Returns the place under which the setting of a command is stored."""
    kind = type(command)
    behavior, owner = COMMANDS.get(kind.NAME, NOTHING), stored_by(kind)
    numbers = []
    for name in instance_keys(owner):
        value = behavior.key.get(name, getattr(command, name, None))
        numbers.append(behavior.translate.get(name, {}).get(value, value) if value is not None else 0)
    return owner.NAME, tuple(int(v) for v in numbers)


def asking(name: str, key: Sequence[int]) -> Command:
    """Makes a command that reads an instance of a setting."""
    kind: Any = command_type(name)
    values: dict[str, Any] = dict(zip(instance_keys(kind), key))
    for p in _parameters(kind)[: kind.REQUIRED.get(READ, 0)]:  # a read may require more than the instance
        if p.kind not in ("constant", "counter"):
            values.setdefault(p.attribute, filled(p, values))
    asked: Command = kind(function=READ, **values)
    return asked


class Settings:
    """All settings of one device. `storage`: the file for saved settings."""

    def __init__(self, profile: Device, storage: Path | None = None) -> None:
        self._profile = profile
        # If the path is a link, its target is replaced.
        self._storage = storage and Path(os.path.realpath(storage))
        self._current: dict[Place, Command] = {}
        self._saved: dict[Place, Command] = {}
        if self._storage is not None:
            if self._storage.exists():
                self._saved = _stored(self._storage, profile)
            self._replace(self._storage, None)  # reports an error now, not only when a host saves something
        self.restart()

    def restart(self) -> None:
        """Sets all settings to their values after power-up."""
        self._current = dict(self._saved)

    def items(self) -> Iterator[tuple[Place, Command]]:
        yield from self._current.items()

    def current(self, command: Command) -> Command:
        """Returns the setting to which a command refers, as a write command of the same type."""
        kind, at = type(command), storage_place(command)
        setting = self._current.get(at)
        if setting is None or COMMANDS.get(kind.NAME, NOTHING).once:
            return self.factory(kind, command)
        return self._as(kind, setting, command)

    def write(self, command: Command) -> None:
        self._current[storage_place(command)] = command

    def save(self, places: Iterable[Place]) -> None:
        for at in places:
            if at in self._current:
                self._saved[at] = self._current[at]
            else:
                self._saved.pop(at, None)
        self._keep()

    def load(self, at: Place) -> Command | None:
        """Restores the saved value, and returns it; None if it is the factory default."""
        self.reset(at)
        if at in self._saved:
            self._current[at] = self._saved[at]
        return self._saved.get(at)

    def reset(self, at: Place) -> None:
        """Restores the factory default; a saved value remains saved."""
        self._current.pop(at, None)

    def places(self, name: str) -> list[Place]:
        """Returns all instances of a setting that have or had a value other than the default."""
        return sorted({at for at in (*self._current, *self._saved) if at[0] == name})

    def everything(self) -> list[Place]:
        return sorted({*self._current, *self._saved})

    # ----------------------------------------------------------------------- values

    def factory(self, kind: type[Command], asked: Command) -> Command:
        """Returns the factory default of the instance to which a command refers."""
        behavior = COMMANDS.get(kind.NAME, NOTHING)
        values: dict[str, Any] = {name: getattr(asked, name) for name in instance_keys(kind)}
        for p in _stored_members(kind):
            if p.attribute not in values:
                here = difference_on(p, self._profile.id)
                default = behavior.initial.get(p.name, p.default) if here.default is None else here.default
                if isinstance(default, tuple) and isinstance(p.type, type) and issubclass(p.type, IntEnum):
                    default = next((x for x in default if not here.values or x in here.values), None)
                elif default is not None and here.bits is not None:
                    default &= here.bits
                values[p.attribute] = filled(p, values, default, here.values)
        return _write(kind, values)

    def _as(self, kind: type[Command], kept: Command, asked: Command) -> Command:
        """Converts a stored setting to the form in which another command reports it."""
        behavior = COMMANDS.get(kind.NAME, NOTHING)
        stored = {p.attribute: getattr(kept, p.attribute, None) for p in _stored_members(kind)}
        stored |= {name: getattr(asked, name) for name in instance_keys(kind)}
        if behavior.effect == "frame_rotation":
            form, turned = str(behavior.arguments["format"]), str(behavior.arguments["rotation"])
            wanted = getattr(asked, form) or getattr(kept, form)
            stored[turned] = views.frame_rotation(getattr(kept, turned), getattr(kept, form), wanted)
            stored[form] = wanted
        elif behavior.effect in views.ORIENTATIONS and type(kept) is not kind:
            matrix = views.vehicle_matrix(COMMANDS[kept.NAME].effect, arguments(kept))
            values = views.orientation_values(behavior.effect, matrix, bool(behavior.arguments.get("inverse")))
            stored |= {str(behavior.arguments[name]): value for name, value in values.items()}
        return _write(kind, stored)

    # ----------------------------------------------------------------------- file

    def _keep(self) -> None:
        if self._storage is None:
            return
        kept = [
            {"setting": name, "instance": list(key), "command": value.NAME, "data": value.encode().hex()}
            for (name, key), value in sorted(self._saved.items(), key=lambda item: item[0])
        ]
        text = json.dumps({"device": self._profile.id, "settings": kept}, indent=1)
        self._replace(self._storage, text + "\n")

    @staticmethod
    def _replace(storage: Path, text: str | None) -> None:
        """Replaces the whole file; without a text, only checks that it can be written. Raises Failure."""
        new = storage.with_name(storage.name + ".new")
        try:
            new.write_text(text or "", "utf-8")
            if text is None:
                new.unlink()
            else:
                os.replace(new, storage)
        except OSError as error:
            raise Failure(f"{storage} cannot be written: {error.strerror}; name another file") from None


def arguments(command: Command) -> dict[str, Any]:
    """Returns the arguments of a command's effect."""
    behavior = COMMANDS.get(command.NAME, NOTHING)
    varied = {p.name: p for p in reflection.info(type(command)).parameters if p.variants}
    arguments: dict[str, Any] = {}
    for name, argument in behavior.arguments.items():
        value = _member(command, argument) if isinstance(argument, str) else argument
        if argument in varied:  # a number whose meaning depends on another one
            value = meant(varied[str(argument)].of(command), value)
        table = behavior.translate.get(argument, {}) if isinstance(argument, str) else {}
        arguments[name] = table.get(value, value) if isinstance(value, int) else value
    return arguments


def _member(value: Any, path: str) -> Any:
    """Returns a parameter, or a member of one; None if it is absent, for example in another case of a union."""
    for name in path.split("."):
        value = getattr(value, name, None)
    return value


def _write(kind: type[Command], values: dict[str, Any]) -> Command:
    function = next(f for f in SETS if f in kind.REQUIRED)
    return kind.decode(cast(Any, kind)(function=function, **values).encode())


def filled(p: Parameter, record: dict[str, Any], default: Any = None, only: frozenset[int] | None = None) -> Any:
    """Chooses a value for a parameter without another source: the default, or a valid value."""
    if p.kind == "switch":
        case = p.cases.get(record.get(p.tag, 0))
        return None if case is None else filled(case, record, case.default)
    if default is not None and not (only and default not in only):
        length = p.length if isinstance(p.length, int) and not isinstance(default, (tuple, str)) else None
        return default if length is None else (default,) * length
    if p.kind == "text":
        return " " * p.length if isinstance(p.length, int) else ""
    if p.kind == "struct" or (p.kind == "array" and p.type is not None and issubclass(p.type, Structure)):
        members: dict[str, Any] = {}
        if not isinstance(p.length, str):
            for member in _stored_members(p.type):
                members[member.attribute] = filled(member, members, member.default)
        item: Any = None if isinstance(p.length, str) else p.type(**members)
    else:
        item = _number(p, only)
    if p.kind != "array" or (p.elements and p.length is None):
        return item
    return (item,) * p.length if isinstance(p.length, int) else ()


def _number(p: Parameter, only: frozenset[int] | None) -> Any:
    """Returns zero, or the permitted number closest to it."""
    if only:
        return min(only)
    if p.scalar == "bool":
        return False
    if isinstance(p.type, type) and issubclass(p.type, OpenEnum) and 0 not in list(p.type):
        return next(iter(p.type))
    least = max((x for x in (p.minimum, p.above) if x is not None), default=0)
    number = max(0, least) if p.maximum is None else min(p.maximum, max(0, least))
    if p.above is not None and number <= p.above:
        number = p.above + 1 if p.maximum is None else (p.above + p.maximum) / 2
    if p.scalar not in ("float", "double"):
        return int(number)
    return (float(number),) * len(p.elements) if p.elements else float(number)


def _stored(path: Path, profile: Device) -> dict[Place, Command]:
    """Reads the saved settings in a file."""
    try:
        kept = json.loads(path.read_text("utf-8"))
        if kept["device"] != profile.id:
            raise Failure(f"{path} has the settings of {kept['device']}, not of {profile.id}; name another file")
        return {
            (entry["setting"], tuple(entry["instance"])): command_type(entry["command"]).decode(
                bytes.fromhex(entry["data"])
            )
            for entry in kept["settings"]
        }
    except OSError as error:
        raise Failure(f"{path} cannot be read: {error.strerror}") from None
    except Failure:
        raise
    except (ValueError, KeyError, TypeError, StopIteration, MipError):
        raise Failure(f"{path} is not a file of saved settings; remove it or name another file") from None
