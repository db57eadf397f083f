"""Load a LinuxCNC compensation file (``COMP_FILE``) as the control does, up to the first bad line.

The control reads pieces of up to 254 bytes. It takes the first three numbers of each piece, as
``scanf`` of the language C does. It stops at the first piece without three numbers: the rest of the
file is never read and nothing is reported. It drops a row that does not ascend, and every row after
256, with an operator error, and continues to run.

Observed on LinuxCNC 2.9.0~pre1 (Debian 12) and read in its source (``usrmotLoadComp``,
``EMCMOT_SET_JOINT_COMP``); unchanged up to 2.9.9.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from compwright.records.axis import FloatArray

#: Rows per joint (EMCMOT_COMP_SIZE).
MAX_ROWS = 256
#: Longest piece of a line that is taken at once, in bytes (LINELEN less the terminator).
LONGEST_PIECE = 254

# What scanf's %lf consumes: an exponent mark may stand without digits, "infi" fails where "inf"
# does not.
_NUMBER = re.compile(
    rb"""[ \t\n\v\f\r]*
        ([+-]?)
        (?:(?P<nan>nan)
          |(?P<inf>inf(?:inity|(?!i)))
          |0x(?P<hex>[0-9a-f]+(?:\.[0-9a-f]*)?|\.[0-9a-f]+)(?:p(?P<hexpower>[+-]?[0-9]*))?
          |0x(?P<hexpoint>\.)
          |(?!0x)(?P<decimal>[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:e(?P<power>[+-]?[0-9]*))?)""",
    re.VERBOSE | re.IGNORECASE,
)


@dataclass(frozen=True, slots=True)
class CompTable:
    """The table rows as the control stores them (positions double, corrections single precision).

    ``nominal`` (k,): positions, machine units. ``forward``, ``reverse`` (k,): corrections going +
    and -, machine units. ``forward_slope``, ``reverse_slope`` (k,): slopes of the corrections to
    the next row. ``notes``: one sentence, with its line, for each part of the file that is not
    loaded.
    """

    nominal: FloatArray
    forward: FloatArray
    reverse: FloatArray
    forward_slope: FloatArray
    reverse_slope: FloatArray
    notes: tuple[str, ...]

    @property
    def defined(self) -> bool:
        """Return whether all entries are finite. Otherwise the control's motion is undefined."""
        columns = (self.nominal, self.forward, self.reverse, self.forward_slope, self.reverse_slope)
        return all(bool(np.all(np.isfinite(column))) for column in columns)


def load_table(content: bytes, file: str, comp_type: int) -> CompTable:
    """Return the table that the control has after loading ``content``. Lines that it cannot read
    give notes; nothing is raised. ``comp_type``: the value of COMP_FILE_TYPE.

    With type 0 the columns are nominal position, actual position going + and actual position going
    -; correction = nominal - actual. With any other type the second and third column are the
    corrections, which are added to the command.
    """
    rows: list[tuple[float, float, float]] = []
    notes: list[str] = []
    for line, piece, rest in _pieces(content):
        row = three_numbers(piece)
        if row is None:
            if piece.strip() or rest.strip():
                notes.append(
                    f"{file}: line {line}: no three numbers: the control stops reading here without"
                    f" a message{_lost(rest)}"
                )
            break
        if len(rows) >= MAX_ROWS:
            notes.append(
                f"{file}: line {line}: more than {MAX_ROWS} rows: the control reports an error and"
                " drops the rest"
            )
            break
        if row[0] <= (rows[-1][0] if rows else -sys.float_info.max):
            notes.append(
                f"{file}: line {line}: position {row[0]:g} does not ascend: the control reports an"
                " error and drops the row"
            )
        else:
            rows.append(row)
            if not _plain(piece):
                notes.append(
                    f"{file}: line {line}: only the first three numbers count: {row[0]:g}"
                    f" {row[1]:g} {row[2]:g}"
                )
    return _stored(rows, comp_type, notes)


def _plain(piece: bytes) -> bool:
    """Return whether a piece of the file (as the control reads it) is exactly one row of separate
    numbers.
    """
    words = piece.split(maxsplit=3)
    one_row = not any(mark in piece.strip() for mark in (b"\r", b"\x00"))
    return one_row and all(_NUMBER.fullmatch(word) for word in words[:3])


def _lost(rest: bytes) -> str:
    lines = sum(1 for line in rest.split(b"\n") if line.strip())
    return f"; {lines} further line{'' if lines == 1 else 's'} not loaded" if lines else ""


def _pieces(content: bytes) -> Iterator[tuple[int, bytes, bytes]]:
    """Yield the pieces that the C function ``fgets`` reads from a file: line number, the piece, and
    the text after it.
    """
    start, line = 0, 1
    while start < len(content):
        newline = content.find(b"\n", start, start + LONGEST_PIECE)
        end = newline + 1 if newline >= 0 else min(start + LONGEST_PIECE, len(content))
        yield line, content[start:end], content[end:]
        line += 1 if newline >= 0 else 0
        start = end


def three_numbers(piece: bytes) -> tuple[float, float, float] | None:
    """Return the three numbers that C's ``sscanf("%lf %lf %lf")`` would find; None for fewer."""
    text = piece.split(b"\x00", 1)[0]
    found: list[float] = []
    start = 0
    while len(found) < 3:
        match = _NUMBER.match(text, start)
        if match is None:
            return None
        found.append(_value(match))
        start = match.end()
    return found[0], found[1], found[2]


def leading_number(text: str) -> float | None:
    """Return the number that C's ``%lf`` would find at the start of ``text``; None if there is no
    number.
    """
    match = _NUMBER.match(text.encode("utf-8", "replace"))
    return None if match is None else _value(match)


def _value(match: re.Match[bytes]) -> float:
    negative = match.group(1) == b"-"
    if match["nan"]:
        value = float("nan")
    elif match["inf"]:
        value = float("inf")
    elif match["hexpoint"]:
        value = 0.0
    elif match["hex"] is not None:
        value = _hexadecimal(match["hex"].decode("ascii"), match["hexpower"])
    else:
        value = float(match["decimal"].decode("ascii") + _power("e", match["power"]))
    return -value if negative else value


def _hexadecimal(digits: str, power: bytes | None) -> float:
    try:
        return float.fromhex("0x" + digits + _power("p", power))
    except OverflowError:
        return float("inf")


def _power(mark: str, power: bytes | None) -> str:
    digits = (power or b"").decode("ascii")
    return mark + digits if digits.strip("+-") else ""


def _stored(rows: list[tuple[float, float, float]], comp_type: int, notes: list[str]) -> CompTable:
    """Return the rows of a file as the table that the control stores, in single precision.
    ``comp_type``: the value of COMP_FILE_TYPE, as in `load_table`.
    """
    columns = np.array(rows, dtype=np.float64).reshape(-1, 3)
    nominal = columns[:, 0].copy()
    with np.errstate(over="ignore", invalid="ignore", divide="ignore", under="ignore"):
        trims = nominal[:, None] - columns[:, 1:] if comp_type == 0 else columns[:, 1:]
        single = trims.astype(np.float32)
        slopes = np.zeros_like(single)
        # differences in single, the quotient in double, stored in single
        slopes[:-1] = np.diff(single, axis=0).astype(np.float64) / np.diff(nominal)[:, None]
    table = CompTable(
        nominal=nominal,
        forward=single[:, 0].astype(np.float64),
        reverse=single[:, 1].astype(np.float64),
        forward_slope=slopes[:, 0].astype(np.float64),
        reverse_slope=slopes[:, 1].astype(np.float64),
        notes=tuple(notes),
    )
    if table.defined:
        return table
    return replace(
        table,
        notes=(
            *notes,
            "a number that is not finite is in the table: the control's motion is not defined",
        ),
    )
