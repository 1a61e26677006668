"""Decodes one log into fragments: an Arrow file for each field, with the rows and columns of `Log.frame`."""

from __future__ import annotations

import json
import os
import shutil
import uuid
from contextlib import ExitStack
from pathlib import Path
from typing import Any

from ..binding import UnknownName, registry
from ..cli.log_report import Report, examine
from ..cli.selection import Selection
from ..cli.show import set_name
from ..columns import Log, contents, frames, read_log, tables
from ..occurrence import Occurrence, of
from . import sources
from .tasks import Work

#: Bytes of a log that are decoded at once.
_PART = 1 << 23
#: The field that a log must contain to identify its device.
_IDENTITY = "base.get_device_info_response"
FACTS = "facts.json"


def decoded(work: Work, log: sources.Log, identity: str) -> dict[str, Any]:
    """Decodes a log; returns its facts, which are also in `facts.json` beside the fragments."""
    done = work.folder / identity
    with_facts = done / FACTS
    if not with_facts.exists():
        making = work.folder / f"{identity}.{uuid.uuid4().hex}"
        making.mkdir(parents=True)
        try:
            with log.local() as path, read_log(path) as source:
                facts = _facts(source)
                facts["fragments"] = _fragments(work, source, facts.pop("clocks"), making)
            (making / FACTS).write_text(json.dumps(facts), "utf-8")
            os.rename(making, done)
        except (OSError, ValueError) as error:
            if not with_facts.exists():  # another worker may have been faster
                return {"failed": getattr(error, "strerror", None) or str(error)}
        finally:
            shutil.rmtree(making, ignore_errors=True)
    said: dict[str, Any] = json.loads(with_facts.read_text("utf-8"))
    return said


def _facts(source: Log) -> dict[str, Any]:
    """Makes the catalogue entry of a log. Raises ValueError if the file is not a log."""
    report = examine(source)
    if not report.packets:
        raise ValueError("the file has no MIP packets")
    told = _told(source) if (0x01, 0x81) in report.fields else {}
    clocks = {number: [c for c, sets in report.clocks.items() if number in sets] for number in report.sets}
    common = {"packets": report.packets, "skipped": report.skipped, "damaged": report.damaged}
    return {**told, **common, "clocks": clocks, "sets": [_set(report, number) for number in sorted(report.sets)]}


def _told(source: Log) -> dict[str, str]:
    """Returns the identity of the device, if the log contains the reply with it."""
    try:
        one = next(source.objects(registry.by_name(_IDENTITY)), None)
    except (UnknownName, LookupError):
        return {}
    said = getattr(one, "device_info", None)
    names = {"device": "serial_number", "model": "model_name"}
    return {key: getattr(said, name).strip("\0 ") for key, name in names.items() if hasattr(said, name)}


def _set(report: Report, number: int) -> dict[str, Any]:
    """Makes the catalogue entry of a descriptor set, by the first clock that it has."""
    said: dict[str, Any] = {"set": set_name(number), "set_packets": report.sets[number]}
    for clock, sets in report.clocks.items():
        if number in sets:
            times = sets[number]
            count, missing, places = times.gaps
            said |= {"clock": clock, "first": times.first, "last": times.last, "rate": times.rate}
            said |= {"gaps": count, "missing": missing, "backwards": times.backwards}
            said["longest_gap"] = max((place.seconds for place in places), default=None)
            break
    return said


def _fragments(work: Work, source: Log, clocks: dict[int, list[str]], folder: Path) -> list[dict[str, Any]]:
    """Writes a file for each field. Raises OSError."""
    import pyarrow as pa

    selection = Selection(work.names, data=True)
    form = tables.Form(position=True, invalid=work.invalid, wanted=selection.has)
    fragments: dict[Occurrence, dict[str, Any]] = {}
    files: dict[Occurrence, Any] = {}
    options = pa.ipc.IpcWriteOptions(compression="lz4")
    sets = _sets(source, selection)
    with ExitStack() as stack:
        for part in source.parts(_PART):
            kinds = dict.fromkeys(of(n, kind) for n, kind in contents.kinds(part) if selection.has(n, kind.DESCRIPTOR))
            for one, column in zip(kinds, part.columns(list(kinds))):
                clock = _clock(clocks, sets[one])
                rows = tables.whole(part, [column], form._replace(clock=clock))
                table = frames.made(rows.columns, "pyarrow", True).drop_columns(["packet"])
                if not len(table):
                    continue
                if one not in files:
                    path = f"{len(files):04}.arrow"
                    file = stack.enter_context(open(folder / path, "wb"))
                    files[one] = stack.enter_context(pa.ipc.new_file(file, table.schema, options=options))
                    fragments[one] = {"path": path, "clock": clock, "field": one.name, "rows": 0, "bytes": 0}
                files[one].write_table(table)
                fragments[one]["rows"] += len(table)
                fragments[one]["bytes"] += table.nbytes
    return list(fragments.values())


def _sets(source: Log, selection: Selection) -> dict[Occurrence, set[int]]:
    """Finds the descriptor sets of each field in the whole log."""
    found: dict[Occurrence, set[int]] = {}
    for part in source.parts(_PART):
        for number, kind in contents.kinds(part):
            if selection.has(number, kind.DESCRIPTOR):
                found.setdefault(of(number, kind), set()).add(number)
    return found


def _clock(clocks: dict[int, list[str]], sets: set[int]) -> str:
    """Chooses the first clock that all of these sets have, else that any of them has, as `Log.frame` does."""
    from ..binding import CLOCKS

    has = {clock: [clock in clocks.get(number, ()) for number in sets] for clock in CLOCKS}
    return next(iter([*(c for c in has if all(has[c])), *(c for c in has if any(has[c]))]), "")


__all__ = ["FACTS", "decoded"]
