"""The programs and commands in the README and on the page about specifications run."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import c_build
import crates
import program
import pytest
from c_build import SANITIZED, run
from program import blocks, section
from support import BUILD, PYTHONPATH, ROOT, driver, heavy, need, simulated, uses

README = (ROOT / "README.md").read_text("utf-8")
#: The README's section of programs.
PROGRAMS = README.partition("## First programs\n")[2].partition("\n## ")[0]
CONTRIBUTING = (ROOT / "CONTRIBUTING.md").read_text("utf-8")
SPECIFICATIONS = (ROOT / "docs/specifications.md").read_text("utf-8")


def block(language: str, title: str = "") -> str:
    """The one example in a language; of a section of the page about specifications, or of the README's programs."""
    (found,) = blocks(section(SPECIFICATIONS, title) if title else PROGRAMS, language)
    return found


def commands(title: str) -> list[list[str]]:
    """The commands of a section, without comments."""
    return [line.partition("#")[0].split() for line in program.commands(section(SPECIFICATIONS, title), "mipgen ")]


def test_quickstart_in_c(tmp_path: Path) -> None:
    program = c_build.compiled(tmp_path / "quickstart", "real", "cc", ROOT / "generated/c/quickstart.c", *SANITIZED)
    assert run(program) == "8 bytes to send\n0.2445 g along x\n"


def test_quickstart_in_python() -> None:
    printed = run(sys.executable, ROOT / "generated/python/quickstart.py", PYTHONDONTWRITEBYTECODE="1")
    assert printed == "75 65 01 02 02 03 e2 c8\n0.2445 g along x\n"


@pytest.mark.xdist_group("values-real")  # the process that has built the driver
@uses("cargo")
def test_quickstart_in_rust() -> None:
    """With the library of the driver: building it takes longer than anything else in `make test`."""
    of = driver("rust", "real")
    built = Path(of.command[0]).parents[2]
    folder = BUILD / "readme"
    manifest = (built / "Cargo.toml").read_text("utf-8").replace('"driver"', '"readme"')
    manifest = re.sub("(?m)^path = .*$", f'path = "{ROOT}/generated/rust/examples/quickstart.rs"', manifest, count=1)
    crates.write({"Cargo.toml": manifest.encode()}, folder)
    command = (need("cargo"), "run", "--release", "--offline", "--quiet", "--target-dir", built / "target")
    printed = run(*command, "--manifest-path", folder / "Cargo.toml", **of.environment)
    assert printed == "8 bytes to send\n0.2445 g along x\n"


def test_first_program_in_python() -> None:
    """On a virtual device, until it has printed a few lines."""
    environment = {**os.environ, "PYTHONPATH": PYTHONPATH}
    with simulated("--tcp", "0") as place:
        command = [sys.executable, "-u", "-c", block("python").replace("/dev/ttyACM0", place)]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment) as first:
            assert first.stdout is not None
            lines = [first.stdout.readline() for _ in range(3)]
            first.kill()
    assert all(re.fullmatch(r"\S.* -?[\d.e-]+ g\n", line) for line in lines), lines


@pytest.mark.parametrize("language", ["c", "cpp", "rust"])
def test_first_programs_are_parts_of_examples(language: str) -> None:
    """The examples are the files linked below each, which the tests of the language run."""
    shown, link = re.findall(rf"```{language}\n(.*?)```\n\nThe whole program: \[[^]]+\]\(([^)]+)\)", PROGRAMS, re.S)[0]
    lines = iter([line.strip() for line in (ROOT / link).read_text("utf-8").splitlines()])
    for line in filter(None, map(str.strip, shown.splitlines())):
        assert line in lines, line  # in this order


def test_first_page_is_short() -> None:
    prose = re.sub(r"<!-- a field.*?<!-- end of the field -->|```.*?```", "", README, flags=re.S)
    assert len(prose.split()) < 700


def test_every_target_of_make_is_there() -> None:
    makefile = (ROOT / "Makefile").read_text("utf-8")
    for name in set(re.findall(r"(?:`|^    )make ([a-z-]+)", README + SPECIFICATIONS + CONTRIBUTING, re.M)):
        assert re.search(rf"^{name}:", makefile, re.M), name


def test_every_path_is_there() -> None:
    pages = ("README.md", "CONTRIBUTING.md", ".github/SECURITY.md", "docs/architecture.md", "docs/specifications.md")
    for page in pages:
        for path in re.findall(r"\]\(([^)#]+)[^)]*\)", (ROOT / page).read_text("utf-8")):
            assert path.startswith("http") or ((ROOT / page).parent / path).exists(), (page, path)


def test_the_field_that_it_shows_is_in_the_specification() -> None:
    """The whole field, exactly as it is there: from its descriptor to the next one."""
    shown = block("yaml", "Correct a field")
    fields = re.split(r"^(?=  - command: )", (ROOT / "spec/sets/base.yaml").read_text("utf-8"), flags=re.M)
    assert shown.rstrip() in [f.rstrip() for f in fields]


def mipgen(folder: Path, command: list[str], *targets: str) -> str:
    """A command of the README, in a folder that has the specification; for these targets only."""
    if not (folder / "spec").exists():
        (folder / "spec").symlink_to(ROOT / "spec")
    assert command[0] == "mipgen"
    done = subprocess.run(
        [sys.executable, "-m", "mipgen", *command[1:], *(word for t in targets for word in ("--target", t))],
        capture_output=True, text=True, cwd=folder, env={**os.environ, "PYTHONPATH": str(ROOT / "generator")},
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize("target", ["python", pytest.param("c", marks=heavy("programs of the real C library"))])
def test_own_fields(target: str, tmp_path: Path) -> None:
    (own,) = commands("Add your own fields")
    file = tmp_path / "my_fields/sets/sensor.yaml"
    file.parent.mkdir(parents=True)
    file.write_text(block("yaml", "Add your own fields"))
    mipgen(tmp_path, own, target)
    out = tmp_path / "with_my_fields"
    if target == "c":
        assert "struct mip_sensor_ambient_light {" in (out / "c/src/mip/sensor.h").read_text()
        sources = sorted((out / "c/src/mip").glob("*/*.c"))
        run(need("cc"), "-std=c99", f"-I{out}/c/src", "-fsyntax-only", *sources)
        return
    code = "from mip_protocol import sensor; print(sensor.AmbientLight.SET, sensor.AmbientLight.DESCRIPTOR)"
    assert run(sys.executable, "-c", code, PYTHONPATH=str(out / "python")) == "128 122\n"


def test_a_part(tmp_path: Path) -> None:
    device, few = commands("Generate a part")
    said, part, *_ = mipgen(tmp_path, device, "python").splitlines()
    assert said.startswith("3dm-gx5-15: ") and part.startswith("a part of the specification; left out: ")
    code = "from mip_protocol import registry; print(len(registry.all_types()))"
    whole = int(run(sys.executable, "-c", code, PYTHONPATH=str(ROOT / "generated/python")))
    part = int(run(sys.executable, "-c", code, PYTHONPATH=str(tmp_path / "for_gx5/python")))
    assert 0 < part < whole
    mipgen(tmp_path, few, "c", "markdown")
    out = tmp_path / "few"
    assert sorted(p.stem for p in (out / "markdown/docs/sets").iterdir()) == ["3dm", "base"]
    run(need("cc"), "-std=c99", f"-I{out}/c/src", "-fsyntax-only", *sorted((out / "c/src/mip").glob("*/*.c")))
