"""Recognise, by its contents, a file that is of a different kind than the command expects, such as
a plan in place of a job.

The error for such a file states its kind and the command that reads it.
"""

from __future__ import annotations

import re
from typing import Final

from compwright.foundations.errors import Fault, InputError, UsageError
from compwright.foundations.input_sizes import (
    CONTROL,
    DEFINITION,
    JOB,
    MACHINE,
    MEASUREMENT,
    PLAN,
    PROFILE,
    InputKind,
)

#: A document of compwright says what it is in its first lines.
_HEAD: Final = 4000
_SCHEMA: Final = re.compile(rb'^\s*\{\s*"schema"\s*:\s*"compwright/([a-z_]+)/')
#: The first key that is a mark says what a YAML file is.
_MARK: Final = re.compile(
    rb"^(compwright_profile|compwright_format|virtual_machine|compwright)[ \t]*:", re.MULTILINE
)
_TEST: Final = re.compile(
    rb"^(\s*HEADER::|\s*\W?target_(mm|deg)\b|direction,.*\bangle_deg\b|\s*TGT_DATA)", re.MULTILINE
)
#: A file of a control: an archive, numbered parameters, values of variables.
_CONTROL: Final = re.compile(
    rb"\A(@@[A-Z]{3}|%(\([^)\n]*\))?\s*N\d{4,5}(Q\d)?[AP])|^\$[A-Z]{2}_\w+\[", re.MULTILINE
)
_PAGE: Final = re.compile(rb"^\s*<(!doctype html|html)\b", re.IGNORECASE)
_MARKED: Final = {
    b"compwright": JOB.name,
    b"compwright_profile": PROFILE.name,
    b"compwright_format": DEFINITION.name,
    b"virtual_machine": MACHINE.name,
}
#: What takes a file of a kind.
_TAKEN_BY: Final = {
    JOB.name: "compwright run",
    PLAN.name: "compwright compare, verify --plan",
    PROFILE.name: "--profile",
    DEFINITION.name: "--format",
    MACHINE.name: "compwright simulate",
    MEASUREMENT.name: "compwright evaluate",
    CONTROL.name: "compwright decode",
}
#: A wrong file in the place of these is a wrong use of the command line; else it is a wrong input.
_USAGE: Final = (JOB, PROFILE, MACHINE, DEFINITION)
_CHECKED: Final = (*_USAGE, PLAN, MEASUREMENT, CONTROL)


def refuse_other_kind(content: bytes, kind: InputKind, file: str) -> None:
    """Raise an error if ``content`` is a known file of a kind other than ``kind``.

    Raises UsageError if a job, profile, definition or virtual machine was expected, else
    InputError.
    """
    if kind not in _CHECKED:
        return
    found = _kind_of(content)
    if found in ("", kind.name):
        return
    taken = _TAKEN_BY.get(found)
    fault = Fault(
        message=f"this is {found}{f' ({taken})' if taken else ''}, not {kind.name}",
        file=file,
        hint=f"give {kind.help}",
    )
    raise (UsageError if kind in _USAGE else InputError)(fault)


def _kind_of(content: bytes) -> str:
    """Return the kind of a file, such as "a page to read", or "" if it is unknown."""
    head = content[:_HEAD]
    schema = _SCHEMA.match(head)
    if schema is not None:
        name = schema[1].decode("ascii")
        return PLAN.name if name == "plan" else f"{name}.json of compwright, a result"
    if _PAGE.match(head):
        return "a page to read"
    mark = _MARK.search(head)
    if mark is not None:
        return _MARKED[mark[1]]
    if _CONTROL.search(head):
        return CONTROL.name
    return MEASUREMENT.name if _TEST.search(head) else ""
