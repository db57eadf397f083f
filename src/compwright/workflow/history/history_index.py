"""An SQLite index of result folders, so that a history reads only changed folders again.

The database is in memory. Its bytes are read and written as a whole, like any other file. It is
recognised by ``application_id`` and ``user_version`` (SQLite, "Database File Format", 1.3.17 and
1.3.15).
"""

from __future__ import annotations

import json
import sqlite3
from collections.abc import Iterator, Sequence
from contextlib import closing, contextmanager
from dataclasses import asdict
from pathlib import Path
from typing import Any

from compwright.documents.history import VALUES
from compwright.foundations import storage
from compwright.foundations.errors import Fault, InputError
from compwright.foundations.session import Session
from compwright.foundations.utf8 import shown_path
from compwright.records.history import HistoryEntry

#: "cwhi", in the header of the file.
_APPLICATION = 0x63776869
_VERSION = 3
_TABLES = f"""
CREATE TABLE folder (
    path TEXT PRIMARY KEY, state TEXT NOT NULL, names TEXT NOT NULL, notes TEXT NOT NULL,
    files TEXT NOT NULL
);
CREATE TABLE test (
    folder TEXT NOT NULL REFERENCES folder (path) ON DELETE CASCADE, number INTEGER NOT NULL,
    machine TEXT NOT NULL, serial TEXT NOT NULL, axis TEXT NOT NULL, name TEXT NOT NULL,
    taken TEXT NOT NULL, day TEXT NOT NULL, unit TEXT NOT NULL,
    {", ".join(f"{name} REAL" for name in VALUES)},
    acting TEXT NOT NULL, verdict TEXT NOT NULL, entry TEXT NOT NULL,
    PRIMARY KEY (folder, number)
);
CREATE INDEX by_axis ON test (serial, machine, axis, day);
PRAGMA application_id = {_APPLICATION};
PRAGMA user_version = {_VERSION};
"""


class HistoryIndex:
    """The tests, notes and file fingerprints of result folders in an SQLite database."""

    def __init__(self, session: Session, database: sqlite3.Connection, file: str) -> None:
        self._session, self._database, self._file = session, database, file
        self.changed = False

    def known(self, folder: Path) -> bool:
        """Return whether a folder is in the index and none of its files has changed since."""
        row = self._one("SELECT state, names FROM folder WHERE path = ?", _key(folder))
        return row is not None and row[0] == _state(self._session, folder, json.loads(row[1]))

    def put(
        self,
        folder: Path,
        entries: Sequence[HistoryEntry],
        notes: Sequence[str],
        files: Sequence[tuple[str, str]],
        names: Sequence[str],
    ) -> None:
        """Store the tests and notes of a folder in the index, in place of its earlier ones.
        ``files``: name and state of its changed files; ``names``: the names of all its files.
        """
        key = _key(folder)
        self.forget(folder)
        self._database.execute(
            "INSERT INTO folder VALUES (?, ?, ?, ?, ?)",
            (
                key,
                _state(self._session, folder, names),
                *(json.dumps(list(each)) for each in (names, notes, files)),
            ),
        )
        self._database.executemany(
            f"INSERT INTO test VALUES ({', '.join('?' * (12 + len(VALUES)))})",  # noqa: S608
            [_row(key, entry) for entry in entries],
        )
        self.changed = True

    def forget(self, folder: Path) -> None:
        """Remove a folder from the index, if it is there."""
        self._database.execute("DELETE FROM test WHERE folder = ?", (_key(folder),))
        gone = self._database.execute("DELETE FROM folder WHERE path = ?", (_key(folder),))
        self.changed = self.changed or gone.rowcount > 0

    def folders_below(self, top: Path) -> list[Path]:
        """Return the folders of the index that are equal to ``top`` or inside it."""
        whole = storage.resolved(top)
        paths = [Path(row[0]) for row in self._database.execute("SELECT path FROM folder")]
        return [path for path in paths if path == whole or whole in path.parents]

    def entries(self, folder: Path) -> list[HistoryEntry]:
        """Return the tests of a folder. Raises InputError for a damaged index."""
        rows = self._database.execute(
            "SELECT entry FROM test WHERE folder = ? ORDER BY number", (_key(folder),)
        )
        try:
            return [_entry(json.loads(row[0]), folder) for row in rows]
        except (ValueError, TypeError, KeyError) as error:
            raise _refused(self._file, "is a damaged index", str(error)) from error

    def notes_of(self, folder: Path) -> tuple[list[str], list[tuple[str, str]]]:
        """Return the notes about a result folder, and name and state of each of its files that was
        changed or is missing since a command wrote it.
        """
        row = self._one("SELECT notes, files FROM folder WHERE path = ?", _key(folder))
        if row is None:
            return [], []
        return json.loads(row[0]), [(name, state) for name, state in json.loads(row[1])]

    def content(self) -> bytes:
        """Return the index as the bytes of its file."""
        self._database.commit()
        return self._database.serialize()

    def _one(self, query: str, *values: str) -> tuple[Any, ...] | None:
        row = self._database.execute(query, values).fetchone()
        return None if row is None else tuple(row)


@contextmanager
def opened(session: Session, path: Path) -> Iterator[HistoryIndex]:
    """Open the index stored in a file, or a new index if there is no file.

    Raises InputError for a file that is not an index of this version; the file is not changed.
    """
    file = shown_path(path)
    with closing(sqlite3.connect(":memory:")) as database:
        try:
            _fill(session, database, path, file)
            yield HistoryIndex(session, database, file)
        except sqlite3.Error as error:
            raise _refused(file, "is a damaged index", str(error)) from error


def _fill(session: Session, database: sqlite3.Connection, path: Path, file: str) -> None:
    if not storage.is_there(session, path):
        database.executescript(_TABLES)
        return
    content = storage.earlier_bytes(session, path)
    if not content.startswith(b"SQLite format 3\0"):
        raise _refused(file, "is not an index of a history", "another file")
    database.deserialize(content)
    if database.execute("PRAGMA application_id").fetchone()[0] != _APPLICATION:
        raise _refused(file, "is not an index of a history", "another program's database")
    version = database.execute("PRAGMA user_version").fetchone()[0]
    if version != _VERSION:
        raise _refused(file, "is an index of another version", str(version), str(_VERSION))
    checked = database.execute("PRAGMA quick_check(1)").fetchone()[0]
    if checked != "ok":
        raise _refused(file, "is a damaged index", str(checked))


def _refused(
    file: str, message: str, found: str, expected: str = "an index, or the name of a new file"
) -> InputError:
    return InputError(
        Fault(
            message=message,
            file=file,
            place="--index",
            expected=expected,
            found=found,
            hint="give another name to `--index`",
        )
    )


def _key(folder: Path) -> str:
    return shown_path(storage.resolved(folder))


def _state(session: Session, folder: Path, names: Sequence[str]) -> str:
    return storage.state_of(session, [folder / name for name in names])


def _row(key: str, entry: HistoryEntry) -> tuple[object, ...]:
    return (
        *(key, entry.number, entry.machine, entry.serial, entry.what, entry.test),
        *(entry.taken, entry.day, entry.unit),
        *(entry.values.get(name) for name in VALUES),
        *(entry.acting, entry.verdict, json.dumps(asdict(entry))),
    )


def _entry(data: dict[str, Any], folder: Path) -> HistoryEntry:
    """Return the history entry that is stored as ``data``. As its folder the entry gets ``folder``,
    the present place of the result folder.
    """
    pairs = {
        key: {name: (pair[0], pair[1]) for name, pair in data[key].items()}
        for key in ("errors", "declared")
    }
    lists = {key: tuple(data[key]) for key in ("targets", "sources")}
    up, down = map(tuple, data["means"])
    own = {"means": (up, down), "folder": shown_path(folder)}
    return HistoryEntry(**{**data, **pairs, **lists, **own})
