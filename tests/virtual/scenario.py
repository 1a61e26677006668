"""Sequences of commands for a device that streams all data that it has."""

from __future__ import annotations

from collections.abc import Iterator

from mipgen import model as m
from support import model
from virtual.commands import Trial, commands, data_fields, trials, unsupported
from virtual.session import START, Session, Witness, assumed_rates, device_named

#: The message formats of devices without `3dm.message_format`: command and data set.
OWN_FORMATS = {
    0x80: "3dm.imu_message_format",
    0x81: "3dm.gnss_message_format",
    0x82: "3dm.filter_message_format",
}

#: `3dm.data_stream_control` of these devices numbers the sets in its own way.
OWN_STREAMS = {0x80: 1, 0x81: 2, 0x82: 3}


def write(support: m.Support, **values: object) -> Trial:
    first = {"function": 1} if support.field.functions else {}
    return Trial(support.field, {**first, **values}, True)


def formats(device: m.Device, rate: float) -> Iterator[Trial]:
    """Requests all data at a rate in Hz; they take several packets each time."""
    known = {s.field.full_name: s for s in commands(device)}
    fields = data_fields(device)
    rates = assumed_rates(device_named(device.id)) | {r.set.number: r.hertz for r in device.base_rates}
    for number, descriptors in fields.items():
        decimation = max(1, round((rates.get(number) or 1) / rate))
        entries = [{"descriptor": d, "decimation": decimation} for d in descriptors]
        counted = {"num_descriptors": len(entries), "descriptors": entries}
        own = OWN_FORMATS.get(number)
        if own in known:
            yield write(known[own], **counted)
        elif "3dm.message_format" in known:
            yield write(known["3dm.message_format"], descriptor_set=number, **counted)
        if "3dm.data_stream_control" in known:
            selector = OWN_STREAMS[number] if own in known else number
            yield write(known["3dm.data_stream_control"], descriptor_set=selector, enable=1)


def prepare(session: Session, rate: float = 1, attempts: int = 1) -> None:
    """Streams all data, whatever the commands before have done."""
    known = {s.field.full_name: s for s in commands(session.device)}
    if "base.resume" in known:
        insist(session, write(known["base.resume"]), attempts)
    for trial in formats(session.device, rate):
        insist(session, trial, attempts)


def insist(session: Session, trial: Trial, attempts: int) -> None:
    """Repeats a command if no reply arrives."""
    for _ in range(attempts):
        if all(e["event"] != "timed_out" for e in session.ask(trial)):
            break


#: Commands that a device accepts only after another one: that one, and its values.
AFTER: dict[str, tuple[str, dict[str, int]]] = {
    "filter.set_initial_attitude": ("filter.reset", {}),
    "filter.set_initial_heading": ("filter.reset", {}),
    "filter.external_heading_update": ("filter.heading_source", {"source": 3}),
    "filter.external_heading_update_with_time": ("filter.heading_source", {"source": 3}),
}


def ask(session: Session, trial: Trial) -> None:
    name, values = AFTER.get(trial.command.full_name, ("", {}))
    for support in commands(session.device):
        if support.field.full_name == name:
            session.ask(write(support, **values))
    session.ask(trial)
    if trial.command.name == "soft_reset":
        session.wait(START)


def everything(device: m.Device) -> Session:
    """Each command with each function and each value; then several in a packet, and several packets at once."""
    session = Session(device, Witness())
    for number, support in enumerate(commands(device)):
        if number % 4 == 0:
            prepare(session)
        for trial in (*trials(support, device), *unsupported(support)):
            ask(session, trial)
    for trial in strangers(device):
        ask(session, trial)
    together(session)
    session.wait(1000)
    session.end()
    return session


def strangers(device: m.Device) -> list[Trial]:
    """Commands that the device does not have: one of each set."""
    known = {s.field.full_name for s in commands(device)}
    found: dict[int, Trial] = {}
    for f in model("real").fields:
        if f.role == m.COMMAND and f.full_name not in known and f.set not in found:
            found[f.set] = next(trials(m.Support(f, f.set, f.functions, m.Evidence("listed")), device))
    return list(found.values())


def together(session: Session, size: int = 6) -> None:
    """Several commands in each packet, and packets that do not wait for each other."""
    plain = few(session.device, 1)
    for of_set in {t.command.set: None for t in plain}:
        own = [t for t in plain if t.command.set == of_set]
        for at in range(0, len(own), size):
            session.send(*own[at : at + size])
            if at % (3 * size) == 0:
                session.settle()
        session.settle()


def few(device: m.Device, count: int) -> list[Trial]:
    """The first values of each function; nothing that restarts or silences the device."""
    found: list[Trial] = []
    for support in commands(device):
        if support.field.name not in ("soft_reset", "set_idle", "built_in_test", "echo_control", "device_status"):
            seen: dict[object, int] = {}
            for trial in trials(support, device):
                seen[trial.function] = seen.get(trial.function, 0) + 1
                if seen[trial.function] <= count:
                    found.append(trial)
    return found


def faulty(device: m.Device, seed: int, attempts: int = 1, **rates: float | tuple[float, float]) -> Session:
    """Each function of each command once, while faults strike; repeated if no reply arrives."""
    session = Session(device, Witness(seed=seed, **rates), seed=seed)
    for number, trial in enumerate(few(device, 1)):
        if number % 20 == 0:
            prepare(session, 4 if len(device.base_rates) < 4 else 1, attempts)
        insist(session, trial, attempts)
        session.wait(40)
    session.wait(500)
    session.end()
    return session


def silenced(device: m.Device) -> Session:
    """The commands that another command keeps from being acknowledged."""
    session = Session(device, Witness())
    known = {s.field.full_name: s for s in commands(device)}
    for support in known.values():
        for condition in support.field.silenced_by:
            session.ask(write(known[condition.command or ""], **{condition.parameter: condition.value}))
            session.ask(next(trials(support, device)))
    session.end()
    return session
