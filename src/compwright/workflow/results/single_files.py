"""Check that ``--force`` replaces a file only by one of the same kind.

This is for files whose path the user gives (``--json``, ``--plot``, ``--table``, ``--out``). A
wrong path would otherwise destroy a measurement, a job or a plan.
"""

from __future__ import annotations

import re
import zipfile
import zlib
from collections.abc import Callable, Iterable, Iterator, Mapping
from io import BytesIO
from pathlib import Path
from typing import Final

from compwright.foundations import storage
from compwright.foundations.errors import Fault, InputError, StorageError, raise_all
from compwright.foundations.session import Session

_TABLE: Final = "a table"
_WORKBOOK: Final = "a workbook"
#: First bytes -> what a file is.
_SIGNATURES: Final = (
    (re.compile(rb"\x89PNG"), "a picture"),
    (re.compile(rb"%PDF"), "a picture"),
    (
        re.compile(rb"(?:<\?xml[^>]*>\s*)?(?:<!(?:--|DOCTYPE)[^>]*>\s*)*<svg", re.DOTALL),
        "a picture",
    ),
    (re.compile(rb"PK\x03\x04"), _WORKBOOK),
    (re.compile(rb"SQLite format 3\x00"), "an index of history"),
    (re.compile(rb"\s*<(?:!DOCTYPE html|html)", re.IGNORECASE), "a page"),
)
#: Keys at the left edge that tell a YAML file of ours.
_YAML: Final = (
    (re.compile(rb"^compwright\s*:", re.MULTILINE), "a job"),
    (re.compile(rb"^compwright_profile\s*:", re.MULTILINE), "a mapping profile"),
    (re.compile(rb"^compwright_format\s*:", re.MULTILINE), "a definition of a control"),
    (re.compile(rb"^virtual_machine\s*:", re.MULTILINE), "a virtual machine"),
)
_SCHEMA: Final = re.compile(rb'\s*\{\s*"schema"\s*:\s*"(compwright/[a-z_]+)/')
#: What a file with an ending of these may be that nothing else tells.
_ENDINGS: Final = {
    "a picture": {".svg", ".png", ".pdf"},
    "a job": {".yaml", ".yml"},
    "a mapping profile": {".yaml", ".yml"},
    _TABLE: {".csv", ".txt"},
    _WORKBOOK: {".xlsx"},
}
_DOCUMENT: Final = {".json"}
_LOOKED_AT: Final = 65536  # bytes


def refuse_other_kinds(
    session: Session, targets: Mapping[Path, bytes], *, force: bool, results: Iterable[Path] = ()
) -> None:
    """Raise StorageError if ``force`` would replace one of the files ``targets`` by one of a
    different kind. ``results``: the other files that the command writes, which are not checked
    here.

    One name for two files is not checked here: it is refused when they are written.
    """
    if not force or not targets:
        return
    twice = {storage.resolved(path) for path in results}
    alone = {
        path: content for path, content in targets.items() if storage.resolved(path) not in twice
    }
    raise_all(StorageError, list(_others(session, alone)))


def _others(session: Session, targets: Mapping[Path, bytes]) -> Iterator[Fault]:
    for path, content in targets.items():
        there = storage.earlier_bytes(session, path)
        if not there.strip() or there == content or storage.was_read(session, path):
            continue  # what was read is refused where it is written
        kind, new = kind_of(there), kind_of(content)
        endings = _ENDINGS.get(new, _DOCUMENT)
        mark = _MARKS.get(kind)
        same = kind == new and (mark is None or mark(there) == mark(content))
        if not same and (kind or path.suffix.lower() not in endings):
            yield Fault(
                message=(
                    "the file was not written by this command, so it is not replaced, not "
                    "even with --force"
                ),
                file=str(path),
                found=kind or "something else",
                hint=f"give another name, or {new}",
            )


def kind_of(content: bytes) -> str:
    """Return the kind of a file, such as "a JSON document", or "" if it is uncertain."""
    if len(content) > _LOOKED_AT:
        content = content[:_LOOKED_AT].rpartition(b"\n")[0]
    schema = _SCHEMA.match(content)
    if schema is not None:
        return f"a JSON document ({schema[1].decode()})"
    kind = next((kind for mark, kind in _SIGNATURES if mark.match(content)), "")
    return kind or _of_text(content)


def _of_text(content: bytes) -> str:
    """Return the kind of a text file, or "" if none of the readers recognises its contents."""
    from compwright.instruments.forms import PLAIN_CSV, form_of
    from compwright.instruments.other_files import is_circular
    from compwright.instruments.own_forms import is_plain_csv
    from compwright.instruments.table_shape import has_table
    from compwright.instruments.text_input import read_any_lines

    kind = next((kind for mark, kind in _YAML if mark.search(content)), "")
    try:
        if kind or is_circular(content, ""):
            return kind or "a measurement"
        lines, _ = read_any_lines(content, "")
        if form_of(lines, "") is not PLAIN_CSV or is_plain_csv(lines):
            return "a measurement"
    except InputError:
        return ""
    return _TABLE if has_table(lines) else ""


def _first_cell(content: bytes) -> bytes:
    """Return the first cell of a header row, by which compwright's tables are recognised."""
    return re.split(rb"[;,\t]", content.lstrip(b"\xef\xbb\xbf").partition(b"\n")[0])[0]


def _properties(content: bytes) -> bytes:
    """Return the properties of a workbook (such as author and date) as bytes, or b"" if it has
    none.

    The properties that compwright writes contain no date. They change only if another program saves
    the file.
    """
    try:
        with zipfile.ZipFile(BytesIO(content)) as archive:
            size = archive.getinfo("docProps/core.xml").file_size
            return b"" if size > _LOOKED_AT else archive.read("docProps/core.xml")
    except (zipfile.BadZipFile, zlib.error, KeyError, ValueError, RuntimeError, OSError, EOFError):
        return b""


#: By kind: what tells those that compwright wrote from others.
_MARKS: Final[Mapping[str, Callable[[bytes], bytes]]] = {
    _TABLE: _first_cell,
    _WORKBOOK: _properties,
}
