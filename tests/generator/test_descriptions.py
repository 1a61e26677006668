"""Descriptions say what a name does not: see "Texts" in spec/README.md."""

from __future__ import annotations

import re
from collections.abc import Iterator

from mipgen import model as m
from support import model

#: Words that add nothing to a name.
EMPTY = frozenset(re.findall(r"\w+", "the a an of in on at to is are was and or for by with its it this that"))

#: Words of texts that names shorten.
SHORT = {
    "accelerometer": "accel",
    "communication": "comm",
    "gyroscope": "gyro",
    "magnetometer": "mag",
}

#: The sources have these names and nothing else.
NAMES_ONLY = {
    "constellation_options",
    "cv7_inertial_continuous_built_in_test.filter_dropped_data",
    "gq7_continuous_built_in_test.antenna_1_shorted",
    "gq7_continuous_built_in_test.antenna_2_shorted",
    "gq7_continuous_built_in_test.filter_comm_error",
    "gq7_continuous_built_in_test.gps_time_fault",
    "gq7_continuous_built_in_test.rtcm_comm_fault",
    "heading_source_flags.mag",
    "rtk_status_flags.modem_state",
    "rtk_status_flags_legacy.controller_state",
    "rtk_status_flags_legacy.controller_status_code",
    "rtk_status_flags_legacy.platform_state",
    "rtk_status_flags_legacy.platform_status_code",
    "sbas_status.corrections_available",
    "signal_quality.time_locked",
}


def words(text: str) -> set[str]:
    """The words of a text, in the form that names have.

    >>> sorted(words("Bytes of the accelerometer."))
    ['accel', 'byte']
    """
    found = (SHORT.get(w, w) for w in re.findall("[a-z0-9]+", text.lower().replace("_", " ")) if w not in EMPTY)
    return {w.removesuffix("s") if len(w) > 3 else w for w in found}


def texts(of: m.Model) -> Iterator[tuple[str, str, str]]:
    """Place, name and description of all that has one."""
    for f in of.fields:
        yield f.full_name, f.name, f.description
        yield from ((f"{f.full_name}.{p.name}", p.name, p.description) for p in f.parameters if p.reserved is None)
    for t in of.all_types:
        yield t.name, t.name, t.description
        parts: tuple[m.EnumValue | m.Bits | m.Parameter, ...] = (
            t.values if isinstance(t, m.Enum)
            else t.bits if isinstance(t, m.Bitfield)
            else t.parameters if isinstance(t, m.Struct)
            else ()
        )  # fmt: skip
        yield from ((f"{t.name}.{x.name}", x.name, x.description) for x in parts)


def test_no_description_repeats_its_name() -> None:
    repeated = {
        place
        for place, name, text in texts(model("real"))
        if text and words(text) <= words(name) and name != "reserved" and not text.endswith(" valid.")
    }
    assert repeated == NAMES_ONLY


#: First words of commands that do several things.
LISTS = re.compile(r"[A-Z][a-z]+s,")


def test_commands_say_what_they_do() -> None:
    """The summary of a command begins with a verb in the third person."""
    first = {f.full_name: f.description.split()[0] for f in model("real").fields if f.role == m.COMMAND}
    verbs = {
        "Acknowledges", "Adapts", "Averages", "Checks", "Clears", "Configures", "Enables", "Ends", "Gets", "Informs",
        "Initializes", "Lets", "Makes", "Moves", "Queries", "Reads", "Requests", "Resets", "Returns", "Runs", "Selects",
        "Sends", "Sets", "Starts", "Stops", "Switches", "Tells",
    }  # fmt: skip
    assert {name: word for name, word in first.items() if word not in verbs and not LISTS.fullmatch(word)} == {}


def test_no_description_is_a_question() -> None:
    question = re.compile("(What|Where|Which|Whether|How|When) ")
    assert [(place, text) for place, _, text in texts(model("real")) if question.match(text)] == []


def test_each_filter_warning_names_what_it_concerns() -> None:
    """Nothing but the condition of the filter as a whole is without fields or commands."""
    status = [t for t in model("real").all_types if t.name in ("gx5_status_flags", "cv7_status_flags")]
    assert len(status) == 2
    bits = [b for t in status if isinstance(t, m.Bitfield) for b in t.bits]
    assert {b.name for b in bits if not b.concerns} == {"filter_condition"}
