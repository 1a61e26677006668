"""Builds what people install, in dist/: the same bytes each time, from the committed output.

    make release

Packages of Python, Rust and JavaScript, archives of the rest, single files, checksums, an SBOM (CycloneDX) and the
notes of the version. The platform wheels of mip-tools are built by the release workflow, on each platform.
"""

from __future__ import annotations

import argparse
import gzip
import hashlib
import io
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import uuid
import zipfile
from collections.abc import Callable
from datetime import datetime, timezone
from pathlib import Path

from cyclonedx.model import HashAlgorithm, HashType
from cyclonedx.model.bom import Bom, BomMetaData
from cyclonedx.model.component import Component, ComponentType
from cyclonedx.model.license import DisjunctiveLicense
from cyclonedx.output import make_outputter
from cyclonedx.schema import OutputFormat, SchemaVersion
from packageurl import PackageURL

ROOT = Path(__file__).resolve().parents[2]
GENERATED = ROOT / "generated"
VERSION = re.search(r"^version: (\S+)", (ROOT / "spec/protocol.yaml").read_text("utf-8"), re.M)[1]  # type: ignore[index]
EPOCH = 315532800  # 1980, the first date that an archive can contain
LICENSE = "MIT"


def run(*command: str | Path, cwd: Path, **environment: str) -> None:
    done = subprocess.run(
        [str(c) for c in command], cwd=cwd, capture_output=True, text=True, env={**os.environ, **environment}
    )
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout[-3000:]}{done.stderr[-3000:]}")


def tracked(folder: Path) -> list[Path]:
    """The files of a folder that belong to the project; what tests and editors leave there does not."""
    listed = subprocess.run(["git", "ls-files", "-z", "."], cwd=folder, capture_output=True, text=True, check=True)
    return sorted(folder / name for name in listed.stdout.split("\0") if name and (folder / name).is_file())


def copied(folder: Path, to: Path) -> Path:
    for path in tracked(folder):
        target = to / path.relative_to(folder)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(path, target)
    return to


def python(folder: Path, dist: Path) -> None:
    """A wheel and a source distribution."""
    with tempfile.TemporaryDirectory() as scratch:
        source, out = copied(folder, Path(scratch) / "source"), Path(scratch) / "out"
        given = {"SOURCE_DATE_EPOCH": str(EPOCH), "MIP_TOOLS_PURE": "1"}
        run(sys.executable, "-m", "build", "--no-isolation", "--outdir", out, cwd=source, **given)
        for path in sorted(out.iterdir()):
            data = path.read_bytes()
            (dist / path.name).write_bytes(again(data) if path.name.endswith(".tar.gz") else data)


def again(archive: bytes) -> bytes:
    """A source distribution without times and owners."""
    packed = io.BytesIO()
    with (
        tarfile.open(fileobj=io.BytesIO(archive)) as old,
        tarfile.open(fileobj=packed, mode="w", format=tarfile.PAX_FORMAT) as new,
    ):
        for member in sorted(old.getmembers(), key=lambda x: x.name):
            entry = tarfile.TarInfo(member.name)
            entry.type, entry.size, entry.mtime = member.type, member.size, EPOCH
            entry.mode = 0o755 if member.isdir() else 0o644
            new.addfile(entry, old.extractfile(member))
    return gzip.compress(packed.getvalue(), mtime=0)


def rust(folder: Path, dist: Path) -> None:
    with tempfile.TemporaryDirectory() as scratch:  # outside the repository, whose revision would be in the package
        source = copied(folder, Path(scratch) / "source")
        run(
            "cargo", "package", "--quiet", "--no-verify", "--offline", "--target-dir", Path(scratch) / "out", cwd=source
        )
        for path in (Path(scratch) / "out/package").glob("*.crate"):
            shutil.copyfile(path, dist / path.name)


def javascript(folder: Path, dist: Path) -> None:
    with tempfile.TemporaryDirectory() as scratch:
        source = copied(folder, Path(scratch) / "source")
        run("npm", "pack", "--silent", "--pack-destination", dist, cwd=source)


def archive(folder: Path, to: Path, top: str, files: Callable[[Path], list[Path]] = tracked) -> None:
    with zipfile.ZipFile(to, "w") as packed:
        for path in files(folder):
            entry = zipfile.ZipInfo(f"{top}/{path.relative_to(folder).as_posix()}")
            entry.external_attr = 0o644 << 16
            packed.writestr(entry, path.read_bytes(), zipfile.ZIP_DEFLATED, 9)


def notes() -> str:
    """The section of the changelog about the version."""
    text = (ROOT / "CHANGELOG.md").read_text("utf-8")
    return re.split(r"^## .*\n+", text, flags=re.M)[1].strip() + "\n"


def sums(dist: Path) -> dict[str, str]:
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in sorted(dist.iterdir())}


def bill(of: dict[str, str]) -> str:
    """A CycloneDX document: each artefact with its hash, and what it needs. All dependencies are optional but NumPy."""
    numpy = Component(name="numpy", type=ComponentType.LIBRARY, bom_ref="numpy", purl=PackageURL("pypi", name="numpy"))
    about = Component(name="mipgen", type=ComponentType.APPLICATION, bom_ref="mipgen", version=VERSION)
    document = Bom(
        serial_number=uuid.uuid5(uuid.NAMESPACE_URL, json.dumps(of)),
        metadata=BomMetaData(timestamp=datetime.fromtimestamp(EPOCH, timezone.utc), component=about),
    )
    document.components.add(numpy)
    files = []
    for name, digest in of.items():
        file = Component(
            name=name, type=ComponentType.FILE, bom_ref=name, version=VERSION,
            licenses=[DisjunctiveLicense(id=LICENSE)], hashes=[HashType(alg=HashAlgorithm.SHA_256, content=digest)],
        )  # fmt: skip
        files.append(file)
        document.components.add(file)
        document.register_dependency(file, [numpy] if name.startswith("mip_tools") else [])
    document.register_dependency(about, files)
    return make_outputter(document, OutputFormat.JSON, SchemaVersion.V1_6).output_as_string(indent=2) + "\n"


def release(dist: Path, site: Path | None) -> None:
    shutil.rmtree(dist, ignore_errors=True)
    dist.mkdir(parents=True)
    python(GENERATED / "python", dist)
    python(ROOT / "tools", dist)
    rust(GENERATED / "rust", dist)
    javascript(GENERATED / "javascript", dist)
    archive(GENERATED / "c", dist / f"mip-c-{VERSION}.zip", "mip")
    archive(GENERATED / "ros2", dist / f"mip-ros2-{VERSION}.zip", "mip_msgs")
    for path in ("wireshark/mip.lua", "kaitai/mip.ksy", "json/mip.json", "json/mip.schema.json"):
        shutil.copyfile(GENERATED / path, dist / Path(path).name)
    if site is not None:
        archive(site, dist / f"mip-reference-{VERSION}.zip", "mip-reference",
                lambda folder: sorted(p for p in folder.rglob("*") if p.is_file()))  # fmt: skip
    listed = sums(dist)
    (dist / "sbom.cdx.json").write_text(bill(listed), "utf-8")
    (dist / "NOTES.md").write_text(notes(), "utf-8")
    (dist / "SHA256SUMS").write_text("".join(f"{digest}  {name}\n" for name, digest in sums(dist).items()), "utf-8")


def main() -> None:
    parser = argparse.ArgumentParser(prog="make release")
    parser.add_argument("--dist", type=Path, default=ROOT / "dist")
    parser.add_argument("--site", type=Path, help="the folder of the reference as a site")
    given = parser.parse_args()
    release(given.dist.resolve(), given.site)
    for path in sorted(given.dist.iterdir()):
        print(f"{path.stat().st_size:10} {path.name}")


if __name__ == "__main__":
    main()
