"""The program: `python -m mipgen`, and `mipgen` where it is installed."""

import gc
import sys

from .cli import main


def run() -> int:
    gc.disable()  # a run is short, and little of it becomes garbage; looking for it takes a tenth of a second
    return main()


if __name__ == "__main__":
    sys.exit(run())
