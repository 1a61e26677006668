"""The program: `python -m mipgen`, and `mipgen` where it is installed."""

import gc
import io
import os
import sys
from typing import NoReturn

from mipgen.cli import main


def run() -> NoReturn:
    for stream in (sys.stdout, sys.stderr):  # characters that the terminal cannot show are escaped
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")
    gc.disable()  # a run is short and makes little garbage; searching for it takes a tenth of a second
    os._exit(main())  # freeing a model, object by object, takes as long as a target


if __name__ == "__main__":
    run()
