"""What `make release` builds: the same bytes each time, and each artefact works in an empty environment."""

from __future__ import annotations

import contextlib
import hashlib
import importlib
import importlib.util
import io
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import zipfile
from collections.abc import Iterator
from email.message import Message
from functools import cache
from importlib.resources import files
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from urllib.error import HTTPError, URLError

import c_build
import jsonschema_rs
import pytest
import yaml
from support import BUILD, ROOT, need, nightly, packaging

sys.path.insert(0, str(ROOT / "tools/release"))  # scripts, which import each other by name
project, publish = importlib.import_module("project"), importlib.import_module("publish")

MESSAGE = "75 65 80 0E 0E 04 3E 7A 63 A0 BB 8E 3B 29 7F E5 BF 7F 84 EE"
pytestmark = pytest.mark.xdist_group("release")  # which is built once


def run(*command: str | Path, cwd: Path, umask: int = -1) -> str:
    clean = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "MIP"))}
    done = subprocess.run([str(c) for c in command], cwd=cwd, env=clean, umask=umask, capture_output=True, text=True)
    assert done.returncode == 0, f"{command}: {done.stdout}{done.stderr}"
    return done.stdout


def test_addresses(tmp_path: Path) -> None:
    """Each manifest names the repository of the specification, or none does; nothing published has an invented one."""
    assert project.other_addresses(ROOT, project.REPOSITORY) == {}
    (tmp_path / "generated").symlink_to(BUILD / "invented")  # it has an address
    written_by_hand = {name: ROOT / name for name in project.MANIFESTS if not name.startswith("generated/")}
    for name, path in written_by_hand.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        shutil.copyfile(path, tmp_path / name)
    assert project.other_addresses(tmp_path, "https://example.com/invented").keys() == written_by_hand.keys()
    published = ["generated", "tools", "README.md", "CITATION.cff"]
    invented = subprocess.run(["git", "grep", "-lF", "example.com", "--", *published], cwd=ROOT, capture_output=True)
    assert invented.stdout == b""


def test_nothing_is_published_without_a_repository(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(publish, "REPOSITORY", "")
    monkeypatch.setattr(sys, "argv", ["publish.py", "npm"])
    with pytest.raises(SystemExit, match="names no repository"):
        publish.main()


@pytest.mark.parametrize(
    ("replies", "message"),
    [
        ([b"", b"the bytes"], None),
        ([b"other bytes"], "file: the registry has other bytes, SHA-256 a3ead5ee"),
        ([b""] * publish.ATTEMPTS, "file: the registry does not have it after 0 minutes"),
    ],
)
def test_a_registry_must_have_what_was_built(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, replies: list[bytes], message: str | None
) -> None:
    (tmp_path / "file").write_bytes(b"the bytes")
    monkeypatch.setattr(publish, "PAUSE", 0)
    with pytest.raises(SystemExit, match=message) if message else contextlib.nullcontext():
        publish.compare(tmp_path / "file", iter(replies).__next__)


def test_what_a_registry_has_is_not_uploaded_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """So that a job which failed after the upload can be run again."""
    for name in ("mip-protocol-1.0.0.tgz", "mip-protocol-1.0.0.crate"):
        (tmp_path / name).write_bytes(b"the bytes")
    monkeypatch.delattr(publish, "run")
    for publisher in (publish.npm, publish.crates):
        monkeypatch.setattr(publish, "fetch", lambda address: b"the bytes")
        publisher(tmp_path, False)
        monkeypatch.setattr(publish, "fetch", lambda address: b"other bytes")
        with pytest.raises(SystemExit, match="the registry has other bytes"):
            publisher(tmp_path, False)


def test_a_registry_without_an_answer_is_asked_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def status(code: int) -> HTTPError:
        return HTTPError("https://pypi.org", code, "", Message(), None)

    listed = {"urls": [{"filename": "mip_tools-1.0.0.tar.gz", "url": "https://files.pythonhosted.org"}]}
    last = [io.BytesIO(json.dumps(listed).encode()), io.BytesIO(b"the bytes")]
    for errors in ([status(404), status(403), status(502), URLError("unreachable"), TimeoutError()], [status(401)]):
        replies = iter([*errors, *last])

        def urlopen(address: str, timeout: int, replies: Iterator[Any] = replies) -> io.BytesIO:
            reply = next(replies)
            if isinstance(reply, io.BytesIO):
                return reply
            raise reply

        (tmp_path / "mip_tools-1.0.0.tar.gz").write_bytes(b"the bytes")
        monkeypatch.setattr(publish, "PAUSE", 0)
        monkeypatch.setattr("urllib.request.urlopen", urlopen)
        with contextlib.nullcontext() if len(errors) > 1 else pytest.raises(HTTPError):
            publish.pypi(tmp_path, False)


def built(name: str, umask: int = 0o022) -> Path:
    dist = BUILD / "release" / name
    run(sys.executable, ROOT / "tools/release/build.py", "--dist", dist, cwd=ROOT, umask=umask)
    return dist


@cache
def dist() -> Path:
    return built("once")


def the(pattern: str) -> Path:
    (found,) = dist().glob(pattern)
    return found


@packaging
def test_a_second_build_has_the_same_bytes() -> None:
    once, twice = ({p.name: p.read_bytes() for p in d.iterdir()} for d in (dist(), built("twice", umask=0o077)))
    assert once.keys() == twice.keys()
    assert [name for name in once if once[name] != twice[name]] == []


@packaging
def test_sums_bill_and_notes_name_everything() -> None:
    listed = dict(line.split("  ")[::-1] for line in (dist() / "SHA256SUMS").read_text("utf-8").splitlines())
    assert listed.keys() == {p.name for p in dist().iterdir()} - {"SHA256SUMS"}
    assert all(hashlib.sha256((dist() / name).read_bytes()).hexdigest() == digest for name, digest in listed.items())
    bill = json.loads((dist() / "sbom.cdx.json").read_text("utf-8"))
    form, *others = (
        json.loads((files("cyclonedx.schema") / f"_res/{name}.SNAPSHOT.schema.json").read_text("utf-8"))
        for name in ("bom-1.6", "spdx", "jsf-0.82")
    )
    known = jsonschema_rs.Registry([(x["$id"].replace(".schema", ".SNAPSHOT.schema"), x) for x in others])
    assert [str(e) for e in jsonschema_rs.validator_for(form, registry=known).iter_errors(bill)] == []
    built = {c["name"]: c["hashes"][0]["content"] for c in bill["components"] if c["type"] == "file"}
    assert built == {n: d for n, d in listed.items() if n not in ("sbom.cdx.json", "NOTES.md")}
    needed = {d["ref"]: d.get("dependsOn", []) for d in bill["dependencies"]}
    assert set(needed["mipgen"]) == built.keys()
    libraries = {c["bom-ref"]: (c["version"], c["scope"]) for c in bill["components"] if c["type"] == "library"}
    assert [name for name in built if "pkg:pypi/numpy" in needed[name]] == [
        n for n in built if n.startswith("mip_tools")
    ]
    assert all(re.match(r"[0-9.]+$", version) for version, _ in libraries.values())
    assert [name for name, (_, scope) in libraries.items() if scope == "required"] == [
        "pkg:pypi/mip-tools",  # of mip-simulator
        "pkg:pypi/numpy",
    ]
    assert {"pkg:cargo/serde", "pkg:pypi/pyserial", "pkg:pypi/mcap"} < libraries.keys()
    changes = (ROOT / "CHANGELOG.md").read_text("utf-8").partition("\n## ")[2].partition("\n")[2].strip()
    assert changes.startswith((dist() / "NOTES.md").read_text("utf-8").strip())


@packaging
def test_the_notes_are_those_of_the_version(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    spec = importlib.util.spec_from_file_location("build_release", ROOT / "tools/release/build.py")
    assert spec and spec.loader
    build = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(build)
    monkeypatch.setattr(build, "VERSION", "0.0.1")
    with pytest.raises(SystemExit, match=r"the first heading is '## .*', not '## 0\.0\.1 \(date\)'"):
        build.notes()


@packaging
@pytest.mark.parametrize("form", ["wheel", "source"])
def test_python(tmp_path: Path, form: str) -> None:
    run(sys.executable, "-m", "venv", "--without-pip", tmp_path / "venv", cwd=tmp_path)
    python, mip = tmp_path / "venv/bin/python", tmp_path / "venv/bin/mip"
    names = ("mip_protocol", "mip_simulator", "mip_tools")
    packages = [the(f"{name}*.whl") for name in names]
    if form == "source":
        sources = [the(f"{name}*.tar.gz") for name in names]
        built = ("wheel", "--no-build-isolation", "--no-index", "--no-deps", "--wheel-dir", tmp_path / "wheels")
        run(sys.executable, "-m", "pip", *built, *sources, cwd=tmp_path)
        packages = sorted((tmp_path / "wheels").iterdir())
    for package in packages:
        with zipfile.ZipFile(package) as packed:
            (metadata,) = (name for name in packed.namelist() if name.endswith(".dist-info/METADATA"))
            assert packed.read(metadata).startswith(b"Metadata-Version: 2.4\n"), "twine knows no newer one"
    protocol, simulator, tools = packages
    assert ("-cp310-abi3-" in tools.name) == (form == "source")
    with zipfile.ZipFile(tools) as packed:
        compiled = [name for name in packed.namelist() if name.startswith("mip_tools/columns/_kernel.")]
        assert len(compiled) == (form == "source") and "mip_tools/columns/kernel.c" not in packed.namelist()
    install = (sys.executable, "-m", "pip", "--python", python, "install", "--no-index", "--no-deps")
    run(*install, protocol, tools, cwd=tmp_path)
    assert "g" in run(python, ROOT / "generated/python/quickstart.py", cwd=tmp_path)
    assert "scaled_accel = (x=0.24452066" in run(mip, "dump", *MESSAGE.split(), cwd=tmp_path)
    (site,) = (tmp_path / "venv/lib").glob("python*/site-packages")
    numpy = find_spec("numpy")
    assert numpy and numpy.origin
    for part in Path(numpy.origin).parents[1].glob("numpy*"):  # without the network
        (site / part.name).symlink_to(part)
    (tmp_path / "log.bin").write_bytes(bytes.fromhex(MESSAGE))
    run(mip, "export", "log.bin", "-o", "log.csv", cwd=tmp_path)
    assert "0.24452066" in (tmp_path / "log.csv").read_text("utf-8")
    assert not (site / "mip_simulator").exists()
    run(*install, simulator, cwd=tmp_path)
    assert "localhost:" in run(mip, "simulate", "3dm-gx5-15", "--tcp", "0", "--duration", "0.01", cwd=tmp_path)


@packaging
def test_rust(tmp_path: Path) -> None:
    with tarfile.open(the("*.crate")) as crate:
        crate.extractall(tmp_path, **({"filter": "data"} if hasattr(tarfile, "data_filter") else {}))  # of 3.11.4
    (folder,) = tmp_path.iterdir()
    target = BUILD / "release/target"
    out = run("cargo", "run", "--quiet", "--offline", "--example", "quickstart", "--target-dir", target, cwd=folder)
    assert " g along x" in out


@packaging
def test_javascript(tmp_path: Path) -> None:
    run(need("npm"), "install", "--silent", "--offline", "--no-audit", the("*.tgz"), cwd=tmp_path)
    readme = (tmp_path / "node_modules/mip-protocol/README.md").read_text("utf-8")
    first = re.search(r"```javascript\n(.*?)```", readme, re.S)
    assert first
    (tmp_path / "first.mjs").write_text(first[1], "utf-8")
    assert " g along x" in run(need("node"), "first.mjs", cwd=tmp_path)


@packaging
def test_c(tmp_path: Path) -> None:
    with zipfile.ZipFile(the(f"mip-c-{project.VERSION}.zip")) as packed:
        packed.extractall(tmp_path)
    sources = sorted(str(p.relative_to(tmp_path)) for p in tmp_path.glob("mip/src/mip/*/*.c"))
    readme = (tmp_path / "mip/README.md").read_text("utf-8")
    assert "cc -Imip/src -Imip/ports mip/examples/stream.c mip/src/mip/*/*.c mip/ports/*.c -o stream" in readme
    objects = tmp_path / "objects"
    objects.mkdir()
    run("cc", "-c", "-I../mip/src", *(f"../{s}" for s in sources), cwd=objects)
    made = sorted(objects.glob("*.o"))
    ports = sorted(tmp_path.glob("mip/ports/*.c"))
    run("cc", "-Imip/src", "-Imip/ports", "mip/examples/stream.c", *made, *ports, "-o", "stream", cwd=tmp_path)
    run("cc", "-Imip/src", "mip/quickstart.c", *made, "-o", "quickstart", cwd=tmp_path)
    assert " g" in run(tmp_path / "quickstart", cwd=tmp_path)


@packaging
def test_c_of_each_family(tmp_path: Path) -> None:
    devices = [d["id"] for d in json.loads((ROOT / "generated/json/mip.json").read_text("utf-8"))["devices"]]
    found: list[str] = []
    for path in sorted(dist().glob(f"mip-c-*-{project.VERSION}.zip")):
        family = path.name.removeprefix("mip-c-").removesuffix(f"-{project.VERSION}.zip")
        with zipfile.ZipFile(path) as packed:
            packed.extractall(tmp_path / family)
        made = tmp_path / family / "mip"
        c_build.builds(made, c_build.headers(made))
        source = (made / "src/mip/extra/profiles.c").read_text("utf-8")
        own = [d for d in devices if d.startswith(family)]
        assert all(f'"{d}"' in source for d in own) and source.count("\nconst struct mip_profile mip_profile_") == len(
            own
        )
        found += own
    assert sorted(found) == sorted(devices)


@packaging
def test_single_files() -> None:
    json.loads((dist() / "mip.json").read_text("utf-8"))
    json.loads((dist() / "mip.schema.json").read_text("utf-8"))
    for name in ("mip.lua", "mip.ksy"):
        folder = {"mip.lua": "wireshark", "mip.ksy": "kaitai"}[name]
        assert (dist() / name).read_bytes() == (ROOT / "generated" / folder / name).read_bytes()


sys.path.insert(0, str(ROOT / "tools/release"))
WORKFLOWS = sorted((ROOT / ".github/workflows").glob("*.yml"))


@nightly("actionlint, which needs Go")
def test_actionlint_finds_nothing() -> None:
    tool = BUILD / "tools/bin/actionlint"
    done = subprocess.run([tool, *WORKFLOWS], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def test_only_jobs_that_publish_may_do_more_than_read() -> None:
    for path in WORKFLOWS:
        workflow = yaml.safe_load(path.read_text("utf-8"))
        assert "write" not in workflow["permissions"].values() or path.name == "pages.yml"
        for name, job in workflow["jobs"].items():
            if "write" in job.get("permissions", {}).values():
                assert path.name == "release.yml", (path.name, name)


def test_registries_follow_one_another() -> None:
    """What can be undone comes first: each job needs the one before it."""
    jobs = yaml.safe_load((ROOT / ".github/workflows/release.yml").read_text("utf-8"))["jobs"]
    order = ["draft", *importlib.import_module("publish").REGISTRIES, "github"]
    assert [jobs[later]["needs"] for later in order[1:]] == order[:-1]


@pytest.mark.parametrize(
    ("old", "new", "passes"),
    [("", "", True), ("version: 1.2.3", "version: 1.3.0", False), ("repository: ", "homepage: ", False),
     ("2026-12-01", "unreleased", False)],
)  # fmt: skip
def test_a_tag_must_fit(tmp_path: Path, old: str, new: str, passes: bool) -> None:
    files = {"spec/protocol.yaml": "version: 1.2.3\nrepository: https://example.com\n",
             "CHANGELOG.md": "# Changelog\n\n## 1.2.3 (2026-12-01)\n"}  # fmt: skip
    (tmp_path / "spec").mkdir()
    for name, text in files.items():
        (tmp_path / name).write_text(text.replace(old, new), "utf-8")
    steps = yaml.safe_load((ROOT / ".github/workflows/release.yml").read_text("utf-8"))["jobs"]["build"]["steps"]
    (step,) = (step["run"] for step in steps if step.get("name", "").startswith("the tag is that of"))
    environment = {**os.environ, "GITHUB_REF_NAME": "v1.2.3"}
    assert (subprocess.run(["bash", "-ec", step], cwd=tmp_path, env=environment).returncode == 0) == passes


def test_each_python_package_has_an_environment() -> None:
    """Which the page names, and the wheels of each platform are tested with a package that is there."""
    jobs = yaml.safe_load((ROOT / ".github/workflows/release.yml").read_text("utf-8"))["jobs"]
    page = (ROOT / "docs/versions.md").read_text("utf-8")
    named = re.findall(r"`pypi-(\w+)`", page)
    assert (
        sorted(named)
        == sorted(jobs["pypi"]["strategy"]["matrix"]["package"])
        == ["mip_protocol", "mip_simulator", "mip_tools"]
    )
    (needed,) = re.findall(r"pip install \{project\}/([\w/]+)", (ROOT / "tools/pyproject.toml").read_text("utf-8"))
    assert (ROOT / needed / "pyproject.toml").is_file()


def test_actions_of_others_are_pinned() -> None:
    used = [line for path in WORKFLOWS for line in path.read_text("utf-8").splitlines() if "uses: " in line]
    others = [line.partition("uses: ")[2] for line in used if "uses: actions/" not in line]
    assert others
    assert [name for name in others if not re.fullmatch(r"\S+@[0-9a-f]{40}  # v[0-9.]+", name)] == []
