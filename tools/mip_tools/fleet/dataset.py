"""The folder of a data set: its files, its manifest, and how both change together.

    OUT/_manifest.json                     what belongs to the data set: files, their logs, and the options
    OUT/_catalogue.parquet                 a row for each log and descriptor set: device, times, rates, gaps
    OUT/clock=gps/field=…/LOG.parquet      the rows of a log
    OUT/_work/                             files of an unfinished run

A file gets its place when it is complete, and its name is the identity of the log.
Only files in the manifest belong to the data set, and the manifest is replaced as a whole.
"""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any
from urllib.parse import quote

from ..errors import Failure

VERSION = 1
MANIFEST, CATALOGUE, WORK = "_manifest.json", "_catalogue.parquet", "_work"


@dataclass(frozen=True)
class Part:
    """A file of rows."""

    path: str  # in the folder
    clock: str
    field: str
    rows: int


@dataclass(frozen=True)
class Member:
    """A log that is in the data set."""

    name: str
    identity: str
    size: int
    rows: int


@dataclass
class Manifest:
    """The content of a data set."""

    options: dict[str, Any]
    files: list[Part] = field(default_factory=list)
    logs: list[Member] = field(default_factory=list)
    failed: dict[str, str] = field(default_factory=dict)  # in the last run: name of a log -> reason

    @property
    def rows(self) -> int:
        """The number of rows of all files."""
        return sum(part.rows for part in self.files)


class Fleet:
    """An existing data set."""

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        self.folder = Path(folder)

    @property
    def manifest(self) -> Manifest:
        """The content of the data set. Raises Failure if the folder has none."""
        manifest = read_manifest(self.folder)
        if manifest is None:
            raise Failure(f"{self.folder} has no complete data set; `mip fleet` makes one")
        return manifest

    def files(self, field: str, clock: str | None = None) -> list[str]:
        """Returns the files of a field, for any Parquet reader, such as `dask.dataframe.read_parquet`.

        Raises LookupError if there are none, or if they have several clocks and you name none.
        """
        own = [part for part in self.manifest.files if part.field == field and clock in (None, part.clock)]
        clocks = sorted({part.clock for part in own})
        if len(clocks) != 1:
            which = f"times by several clocks: {', '.join(clocks)}; name one" if clocks else "no such rows"
            raise LookupError(f"{field}: {self.folder} has {which}")
        return [str(self.folder / part.path) for part in own]

    def dataset(self, field: str, clock: str | None = None) -> Any:
        """Opens the rows of a field as a PyArrow data set. Raises LookupError as `files` does."""
        import pyarrow.dataset

        return pyarrow.dataset.dataset(self.files(field, clock))

    def catalogue(self) -> Any:
        """Reads the catalogue as a PyArrow table: a row for each log and descriptor set."""
        import pyarrow.parquet

        return pyarrow.parquet.read_table(self.folder / CATALOGUE, partitioning=None)


def open_fleet(folder: str | os.PathLike[str]) -> Fleet:
    """Opens the data set in a folder. Raises Failure if it has none."""
    fleet = Fleet(folder)
    fleet.manifest  # noqa: B018
    return fleet


def read_manifest(folder: Path) -> Manifest | None:
    """Reads the manifest of a folder; None if there is none. Raises Failure if it has another version."""
    try:
        content = json.loads((folder / MANIFEST).read_text("utf-8"))
    except FileNotFoundError:
        return None
    except ValueError as error:
        raise Failure(f"{folder / MANIFEST} is damaged: {error}") from None
    if content.pop("version", None) != VERSION:
        raise Failure(f"{folder / MANIFEST} is of another version of mip-tools; use another folder")
    files, logs = [Part(**entry) for entry in content.pop("files")], [Member(**entry) for entry in content.pop("logs")]
    return Manifest(files=files, logs=logs, **content)


def write_manifest(folder: Path, manifest: Manifest) -> None:
    """Replaces the manifest."""
    text = json.dumps({"version": VERSION, **asdict(manifest)}, indent=1) + "\n"
    with placed(folder / MANIFEST) as part:
        part.write_text(text, "utf-8")


@contextmanager
def placed(path: Path) -> Iterator[Path]:
    """Provides a temporary path, which is renamed to the final one when the file is complete and on the disk."""
    part = path.with_name(f"_{path.name}.{os.getpid()}.part")
    try:
        yield part
        with part.open("rb+") as file:
            os.fsync(file.fileno())
        os.replace(part, path)
    finally:
        part.unlink(missing_ok=True)


def rows_folder(clock: str, field: str) -> str:
    """Returns the folder for the rows of a field."""
    return f"clock={clock or 'none'}/field={quote(field, safe='')}"


def unlisted(folder: Path, manifest: Manifest) -> list[Path]:
    """Finds files that are not in the manifest because a run ended while it moved them."""
    listed = {part.path for part in manifest.files}
    every = sorted(folder.glob("clock=*/field=*/*"))
    return [path for path in every if path.relative_to(folder).as_posix() not in listed]


@contextmanager
def alone(folder: Path) -> Iterator[None]:
    """Keeps other runs from changing the folder meanwhile. Raises Failure if another run is active."""
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / "_lock", "ab") as file:
        try:
            _lock(file.fileno())
        except OSError:
            raise Failure(f"another run is active in {folder}; wait until it has ended") from None
        yield


def _lock(number: int) -> None:
    """Acquires a lock that the system releases when the process ends, for any reason."""
    try:
        import fcntl
    except ImportError:
        import msvcrt

        msvcrt.locking(number, msvcrt.LK_NBLCK, 1)  # type: ignore[attr-defined, unused-ignore]
    else:
        fcntl.flock(number, fcntl.LOCK_EX | fcntl.LOCK_NB)


def cleared(folder: Path) -> None:
    """Removes what a finished run no longer needs."""
    shutil.rmtree(folder / WORK, ignore_errors=True)
