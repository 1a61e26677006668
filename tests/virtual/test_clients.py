"""The clients of all languages against the virtual device: every command, all data, every fault."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import replace
from functools import cache
from typing import Any

import pytest
from mipgen import model as m
from random_values import chance
from support import NIGHTLY, OFFERS, at_hand, differences, driver, heavy, model, rounds, uses
from virtual.commands import Trial, commands, data_fields
from virtual.ledger import OUTCOMES, check
from virtual.scenario import everything, faulty, formats, silenced
from virtual.session import KINDS, Session, Witness

pytestmark = uses()  # the clients at hand

#: Devices with a complete manual, and one of which little is known.
DEVICES = ("3dm-cv7-gnss-ins", "3dm-gx5-15", "3dm-gx5-45", "3dm-gq7")

MANY_SEEDS = "the clients against all devices, with many seeds"

#: How often a fault strikes, by what it affects.
RATES = {"packet": 0.1, "data": 0.2, "answer": 0.1, "response": 0.15, "byte": 0.005, "tick": 0.03}


def device(name: str) -> m.Device:
    return next(d for d in model("real").devices if d.id == name)


def repeat(sessions: Iterable[Session]) -> None:
    """The same steps with the client of each language: the same events, and so the same packets to the device."""
    requests, wanted = [], []
    for session in sessions:
        requests.append({"op": "client", "steps": session.steps})
        wanted.append(session.client.events)
    for language in [name for name, offered in OFFERS.items() if "client" in offered and at_hand(name)]:
        answers = [a.get("events") for a in driver(language, "real").ask(requests)]
        for expected, found in zip(wanted, answers, strict=True):
            if found != expected:
                pytest.fail(f"{language}: {differences([{}] * len(expected), expected, found)}")


def ends(session: Session) -> Counter[str]:
    return Counter(e["event"] for e in session.client.events if e["event"] in OUTCOMES)


def functions(device: m.Device) -> set[tuple[str, int | None]]:
    """Each function of each command."""
    found: set[tuple[str, int | None]] = set()
    for s in commands(device):
        found |= {(s.field.full_name, f.value) for f in s.functions} or {(s.field.full_name, None)}
    return found


@pytest.mark.parametrize("name", [DEVICES[0], *(pytest.param(name, marks=heavy(MANY_SEEDS)) for name in DEVICES[1:])])
def test_every_command(name: str) -> None:
    """Without faults, each function of each command is carried out, and all data arrive."""
    session = everything(device(name))
    check(session)
    assert not ends(session).keys() - {"acknowledged", "refused", "silent"}
    done = {e["command"] for e in session.client.events if e["event"] in ("acknowledged", "silent")}
    trials = [session.trials[n] for n in done]
    assert functions(device(name)) <= {(t.command.full_name, t.values.get("function")) for t in trials}
    received = [e for e in session.client.events if e["event"] == "received"]
    fields = {(e["set"], f["descriptor"]) for e in received for f in e["fields"]}
    if any(formats(device(name), 1)):  # the formats of some devices are not known
        assert fields >= {(number, d) for number, known in data_fields(device(name)).items() for d in known}
    repeat([session])


def test_what_is_not_acknowledged_times_out() -> None:
    """With echo disabled, a device does not answer some commands; the client reports time-outs."""
    of = device("3dm-cv7-gnss-ins")
    session = silenced(of)
    silent = {
        session.trials[e["command"]].command.full_name for e in session.client.events if e["event"] == "timed_out"
    }
    wanted = {s.field.full_name for s in commands(of) if s.field.silenced_by}
    assert silent == wanted and len(wanted) == 9
    repeat([session])


#: One fault for each kind of thing that faults affect, drawn by the seed; all of them together are tested below.
DRAWN = {chance("fault", of).choice([kind for kind, known in KINDS.items() if known.of == of]) for of in RATES}


@pytest.mark.parametrize(
    "kind", [kind if kind in DRAWN else pytest.param(kind, marks=heavy("each fault alone")) for kind in KINDS]
)
def test_each_fault(kind: str) -> None:
    """Every command ends as it must, and no intact packet is lost."""
    session = faulty(device("3dm-gx5-15"), [*KINDS].index(kind), **{kind: RATES[KINDS[kind].of]})
    assert kind in {i.kind for i in session.witness.injected}, f"{kind} has not struck"
    check(session)
    repeat([session])


def test_all_faults_together() -> None:
    rates = {kind: RATES[known.of] / 4 for kind, known in KINDS.items()}
    sessions = [faulty(device("3dm-gx5-15"), 7, **rates)]
    for session in sessions:
        check(session)
    seen: Counter[str] = sum((ends(s) for s in sessions), Counter())
    assert seen.keys() >= {"acknowledged", "refused", "timed_out", "missing_response"}
    repeat(sessions)


def test_who_asks_again_gets_an_answer() -> None:
    """Faults that change bytes do not keep a command from succeeding in a few attempts."""
    rates = {kind: 0.02 for kind, known in KINDS.items() if known.of == "packet"} | {"command_lose": 0.002}
    session = faulty(device("3dm-gx5-15"), 3, attempts=6, **rates)
    check(session)
    last = {id(session.trials[e["command"]]): e["event"] for e in session.client.events if e["event"] in OUTCOMES}
    assert "timed_out" in ends(session)
    assert "timed_out" not in last.values()
    repeat([session])


@heavy(MANY_SEEDS)
@pytest.mark.parametrize("seed", range(8 if NIGHTLY else 2))
def test_all_devices_and_faults(seed: int) -> None:
    """Nightly all devices; else the seed draws some."""
    rates = {kind: RATES[known.of] / 6 for kind, known in KINDS.items()}
    devices = [of for of in model("real").devices if commands(of)]
    for of in chance("devices", seed).sample(devices, rounds(3, len(devices))):
        sessions = [faulty(of, seed, **rates), *([everything(of)] if seed == 0 else [])]
        for session in sessions:
            check(session)
        repeat(sessions)


# --------------------------------------------------------------------------- the ledger itself


@cache
def spoiled_session() -> Session:
    session = faulty(device("3dm-gx5-15"), 5, lose=0.05, double_packet=0.05, lose_answer=0.05)
    check(session)
    return session


def changed(session: Session, events: list[dict[str, Any]], **more: Any) -> Session:
    when = session.when[: len(events)] + session.when[-1:] * (len(events) - len(session.when))
    made = replace(session, client=replace(session.client, events=events), when=when, **more)
    made.virtual, made.link = session.virtual, session.link
    return made


def spoil(name: str, events: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """What a client with a mistake would report."""

    def at(kind: str, test: Any = lambda e: True) -> int:
        return next(n for n, e in enumerate(events) if e["event"] == kind and test(e))

    made = list(events)
    if name == "a data packet is lost":
        del made[at("received", lambda e: e["set"] >= 0x80)]
    elif name == "a data packet comes twice":
        made.insert(0, made[at("received", lambda e: e["set"] >= 0x80)])
    elif name == "two data packets change places":
        first = at("received", lambda e: e["set"] >= 0x80)
        second = at("received", lambda e: e["set"] >= 0x80 and e != made[first])
        made[first], made[second] = made[second], made[first]
    elif name == "another value":
        n = at("acknowledged", lambda e: 0 in e.get("response", {}).get("values", {}).values())
        values = {key: 1 if value == 0 else value for key, value in made[n]["response"]["values"].items()}
        made[n] = {**made[n], "response": {**made[n]["response"], "values": values}}
    elif name == "an acknowledge that nobody has sent":
        n = at("timed_out")
        made[n] = {**made[n], "event": "acknowledged"}
    elif name == "a refusal that nobody has sent":
        n = at("acknowledged", lambda e: "response" not in e)
        made[n] = {**made[n], "event": "refused", "code": 5}
    elif name == "no end":
        del made[at("acknowledged")]
    elif name == "two ends":
        made.append(made[at("acknowledged")])
    elif name == "a time-out without a reason":
        n = at("acknowledged", lambda e: "response" not in e)
        made[n] = {"event": "timed_out", "command": made[n]["command"]}
    return made


SPOILED = (
    "a data packet is lost", "a data packet comes twice", "two data packets change places", "another value",
    "an acknowledge that nobody has sent", "a refusal that nobody has sent", "no end", "two ends",
    "a time-out without a reason",
)  # fmt: skip


@pytest.mark.parametrize("name", SPOILED)
def test_the_ledger_sees(name: str) -> None:
    session = spoiled_session()
    events = spoil(name, session.client.events)
    assert events != session.client.events
    with pytest.raises(AssertionError):
        check(changed(session, events))


def test_the_ledger_sees_a_loss_that_no_fault_explains() -> None:
    session = spoiled_session()
    first = next(packet for packet, carried in session.witness.packets if packet == carried)
    with pytest.raises(AssertionError, match="not logged"):
        check(changed(session, session.client.events, stream=bytearray(session.stream).replace(first, b"")))


def test_answers_in_several_packets() -> None:
    """The answers to one packet do not fit into one."""
    session = Session(device("3dm-cv7-gnss-ins"), Witness())
    asking = next(s for s in commands(session.device) if s.field.name == "get_device_descriptors")
    session.ask(*[Trial(asking.field, {}, True)] * 3)
    session.end()
    check(session)
    assert ends(session) == {"acknowledged": 3}
    assert len(session.witness.packets) > 1
    repeat([session])
