"""The templates of a target: their files, filters, compiled forms and errors."""

from __future__ import annotations

import sys
import traceback
from collections.abc import Callable, Mapping
from typing import Any

import jinja2

from mipgen.base import cache
from mipgen.base.errors import Failure

from .discovery import RUNTIME, Source

SETTINGS: dict[str, Any] = {
    "trim_blocks": True,
    "lstrip_blocks": True,
    "keep_trailing_newline": True,
    "autoescape": False,
    "extensions": ["jinja2.ext.do"],
}

Filters = Mapping[str, Callable[..., Any]]


class Templates:
    def __init__(self, source: Source, filters: Filters, variables: Mapping[str, Any]) -> None:
        late = {name: _at_run_time(function) for name, function in filters.items()}
        self.source = source
        self.environment = jinja2.Environment(
            loader=jinja2.FunctionLoader(self._load),
            undefined=jinja2.StrictUndefined,
            bytecode_cache=_Compiled(late),
            **SETTINGS,
        )
        self.environment.filters.update(late)
        # TOML and YAML have no pairs of surrogates, as JSON writes a character beyond 16 bits in ASCII.
        self.environment.policies["json.dumps_kwargs"] = {"sort_keys": True, "ensure_ascii": False}
        self.environment.globals.update(variables)

    def render(self, template: str, context: Mapping[str, Any], path: str) -> str:
        """Renders the text of the file `path`."""
        try:
            return self.environment.get_template(template).render(context)
        except jinja2.TemplateNotFound as error:
            raise Failure(f"there is no template {error.name} (for {path})", f"target {self.source.name}") from None
        except jinja2.TemplateSyntaxError as error:
            raise Failure(f"{error.message} (for {path})", f"{error.filename}:{error.lineno}") from None
        except jinja2.TemplateRuntimeError as error:
            raise Failure(f"{error.message} (for {path})", self._place(error)) from None

    def _load(self, name: str) -> tuple[str, str, Callable[[], bool]] | None:
        """Finds a template; `runtime/NAME` is one of the files that are copied, of which a template can be made up."""
        inner = name.removeprefix(f"{RUNTIME}/")
        for folder in self.source.folders if inner == name else self.source.runtimes:
            path = folder / inner
            if path.is_file():
                return path.read_text("utf-8"), str(path), lambda: True
        return None

    def _place(self, error: BaseException) -> str:
        """Returns the line of a template where an error occurred."""
        folders = tuple(map(str, self.source.folders))
        frames = reversed(traceback.extract_tb(error.__traceback__))
        lines = (f"{f.filename}:{f.lineno}" for f in frames if f.filename.startswith(folders))
        return next(lines, f"target {self.source.name}")


class _Compiled(jinja2.BytecodeCache):
    """Caches compiled templates. Compiled code depends on which filters exist, and on their kinds."""

    def __init__(self, filters: Filters) -> None:
        kinds = sorted((name, str(getattr(function, "jinja_pass_arg", ""))) for name, function in filters.items())
        self.how = repr((jinja2.__version__, sys.version, sorted(SETTINGS.items()), kinds))

    def load_bytecode(self, bucket: Any) -> None:
        data = cache.get("templates", cache.key(self.how, bucket.key, bucket.checksum))
        if data is not None:
            bucket.bytecode_from_string(data)

    def dump_bytecode(self, bucket: Any) -> None:
        cache.put("templates", {cache.key(self.how, bucket.key, bucket.checksum): bucket.bytecode_to_string()})


def _at_run_time(function: Callable[..., Any]) -> Callable[..., Any]:
    """Protects a filter from calls at compile time, when Jinja would store the result in the cached code."""
    if hasattr(function, "jinja_pass_arg"):
        return function

    @jinja2.pass_context
    def call(_: Any, *arguments: Any, **named: Any) -> Any:
        return function(*arguments, **named)

    return call
