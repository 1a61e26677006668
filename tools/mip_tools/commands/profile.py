"""`mip profile`: writes what a device reports about itself as a file for a specification."""

from __future__ import annotations

import argparse
import sys
from datetime import date
from pathlib import Path

from ..errors import Failure
from ..files import outputs, signals
from ..options import add_baud, add_device, line_of
from ..ports import connection, device_file
from ..ports.listing import ask

EPILOG = """\
examples:
  mip profile /dev/ttyACM0                   writes devices/MODEL.yaml below the current folder
  mip profile /dev/ttyACM0 --spec spec       the same below spec
  mip profile localhost:5000 --dry-run       prints what would be written

The device is set to idle while it is queried, and resumes afterwards. The file states the model,
the firmware and the date as evidence, and contains no serial number. For a model in the generated
package, the file extends its profile. If the file exists, the list is written to a file beside it,
devices/MODEL-FIRMWARE.yaml. `mipgen validate` checks the files.
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("port", metavar="PORT", help="a port such as /dev/ttyACM0, COM3, HOST:PORT, rfc2217://HOST:PORT")
    add("--spec", type=Path, default=Path(), metavar="FOLDER", help="a specification or an overlay (default: .)")
    add("--dry-run", "--stdout", action="store_true", dest="dry_run", help="print the file, write nothing")
    add_device(parser)
    add_baud(parser)


def run(options: argparse.Namespace) -> int:
    folder: Path = options.spec
    if not folder.is_dir():
        raise Failure(f"{folder} is not a folder; create it, or name another one with --spec")
    with signals.handled(signals.interrupt), connection.opened(line_of(options, options.port)) as link:
        listing = ask(link, options.port, _complain)
    facts = device_file.Facts(device_file.named(listing, options.device, _complain), listing, date.today().isoformat())
    text = device_file.file_text(facts, folder)
    for contradiction in facts.contradictions():
        _complain(contradiction)
    if options.dry_run:
        sys.stdout.write(text)
        return 0
    path = device_file.place(facts, folder)
    _write(path, text)
    fields, undefined = (sum(map(len, x.values())) for x in (facts.fields(), facts.undefined()))
    what = f"{fields} commands and data fields, {undefined} undefined descriptors"
    print(f"{path}: {facts.model.title}, firmware {listing.firmware}: {what}")
    return 0


def _complain(text: str) -> None:
    print(f"mip profile: {text}", file=sys.stderr)


def _write(path: Path, text: str) -> None:
    try:
        path.parent.mkdir(exist_ok=True)
    except OSError as error:
        raise Failure(f"{path.parent} cannot be created: {error.strerror}") from None
    with outputs.whole(str(path)) as file:
        file.write(text.encode("utf-8"))
