"""`mip completion`: scripts that complete commands, options and names of fields in a shell."""

from __future__ import annotations

import argparse

from ..binding import use
from . import COMMANDS, PACKAGE, loaded, without_package

EPILOG = """\
  bash:  mip completion bash > ~/.local/share/bash-completion/completions/mip
  zsh:   mip completion zsh > a folder of $fpath, as _mip
  fish:  mip completion fish > ~/.config/fish/completions/mip.fish

The scripts call `mip` for the words, so they complete the fields of the package in use.
"""

SCRIPTS = {
    "bash": """\
_mip() {
    local IFS=$'\\n' words=("${COMP_WORDS[@]:1:COMP_CWORD}") word=${COMP_WORDS[COMP_CWORD]}
    # Bash divides words at colons and equal signs, too.
    COMPREPLY=($(compgen -W "$(mip completion words -- "${words[@]}" 2>/dev/null)" -- "$word"))
    [[ ${#COMPREPLY[@]} -gt 0 ]] || compopt -o default
}
complete -F _mip mip
""",
    "zsh": """\
#compdef mip
_mip() {
    local -a found
    found=("${(@f)$(mip completion words -- "${(@)words[2,CURRENT]}" 2>/dev/null)}")
    found=(${found:#})
    if (( $#found )); then compadd -- $found; else _files; fi
}
if [[ $funcstack[1] == _mip ]]; then _mip "$@"; else compdef _mip mip; fi
""",
    "fish": """\
function __mip_words
    set -l words (commandline -opc) (commandline -ct)
    mip completion words -- $words[2..-1] 2>/dev/null
end
complete -c mip -a '(__mip_words)'
""",
}


def _shell(name: str) -> str:
    """Checks the name of a shell, or `words`, which only the scripts use."""
    if name not in (*SCRIPTS, "words"):
        raise argparse.ArgumentTypeError(f"'{name}' is not one of {', '.join(SCRIPTS)}")
    return name


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    parser.add_argument("shell", type=_shell, metavar="SHELL", help=", ".join(SCRIPTS))
    parser.add_argument("words", nargs="*", default=[], help=argparse.SUPPRESS)


def run(options: argparse.Namespace) -> int:
    if options.shell in SCRIPTS:
        print(SCRIPTS[options.shell], end="")
    else:
        print(*completions(options.words), sep="\n")
    return 0


def completions(typed: list[str]) -> list[str]:
    """Returns the words that can complete the last one."""
    package, typed = without_package(typed)
    if package is not None:
        use(package)
    *before, last = typed or [""]
    if not before:
        return [name for name in (*COMMANDS, "--help", PACKAGE, "--version") if name.startswith(last)]
    if before[0] not in COMMANDS:
        return []
    parser = argparse.ArgumentParser()
    loaded(before[0]).add_arguments(parser)
    actions = parser._actions  # argparse has no other way to ask
    option = next((a for a in actions if before[-1] in a.option_strings and a.nargs != 0), None)
    if option is not None:
        return [text for text in _values(option, before) if text.startswith(last)]
    if last.startswith("-"):
        return [o for a in actions for o in a.option_strings if o.startswith(last)]
    places = [a for a in actions if not a.option_strings]
    if "--hex" in before:
        places = places[1:]  # there is no port then
    taken = _positions(before[1:], actions)
    if taken >= len(places) and not (places and places[-1].nargs in ("+", "*")):
        return []
    candidates = _values(places[min(taken, len(places) - 1)], before)
    return [text for text in candidates if text.startswith(last)]


def _positions(words: list[str], actions: list[argparse.Action]) -> int:
    """Counts the words that are neither options nor values of options."""
    valued = {o for a in actions for o in a.option_strings if a.nargs != 0}
    options = {o for a in actions for o in a.option_strings}
    return sum(word not in options and (i == 0 or words[i - 1] not in valued) for i, word in enumerate(words))


def _values(action: argparse.Action, before: list[str]) -> list[str]:
    if action.choices is not None:
        return [str(choice) for choice in action.choices]
    kind = str(action.metavar or "")
    if kind == "SHELL":
        return list(SCRIPTS)
    from ..names import candidates  # noqa: PLC0415 (it needs the generated package, which is chosen by now)

    if kind == "DEVICE":
        return candidates.device_ids()
    if kind == "FUNCTION":
        return candidates.functions_of(before)
    if kind.startswith(("NAME", "FIELD", "COMMAND")):
        return candidates.field_names(only_commands=kind.startswith("COMMAND"))
    return []
