"""The logo of a report: read once, checked, and embedded in the page."""

from __future__ import annotations

import struct
import zlib
from pathlib import Path
from typing import Final

from compwright.foundations import storage
from compwright.foundations.errors import Fault, InputError
from compwright.foundations.input_sizes import LOGO
from compwright.foundations.session import Session
from compwright.instruments.safe_xml import read_xml
from compwright.records.job import Logo

_PNG: Final = b"\x89PNG\r\n\x1a\n"
_JPEG: Final = (b"\xff\xd8\xff", b"\xff\xd9")


def read_logo(session: Session, name: str, folder: Path) -> Logo:
    """Return the picture in ``report.logo``. Raises InputError for an unusable file."""
    content = storage.read_bytes(session, storage.named_from(folder, name), LOGO)
    if content.startswith(_PNG) and _whole_png(content):
        return Logo("image/png", content)
    if content.startswith(_JPEG[0]) and content.rstrip(b"\0").endswith(_JPEG[1]):
        return Logo("image/jpeg", content)
    if (
        content.lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"<")
        and read_xml(content, name).tag.rpartition(":")[2] == "svg"
    ):
        return Logo("image/svg+xml", content)
    raise InputError(
        Fault(
            message="the file is incomplete, or not a picture for a report",
            file=name,
            place="report.logo",
            expected="a whole .png, .jpg or .svg file",
            hint="give a whole .png, .jpg or .svg file under `report.logo`",
        )
    )


def _whole_png(content: bytes) -> bool:
    """Return whether a PNG file is complete: every chunk with its checksum, including the last
    one.
    """
    at = len(_PNG)
    while at + 12 <= len(content):
        (size,) = struct.unpack_from(">I", content, at)
        end = at + 12 + size
        kind = content[at + 4 : at + 8]
        if end > len(content):
            return False
        (check,) = struct.unpack_from(">I", content, end - 4)
        if check != zlib.crc32(content[at + 4 : end - 4]):
            return False
        if kind == b"IEND":
            return True
        at = end
    return False
