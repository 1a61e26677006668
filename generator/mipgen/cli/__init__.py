"""The command line: `arguments` defines the arguments, `commands` executes the commands."""

from .arguments import main, parser

__all__ = ["main", "parser"]
