"""The tools on top of a package of another specification, of two fields, without any, and with fields of an overlay."""

from __future__ import annotations

import ast
import os
import re
import shutil
import struct
import subprocess
import sys
from pathlib import Path

import pytest
from mipgen import cli
from packages import real
from support import ROOT, SPECS

TOOLS = ROOT / "tools"


@pytest.fixture(scope="module")
def own(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The Python package of the specification that `mipgen new` writes."""
    folder = tmp_path_factory.mktemp("own")
    assert cli.main(["new", str(folder / "spec")]) == 0
    assert cli.main(["generate", "--spec", str(folder / "spec"), "--out", str(folder), "--target", "python"]) == 0
    return folder / "python"


def package(folder: Path) -> Path:
    """The package in the folder of a distribution."""
    (found,) = folder.glob("*/reflection.py")
    return found.parent


def python(*words: object, path: Path | None = None, data: str = "", **more: str) -> subprocess.CompletedProcess[str]:
    folders = os.pathsep.join(map(str, filter(None, (TOOLS, path))))
    clean = {k: v for k, v in os.environ.items() if k != "MIP_PACKAGE"}
    return subprocess.run(
        [sys.executable, *map(str, words)], input=data, capture_output=True, text=True, cwd=ROOT / "docs",
        env={**clean, "PYTHONPATH": folders, **more},
    )  # fmt: skip


def mip(*words: object, path: Path | None = None, **environment: str) -> str:
    done = python("-m", "mip_tools", *words, path=path, **environment)
    assert (done.returncode, done.stderr) == (0, ""), done.stderr
    return done.stdout


def test_every_way_to_name_a_package(own: Path) -> None:
    wanted = mip("fields", "--package", own)
    assert wanted.splitlines() == ["0x01  tools              2 fields", "0x80  measurements       1 fields"]
    folder = package(own)
    for words in (("fields", f"--package={own}"), ("--package", os.path.relpath(folder, ROOT / "docs"), "fields")):
        assert mip(*words, MIP_PACKAGE="nothing") == wanted, words
    assert mip("--package", folder.name, "fields", path=own) == wanted
    assert mip("fields", MIP_PACKAGE=str(own)) == wanted


def test_columns_and_a_virtual_device_of_two_fields(own: Path) -> None:
    code = f"""
import mip_tools
mip_tools.use({str(own)!r})
from mip_simulator import VirtualDevice
from {package(own).name} import Parser, registry
device = VirtualDevice("my-device")
link = device.connect()
for data in (b"\\1\\2\\5", b"\\2"):
    kind = registry.by_name("tools.light")
    link.write(bytes(kind.decode(data).packet()))
    device.advance(0.5)
print(*[f for packet in Parser().feed(link.read()) for f in registry.decode_packet(packet)], sep="; ")
data = registry.by_name("measurements.temperature")(21.5)
print(mip_tools.read_log(bytes(data.packet()) * 3)["measurements.temperature"]["temperature"].tolist())
"""
    done = python("-c", code)
    assert done.returncode == 0, done.stderr
    first, second = done.stdout.splitlines()
    assert "mode = blink" in first and "rate = 5 Hz" in first and second == "[21.5, 21.5, 21.5]"


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["fields"], "mip fields: mip_protocol is not installed; install the generated Python package, or name yours "
                     "with --package NAME, MIP_PACKAGE=NAME or mip_tools.use(NAME)"),
        (["fields", "--package", "json"], "mip fields: json is not a package that mipgen has generated"),
        (["fields", "--package", "no_such"], "mip fields: no_such is neither an installed package nor a folder; "
                                             "install it, or name its folder"),
        (["fields", "--package", "."], f"mip fields: {ROOT / 'docs'} contains no package that mipgen has generated"),
        (["fields", "--package"], "mip fields: --package needs the name or the folder of a generated package"),
    ],
)  # fmt: skip
def test_there_is_no_package(words: list[str], said: str) -> None:
    done = python("-m", "mip_tools", *words)
    assert (done.returncode, done.stdout, done.stderr) == (2 if "needs" in said else 1, "", f"{said}\n")


def test_without_a_package_there_is_still_help() -> None:
    assert "--package NAME" in mip("--help")
    said = "without a generated package; logs are read with nothing: a generated package is missing\n"
    assert mip("--version").endswith(said)


def test_a_package_that_lacks_what_a_tool_needs(own: Path, tmp_path: Path) -> None:
    folder = shutil.copytree(package(own), tmp_path / "lacking")
    remedy = "regenerate it with the mipgen version of these tools"
    for words, what in ((("simulate", "my-device"), "simulation.json"), (("dump", "00"), "lacking.lookup")):
        (folder / what.replace("lacking.lookup", "lookup.py")).unlink()
        done = python("-m", "mip_tools", *words, "--package", folder)
        assert (done.returncode, done.stderr) == (1, f"mip {words[0]}: lacking lacks {what}; {remedy}\n")


def test_one_module_imports_the_package() -> None:
    """`binding` names all that is used of it, once for Python and once for type checkers."""
    for path in (TOOLS / "mip_tools").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            modules = [node.module] if isinstance(node, ast.ImportFrom) else []
            modules += [a.name for a in node.names] if isinstance(node, ast.Import) else []
            assert path.name == "binding.py" or not [x for x in modules if (x or "").startswith("mip_protocol")], path
    from mip_tools import binding

    tree = ast.parse((TOOLS / "mip_tools/binding.py").read_text("utf-8"))
    typed = {
        (node.module.partition(".")[2] or a.name, a.asname or a.name)
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("mip_protocol")
        for a in node.names
    }
    found = {(home, name) for name, home in binding._HOMES.items()} | {(name, name) for name in binding._MODULES}
    assert typed - {("device", "DeviceAtPort")} == found


def test_pages_install_the_folder_and_no_package_of_that_name() -> None:
    """`pip install tools` would install a stranger's package from the index."""
    pages = [ROOT / "README.md", TOOLS / "README.md", *(ROOT / "docs").glob("*.md"), *TOOLS.rglob("*.py")]
    commands = [c for p in pages for c in re.findall(r"pip install ([^`#\n]*)", p.read_text("utf-8"))]
    assert sum("/tools" in c for c in commands) > 5
    assert not [c for c in commands if re.search(r"(?<![\w/])tools\b", c)], commands


# --------------------------------------------------------------------------- fields of one's own


@pytest.fixture(scope="module")
def overlaid(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The Python package of the specification with an overlay."""
    folder = tmp_path_factory.mktemp("overlay")
    words = ["--spec", str(SPECS["real"][0]), "--spec", str(ROOT / "tests/overlay"), "--target", "python"]
    assert cli.main(["generate", *words, "--out", str(folder)]) == 0
    return folder / "python"


LIGHT = struct.pack(">4fB", 250.0, 0.5, 0.25, 0.125, 1)


def log(packets: int = 3) -> bytes:
    """Packets with a field of the overlay, and one of the specification."""
    builder = real.packet.PacketBuilder(0x80).add(0x7A, LIGHT).add(0x04, struct.pack(">3f", 1, 2, 3))
    return bytes(builder.build()) * packets


def test_an_own_field_in_dump_export_and_columns(overlaid: Path, tmp_path: Path) -> None:
    out = mip("dump", "--package", overlaid, log(1).hex())
    assert "illuminance = 250.0 lx" in out and "lamp = on" in out
    file = tmp_path / "log.bin"
    file.write_bytes(log())
    words = ("export", file, "ambient_light", "scaled_accel", "-o", "-")
    done = python("-m", "mip_tools", *words, MIP_PACKAGE=str(overlaid))
    assert done.returncode == 0 and done.stderr.endswith("no date: no timestamps; add one to the message format\n")
    heading, *rows = done.stdout.splitlines()
    assert "sensor.ambient_light.bend.x [rad]" in heading and len(rows) == 3 and "250.0,0.5,0.25,0.125" in rows[0]
    code = f"import mip_tools; mip_tools.use({str(overlaid)!r}); log = mip_tools.read_log({str(file)!r})\n"
    code += "print(log['sensor.ambient_light']['illuminance'].tolist(), log['sensor.scaled_accel']['scaled_accel'][0])"
    done = python("-c", code)
    assert (done.stdout, done.stderr) == ("[250.0, 250.0, 250.0] [1. 2. 3.]\n", "")


def test_an_own_command_is_sent_to_a_virtual_device(overlaid: Path) -> None:
    words = ["simulate", "3dm-cv7-gnss-ins", "--tcp", "0", "--package", str(overlaid)]
    environment = {**os.environ, "PYTHONPATH": str(TOOLS)}
    command = [sys.executable, "-m", "mip_tools", *words]
    with subprocess.Popen(command, stdout=subprocess.PIPE, env=environment) as process:
        assert process.stdout is not None
        place = process.stdout.readline().decode().strip()
        for words, said in (["write", "state=on"], ""), (["read"], "state = on"):
            assert said in mip("send", place, "payload.lamp", *words, "--package", overlaid)
        process.kill()
