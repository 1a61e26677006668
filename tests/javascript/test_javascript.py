"""The JavaScript modules, in Node."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import pytest
from mipgen import model as m
from mipgen.lower import codec
from mipgen.targets.javascript import names
from random_values import drawn
from support import BUILD, ROOT, SPECS, heavy, model, need, rounds, simulated, small, uses

pytestmark = uses("node")
GENERATED = ROOT / "generated/javascript"


def node(*arguments: str | Path, **environment: str) -> str:
    done = subprocess.run(
        [need("node"), *map(str, arguments)], capture_output=True, text=True, env={**os.environ, **environment}
    )
    assert done.returncode == 0, done.stdout[-4000:] + done.stderr[-4000:]
    return done.stdout


def answers(topic: str, spec: str, lines: Iterable[str]) -> list[Any]:
    """What the modules of a specification answer to each line."""
    command = [need("node"), ROOT / "tests/javascript/answers.mjs", SPECS[spec][1] / "javascript", topic]
    text = "".join(f"{line}\n" for line in lines)
    done = subprocess.run(command, input=text, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return list(json.loads(done.stdout))


@small("the real modules of JavaScript")
def test_unit(spec: str) -> None:
    said = node("--test", ROOT / "tests/javascript/unit.test.mjs", FOLDER=str(SPECS[spec][1] / "javascript"))
    assert int(re.findall(r"^# pass (\d+)", said, re.M)[0]) > 0


@small("the real modules of JavaScript")
def test_every_field_as_json_and_as_a_clone(spec: str) -> None:
    """All bits come back from JSON; from a clone, those of numbers."""
    of = model(spec)
    fields = [(f, codec.encode(f, values)) for f in of.fields for values in drawn(f, rounds(4, 40))]
    lines = (f"{f.full_name} {data.hex()}" for f, data in fields)
    texts = ""
    for (f, data), (back, clone, text) in zip(fields, answers("json", spec, lines), strict=True):
        assert back == data.hex(), (f.full_name, text)
        assert clone == data.hex() or '"0x' in text, f.full_name
        texts += text
    assert re.search(r':"\d{18,}"', texts) and re.search(r'"0x7f[89a-f]', texts)


def test_the_field_to_blame_for_a_rejection() -> None:
    """By the cases that all languages share."""
    cases = json.loads((ROOT / "tests/rejected.json").read_text("utf-8"))
    found = zip(cases, answers("rejected", "real", map(json.dumps, cases)), strict=True)
    assert [(c["title"], c["cause"], x) for c, x in found if c["cause"] != x] == []
    reasons = re.findall(r"^    reason: (.*);$", (GENERATED / "mip/index.d.mts").read_text("utf-8"), re.M)
    assert {json.dumps(c["cause"][3]) for c in cases if c["cause"]} <= set(reasons[0].split(" | "))


def test_devices_at_their_worst() -> None:
    said = node("--test", ROOT / "tests/javascript/device.test.mjs", FOLDER=str(GENERATED))
    assert int(re.findall(r"^# pass (\d+)", said, re.M)[0]) > 10


def test_the_quickstart_runs() -> None:
    quickstart = (GENERATED / "quickstart.mjs").read_text("utf-8")
    assert f"```javascript\n{quickstart}```" in (GENERATED / "README.md").read_text("utf-8")
    assert node(GENERATED / "quickstart.mjs") == "75 65 0c 08 08 0f 01 80 01 04 00 0a 95 dc\n0.2445 g along x\n"


def program(folder: Path, name: str) -> Path:
    """A program of the README, in a folder where the package is installed."""
    text = (ROOT / "examples" / name).read_text("utf-8")
    assert f"```javascript\n{text}```" in (GENERATED / "README.md").read_text("utf-8")
    package = folder / "node_modules/mip-protocol"
    package.parent.mkdir()
    package.symlink_to(GENERATED)
    path = folder / name
    path.write_text(text, "utf-8")
    return path


@heavy("a virtual device for JavaScript")
@pytest.mark.parametrize("device", ["3dm-cv7-gnss-ins", "3dm-gx5-15"])
def test_a_program_talks_to_a_device(device: str, tmp_path: Path) -> None:
    """Devices of two generations with different commands; only the older one lacks the command that is rejected."""
    path = program(tmp_path, "live.mjs")
    with simulated("--tcp", "0", device=device) as place:
        host, _, port = place.rpartition(":")
        text = path.read_text("utf-8")
        assert '"localhost", 5744' in text
        path.write_text(text.replace('"localhost", 5744', f'"{host}", {port}'), "utf-8")
        name, *rest = node(path).splitlines()
    assert name == {"3dm-cv7-gnss-ins": "3DM-CV7-GNSS/INS", "3dm-gx5-15": "3DM-GX5-15"}[device]
    refused = ["3dm.pps_source_control rejected (unknown command)"] if device == "3dm-gx5-15" else []
    assert rest[: len(refused)] == refused
    angles = rest[len(refused) :]
    assert len(angles) == 10
    assert all(re.fullmatch(r"(-?\d+\.\d{3} ?){3}", line) for line in angles)


@heavy("a virtual device for JavaScript")
def test_the_snippets_of_the_readme_run_in_a_copy_of_the_package(tmp_path: Path) -> None:
    """With the paths that it states, instead of an installed package."""
    readme = (GENERATED / "README.md").read_text("utf-8")
    shutil.copytree(GENERATED, tmp_path / "mip-protocol")
    stated = re.findall(r"`\./(mip-protocol/[\w/]+\.mjs)`", readme)
    assert len(stated) == 3 and all((tmp_path / path).is_file() for path in stated)
    blocks = re.findall(r"^```javascript\n(.*?)^```", readme, re.M | re.S)
    marks = ("rejections(", "ComplementaryFilter", "?? packet")
    explain, change, time = (next(b for b in blocks if mark in b) for mark in marks)
    main = f"""
        import {{ ComplementaryFilter }} from "./mip-protocol/3dm.mjs";
        import {{ LlhPosition }} from "./mip-protocol/gnss_data.mjs";
        import {{ ScaledAccel }} from "./mip-protocol/sensor.mjs";
        import {{ openTcp }} from "./mip-protocol/mip/tcp.mjs";
        import {{ Clock }} from "./mip-protocol/time.mjs";
        const [host, port, older] = process.argv.slice(2);
        {explain}
        if (older) {{
            {change}
            const {{ pitchRollTimeConstant, headingTimeConstant }} = await device.request(ComplementaryFilter.read());
            console.log(pitchRollTimeConstant, headingTimeConstant === setting.headingTimeConstant);
        }}
        for (const timestamp of [true, "gps"]) {{
            await device.stream([[ScaledAccel, 10]], {{ timestamp }});
            const packet = await device.next();
            {time}
            console.log(typeof time, packet.time(Clock.GPS) === undefined, packet.time(Clock.REFERENCE) === undefined);
        }}
        await device.stream([[LlhPosition, 1]], {{ set: 0x81 }}).catch((error) => console.log(error.message));
        await device.close();
    """
    for name in ("model", "rejected"):
        main = main.replace(f'"mip-protocol/{name}"', f'"./mip-protocol/{"mip/" * (name == "rejected")}{name}.mjs"')
    (tmp_path / "main.mjs").write_text(main, "utf-8")
    for name, more, wanted in (
        ("3dm-gx5-15", ["older"], ["7 true", "bigint false true", "bigint false true"]),
        ("3dm-cv7-ar", [], ["bigint true false", "bigint false true"]),
    ):
        with simulated("--tcp", "0", device=name) as place:
            said = node(tmp_path / "main.mjs", *place.rsplit(":", 1), *more).splitlines()
        assert said[:-1] == wanted
        assert "GNSS" in said[-1].partition("rejected")[2], said


def test_a_program_reads_a_log(tmp_path: Path) -> None:
    path = program(tmp_path, "decode_log.mjs")
    packet = bytes.fromhex("7565800e0e043e7a63a0bb8e3b297fe5bf7f84ee")
    (tmp_path / "log.bin").write_bytes(b"$GPGGA\r\n" + 3 * packet)
    said = subprocess.run([need("node"), path], cwd=tmp_path, capture_output=True, text=True, check=True).stdout
    assert said.count("128 ScaledAccel {") == 3
    assert said.endswith("8 bytes between packets\n")


def test_the_package_is_complete() -> None:
    about = json.loads((GENERATED / "package.json").read_text("utf-8"))
    assert about["engines"] == {"node": ">=18"}
    assert about["sideEffects"] is False
    assert "IMU" in about["keywords"]
    addressed = json.loads((BUILD / "invented/javascript/package.json").read_text("utf-8"))  # it has an address
    assert addressed["repository"] == {"type": "git", "url": addressed["homepage"]}
    assert not about.keys() & {"repository", "homepage"}
    for name, paths in about["exports"].items():
        for path in paths.values() if isinstance(paths, dict) else (paths,):
            assert (GENERATED / path).is_file(), name
    assert (GENERATED / about["types"]).is_file()


@small("the real modules of JavaScript")
def test_bits_have_their_masks(spec: str) -> None:
    """Of every bitfield, also of those with numbers of 64 bits, which are BigInts."""
    wanted: dict[str, dict[str, str]] = {}
    for t in model(spec).types:
        if isinstance(t, m.Bitfield):
            of = wanted.setdefault(f"{names.home(t)}.{names.class_name(t)}", {})
            of |= {names.constant(b.name): str(b.mask) for b in t.bits}
    code = """
        const wanted = JSON.parse(process.env.NAMES);
        const found = {};
        for (const name of wanted) {
            const [home, kind] = name.split(".");
            const of = (await import(`${process.env.FOLDER}/${home}.mjs`))[kind];
            found[name] = Object.fromEntries(Object.entries(of).map(([bit, mask]) => [bit, String(mask)]));
        }
        console.log(JSON.stringify(found));
    """
    folder = str(SPECS[spec][1] / "javascript")
    assert json.loads(node("--input-type=module", "-e", code, FOLDER=folder, NAMES=json.dumps([*wanted]))) == wanted


def test_every_export_is_in_the_readme() -> None:
    readme = (GENERATED / "README.md").read_text("utf-8")
    index = (GENERATED / "mip/index.mjs").read_text("utf-8") + (GENERATED / "mip/tools.mjs").read_text("utf-8")
    listed = (name.strip() for inner in re.findall(r"export \{([^}]*)\}", index) for name in inner.split(","))
    names = set(filter(None, listed))
    assert len(names) > 10
    for name in names:
        assert re.search(rf"\b{name}\b", readme), name
    assert (
        f"```typescript\n{(ROOT / 'examples/typed.mts').read_text('utf-8')}```" in readme
    )  # which test_types.py compiles
