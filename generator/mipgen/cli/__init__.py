"""The command line: `arguments` says what may be given, `commands` does it."""

from .arguments import main, parser

__all__ = ["main", "parser"]
