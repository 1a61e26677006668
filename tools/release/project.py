"""What building and publishing share: where the project is, what it is called, and its files."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
GENERATED = ROOT / "generated"
VERSION = re.search(r"^version: (\S+)", (ROOT / "spec/protocol.yaml").read_text("utf-8"), re.M)[1]  # type: ignore[index]
REPOSITORY = "".join(re.findall(r"^repository: (\S+)", (ROOT / "spec/protocol.yaml").read_text("utf-8"), re.M))
UNPUBLISHED = "spec/protocol.yaml names no repository, so that no package says where it is from: nothing is published"

#: The manifests that name the public repository, and how. The generator writes those in generated/.
MANIFESTS = {
    "CITATION.cff": r"^repository-code: \"?([^\"\s]+)",
    "pyproject.toml": r"^Repository = \"(.*)\"",
    "tools/pyproject.toml": r"^Repository = \"(.*)\"",
    "tools/mip_simulator/pyproject.toml": r"^Repository = \"(.*)\"",
    "generated/c/idf_component.yml": r"^repository: (.*)",
    "generated/c/library.json": r"\"type\": \"git\", \"url\": \"(.*?)\"",
    "generated/c/library.properties": r"^url=(.+)",  # Arduino requires the key, even if empty
    "generated/javascript/package.json": r"\"type\": \"git\", \"url\": \"(.*?)\"",
    "generated/python/pyproject.toml": r"^Repository = \"(.*)\"",
    "generated/ros2/package.xml": r"<url type=\"repository\">(.*)</url>",
    "generated/rust/Cargo.toml": r"^repository = \"(.*)\"",
}


def other_addresses(root: Path, repository: str) -> dict[str, list[str]]:
    """The manifests that name another repository than this one, or none, or one without need."""
    named = {name: re.findall(pattern, (root / name).read_text("utf-8"), re.M) for name, pattern in MANIFESTS.items()}
    return {name: addresses for name, addresses in named.items() if addresses != [repository] * bool(repository)}


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
