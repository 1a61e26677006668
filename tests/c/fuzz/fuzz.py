"""`make fuzz`: libFuzzer on each target for a while; inputs that reach new code are kept in corpus/, as text.

    make fuzz TIME=60 TARGETS="parser fields-invented"

An input that fails is shown as hexadecimal: after the repair it belongs into corpus/, as a line of its own.
"""

from __future__ import annotations

import argparse
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).parent
sys.path += [str(HERE.parent), str(HERE.parents[1]), str(HERE.parents[2] / "generator")]

import c_build  # noqa: E402
from seeds import seeds  # noqa: E402
from support import BUILD, model  # noqa: E402

#: Name -> source, and the specification whose library it runs. The parser is the same in both.
TARGETS = {
    "parser": ("parser", "real"),
    "fields": ("fields", "real"),
    "fields-invented": ("fields", "invented"),
    "client": ("client", "real"),
    "client-invented": ("client", "invented"),
}

FLAGS = ["-std=c99", "-g", "-O1", "-fsanitize=fuzzer-no-link,address,undefined", "-fno-sanitize-recover=all"]
LARGEST = {"parser": 800, "fields": 260, "client": 400}  # bytes of an input: what is kept stays small


def begin(name: str) -> list[bytes]:
    """The inputs that need no search."""
    source, spec = TARGETS[name]
    return seeds(source, model(spec))


def kept(name: str) -> list[bytes]:
    """The inputs of the kept corpus."""
    lines = (HERE / f"corpus/{name}.hex").read_text("ascii").splitlines()
    return [bytes.fromhex(line) for line in lines if line and not line.startswith("#")]


def keep(name: str, inputs: list[bytes]) -> None:
    head = f"# Inputs for {TARGETS[name][0]}.c that reach what the seeds do not, found by `make fuzz`; one per line.\n"
    lines = sorted({i.hex() for i in inputs}, key=lambda line: (len(line), line))
    (HERE / f"corpus/{name}.hex").write_text(head + "".join(f"{line}\n" for line in lines), "ascii")


def build(name: str, program: Path) -> Path:
    source, spec = TARGETS[name]
    library = c_build.archive(spec, "clang", *FLAGS)
    return c_build.compiled(program, spec, "clang", HERE / f"{source}.c", *FLAGS, "-fsanitize=fuzzer", library=library)


def write(folder: Path, inputs: list[bytes]) -> Path:
    folder.mkdir()
    for i, data in enumerate(inputs):
        (folder / f"{i:05}").write_bytes(data)
    return folder


def run(folder: Path, *arguments: str | Path) -> str:
    """The fuzzer, with a failure shown."""
    command = [folder / "program", f"-artifact_prefix={folder}/failure-", "-timeout=20", *arguments]
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode != 0:
        shown = [f"{path.name}: {path.read_bytes().hex()}" for path in sorted(folder.glob("failure-*"))]
        sys.exit("\n".join([done.stderr[-4000:], *shown]))
    return done.stderr


def fuzz(name: str, seconds: int) -> None:
    folder = BUILD / f"fuzz/{name}"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    build(name, folder / "program")
    first = write(folder / "seeds", begin(name))
    before = write(folder / "kept", kept(name))
    found = write(folder / "found", [])
    largest = LARGEST[TARGETS[name][0]]
    output = run(folder, f"-max_total_time={seconds}", f"-max_len={largest}", found, first, before)
    # What is needed beside the seeds, the smallest of those that reach the same; edges count, not how often.
    merged = write(folder / "merged", begin(name))
    known = {p.name for p in merged.iterdir()}
    run(folder, "-merge=1", "-use_counters=0", merged, before, found)
    keep(name, [p.read_bytes() for p in merged.iterdir() if p.name not in known])
    status = next((line.strip() for line in reversed(output.splitlines()) if "DONE" in line), "")
    print(f"{name}: {status}; {len(kept(name))} inputs kept")


def main() -> None:
    parser = argparse.ArgumentParser(prog="make fuzz")
    parser.add_argument("--time", type=int, default=60, metavar="SECONDS", help="for each target")
    parser.add_argument("--targets", nargs="*", default=list(TARGETS), choices=list(TARGETS))
    arguments = parser.parse_args()
    for name in arguments.targets:
        fuzz(name, arguments.time)


if __name__ == "__main__":
    main()
