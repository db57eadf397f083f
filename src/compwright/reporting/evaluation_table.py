"""Many tests as a table for spreadsheets: one row per test, with units in the header.

Text from files and file names are data. If a spreadsheet would take such a text for a formula, it
is made harmless: by an apostrophe before it in CSV, by the type of the cell in a workbook.
"""

from __future__ import annotations

import csv
import re
import zipfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from io import BytesIO, StringIO
from typing import Any, Final

from compwright.foundations.errors import Fault, UsageError
from compwright.foundations.extras import need
from compwright.foundations.utf8 import encoded, visible
from compwright.reporting.numbers import PARAMETERS

Cell = str | float | int | bool | None
#: A table: the headers, and rows as long.
Table = tuple[list[str], list[list[Cell]]]
_Result = Mapping[str, Any]

#: What spreadsheets take for the beginning of a formula or a command.
_FORMULA: Final = ("=", "+", "-", "@", "\t", "\r")
#: No program asks when a table was made: same tests, same bytes.
_WHEN: Final = "2000-01-01T00:00:00Z"
_WHEN_ZIPPED: Final = (2000, 1, 1, 0, 0, 0)
_DATES: Final = re.compile(r"(<dcterms:(?:created|modified)[^>]*>)[^<]*(<)")
#: Columns before and behind all others.
_FIRST: Final = ("kind", "file", "sha256", "name")
_LAST: Final = ("errors", "warnings", "infos", "findings")
_SENSES: Final = ("ccw", "cw", "common")


def table_bytes(document: Mapping[str, Any], suffix: str) -> bytes:
    """Return the tests of an evaluation as a ``.csv`` or ``.xlsx`` table.

    ``.csv``: UTF-8, commas between the columns, decimal points. It has one table for positioning
    and circular tests; columns of the other kind of test are empty. ``.xlsx``: a sheet for each
    kind of test, and one for files that could not be evaluated.

    Deviations are in µm or arcsec, as the column ``unit`` states; positions are in mm or deg
    (``position_unit``). The cell of a parameter that a test does not have is empty. Raises
    UsageError for another file name extension, and for ``.xlsx`` if openpyxl (extra ``excel``) is
    not installed.
    """
    writers: dict[str, Callable[[Mapping[str, Any]], bytes]] = {".csv": _csv, ".xlsx": _workbook}
    if suffix.lower() not in writers:
        raise UsageError(
            Fault(
                message="the name of the table has an unknown ending",
                expected=" or ".join(writers),
                found=suffix or "no ending",
                hint=f"give a name that ends in {' or '.join(writers)}",
            )
        )
    return writers[suffix.lower()](document)


def _csv(document: Mapping[str, Any]) -> bytes:
    tables = [table for _, table in _tables(document)]
    headers = list(dict.fromkeys(header for heads, _ in tables for header in heads))
    stream = StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(headers)
    for heads, rows in tables:
        for row in rows:
            cells = dict(zip(heads, row, strict=True))
            writer.writerow([_as_text(cells.get(header)) for header in headers])
    return encoded(stream.getvalue())


def _as_text(cell: Cell) -> str:
    if cell is None:
        return ""
    if isinstance(cell, bool):
        return "yes" if cell else "no"
    if isinstance(cell, str):
        return f"'{cell}" if cell.startswith(_FORMULA) else cell
    return repr(cell)


def _tables(document: Mapping[str, Any]) -> list[tuple[str, Table]]:
    """Return one table for each kind of test."""
    found = []
    for kind, columns in (
        ("positioning", _positioning),
        ("circular", _circular),
        ("environment", _stand_still),
        ("lost_motion", _lost_motion),
    ):
        results = [result for result in document["results"] if result["kind"] == kind]
        if results:
            found.append((kind, columns(results)))
    return found


def _stand_still(results: Sequence[_Result]) -> Table:
    columns = ("axis", "axis_kind", "standard", "n_readings", "duration_min", "unit")
    heads = [*_FIRST, *columns, "E_VE [um|arcsec]", *_LAST]
    rows = [
        [
            *_first(result),
            *(_text(result[key]) for key in ("axis", "axis_kind", "standard")),
            result["n_readings"],
            result["duration_min"],
            result["unit"],
            result["parameters"]["E_VE"],
            *_last(result),
        ]
        for result in results
    ]
    return heads, rows


def _lost_motion(results: Sequence[_Result]) -> Table:
    heads = [*_FIRST, "axis", "over", "n_readings", "depends", "constant [um]", "left [um]", *_LAST]
    rows = [
        [
            *_first(result),
            *(_text(result[key]) for key in ("axis", "over")),
            result["n_readings"],
            _text(result["depends"]),
            *(result["parameters"][key] for key in ("constant", "left")),
            *_last(result),
        ]
        for result in results
    ]
    return heads, rows


def _positioning(results: Sequence[_Result]) -> Table:
    names = _in_use(results, lambda result: result["parameters"])
    places = _in_use(results, lambda result: result["at"])
    heads = [
        *_FIRST,
        *("axis", "axis_kind", "standard", "spread", "cycle", "n_targets"),
        *("n_runs positive", "n_runs negative", "position_unit", "unit"),
        *(f"{name} [um|arcsec]" for name in names),
        *(f"{name} at [mm|deg]" for name in places),
        *_LAST,
    ]
    rows = [
        [
            *_first(result),
            *(_text(result[key]) for key in ("axis", "axis_kind", "standard", "spread", "cycle")),
            result["n_targets"],
            result["n_runs"]["positive"],
            result["n_runs"]["negative"],
            result["position_unit"],
            result["unit"],
            *(result["parameters"].get(name) for name in names),
            *(result["at"].get(name) for name in places),
            *_last(result),
        ]
        for result in results
    ]
    return heads, rows


def _circular(results: Sequence[_Result]) -> Table:
    names = _in_use(results, lambda result: result["parameters"])
    causes = _in_use(results, lambda result: result["diagnosis"] or {})
    units = {
        name: cause["unit"]
        for result in results
        for name, cause in (result["diagnosis"] or {}).items()
    }
    heads = [
        *_FIRST,
        *("plane", "standard", "nominal_radius [mm]", "feed [mm/min]"),
        *("arc start [deg]", "arc extent [deg]", "calibrated"),
        *(f"{name} [um]" for name in names),
        *(f"centre {sense} {axis} [um]" for sense in _SENSES for axis in ("first", "second")),
        *(f"mean_radius_deviation {sense} [um]" for sense in _SENSES[:2]),
    ]
    for name in causes:
        heads += [f"{name} [{units[name]}]", f"{name} std_error [{units[name]}]"]
    rows = [
        [*_circle(result, names), *_causes(result, causes), *_last(result)] for result in results
    ]
    return [*heads, *_LAST], rows


def _circle(result: _Result, names: Sequence[str]) -> list[Cell]:
    centres = [result["centre"].get(sense) or (None, None) for sense in _SENSES]
    return [
        *_first(result),
        _text(result["plane"]),
        result["standard"],
        result["nominal_radius"],
        result["feed"],
        result["arc"]["start"],
        result["arc"]["extent"],
        result["calibrated"],
        *(result["parameters"].get(name) for name in names),
        *(coordinate for centre in centres for coordinate in centre),
        *(result["mean_radius_deviation"].get(sense) for sense in _SENSES[:2]),
    ]


def _causes(result: _Result, names: Sequence[str]) -> list[Cell]:
    found = result["diagnosis"] or {}
    return [found.get(name, {}).get(key) for name in names for key in ("value", "std_error")]


def _first(result: _Result) -> list[Cell]:
    """Return the first cells of a row: files and hashes of the test, separated by semicolons."""
    sources = result["sources"]
    return [
        result["kind"],
        _text("; ".join(source["file"] for source in sources)),
        "; ".join(source["sha256"] for source in sources),
        _text(result["name"]),
    ]


def _last(result: _Result) -> list[Cell]:
    """Return the last cells of a row: the number of findings of each severity, and their codes."""
    findings = result["findings"]
    counts = [
        sum(finding["severity"] == severity for finding in findings)
        for severity in ("error", "warning", "info")
    ]
    return [*counts, " ".join(dict.fromkeys(finding["code"] for finding in findings))]


def _in_use(results: Iterable[_Result], part: Callable[[_Result], Mapping[str, Any]]) -> list[str]:
    """Return, in the usual order, the names (such as those of parameters) that occur in at least
    one result. ``part``: the function that returns the part of a result with these names.
    """
    names = dict.fromkeys(name for result in results for name in part(result))
    order = {name: place for place, name in enumerate(PARAMETERS)}
    return sorted(names, key=lambda name: order.get(name, len(order)))


def _text(value: object) -> str:
    """Return a text or file name as one line, with control characters made visible."""
    return visible(str(value))


def _workbook(document: Mapping[str, Any]) -> bytes:
    openpyxl = need("openpyxl", "excel", "workbooks (or give --table FILE.csv)")
    book = openpyxl.Workbook(write_only=True)
    tables = [*_tables(document), *_not_evaluated(document)]
    for name, (heads, rows) in tables or [("positioning", ([*_FIRST], []))]:
        _fill(book.create_sheet(name), heads, rows)
    stream = BytesIO()
    book.save(stream)
    return _undated(stream.getvalue())


def _not_evaluated(document: Mapping[str, Any]) -> list[tuple[str, Table]]:
    errors = document["errors"]
    rows: list[list[Cell]] = [[_text(one["file"]), _text(one["message"])] for one in errors]
    return [("not evaluated", (["file", "error"], rows))] if rows else []


def _fill(sheet: Any, heads: Sequence[str], rows: Sequence[Sequence[Cell]]) -> None:
    from openpyxl.cell import WriteOnlyCell
    from openpyxl.utils import get_column_letter

    def cell(value: Cell) -> object:
        made = WriteOnlyCell(sheet, value=value)
        if isinstance(value, str):
            made.data_type = "s"  # whatever it begins with, it is no formula
        return made

    sheet.freeze_panes = "A2"
    sheet.auto_filter.ref = f"A1:{get_column_letter(len(heads))}{len(rows) + 1}"
    for place, head in enumerate(heads, start=1):
        sheet.column_dimensions[get_column_letter(place)].width = max(len(head) + 2, 10)
    for row in (heads, *rows):
        sheet.append([cell(value) if isinstance(value, str) else value for value in row])


def _undated(content: bytes) -> bytes:
    """Return a workbook without its time of creation, so that equal results give equal bytes."""
    stream = BytesIO()
    with (
        zipfile.ZipFile(BytesIO(content)) as made,
        zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as undated,
    ):
        for name in made.namelist():
            part = made.read(name)
            if name == "docProps/core.xml":
                part = _DATES.sub(rf"\g<1>{_WHEN}\g<2>", part.decode("utf-8")).encode()
            undated.writestr(zipfile.ZipInfo(name, _WHEN_ZIPPED), part, zipfile.ZIP_DEFLATED)
    return stream.getvalue()
