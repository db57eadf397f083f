"""Read plain CSV in a Windows code page, because the numbers and key words are the same in all
these code pages.

Numbers, directions and key words are ASCII. Only free text may contain other characters: comment
lines, and names in the header row. If it does, a finding reports the code page that was assumed.
"""

from __future__ import annotations

from dataclasses import replace

from compwright.foundations.errors import InputError
from compwright.foundations.findings import Finding
from compwright.instruments.comments import comment_text
from compwright.instruments.csv_table import first_row
from compwright.instruments.fault_list import shown
from compwright.instruments.text_input import read_any_lines, read_lines

_NAMES = {"cp1252": "Windows-1252", "cp1251": "Windows-1251", "gbk": "GBK"}


def read_plain_lines(content: bytes, file: str) -> tuple[list[str], Finding | None]:
    """Return the lines of a plain CSV file, and the finding that its code page was assumed; None in
    place of the finding for UTF-8.

    Raises InputError as `read_lines` does. Raises it also if the file is not UTF-8 and a row of
    readings contains other characters than ASCII, because they may change a reading.
    """
    try:
        return read_lines(content, file), None
    except InputError as strict:
        try:
            lines, encoding = read_any_lines(content, file)
        except InputError:
            raise strict from None
        name = _NAMES.get(encoding, encoding)
        header = first_row(lines)
        foreign = {n: line for n, line in enumerate(lines, start=1) if not line.isascii()}
        for number, line in foreign.items():
            if comment_text(line) is None and (header is None or number != header[0]):
                faults = [
                    replace(fault, place=f"line {number}", found=f"{shown(line)} ({name})")
                    for fault in strict.faults
                ]
                raise InputError(*faults) from None
        return lines, _finding(name, *next(iter(foreign.items())))


def _finding(name: str, number: int, line: str) -> Finding:
    return Finding.of("CW-R062", "info", code_page=name, line=number, text=shown(line.strip()))
