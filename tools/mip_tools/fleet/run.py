"""A run: finds new logs, has workers decode them, and writes the manifest."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Sequence
from contextlib import nullcontext
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from .. import __version__, binding
from ..errors import Failure
from . import dataset, store
from .sources import Log, find_logs, is_url
from .workers import decoded

#: Called with the number done, the total, and a word for the items.
Progress = Callable[[int, int, str], object]


@dataclass
class Built:
    """The result of a run."""

    manifest: dataset.Manifest
    added: list[str] = field(default_factory=list)  # names of logs
    unchanged: list[str] = field(default_factory=list)  # logs of an earlier run, maybe under another name
    failed: dict[str, str] = field(default_factory=dict)  # name of a log -> reason


def build_dataset(
    sources: str | os.PathLike[str] | Iterable[str | os.PathLike[str]],
    out: str | os.PathLike[str],
    *,
    only: Sequence[str] = (),
    pattern: str = "*.bin",
    invalid: str = "keep",
    device: str | None = None,
    workers: int | None = None,
    progress: Progress = lambda done, of, what: None,
) -> Built:
    """Adds logs to the data set in `out`, a folder or a URL, which is created if it does not exist.

    `sources` are logs, folders of logs, or URLs of either. `only` names fields and sets; by default, all data are in
    the data set. `device` is the id of the device whose flags are read, by default the one that the log names.
    `workers` is the number of processes, by default one for each core.

    Raises Misuse if the package for a URL is missing, Failure if the folder cannot be written, is used by another run,
    or was made with other options.
    """
    out = os.fspath(out).removeprefix("file://")
    try:
        from .decode import Work
    except ImportError as error:
        raise Failure(str(binding.MissingExtra(str(error.name), "fleet"))) from None
    several = [sources] if isinstance(sources, (str, os.PathLike)) else list(sources)
    logs = find_logs([os.fspath(path) for path in several], pattern)
    options = {
        "mip_tools": __version__,
        "package": f"{binding.name()} {binding.VERSION}",
        "only": list(only),
        "invalid": invalid,
        **({"device": device} if device else {}),
    }
    try:
        place = store.staged(out) if is_url(out) else nullcontext(Path(out).resolve())
        with place as folder, dataset.alone(folder):
            run = _Run(folder, options, progress)
            run.begin()
            run.sort(logs)
            run.decode(Work(folder / dataset.WORK, tuple(only), invalid, device), workers)
            run.end()
            return run.built
    except OSError as error:
        raise Failure(f"{error.filename or out} cannot be written: {error.strerror or error}") from None


class _Run:
    def __init__(self, folder: Path, options: dict[str, Any], progress: Progress) -> None:
        self.folder, self.work, self._progress = folder, folder / dataset.WORK, progress
        before = dataset.read_manifest(folder)
        self._before = before or dataset.Manifest(options)
        self.new: list[tuple[Log, str, int]] = []
        self.built = Built(dataset.Manifest(options, list(self._before.files), list(self._before.logs)))
        self._facts: dict[str, dict[str, Any]] = {}
        for name, value in options.items():
            if self._before.options.get(name) != value:
                difference = f"{name} {self._before.options.get(name)!r}, not {value!r}"
                raise Failure(f"{folder} was made with {difference}; use the same options, or another folder")

    def begin(self) -> None:
        """Moves back the files that an interrupted run had already moved."""
        for path in dataset.unlisted(self.folder, self._before):
            back = self.work / path.stem / path.relative_to(self.folder)
            back.parent.mkdir(parents=True, exist_ok=True)
            os.replace(path, back)
        options_text = json.dumps(self._before.options)
        stamp = self.work / "options.json"
        if (
            not stamp.exists() or stamp.read_text("utf-8") != options_text
        ):  # unfinished work with other options is useless
            dataset.cleared(self.folder)
            self.work.mkdir()
            with dataset.placed(stamp) as part:
                part.write_text(options_text, "utf-8")

    def sort(self, logs: Sequence[Log]) -> None:
        """Sorts the logs into new, known and changed ones."""
        names = {member.name: member for member in self._before.logs}
        identities = {member.identity for member in self._before.logs}
        for log in logs:
            try:
                identity, size = log.identity()
            except (OSError, ImportError) as error:
                self.built.failed[log.name] = getattr(error, "strerror", None) or str(error)
                continue
            if identity in identities:
                self.built.unchanged.append(log.name)
            elif log.name in names:
                self.built.failed[log.name] = "it has changed since it was added; its earlier rows are kept"
            else:
                identities.add(identity)
                self.new.append((log, identity, size))

    def decode(self, work: Any, workers: int | None) -> None:
        """Has workers decode the new logs, large ones first."""
        jobs = [(work, log, identity) for log, identity, _ in sorted(self.new, key=lambda listed: -listed[2])]
        for count, (name, facts) in enumerate(decoded(jobs, workers), 1):
            self._progress(count, len(jobs), "logs")
            if "failed" in facts:
                self.built.failed[name] = facts["failed"]
            else:
                self._facts[name] = facts

    def end(self) -> None:
        """Moves the new files to their folders, and writes the manifest."""
        manifest = self.built.manifest
        for log, identity, size in self.new:
            files = self._facts.get(log.name, {}).get("files")
            if files is None:
                continue
            for file in files:
                place = self.folder / file["path"]
                place.parent.mkdir(parents=True, exist_ok=True)
                os.replace(self.work / identity / file["path"], place)
                manifest.files.append(dataset.Part(**file))
            manifest.logs.append(dataset.Member(log.name, identity, size, sum(file["rows"] for file in files)))
            self.built.added.append(log.name)
        manifest.failed = self.built.failed
        manifest.logs.sort(key=lambda entry: entry.name)
        manifest.files.sort(key=lambda entry: entry.path)
        if self.built.added:
            self._write_catalogue()
        dataset.write_manifest(self.folder, manifest)
        for path in dataset.unlisted(self.folder, manifest):
            path.unlink()
        dataset.cleared(self.folder)

    def _write_catalogue(self) -> None:
        """Adds the rows of the new logs to the catalogue, and removes those of logs that are not in the data set."""
        import pyarrow as pa
        import pyarrow.parquet as parquet

        path = self.folder / dataset.CATALOGUE
        rows = []
        if path.exists():
            counted = {member.name for member in self._before.logs}
            rows = [row for row in parquet.read_table(path).to_pylist() if row["log"] in counted]
        sizes = {log.name: size for log, _, size in self.new}
        for name, facts in sorted(self._facts.items()):
            own = {key: facts.get(key) for key in ("device", "model", "packets", "skipped", "damaged")}
            for each in facts["sets"]:
                rows.append({"log": name, "size": sizes[name], **own, **each, **_dates(each)})
        with dataset.placed(path) as part:
            parquet.write_table(pa.Table.from_pylist(rows, _catalogue_schema(pa)), part)


def _catalogue_schema(pa: Any) -> Any:
    text, whole, real, time = pa.string(), pa.int64(), pa.float64(), pa.timestamp("ns", "UTC")
    columns = {
        "log": text, "size": whole, "device": text, "model": text, "packets": whole, "skipped": whole,
        "damaged": whole, "set": text, "set_packets": whole, "clock": text, "first": whole, "last": whole,
        "first_utc": time, "last_utc": time, "rate": real, "gaps": whole, "missing": real, "longest_gap": real,
        "backwards": whole,
    }  # fmt: skip
    units = {"size": "B", "skipped": "B", "first": "ns", "last": "ns", "rate": "Hz", "missing": "s", "longest_gap": "s"}
    facts = {name: {"unit": unit} for name, unit in units.items()}
    return pa.schema([pa.field(name, kind, metadata=facts.get(name)) for name, kind in columns.items()])


def _dates(each: dict[str, Any]) -> dict[str, Any]:
    """Converts the first and the last time to dates, if the clock has a date."""
    if not binding.CLOCKS.get(each.get("clock", "")):
        return {}
    return {"first_utc": each["first"], "last_utc": each["last"]}
