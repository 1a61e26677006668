"""Other versions of a specification: folders, and revisions of its Git repository."""

from __future__ import annotations

import io
import subprocess
import tarfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from mipgen.base.errors import Failure

#: Tags of releases.
RELEASES = "v[0-9]*"


@contextmanager
def spec_folder(name: str, spec: Path) -> Iterator[Path]:
    """Provides the folder of that name, or else the folder `spec` from the Git revision of that name."""
    if name and Path(name).is_dir():
        yield Path(name)
        return
    neither = f"there is no folder '{name}', and {spec} is not in a Git repository with revisions; specify a folder"
    top = Path(_git(spec, "rev-parse", "--show-toplevel", fails=neither).strip())
    commit = _git(
        top,
        "rev-parse",
        "--verify",
        "--quiet",
        f"{name}^{{commit}}",
        fails=f"'{name}' is neither a folder nor a revision",
    )
    place = spec.resolve().relative_to(top.resolve()).as_posix()
    archive = _run(
        top, ("archive", "--format=tar", f"{commit.strip()}:{place}"), f"the revision '{name}' has no folder {place}"
    )
    with TemporaryDirectory() as folder:
        with tarfile.open(fileobj=io.BytesIO(archive)) as files:
            if hasattr(tarfile, "data_filter"):
                files.extractall(folder, filter="data")
            else:  # no filter, as in Python 3.11.2; the archive is trusted, because Git has just made it
                files.extractall(folder)
        yield Path(folder)


def last_release(spec: Path) -> str | None:
    """Returns the newest release tag that is an ancestor of the current revision; None if there is none."""
    try:
        return _git(spec, "describe", "--tags", "--abbrev=0", f"--match={RELEASES}", fails="no release").strip()
    except Failure:
        return None


def _git(spec: Path, *arguments: str, fails: str) -> str:
    return _run(spec, arguments, fails).decode("utf-8")


def _run(spec: Path, arguments: tuple[str, ...], fails: str) -> bytes:
    try:
        done = subprocess.run(["git", "-C", str(spec), *arguments], capture_output=True)
    except FileNotFoundError:
        raise Failure("git is missing; specify two folders instead") from None
    if done.returncode:
        raise Failure(fails)
    return done.stdout
