"""Builds what people install, in dist/: the same bytes each time, from the committed output.

    make release
    make release REHEARSE=1     does the dry run of each registry, too

Packages of Python, Rust and JavaScript, archives of the rest, among them C for each product family, single files,
checksums, an SBOM (CycloneDX) and the notes of the version. The platform wheels of mip-tools are built by the release
workflow, on each platform.

`tests/release` installs each artefact.
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
from email import message_from_bytes
from pathlib import Path

from cyclonedx.model import HashAlgorithm, HashType
from cyclonedx.model.bom import Bom, BomMetaData
from cyclonedx.model.component import Component, ComponentScope, ComponentType
from cyclonedx.model.license import DisjunctiveLicense
from cyclonedx.output import make_outputter
from cyclonedx.schema import OutputFormat, SchemaVersion
from packageurl import PackageURL
from packaging.requirements import Requirement
from project import GENERATED, REPOSITORY, ROOT, UNPUBLISHED, VERSION, copied, other_addresses, run, tracked

EPOCH = 315532800  # 1980, the first date that an archive can contain
LICENSE = "MIT"


def python(folder: Path, dist: Path) -> None:
    """A wheel and a source distribution."""
    with tempfile.TemporaryDirectory() as scratch:
        source, out = copied(folder, Path(scratch) / "source"), Path(scratch) / "out"
        environment = {"SOURCE_DATE_EPOCH": str(EPOCH), "MIP_TOOLS_PURE": "1"}
        run(sys.executable, "-m", "build", "--no-isolation", "--outdir", out, cwd=source, **environment)
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


def families() -> dict[str, list[str]]:
    """The devices of each product family, with which their ids begin: 3dm-gx5."""
    found: dict[str, list[str]] = {}
    for device in json.loads((GENERATED / "json/mip.json").read_text("utf-8"))["devices"]:
        found.setdefault("-".join(device["id"].split("-")[:2]), []).append(device["id"])
    return found


def parts(family: str, devices: list[str], dist: Path) -> None:
    """C for these devices only."""
    with tempfile.TemporaryDirectory() as scratch:
        chosen = [word for device in devices for word in ("--device", device)]
        command = (sys.executable, "-m", "mipgen", "generate", "--target", "c", "--out", scratch, *chosen)
        run(*command, cwd=ROOT, PYTHONPATH=str(ROOT / "generator"))
        archive(Path(scratch) / "c", dist / f"mip-c-{family}-{VERSION}.zip", "mip", every)


def every(folder: Path) -> list[Path]:
    return sorted(path for path in folder.rglob("*") if path.is_file())


def notes() -> str:
    """The section of the changelog about the version, which is the first one."""
    _, heading, text, *_ = re.split(r"^## (.*)\n+", (ROOT / "CHANGELOG.md").read_text("utf-8"), flags=re.M)
    if not re.fullmatch(rf"{re.escape(VERSION)} \(.+\)", heading):
        sys.exit(f"CHANGELOG.md: the first heading is '## {heading}', not '## {VERSION} (date)'")
    return text.strip() + "\n"


def sums(dist: Path) -> dict[str, str]:
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in sorted(dist.iterdir())}


def needs(dist: Path) -> dict[str, dict[str, bool]]:
    """What each artefact needs, as package URLs without versions: true if always, false if only for an extra."""
    needed: dict[str, dict[str, bool]] = {}
    for wheel in dist.glob("*.whl"):
        with zipfile.ZipFile(wheel) as packed:
            (name,) = (x for x in packed.namelist() if x.endswith(".dist-info/METADATA"))
            about = message_from_bytes(packed.read(name))
        listed = [Requirement(x) for x in about.get_all("Requires-Dist", [])]
        listed = [x for x in listed if x.name != about["Name"]]  # an extra of all extras names its own package
        needed[wheel.name] = {f"pkg:pypi/{x.name}": True for x in listed if x.marker is None}
        needed[wheel.name] |= {
            f"pkg:pypi/{x.name}": False for x in listed if f"pkg:pypi/{x.name}" not in needed[wheel.name]
        }
        needed[f"{wheel.name.split('-py3')[0]}.tar.gz"] = needed[wheel.name]
    command = ["cargo", "metadata", "--format-version", "1", "--no-deps", "--offline"]
    (package,) = json.loads(subprocess.check_output(command, cwd=GENERATED / "rust"))["packages"]
    wanted = [x for x in package["dependencies"] if x["kind"] != "dev"]
    needed[f"{package['name']}-{VERSION}.crate"] = {f"pkg:cargo/{x['name']}": not x["optional"] for x in wanted}
    return needed


def tested() -> dict[str, str]:
    """The versions with which the tests run."""
    locks = [(ROOT / f"requirements/{name}.txt").read_text("utf-8") for name in ("generator", "development", "all")]
    pinned = {
        f"pkg:pypi/{name}": version for lock in locks for name, version in re.findall(r"^(\S+)==(\S+)", lock, re.M)
    }
    lock = (ROOT / "tests/rust/Cargo.lock").read_text("utf-8")
    crates = re.findall(r'name = "([^"]*)", version = "([^"]*)"', lock)
    return pinned | {f"pkg:cargo/{name}": version for name, version in crates}


def bill(digests: dict[str, str], needed: dict[str, dict[str, bool]]) -> str:
    """A CycloneDX document: each artefact with its hash, and what it needs, in the version that was tested."""
    about = Component(name="mipgen", type=ComponentType.APPLICATION, bom_ref="mipgen", version=VERSION)
    document = Bom(
        serial_number=uuid.uuid5(uuid.NAMESPACE_URL, json.dumps(digests)),
        metadata=BomMetaData(timestamp=datetime.fromtimestamp(EPOCH, timezone.utc), component=about),
    )
    own = {f"pkg:pypi/{name.partition('-')[0].replace('_', '-')}": VERSION for name in digests if name.endswith(".whl")}
    versions, libraries = tested() | own, {}
    for address in sorted({address for listed in needed.values() for address in listed}):
        required = any(listed.get(address) for listed in needed.values())
        purl = PackageURL.from_string(f"{address}@{versions[address]}")
        libraries[address] = Component(
            name=purl.name, version=purl.version, type=ComponentType.LIBRARY, bom_ref=address, purl=purl,
            scope=ComponentScope.REQUIRED if required else ComponentScope.OPTIONAL,
        )  # fmt: skip
        document.components.add(libraries[address])
    files = []
    for name, digest in digests.items():
        file = Component(
            name=name, type=ComponentType.FILE, bom_ref=name, version=VERSION,
            licenses=[DisjunctiveLicense(id=LICENSE)], hashes=[HashType(alg=HashAlgorithm.SHA_256, content=digest)],
        )  # fmt: skip
        files.append(file)
        document.components.add(file)
        document.register_dependency(file, [libraries[x] for x in needed.get(name, ())])
    document.register_dependency(about, files)
    return make_outputter(document, OutputFormat.JSON, SchemaVersion.V1_6).output_as_string(indent=2) + "\n"


def release(dist: Path, site: Path | None) -> None:
    about = notes()
    shutil.rmtree(dist, ignore_errors=True)
    dist.mkdir(parents=True)
    python(GENERATED / "python", dist)
    python(ROOT / "tools", dist)
    python(ROOT / "tools/mip_simulator", dist)
    rust(GENERATED / "rust", dist)
    javascript(GENERATED / "javascript", dist)
    archive(GENERATED / "c", dist / f"mip-c-{VERSION}.zip", "mip")
    for family, devices in families().items():
        parts(family, devices, dist)
    archive(GENERATED / "ros2", dist / f"mip-ros2-{VERSION}.zip", "mip_msgs")
    for path in ("wireshark/mip.lua", "kaitai/mip.ksy", "json/mip.json", "json/mip.schema.json"):
        shutil.copyfile(GENERATED / path, dist / Path(path).name)
    if site is not None:
        archive(site, dist / f"mip-reference-{VERSION}.zip", "mip-reference", every)
    listed = sums(dist)
    (dist / "sbom.cdx.json").write_text(bill(listed, needs(dist)), "utf-8")
    (dist / "NOTES.md").write_text(about, "utf-8")
    (dist / "SHA256SUMS").write_text("".join(f"{digest}  {name}\n" for name, digest in sums(dist).items()), "utf-8")


def main() -> None:
    parser = argparse.ArgumentParser(prog="make release")
    parser.add_argument("--dist", type=Path, default=ROOT / "dist")
    parser.add_argument("--site", type=Path, help="the folder of the reference as a site")
    options = parser.parse_args()
    for name, addresses in other_addresses(ROOT, REPOSITORY).items():
        sys.exit(
            f"{name}: the repository is {REPOSITORY or 'not'} in spec/protocol.yaml, and here {addresses or 'missing'}"
        )
    os.umask(0o022)  # packages contain the modes of files
    release(options.dist.resolve(), options.site)
    for path in sorted(options.dist.iterdir()):
        print(f"{path.stat().st_size:10} {path.name}")
    if not REPOSITORY:
        print(UNPUBLISHED)


if __name__ == "__main__":
    main()
