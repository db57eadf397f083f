"""Characters that a serial line (RS-232, paper tape) adds around the text of a control's file."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from compwright.records.correction import ControlFile

#: NUL, DC1 to DC4, SUB (Ctrl-Z), DEL.
_CODES = b"\x00\x11\x12\x13\x14\x1a\x7f"
_AROUND = _CODES + b" \t\r\n\x0b\x0c"
_CODE = re.compile(b"[" + _CODES + b"]")
#: Bytes that no text holds.
_NO_TEXT = re.compile(rb"[\x00-\x08\x0e-\x1f]")


def from_line(name: str, raw: bytes, folder: str = "") -> ControlFile:
    """Return a control's file, in which the characters that a serial line added before and after
    the text are separated from the text. ``folder``: the folder that the user named in place of the
    file, or "".
    """
    head = raw[: len(raw) - len(raw.lstrip(_AROUND))]
    tail = raw[len(raw.rstrip(_AROUND)) :]
    begin = max((match.end() for match in _CODE.finditer(head)), default=0)
    first = _CODE.search(tail)
    end = len(raw) if first is None else len(raw) - len(tail) + first.start()
    if end <= begin or (begin == 0 and end == len(raw)) or _NO_TEXT.search(raw, begin, end):
        return ControlFile(name, raw, folder)
    return ControlFile(name, raw[begin:end], folder, raw[:begin], raw[end:])


def as_on_line(files: Sequence[ControlFile], own: Sequence[ControlFile]) -> tuple[ControlFile, ...]:
    """Return new files with the serial-line characters that the control's own files have."""
    around = {file.name: (file.leader, file.trailer) for file in own}
    return tuple(
        replace(file, leader=around[file.name][0], trailer=around[file.name][1])
        if file.name in around
        else file
        for file in files
    )


def whole(files: Sequence[ControlFile]) -> tuple[ControlFile, ...]:
    """Return the files as they were originally: with the characters that the serial transmission
    added (such as ``%``, DC2, NUL), which the reader had removed from their contents.
    """
    return tuple(
        replace(file, content=file.raw, leader=b"", trailer=b"")
        if file.leader or file.trailer
        else file
        for file in files
    )
