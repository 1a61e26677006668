"""What is assumed about a log, in a line each: its device, how flags are read, and why it has no date."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from ..binding import DEVICE_CLOCK, SECOND
from ..text.clocks import dated
from ..text.numbers import count_text

if TYPE_CHECKING:
    from ..columns import Log
    from ..columns.timeline import Timeline

#: What synchronizes a device.
REMEDY = "a GNSS receiver with a fix, a pulse per second with time updates, or a time set by the host"


def print_assumptions(command: str, log: Log, *, times: bool = True, names: bool = True) -> None:
    """Prints the lines on standard error; `times`, `names`: does the output have times, and name values?"""
    from ..columns import timeline

    line = timeline.of_log(log) if times else None
    without = [] if line is None or not line.sets or any_date(line) else [no_date(line)]
    for text in [*log.assumed(names), *without]:
        print(f"mip {command}: {text}", file=sys.stderr)


def any_date(line: Timeline) -> bool:
    """Has any packet a date?"""
    return any(count for times in line.sets.values() for clock, count in times.valid.items() if dated(clock))


def no_date(line: Timeline) -> str:
    """Says which clock the times of a log have, and why they have no date."""
    clock = line.clocks(line.sets).undated
    return f"{f'{clock} clock, ' * bool(clock)}no date: {reason_for_no_date(line)}"


def reason_for_no_date(line: Timeline) -> str:
    """Says why a log has no date."""
    sets = line.sets.values()
    stamped = sum(times.stamped for times in sets)
    own = sum(times.alone.get(DEVICE_CLOCK, 0) for times in sets)
    if own:
        return f"not synchronized; {own} of {count_text(stamped, 'timestamp')} without a date"
    if stamped:
        return f"{count_text(stamped, 'timestamp')} of which none is valid"
    if line.clocks(line.sets).undated:
        return "no timestamp with a date is in the packets"
    return "no timestamps; add one to the message format"


def synchronization(line: Timeline) -> list[str]:
    """Says when a log has no date although it has one at other times."""
    if not any_date(line):
        return []
    losses = [lost for times in line.sets.values() for lost in times.lost]
    again = [(lost.end - lost.begin) / SECOND for lost in losses if lost.end is not None]
    remarks = []
    if again:
        remarks.append(f"synchronization lost for {max(again):.3g} s")
    if len(again) < len(losses):
        remarks.append("synchronization lost until the end")
    return remarks
