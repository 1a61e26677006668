"""A data set in an object store: a run works in a folder of this machine, and sends what it has added."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ..errors import Failure
from .dataset import CATALOGUE, MANIFEST
from .sources import file_system, store_errors


@contextmanager
def staged(url: str) -> Iterator[Path]:
    """Provides a folder for a run that extends the data set at a URL.

    When the run has ended, its files are sent, the manifest last: until then, the data set in the store is unchanged.
    Raises Misuse if the package for the store is missing, Failure if the store cannot be read or written, or if
    another run has changed the data set meanwhile.
    """
    system, top = file_system(url)
    places = {name: f"{top.rstrip('/')}/{name}" for name in (MANIFEST, CATALOGUE)}

    def manifest() -> bytes | None:
        return system.cat_file(places[MANIFEST]) if system.exists(places[MANIFEST]) else None

    with tempfile.TemporaryDirectory(prefix="mip-") as name:
        folder = Path(name)
        with store_errors(url, "read"):
            before = manifest()
            if before is not None:
                for file, place in places.items():
                    if system.exists(place):
                        system.get_file(place, str(folder / file))
        try:
            yield folder
        except Failure as error:  # whoever reads it knows the URL only
            raise Failure(str(error).replace(name, url)) from None
        with store_errors(url, "written"):
            system.invalidate_cache()
            if manifest() != before:
                raise Failure(f"another run has changed {url} meanwhile; run again")
            rows = sorted(folder.glob("clock=*/field=*/*"))
            for path in (*rows, folder / CATALOGUE, folder / MANIFEST):
                if path.exists():
                    system.put_file(str(path), f"{top.rstrip('/')}/{path.relative_to(folder).as_posix()}")
