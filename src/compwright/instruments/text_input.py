"""Read the bytes of a measurement file as numbered lines of text. Bytes that are not text are
refused.
"""

from __future__ import annotations

import codecs
import re
from collections.abc import Sequence

from compwright.foundations.errors import Fault, InputError

#: First bytes of files that people hand over instead of a text export -> what they are.
_SIGNATURES = (
    (b"\xd0\xcf\x11\xe0", "an old Excel workbook (.xls)"),
    (b"%PDF", "a PDF document"),
    (b"\x89PNG", "a picture"),
    (b"\xff\xd8\xff", "a picture"),
)
_LINE_END = re.compile(r"\r\n|\r|\n")
#: Control characters that no text export holds; tab, line feed and carriage return are text.
_CONTROL = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f]")
#: A number with its decimals, if it has a decimal mark.
_LAST_NUMBER = re.compile(r"[+-]?[0-9]*(?:[.,](?P<decimals>[0-9]*))?(?:[eE][+-]?[0-9]*)?")
_WANTED = "a text file in UTF-8, or in UTF-16 with byte order mark"
_GIVE_TEXT = "give the file that the instrument wrote as text, or save the sheet as CSV UTF-8"
_SAVE_AGAIN = (
    "UTF-8: save the file again with that encoding (editor: save as, encoding UTF-8; spreadsheet:"
    " CSV UTF-8), or write u for µ and deg for °"
)


#: Bytes beyond ASCII that stand side by side: Chinese text has them in pairs, Cyrillic text has
#: words of them, western text has single ones.
_HIGH_BYTES = re.compile(rb"[\x80-\xff]+")
#: A Cyrillic word in cp1251.
_CYRILLIC = re.compile(rb"[\xc0-\xff\xa8\xb8]{3,}")


def read_lines(content: bytes, file: str) -> list[str]:
    """Return the lines of a text file without their ends (LF, CRLF or CR). Line n of the file is
    item n - 1.

    The text is UTF-8 with or without a byte order mark, or UTF-16 with one. Raises InputError for
    an empty file, for a binary file (with its type if its first bytes show it), and for text in
    another encoding (with the line of the first wrong byte).
    """
    _refuse_other_files(content, file)
    return _lines(_decode(content, file), file)


def read_any_lines(content: bytes, file: str, encoding: str | None = None) -> tuple[list[str], str]:
    """Return the lines of a text file and the name of its encoding, which may be an old Windows
    code page.

    If ``encoding`` is not given, it is determined by `encoding_of`. Raises InputError for a binary
    file and for bytes that are invalid in that encoding.
    """
    _refuse_other_files(content, file)
    name = encoding or encoding_of(content)
    try:
        text = content.decode("utf-8-sig" if name == "utf-8" else name)
    except (UnicodeDecodeError, LookupError) as error:
        known = not isinstance(error, LookupError)
        raise InputError(
            Fault(
                message="the file is not text in the encoding that was named"
                if encoding
                else "the file is not text",
                file=file,
                expected="the encoding in which the file was written: utf-8, utf-16, cp1252, ..",
                found=f"{name}{'' if known else ', which is not known'}",
                hint="correct `encoding` in the profile, or save the file as UTF-8",
            )
        ) from error
    return _lines(text, file), name


def encoding_of(content: bytes) -> str:
    """Return the most probable encoding of ``content``.

    A byte order mark shows UTF-16. Otherwise valid UTF-8 is taken as UTF-8. For other content there
    are three code pages: cp1251 if most bytes beyond ASCII are in words of Cyrillic letters, gbk if
    all these bytes are in pairs, else cp1252.
    """
    if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return "utf-16"
    try:
        content.decode("utf-8-sig")
    except UnicodeDecodeError:
        runs = _HIGH_BYTES.findall(content)
        words = [run for run in runs if _CYRILLIC.fullmatch(run)]
        if 2 * len(b"".join(words)) > len(b"".join(runs)):
            return "cp1251"
        return "gbk" if all(len(run) % 2 == 0 for run in runs) and _decodes(content) else "cp1252"
    return "utf-8"


def _decodes(content: bytes) -> bool:
    try:
        content.decode("gbk")
    except UnicodeDecodeError:
        return False
    return True


def _refuse_other_files(content: bytes, file: str) -> None:
    for signature, name in _SIGNATURES:
        if content.startswith(signature):
            raise InputError(
                Fault(
                    message="the file is not a text file",
                    file=file,
                    expected=_WANTED,
                    found=name,
                    hint=(
                        "give the file that the instrument wrote as text, or save the "
                        "sheet as CSV UTF-8"
                    ),
                )
            )


def _lines(text: str, file: str) -> list[str]:
    if not text.strip("\ufeff \t\r\n"):
        typed = file.lower().endswith((".csv", ".txt"))
        raise InputError(
            Fault(
                message="the file is empty",
                file=file,
                expected="a header row and readings" if typed else "the readings of an instrument",
                hint=(
                    "add a header row and the readings"
                    if typed
                    else "copy the file from the instrument again"
                ),
            )
        )
    control = _CONTROL.search(text)
    if control:
        raise InputError(
            Fault(
                message="the file is a binary file",
                file=file,
                place=f"line {_line_number(text[: control.start()])}",
                expected=_WANTED,
                found=f"control character 0x{ord(control.group()):02X}",
                hint=_GIVE_TEXT,
            )
        )
    return text.lstrip("\ufeff").replace("\r\n", "\n").replace("\r", "\n").split("\n")


def unfinished_number(lines: Sequence[str]) -> str:
    """Return the last number of a file if the file may have been cut off within it, so that digits
    may be missing; else "".

    The number is complete if the numbers at the ends of all similar lines have the same number of
    decimals as it, and at least one.
    """
    last = _LAST_NUMBER.fullmatch(_last_cell(lines[-1]))
    if last is None or not last.group():
        return ""
    kind = _kind(lines[-1])
    rows = [line for line in lines[:-1] if line.strip() and not line.lstrip(' "').startswith("#")][
        0 if kind else 1 :
    ]
    others = [_LAST_NUMBER.fullmatch(_last_cell(line)) for line in rows if _kind(line) == kind]
    decimals = {None if other is None else len(other["decimals"] or "") for other in others}
    whole = decimals == {len(last["decimals"] or "")} and decimals != {0}
    return "" if whole else last.group()


def _last_cell(line: str) -> str:
    delimiter = next((mark for mark in "=;\t," if mark in line), " ")
    return line.rstrip(" ").rpartition(delimiter)[2].strip('" ')


def _kind(line: str) -> str:
    """Return the key of a line ``KEY[index]=value``, or an empty text for a row of a table."""
    return line.partition("[")[0].strip() if "=" in line else ""


def _decode(content: bytes, file: str) -> str:
    utf16 = content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    try:
        return content.decode("utf-16" if utf16 else "utf-8-sig")
    except UnicodeDecodeError as error:
        if utf16:
            place, found = "", f"a broken UTF-16 character at byte {error.start + 1}"
        else:
            readable = content[: error.start].decode("utf-8-sig", errors="replace")
            place, found = f"line {_line_number(readable)}", f"byte 0x{content[error.start]:02X}"
        binary = b"\x00" in content and not utf16
        raise InputError(
            Fault(
                message="the file is a binary file"
                if binary
                else "the file is not text in a known encoding",
                file=file,
                place=place,
                expected=_WANTED if binary or utf16 else _SAVE_AGAIN,
                found=(
                    found
                    if binary or utf16
                    else f"{found}{_as_windows(content[error.start : error.start + 1])}"
                ),
                hint=_GIVE_TEXT if binary else "save the file again as UTF-8",
            )
        ) from error


def _as_windows(byte: bytes) -> str:
    """Return, as a part of a message, the character that ``byte`` is in Windows-1252; "" if it is
    no printable character.
    """
    try:
        character = byte.decode("cp1252")
    except UnicodeDecodeError:
        return ""
    return f", which is '{character}' in Windows-1252" if character.isprintable() else ""


def _line_number(before: str) -> int:
    return len(_LINE_END.findall(before)) + 1


def stem(file: str) -> str:
    """Return a file name without its folder and extension."""
    name = re.split(r"[\\/]", file)[-1]
    return name.rpartition(".")[0] or name
