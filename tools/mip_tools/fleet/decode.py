"""Decodes one log: a Parquet file for each field, with the rows and columns of `Log.frame`."""

from __future__ import annotations

import json
import os
import shutil
import uuid
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa

from ..binding import registry
from ..columns import Log, buffers, contents, frames, read_log, tables
from ..columns.sender import identity_replies
from ..formats.writers import parquet_writer
from ..logs.report import Report, report_on
from ..names.occurrence import Occurrence, occurrence_in
from ..names.selection import Selection
from ..text.show import set_name
from . import sources
from .dataset import rows_folder

#: Bytes of a log that are decoded at once; their rows are a row group.
_PART = 1 << 24
FACTS = "facts.json"


@dataclass(frozen=True)
class Work:
    """The parameters that are the same for all logs."""

    folder: Path  # of unfinished work
    names: tuple[str, ...]
    invalid: str
    device: str | None = None  # the id of the device whose flags these are


def decode_log(work: Work, log: sources.Log, identity: str) -> dict[str, Any]:
    """Decodes a log into a folder. Returns its facts, which are also there, in `facts.json`."""
    done = work.folder / identity
    facts = _read(done, log.name)
    if facts is None:
        shutil.rmtree(done, ignore_errors=True)
        making = work.folder / f"{identity}.{uuid.uuid4().hex}"
        making.mkdir(parents=True)
        try:
            with log.local() as path, read_log(path, device=work.device) as source:
                report = report_on(source)
                facts = {"log": log.name, **_facts(source, report)}
                facts["files"] = _files(work, source, report, making, (log.name, facts.get("device"), identity))
            (making / FACTS).write_text(json.dumps(facts), "utf-8")
            os.rename(making, done)
        except (OSError, ValueError) as error:
            return {"failed": getattr(error, "strerror", None) or str(error)}
        finally:
            shutil.rmtree(making, ignore_errors=True)
    return facts


def _read(done: Path, name: str) -> dict[str, Any] | None:
    """Returns the facts of a log that an interrupted run decoded under this name."""
    try:
        facts: dict[str, Any] = json.loads((done / FACTS).read_text("utf-8"))
    except FileNotFoundError:
        return None
    return facts if facts["log"] == name else None


def _facts(source: Log, report: Report) -> dict[str, Any]:
    """Makes the catalogue entry of a log. Raises ValueError if the file is not a log."""
    if not report.packets:
        raise ValueError("the file has no MIP packets")
    common = {"packets": report.packets, "skipped": report.skipped, "damaged": report.damaged}
    sets = [_set(report, number) for number in sorted(report.sets)]
    return {**_identity(source), **common, "assumed": report.assumed, "sets": sets}


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


def _files(
    work: Work, source: Log, report: Report, folder: Path, names: tuple[str, str | None, str]
) -> list[dict[str, Any]]:
    """Writes a file for each field. `names`: of the log, of the device, of the files. Raises OSError."""
    name, device, identity = names
    selection = Selection(work.names, data=True)
    form = tables.Form(position=True, invalid=work.invalid, wanted=selection.has)
    files: dict[Occurrence, dict[str, Any]] = {}
    writers: dict[Occurrence, Any] = {}
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
                for title, text in (("log", name), ("device", device)):
                    table = table.append_column(title, _same(text, len(table)))
                if occurrence not in writers:
                    clock = "+".join(filter(None, clocks[:2])) or "none"
                    path = Path(rows_folder(clock, occurrence.name)) / f"{identity}.parquet"
                    (folder / path).parent.mkdir(parents=True)
                    writers[occurrence] = stack.enter_context(parquet_writer(folder / path, table.schema))
                    files[occurrence] = {"path": path.as_posix(), "clock": clock, "field": occurrence.name, "rows": 0}
                writers[occurrence].write_table(table, row_group_size=len(table))
                files[occurrence]["rows"] += len(table)
    return list(files.values())


def _same(text: str | None, count: int) -> Any:
    """Makes a column with the same text in all rows."""
    mask = np.ones(count, bool) if text is None else None
    which = buffers.array(pa, np.zeros(count, np.int32), mask)
    return pa.DictionaryArray.from_arrays(which, buffers.texts(pa, [] if text is None else [text]))
