"""The commands, programs and files of docs/mip.md, docs/settings.md, docs/new-language.md and spec/README.md."""

from __future__ import annotations

import os
import re
import subprocess
from dataclasses import fields
from pathlib import Path

import pytest
from mipgen import cli
from mipgen.emit.target import Target
from mipgen.resolve.load import load_model
from program import blocks, commands, mip, printed, programs, section, simulated
from support import ROOT, uses

MIP, SETTINGS, LANGUAGE, SPEC = (
    (ROOT / name).read_text("utf-8")
    for name in ("docs/mip.md", "docs/settings.md", "docs/new-language.md", "spec/README.md")
)


# --------------------------------------------------------------------------- the commands of mip


def test_every_command_is_named() -> None:
    from mip_tools.__main__ import COMMANDS, EPILOG

    assert sorted(re.findall(r"^\| `([a-z][a-z-]+)` \|", MIP, re.M)) == sorted(COMMANDS)
    said = re.findall(r"\b(\d+)(?= [a-z])", EPILOG.partition("exit status:")[2])
    assert re.findall(r"^\| (\d+) \|", section(MIP, "Exit status"), re.M) == said


def test_one_packet(tmp_path: Path) -> None:
    (command,) = commands(section(MIP, "One packet explained"), "mip ")
    assert f"```text\n{printed(command, tmp_path)}```" in MIP


def test_from_a_device_to_a_table(tmp_path: Path) -> None:
    first, *others = commands(section(MIP, "From a device to a table"), "mip ")
    (port,) = re.findall(r"^mip simulate 3dm-cv7-gnss-ins --tcp (\d+) &$", first)
    with simulated() as place:
        other = place.rpartition(":")[2]
        shown = {command: printed(command.replace(port, other), tmp_path) for command in others}
    assert len(shown) > 9 and all(shown[c] for c in others if not re.search(r"record|-o [a-z]|cut", c))
    assert (tmp_path / "log.csv").read_text().startswith("time,time_own,sensor.scaled_accel.x [g],")
    assert 0 < (tmp_path / "part.bin").stat().st_size < (tmp_path / "log.bin").stat().st_size


# --------------------------------------------------------------------------- settings


def test_a_file_of_settings(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The commands run as written, and a device accepts the file."""
    first, *others = commands(SETTINGS, "mip ")
    (port,) = re.findall(r"^mip simulate 3dm-cv7-gnss-ins --tcp (\d+) &$", first)
    monkeypatch.chdir(tmp_path)
    with simulated() as place:
        for command in others:
            printed(command.replace(f"localhost:{port}", place), tmp_path)
        (sample,) = blocks(SETTINGS, "yaml")
        file = tmp_path / "settings.yaml"
        whole = file.read_text("utf-8")
        file.write_text(sample, "utf-8")
        code, out, error = mip("config", "push", place, "settings.yaml")
        assert (code, error) == (0, "") and ": 3 settings changed, 1 as before, 0 refused" in out
        (where, text) = re.findall(r"`settings\.yaml:(\d+:\d+): (.*?'\?)`", SETTINGS)[0]
        file.write_text(whole.replace("receiver_1}", "receiver_9}"), "utf-8")
        code, _, error = mip("config", "push", place, "settings.yaml")
        assert (code, error) == (1, f"mip config: settings.yaml:{where}: {text}\n")


def test_the_table_of_settings_commands() -> None:
    named = re.findall(r"^\| `mip config (\w+) ", SETTINGS, re.M)
    assert f"  ACTION  {', '.join(named)}\n" in re.sub(r"(?m)^  ACTION +", "  ACTION  ", mip("config", "--help")[1])


# --------------------------------------------------------------------------- another language


@uses("node")
def test_another_language_from_the_first_block_to_the_last(tmp_path: Path) -> None:
    """A block below the name of a file is that file; the others are commands with their output."""
    path = os.pathsep.join((str(programs(tmp_path / "bin", mipgen="mipgen")), os.environ["PATH"]))
    environment = {**os.environ, "PATH": path, "PYTHONPATH": str(ROOT / "generator"), "LC_ALL": "C"}
    here = tmp_path / "here"
    here.mkdir()
    shown = re.findall(r"(?:^`(\S+)`:\n\n)?^```(\w*)\n(.*?)^```$", LANGUAGE, re.M | re.S)
    assert len(shown) == LANGUAGE.count("```") / 2 >= 10
    for file, kind, text in shown:
        if file:
            (here / file).parent.mkdir(parents=True, exist_ok=True)
            (here / file).write_text(text)
            continue
        assert kind == "console", text
        for command, output in re.findall(r"^\$ (.*\n)((?:[^$].*\n)*)", text, re.M):
            done = subprocess.run(
                ["sh", "-c", f"exec 2>&1; {command}"], cwd=here, env=environment, text=True, stdout=subprocess.PIPE
            )
            assert (command, done.stdout) == (command, output) and done.returncode == 0


def test_every_attribute_of_a_target_is_described() -> None:
    table = LANGUAGE.partition("\n| Attribute |")[2].partition("\n\n")[0]
    named = [name for row in table.splitlines()[2:] for name in re.findall(r"`(\w+)`", row.split("|")[1])]
    assert named == [f.name for f in fields(Target)]


# --------------------------------------------------------------------------- a specification


def test_the_specification_that_is_shown_is_complete(tmp_path: Path) -> None:
    core = section(SPEC, "A device of your own")
    files = re.findall(r"`([a-z/]+\.yaml)`, [^\n]*:\n\n```yaml\n(.*?)```", core, re.DOTALL)
    assert len(files) == core.count("```yaml") == 4
    for name, content in files:
        path = tmp_path / "spec" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content, "utf-8")
    model = load_model(tmp_path / "spec")
    assert [f.full_name for f in model.fields] == [
        "tools.ping", "tools.light", "tools.light_response", "measurements.environment",
    ]  # fmt: skip
    out = tmp_path / "out"
    assert cli.main(["generate", "--spec", str(tmp_path / "spec"), "--out", str(out), "--target", "python"]) == 0
    assert (out / "python/my_device_protocol/measurements.py").is_file()
