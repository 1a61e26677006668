"""What the README shows is what runs."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

from support import BUILD, ROOT, locked, need

README = (ROOT / "README.md").read_text("utf-8")


def block(language: str) -> str:
    found = re.findall(rf"```{language}\n(.*?)```", README, re.S)
    assert len(found) == 1, language
    return str(found[0])


def run(*command: str | Path, **environment: str) -> str:
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, env={**os.environ, **environment})
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_c(tmp_path: Path) -> None:
    source = (ROOT / "generated/c/taste.c").read_text("utf-8")
    assert source.partition("*/\n")[2].rstrip() == block("c").rstrip()
    sources = sorted((ROOT / "generated/c/src").glob("*.c"))
    run(
        need("gcc"),
        "-std=c99",
        f"-I{ROOT}/generated/c/include",
        ROOT / "generated/c/taste.c",
        *sources,
        "-o",
        tmp_path / "taste",
    )
    assert run(tmp_path / "taste") == "8 bytes to send\n0.2445 g along x\n"


def test_python() -> None:
    source = (ROOT / "generated/python/taste.py").read_text("utf-8")
    assert source.partition('"""\n\n')[2] == block("python")
    printed = run(sys.executable, ROOT / "generated/python/taste.py", PYTHONDONTWRITEBYTECODE="1")
    assert printed == "75 65 01 02 02 03 e2 c8\n0.2445 g along x\n"


def test_rust() -> None:
    source = (ROOT / "generated/rust/examples/taste.rs").read_text("utf-8")
    assert source == block("rust")
    crate = BUILD / "readme-rust"
    with locked(crate):
        (crate / "src").mkdir(parents=True, exist_ok=True)
        (crate / "src/main.rs").write_text(source)
        (crate / "Cargo.toml").write_text(
            '[package]\nname = "taste"\nversion = "0.0.0"\nedition = "2021"\n\n[workspace]\n\n'
            f'[dependencies]\nmip-protocol = {{ path = "{ROOT}/generated/rust" }}\n'
        )
        manifest = crate / "Cargo.toml"
        printed = run(
            need("cargo"),
            "run",
            "--quiet",
            "--offline",
            "--manifest-path",
            manifest,
            CARGO_TARGET_DIR=str(BUILD / "rust"),
        )
    assert printed == "8 bytes to send\n0.2445 g along x\n"


def test_every_target_of_make_is_there() -> None:
    makefile = (ROOT / "Makefile").read_text("utf-8")
    for name in set(re.findall(r"(?:`|^    )make ([a-z-]+)", README, re.M)):
        assert re.search(rf"^{name}:", makefile, re.M), name


def test_every_path_is_there() -> None:
    for path in re.findall(r"\]\(([^)#]+)\)", README):
        assert path.startswith("http") or (ROOT / path).exists(), path
    for folder in re.findall(r"^\| `(generated/\w+)` ", README, re.M):
        assert (ROOT / folder / "README.md").is_file(), folder


def test_the_field_that_it_shows_is_in_the_specification() -> None:
    shown = block("yaml").splitlines()
    there = (ROOT / "spec/sets/base.yaml").read_text("utf-8")
    for line in ("  - command: 0x09", "    name: comm_port_speed", "    functions: WRSLD"):
        assert line in shown and line in there
