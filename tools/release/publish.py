"""Publishes what `make release` built to one registry, and checks that the registry has these very bytes.

    make release REHEARSE=1                 builds dist/, and does the dry run of each registry
    python tools/release/publish.py npm     a step of .github/workflows/release.yml

The workflow goes through the registries in the order of `REGISTRIES`: a package can be removed from npm for three days,
on PyPI it can only be withdrawn, and a crate stays for good.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import sys
import tarfile
import tempfile
import time
import urllib.error
import urllib.request
import venv
from collections.abc import Callable
from pathlib import Path

from project import GENERATED, REPOSITORY, ROOT, UNPUBLISHED, VERSION, copied, run

TWINE = "twine==6.1.0"  # that of the action which uploads the packages
ATTEMPTS, PAUSE = 20, 30  # seconds: a registry takes some minutes to show what is new


def npm(dist: Path, rehearse: bool) -> None:
    (package,) = dist.glob("mip-protocol-*.tgz")
    address = f"https://registry.npmjs.org/mip-protocol/-/{package.name}"
    if rehearse or not has(package, fetch(address)):
        run("npm", "publish", package, "--access", "public", "--dry-run" if rehearse else "--provenance", cwd=dist)
    if not rehearse:
        compare(package, lambda: fetch(address))


def pypi(dist: Path, rehearse: bool) -> None:
    """Checks the packages, or compares them with those that the action of PyPI has uploaded."""
    packages = sorted([*dist.glob("mip_*.whl"), *dist.glob("mip_*.tar.gz")])
    if rehearse:
        twine = ROOT / "build/twine"
        if not (twine / "bin/twine").exists():
            venv.create(twine, with_pip=True)
            run(twine / "bin/python", "-m", "pip", "install", "--quiet", TWINE, cwd=ROOT)
        run(twine / "bin/twine", "check", "--strict", *packages, cwd=dist)
        return
    for package in packages:
        project = package.name.partition("-")[0]

        def uploaded(name: str = package.name, about: str = f"https://pypi.org/pypi/{project}/{VERSION}/json") -> bytes:
            listed = json.loads(fetch(about) or b'{"urls": []}')["urls"]
            return next((fetch(x["url"]) for x in listed if x["filename"] == name), b"")

        compare(package, uploaded)


def crates(dist: Path, rehearse: bool) -> None:
    """Publishes the crate only if cargo packs the one in dist/ again, which is attested."""
    (crate,) = dist.glob("mip-protocol-*.crate")
    address = f"https://static.crates.io/crates/mip-protocol/{crate.name}"
    if not rehearse and has(crate, fetch(address)):
        return
    with tempfile.TemporaryDirectory() as scratch:
        source, target = copied(GENERATED / "rust", Path(scratch) / "source"), Path(scratch) / "target"
        # The versions that cargo chose at that time are in the crate: cargo would choose newer ones now.
        with tarfile.open(crate) as packed, packed.extractfile(f"{crate.stem}/Cargo.lock") as lock:  # type: ignore[union-attr]
            (source / "Cargo.lock").write_bytes(lock.read())
        run("cargo", "package", "--quiet", "--no-verify", "--locked", "--target-dir", target, cwd=source)
        if (target / "package" / crate.name).read_bytes() != crate.read_bytes():
            sys.exit(f"dist/{crate.name} is not what this version of cargo packs from generated/rust")
        run(
            "cargo",
            "publish",
            "--quiet",
            "--locked",
            "--target-dir",
            target,
            *(["--dry-run"] if rehearse else []),
            cwd=source,
        )
    if not rehearse:
        compare(crate, lambda: fetch(address))


REGISTRIES: dict[str, Callable[[Path, bool], None]] = {"npm": npm, "pypi": pypi, "crates": crates}


def fetch(address: str) -> bytes:
    """What is at the address; nothing as long as the registry does not have it, or cannot be asked."""
    try:
        with urllib.request.urlopen(address, timeout=PAUSE) as reply:
            return bytes(reply.read())
    except OSError as error:  # storage without a list of its files denies access (403) to what it lacks
        if isinstance(error, urllib.error.HTTPError) and error.code < 500 and error.code not in (403, 404, 429):
            raise
        return b""


def has(file: Path, published: bytes) -> bool:
    """Does the registry have the file? Ends the program if it has other bytes."""
    if published and published != file.read_bytes():
        sys.exit(f"{file.name}: the registry has other bytes, SHA-256 {hashlib.sha256(published).hexdigest()}")
    return bool(published)


def compare(file: Path, published: Callable[[], bytes]) -> None:
    """Ends the program unless the registry has the bytes of the file."""
    for attempt in range(ATTEMPTS):
        if attempt:
            time.sleep(PAUSE)
        if has(file, published()):
            return
    sys.exit(f"{file.name}: the registry does not have it after {ATTEMPTS * PAUSE // 60} minutes")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument(
        "registry", nargs="*", choices=[*REGISTRIES, []], metavar="REGISTRY", help=", ".join(REGISTRIES)
    )
    parser.add_argument("--dist", type=Path, default=ROOT / "dist")
    parser.add_argument("--rehearse", action="store_true", help="publish nothing: check, and do the registry's dry run")
    options = parser.parse_args()
    if not options.rehearse and not REPOSITORY:
        sys.exit(UNPUBLISHED)
    for name in options.registry or REGISTRIES:
        REGISTRIES[name](options.dist.resolve(), options.rehearse)
        print(f"{name}: {'would be published' if options.rehearse else 'published'}")


if __name__ == "__main__":
    main()
