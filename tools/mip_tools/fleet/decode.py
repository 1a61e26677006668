"""Decodes one log into fragments: an Arrow file for each field, with the rows and columns of `Log.frame`."""

from __future__ import annotations

import json
import os
import shutil
import uuid
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pyarrow as pa

from ..binding import registry
from ..columns import Log, contents, frames, read_log, tables
from ..columns.sender import identity_replies
from ..logs.report import Report, report_on
from ..names.occurrence import Occurrence, occurrence_in
from ..names.selection import Selection
from ..text.show import set_name
from . import sources
from .work import Work

#: Bytes of a log that are decoded at once.
_PART = 1 << 23
FACTS = "facts.json"


def decode_to_fragments(work: Work, log: sources.Log, identity: str) -> dict[str, Any]:
    """Decodes a log; returns its facts, which are also in `facts.json` beside the fragments."""
    done = work.folder / identity
    with_facts = done / FACTS
    if not with_facts.exists():
        making = work.folder / f"{identity}.{uuid.uuid4().hex}"
        making.mkdir(parents=True)
        try:
            with log.local() as path, read_log(path, device=work.sender) as source:
                report = report_on(source)
                facts = _facts(source, report)
                facts["fragments"] = _fragments(work, source, report, making)
            (making / FACTS).write_text(json.dumps(facts), "utf-8")
            os.rename(making, done)
        except (OSError, ValueError) as error:
            if not with_facts.exists():  # another worker may have been faster
                return {"failed": getattr(error, "strerror", None) or str(error)}
        finally:
            shutil.rmtree(making, ignore_errors=True)
    facts_read: dict[str, Any] = json.loads(with_facts.read_text("utf-8"))
    return facts_read


def _facts(source: Log, report: Report) -> dict[str, Any]:
    """Makes the catalogue entry of a log. Raises ValueError if the file is not a log."""
    if not report.packets:
        raise ValueError("the file has no MIP packets")
    identity = _identity(source)
    common = {"packets": report.packets, "skipped": report.skipped, "damaged": report.damaged}
    return {
        **identity,
        **common,
        "assumed": report.assumed,
        "sets": [_set(report, number) for number in sorted(report.sets)],
    }


def _identity(source: Log) -> dict[str, str]:
    """Returns the identity of the device, if the log contains the reply of one device only."""
    names = {"device": "serial_number", "model": "model_name"}
    devices = [getattr(reply, "device_info", None) for reply in identity_replies(source)]
    values = {key: {getattr(d, name).strip("\0 ") for d in devices if hasattr(d, name)} for key, name in names.items()}
    return {key: found.pop() for key, found in values.items() if len(found) == 1}


def _set(report: Report, number: int) -> dict[str, Any]:
    """Makes the catalogue entry of a descriptor set."""
    entry: dict[str, Any] = {"set": set_name(number), "set_packets": report.sets[number]}
    clock = report.clock_of(number)
    if clock:
        times = report.clocks[clock][number]
        count, missing, places = times.gaps
        entry |= {"clock": clock, "first": times.first, "last": times.last, "rate": times.rate}
        entry |= {"gaps": count, "missing": missing, "backwards": times.backwards}
        entry["longest_gap"] = max((place.seconds for place in places), default=None)
    return entry


def _fragments(work: Work, source: Log, report: Report, folder: Path) -> list[dict[str, Any]]:
    """Writes a file for each field. Raises OSError."""
    selection = Selection(work.names, data=True)
    form = tables.Form(position=True, invalid=work.invalid, wanted=selection.has)
    fragments: dict[Occurrence, dict[str, Any]] = {}
    files: dict[Occurrence, Any] = {}
    options = pa.ipc.IpcWriteOptions(compression="lz4")
    sets: dict[Occurrence, set[int]] = {}
    for number, descriptor in report.fields:
        for kind in registry.types(number, descriptor):
            sets.setdefault(occurrence_in(number, kind), set()).add(number)
    with ExitStack() as stack:
        for part in source.parts(_PART):
            kinds = dict.fromkeys(
                occurrence_in(n, kind) for n, kind in contents.decodable(part) if selection.has(n, kind.DESCRIPTOR)
            )
            for occurrence, column in zip(kinds, part.columns(list(kinds))):
                clocks = report.timeline.clocks(sets[occurrence])
                rows = tables.whole_table(part, [column], form._replace(**clocks._asdict()))
                table = frames.as_frame(rows.columns, "pyarrow", True).drop_columns(["packet"])
                if not len(table):
                    continue
                if occurrence not in files:
                    path = f"{len(files):04}.arrow"
                    file = stack.enter_context(open(folder / path, "wb"))
                    files[occurrence] = stack.enter_context(pa.ipc.new_file(file, table.schema, options=options))
                    fragments[occurrence] = {
                        "path": path,
                        "clock": "+".join(filter(None, clocks[:2])),
                        "field": occurrence.name,
                        "rows": 0,
                        "bytes": 0,
                    }
                files[occurrence].write_table(table)
                fragments[occurrence]["rows"] += len(table)
                fragments[occurrence]["bytes"] += table.nbytes
    return list(fragments.values())
