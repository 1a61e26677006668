"""A run: finds new logs, has workers decode them, packs the rows, and writes the manifest."""

from __future__ import annotations

import json
import logging
import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from importlib import import_module
from pathlib import Path
from typing import Any

from .. import __version__, binding
from ..errors import Failure, Misuse
from . import dataset, pack, tasks
from .sources import Log, device_in, find_logs, is_url
from .work import Source, Work

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
    sender: str | None = None,
    workers: int | None = None,
    scheduler: str | None = None,
    group: int = pack.GROUP,
    progress: Progress = lambda done, of, what: None,
) -> Built:
    """Adds logs to the data set in the folder `out`, which is created if it does not exist.

    `sources` are logs, folders of logs, or URLs of either. `only` names fields and sets; by default, all data are in
    the data set. `device` is a regular expression whose first group finds the device in the name of a log; `sender` is
    the id of the device whose flags are read, by default the one that the log names. The workers are `workers`
    processes on this machine, by default one for each core, or those of a Dask scheduler.

    Raises Misuse if `out` is a URL, Failure if the folder cannot be written, is used by another run, or was made with
    other options.
    """
    if is_url(os.fspath(out)):
        raise Misuse(f"{out}: a data set is made in a folder, which you can copy to the store when it is complete")
    dask = _dask()
    several = [sources] if isinstance(sources, (str, os.PathLike)) else list(sources)
    logs = find_logs([os.fspath(path) for path in several], pattern)
    folder = Path(out).resolve()
    options = {
        "mip_tools": __version__,
        "package": f"{binding.name()} {binding.VERSION}",
        "only": list(only),
        "invalid": invalid,
        "device": device,
        **({"sender": sender} if sender else {}),
    }
    try:
        with dataset.alone(folder):
            run = _Run(folder, options, group, progress)
            run.begin()
            run.sort(logs)
            if run.new:
                work = Work(binding.use_argument(), folder / dataset.WORK, tuple(only), invalid, sender)
                with _client(dask, workers, scheduler) as client:
                    run.decode(client, work)
                    run.pack(client)
            run.end()
            return run.built
    except OSError as error:
        raise Failure(f"{error.filename or out} cannot be written: {error.strerror or error}") from None


class _Run:
    def __init__(self, folder: Path, options: dict[str, Any], group: int, progress: Progress) -> None:
        self.folder, self.work = folder, folder / dataset.WORK
        self._group, self._progress = group, progress
        before = dataset.read_manifest(folder)
        self._before = before or dataset.Manifest(options)
        self.new: list[tuple[Log, str, int]] = []
        self.built = Built(dataset.Manifest(options, list(self._before.files), list(self._before.logs)))
        self._packed: list[Path] = []
        self._facts: dict[str, dict[str, Any]] = {}
        for name, value in options.items():
            if self._before.options.get(name) != value:
                difference = f"{name} {self._before.options.get(name)!r}, not {value!r}"
                raise Failure(f"{folder} was made with {difference}; use the same options, or another folder")

    def begin(self) -> None:
        """Moves back the files that an interrupted run had already moved."""
        for path in dataset.unlisted(self.folder, self._before):
            clock, name = dataset.belongs(path)
            back = self.work / dataset.rows_folder(clock, name) / path.name
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

    def decode(self, client: Any, work: Work) -> None:
        """Has workers decode the new logs, large ones first."""
        order = sorted(self.new, key=lambda listed: -listed[2])
        jobs = [(log.name, (work, log, identity)) for log, identity, _ in order]
        for name, result in self._done(client, tasks.decode_log, jobs, "logs"):
            if isinstance(result, Exception):
                self.built.failed[name] = _why(result)
            elif "failed" in result:
                self.built.failed[name] = result["failed"]
            else:
                device = device_in(name, self._before.options["device"])
                self._facts[name] = result | ({"device": device} if device else {})

    def pack(self, client: Any) -> None:
        """Has workers make files from the fragments."""
        fresh = []
        for log, identity, size in self.new:
            facts = self._facts.get(log.name)
            if facts is None:
                continue
            for fragment in facts["fragments"]:
                source = Source(
                    self.work / identity / fragment["path"], fragment["bytes"], log.name, facts.get("device")
                )
                fresh.append((fragment["clock"] or "none", fragment["field"], source))
            rows = sum(fragment["rows"] for fragment in facts["fragments"])
            self.built.added.append(log.name)
            self.built.manifest.logs.append(dataset.Member(log.name, identity, size, rows))
        packs, remaining = pack.planned(self.folder, self.work, fresh, self._before.files, self._group)
        self.built.manifest.files = list(remaining)
        ways = {str(fragment.path): (clock, name, fragment.path) for clock, name, fragment in packs}
        jobs = [(str(fragment.path), (fragment,)) for *_, fragment in packs]
        for key, result in self._done(client, tasks.pack, jobs, "files"):
            clock, name, path = ways[key]
            if isinstance(result, Exception):
                raise Failure(f"the rows of {name} cannot be written: {_why(result)}; run it again")
            place = f"{dataset.rows_folder(clock, name)}/{path.name}"
            self.built.manifest.files.append(dataset.Part(place, clock, name, *result))
            self._packed.append(path)

    def end(self) -> None:
        """Moves the new files to their folders, and writes the manifest."""
        manifest = self.built.manifest
        manifest.failed = self.built.failed
        manifest.logs.sort(key=lambda entry: entry.name)
        manifest.files.sort(key=lambda entry: entry.path)
        for path in self._packed:
            place = self.folder / path.relative_to(self.work)
            place.parent.mkdir(parents=True, exist_ok=True)
            os.replace(path, place)
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

    def _done(
        self, client: Any, function: Callable[..., Any], jobs: Sequence[tuple[str, tuple[Any, ...]]], what: str
    ) -> Iterator[tuple[str, Any]]:
        """Runs jobs. Yields the results, or the exceptions, as they arrive."""
        completed: Any = import_module("dask.distributed").as_completed
        futures = {client.submit(function, *job, pure=False): key for key, job in jobs}
        for count, future in enumerate(completed(list(futures)), 1):
            error = future.exception()
            self._progress(count, len(futures), what)
            yield futures[future], future.result() if error is None else error
            future.release()


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


def _why(error: BaseException) -> str:
    """Describes the reason in one line."""
    if type(error).__name__ == "KilledWorker":
        return "the workers that read it crashed repeatedly: out of memory, or the file changed meanwhile"
    return " ".join(f"{type(error).__name__}: {error}".split())


@contextmanager
def _client(dask: Any, workers: int | None, scheduler: str | None) -> Iterator[Any]:
    """Starts workers. Raises Failure if there is no scheduler at the address."""
    try:
        if scheduler:
            made = dask.Client(scheduler, timeout=10)
        else:  # logs are mapped, not read: a memory limit would count their pages
            cluster = dask.LocalCluster(
                n_workers=workers or os.cpu_count() or 1,
                threads_per_worker=1,
                memory_limit=0,
                dashboard_address="127.0.0.1:0",
                silence_logs=logging.CRITICAL,
            )
            made = dask.Client(cluster)
    except (OSError, ValueError) as error:
        raise Failure(f"no Dask scheduler answers at {scheduler}: {error}") from None
    except RuntimeError as error:
        raise Failure(f"the workers could not be started: {error} Run it again") from None
    try:
        with made:
            yield made
    finally:
        if not scheduler:
            cluster.close()


def _dask() -> Any:
    try:
        import dask.distributed
        import pyarrow  # noqa: F401
    except ImportError as error:
        raise Failure(f"{error.name} is missing; install the extra `fleet` of mip-tools") from None
    return dask.distributed
