"""Replace command-line options by the library's argument names in error messages."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection
from dataclasses import replace
from functools import wraps
from inspect import signature
from typing import Final, ParamSpec, TypeVar

from compwright.foundations.errors import CompwrightError, Fault

P = ParamSpec("P")
T = TypeVar("T")

#: Options whose argument has another name.
_RENAMED: Final = {"out": "folder", "option": "options", "with-tables": "tables"}
#: Options without a value.
_SWITCHES: Final = ("force", "accept_worse")
#: A command, an option with the value to copy, or an option alone.
_OPTION = re.compile(r"`compwright [^`]*`|`--([a-z-]+) ([^`]+)`|--([a-z-]+)")
_NUMBER = re.compile(r"-?\d+(\.\d+)?")


def in_argument_names(function: Callable[P, T]) -> Callable[P, T]:
    """Return ``function`` wrapped so that its error messages name arguments (``force=True``)
    instead of options (``--force``).

    Options for which the function has no argument, and whole commands, are not changed.
    """

    @wraps(function)
    def called(*args: P.args, **kwargs: P.kwargs) -> T:
        try:
            return function(*args, **kwargs)
        except CompwrightError as error:
            known = signature(function).parameters.keys()
            error.faults = tuple(_renamed(fault, known) for fault in error.faults)
            error.args = ("\n".join(error.lines()),)
            raise

    return called


def _renamed(fault: Fault, known: Collection[str]) -> Fault:
    def argument(found: re.Match[str]) -> str:
        given, value, alone = found.groups()
        option = given or alone or ""
        name = _RENAMED.get(option, option.replace("-", "_"))
        if name not in known:
            return found[0]
        if name in _SWITCHES:
            return f"{name}=True"
        if value is None:
            return name
        key, mark, text = value.partition("=")
        if name != "options" or not mark:
            return f'`{name}="{value}"`'
        text = text if _NUMBER.fullmatch(text) else f'"{text}"'
        return f'`options={{"{key}": {text}}}`'

    return replace(
        fault,
        message=_OPTION.sub(argument, fault.message),
        place=_OPTION.sub(argument, fault.place),
        expected=_OPTION.sub(argument, fault.expected),
        hint=_OPTION.sub(argument, fault.hint),
    )
