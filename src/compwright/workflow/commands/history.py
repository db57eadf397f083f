"""``history``: show the results of machines over the years, from their result folders."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import nullcontext
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from compwright.documents.history import TestSeries, history_csv, history_document
from compwright.documents.json_text import to_json
from compwright.evaluation.series_changes import (
    noted_changes,
    noted_trends,
    same_readings,
    without_repeats,
)
from compwright.foundations import storage
from compwright.foundations.errors import Fault, InputError, UsageError, collect
from compwright.foundations.session import Session
from compwright.foundations.utf8 import shown_path
from compwright.records.history import HistoryEntry
from compwright.workflow.history.history_entries import entries_of
from compwright.workflow.history.history_index import HistoryIndex, opened
from compwright.workflow.history.result_folders import read_folder, result_folders
from compwright.workflow.results.single_files import refuse_other_kinds


@dataclass(frozen=True, slots=True, kw_only=True)
class HistoryOutcome:
    """The result of ``history``: the JSON document, the written files and the exit code.

    ``exit_code``: 3 if something could not be read and the rest was read. ``read``: the number of
    folders that were read; the others were known from the index.
    """

    exit_code: int
    document: Mapping[str, Any]
    files: tuple[Path, ...]
    read: int


def history_of(
    session: Session,
    tops: Sequence[Path],
    *,
    index: Path | None = None,
    json_path: Path | None = None,
    plot_path: Path | None = None,
    page_path: Path | None = None,
    table_path: Path | None = None,
    force: bool = False,
) -> HistoryOutcome:
    """Return the tests in the result folders below ``tops`` by machine, axis and date, with the
    changes between them, and write the requested files. ``index``: a database that keeps what was
    read for the next call.

    Raises UsageError, StorageError, and InputError if nothing can be read or ``index`` is not such
    a database. In these cases no file is written.
    """
    named = [
        path for path in (json_path, plot_path, page_path, table_path, index) if path is not None
    ]
    if len(set(named)) < len(named):
        raise UsageError(
            Fault(
                message="two of --json, --plot, --page, --table and --index name the same file",
                hint="give each of these options a different file",
            )
        )
    folders, faults = result_folders(session, tops)
    with nullcontext() if index is None else opened(session, index) as database:
        entries, folder_documents, read = _read(session, folders, database, faults)
        kept = {}
        if index is not None and database is not None:
            _forget_gone(tops, folders, database)
            kept = {index: database.content()} if database.changed else {}
    if faults and not entries:
        raise InputError(*faults)
    series = _series(entries, tops)
    document = history_document(series, folder_documents, _notes(series), faults)
    requested = _requested_files(document, json_path, plot_path, page_path, table_path)
    return HistoryOutcome(
        exit_code=InputError.exit_code if faults else 0,
        document=document,
        files=_written(session, requested, kept, force=force),
        read=read,
    )


def _read(
    session: Session, folders: Sequence[Path], database: HistoryIndex | None, faults: list[Fault]
) -> tuple[list[HistoryEntry], list[dict[str, Any]], int]:
    """Return the tests and notes of all folders, and the number of folders that were read.

    A fault is added to ``faults`` for each folder that cannot be read.
    """
    entries: list[HistoryEntry] = []
    folder_documents = []
    read = 0
    for folder in folders:
        if database is not None and database.known(folder):
            entries += database.entries(folder)
            notes, files = database.notes_of(folder)
        else:
            read += 1
            if database is not None:
                database.forget(folder)
            try:
                found = read_folder(session, folder)
                of_folder = entries_of(found)
                if database is not None:
                    database.put(folder, of_folder, found.notes, found.files, found.names)
            except InputError as error:
                faults.extend(collect([error]))
                continue
            entries += of_folder
            notes, files = list(found.notes), list(found.files)
        folder_documents.append(
            {
                "folder": shown_path(folder),
                "notes": notes,
                "files": [{"file": name, "state": state} for name, state in files],
            }
        )
    return entries, folder_documents, read


def _forget_gone(tops: Sequence[Path], folders: Sequence[Path], database: HistoryIndex) -> None:
    there = {storage.resolved(folder) for folder in folders}
    for top in tops:
        for folder in database.folders_below(top):
            if folder not in there:
                database.forget(folder)


def _series(entries: Iterable[HistoryEntry], tops: Sequence[Path]) -> list[TestSeries]:
    """Return the tests grouped by machine and axis, in each group in the order of time."""
    groups: dict[tuple[str, bool, str], list[HistoryEntry]] = {}
    for entry in entries:
        group_key = (_machine(entry, tops), entry.kind == "circular", entry.what)
        groups.setdefault(group_key, []).append(entry)
    found = []
    for key, circular, what in sorted(groups, key=lambda each: (*each[:2], _natural(each[2]))):
        group = groups[key, circular, what]
        in_time = _in_time(group)
        ordered = sorted(without_repeats(sorted(group, key=in_time)), key=in_time)
        last, trends = ordered[-1], tuple(noted_trends(ordered))
        found.append(
            TestSeries(
                key=key,
                machine=last.machine,
                serial=last.serial,
                what=last.what,
                entries=tuple(ordered),
                changes=tuple(noted_changes(ordered, trends)),
                trends=trends,
            )
        )
    return found


def _machine(entry: HistoryEntry, tops: Sequence[Path]) -> str:
    """Return what identifies a machine: its serial number, else its name, else the folder.

    If there is neither serial number nor name, the results of one folder belong together.
    """
    if entry.serial:
        return f"1 {entry.serial.casefold()}"
    if entry.machine:
        return f"2 {entry.machine.casefold()}"
    folder = Path(entry.folder)
    top = next((top for top in tops if top == folder or top in folder.parents), folder)
    parts = folder.relative_to(top).parts if top in folder.parents else ()
    return f"3 {top}/{parts[0] if parts else ''}"


def _in_time(group: Iterable[HistoryEntry]) -> Callable[[HistoryEntry], tuple[object, ...]]:
    """Return a sort key that orders tests by date. A test without a date is sorted next to the
    dated tests of the same folder.

    Tests of the same day are in the order of the folders, unless each of them states its time.
    """
    dated: dict[str, list[str]] = {}
    for entry in group:
        if entry.day:
            dated.setdefault(entry.folder, []).append(entry.day)

    def day_of(entry: HistoryEntry) -> str:
        nearest = max if entry.taken == "after" else min
        return entry.day or nearest(dated.get(entry.folder, [""])).partition(" ")[0]

    timeless = {day_of(entry) for entry in group if " " not in day_of(entry)}

    def in_time(entry: HistoryEntry) -> tuple[object, ...]:
        day = day_of(entry)
        date = day.partition(" ")[0]
        return (
            day == "",
            date if date in timeless else day,
            _natural(entry.folder),
            entry.taken == "after",
            entry.number,
        )

    return in_time


def _date(entry: HistoryEntry) -> str:
    return entry.day.partition(" ")[0]


def _natural(text: str) -> list[tuple[int, int, str]]:
    """Return a sort key that puts round-2 before round-10."""
    return [
        (0, int(part), "") if part.isdecimal() else (1, 0, part.casefold())
        for part in re.split(r"(\d+)", text)
        if part
    ]


def _notes(series: Sequence[TestSeries]) -> list[str]:
    entries = [entry for one in series for entry in one.entries]
    undated = sum(not entry.day for entry in entries)
    unread = sum(bool(entry.date) and not entry.day for entry in entries)
    simulated = sum(entry.simulated for entry in entries)
    found = []
    if undated:
        what = "states" if undated == 1 else "state"
        unclear = f" ({unread} a date that can be read in two ways)" if unread else ""
        found.append(
            f"{undated} of {len(entries)} tests {what} no date{unclear}: each is listed next to the"
            " dated tests of its folder, else last, in the order of the folders. To date a test,"
            " add `# date: 2026-11-30` to its file"
        )
    found += [*_turned_dates(entries), *_names_of_one_number(entries)]
    found += [note for one in series for note in _copies(one.entries)]
    if simulated:
        found.append(f"{simulated} of {len(entries)} tests were simulated")
    return found


def _turned_dates(entries: Sequence[HistoryEntry]) -> Iterator[str]:
    """Yield a note if a test after loading has an earlier date than a test before loading."""
    by_folder: dict[str, dict[str, list[str]]] = {}
    for entry in entries:
        dated = by_folder.setdefault(entry.folder, {"before": [], "after": []})
        if entry.day:
            dated[entry.taken].append(_date(entry))
    for folder, days in by_folder.items():
        if days["before"] and days["after"] and min(days["after"]) < max(days["before"]):
            yield (
                f"{folder}: a test after loading is dated {min(days['after'])}, one before loading"
                f" {max(days['before'])}: the order here follows the dates, look at them"
            )


def _copies(entries: Sequence[HistoryEntry]) -> Iterator[str]:
    """Yield a note for each test of an axis that has the readings of an earlier one."""
    for place, later in enumerate(entries):
        earlier = next((one for one in entries[:place] if same_readings(one, later)), None)
        if earlier is not None:
            yield (
                f"{later.folder}: {later.test} has the readings of {earlier.test} in"
                f" {earlier.folder}. A copy counts as a test of its own, although nothing was"
                " measured again. Leave the folder of the copy out"
            )


def _names_of_one_number(entries: Iterable[HistoryEntry]) -> Iterator[str]:
    """Yield a finding where machines with different names have the same serial number."""
    names: dict[str, dict[str, str]] = {}
    for entry in entries:
        if entry.serial and entry.machine:
            known = names.setdefault(entry.serial.casefold(), {})
            known.setdefault(entry.machine.casefold(), entry.machine)
    for serial, known in names.items():
        if len(known) > 1:
            yield (
                f"serial number {serial}: named {' and '.join(known.values())}; shown as one"
                " machine. If they are two, a difference between them does not mean that one of"
                " them changed"
            )


def _requested_files(
    document: Mapping[str, Any],
    json_path: Path | None,
    plot_path: Path | None,
    page_path: Path | None,
    table_path: Path | None,
) -> dict[Path, bytes]:
    files: dict[Path, bytes] = {}
    if plot_path is not None:
        from compwright.reporting.history_plot import history_plot

        files[plot_path] = history_plot(document, format=plot_path.suffix.lower().removeprefix("."))
    if page_path is not None:
        from compwright.reporting.history_page import history_page

        files[page_path] = history_page(document)
    if table_path is not None:
        files[table_path] = history_csv(document)
    if json_path is not None:
        files[json_path] = to_json(document).encode()
    return files


def _written(
    session: Session, requested: Mapping[Path, bytes], index: Mapping[Path, bytes], *, force: bool
) -> tuple[Path, ...]:
    """Write the requested files and the index, all or none. An existing index is replaced even
    without ``force``.
    """
    storage.refuse_overwriting(session, requested, force=force)
    refuse_other_kinds(session, requested, force=force)
    files = {**requested, **index}
    if not files:
        return ()
    first, *_ = files
    storage.write_files(
        session, first.parent, {first.name: files[first]}, force=True, elsewhere=files
    )
    return tuple(files)
