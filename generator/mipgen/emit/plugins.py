"""Programs as targets: the model as JSON on standard input, files as JSON on standard output.

A plugin reads the content of `mip.json`, and writes `{"files": {"PATH": "TEXT", ...}}`; a file that is not text is
`{"base64": "..."}`. It may add `"title"`, which is shown like the titles of targets.
"""

from __future__ import annotations

import base64
import binascii
import contextlib
import json
import os
import re
import shutil
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

from mipgen.base import resources
from mipgen.base.errors import Failure

from . import output

_NAME = re.compile(r"[A-Za-z0-9][\w.-]*", re.ASCII)
_FORM = 'write {"files": {"PATH": "TEXT", ...}}'


def parse(text: str) -> tuple[str, str]:
    """Returns the name of a plugin and the path of its program, given as `PROGRAM` or `NAME=PROGRAM`."""
    name, equals, program = text.partition("=")
    if not equals or not _NAME.fullmatch(name):
        name, program = Path(text).stem, text
    if not _NAME.fullmatch(name):
        raise Failure("give its target a name: --plugin NAME=PROGRAM", f"plugin {text}")
    place = shutil.which(program)
    if place is None and not Path(program).is_file():
        raise Failure(f"there is no program {program}", f"plugin {name}")
    if place is None:
        remedy = f"chmod +x {program}" if os.sep in program else f"write ./{program}"
        raise Failure(f"{program} is a file that cannot be run as a program; {remedy}", f"plugin {name}")
    return name, place


def run(name: str, program: str, document: bytes) -> tuple[str, dict[str, bytes]]:
    """Runs a plugin. Returns its title, and all files that it makes from the model."""
    place = f"plugin {name}"
    answer = _parsed(_output(program, document, place), place)
    made: dict[str, bytes] = {"LICENSE": (resources.root() / "LICENSE").read_bytes()}
    for path, content in answer["files"].items():
        output.admit(path, made, place)
        made[path] = _bytes(content, f"{place}: {path}")
    return answer.get("title", f"made by {program}"), output.with_manifest(made, place)


def _output(program: str, document: bytes, place: str) -> bytes:
    """Runs the program and returns its output. It has its own process group, which is ended if this run is stopped."""
    try:
        process = subprocess.Popen(
            [program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True
        )
    except OSError as error:
        raise Failure(f"{program} cannot be run: {error.strerror}", place) from None
    with process:
        try:
            written, messages = process.communicate(document)
        except BaseException:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            raise
    text = messages.decode("utf-8", "replace").rstrip()
    if process.returncode != 0:
        raise Failure(f"{program} ended with status {process.returncode}{':' if text else ''}\n{text}".rstrip(), place)
    if text:
        print(text, file=sys.stderr)
    return written


def _parsed(written: bytes, place: str) -> dict[str, Any]:
    try:
        answer = json.loads(written.decode("utf-8"))
    except ValueError as error:
        raise Failure(f"its output is not JSON ({error}); {_FORM}", place) from None
    if not isinstance(answer, dict) or not isinstance(answer.get("files"), dict):
        raise Failure(f'its output has no object "files"; {_FORM}', place)
    unknown = sorted(answer.keys() - {"files", "title"})
    if unknown:
        raise Failure(f"""its output has '{unknown[0]}'; only "files" and "title" are known""", place)
    if not isinstance(answer.get("title", ""), str):
        raise Failure('"title" must be text', place)
    return answer


def _bytes(content: object, place: str) -> bytes:
    try:
        if isinstance(content, str):
            return content.encode("utf-8")
        if isinstance(content, dict) and content.keys() == {"base64"}:
            return base64.b64decode(content["base64"], validate=True)
    except (UnicodeError, TypeError, binascii.Error) as error:
        raise Failure(f"its content cannot be read: {error}", place) from None
    raise Failure('its content must be text, or {"base64": "..."}', place)
