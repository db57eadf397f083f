"""Find the measurement files of a path (a file, or all files in a folder), and read mapping
profiles.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from compwright.foundations import storage
from compwright.foundations.errors import Fault, InputError
from compwright.foundations.input_sizes import PROFILE
from compwright.foundations.session import Session
from compwright.foundations.utf8 import shown_path
from compwright.instruments.profile import Profile

#: Endings of other files in a folder of measurements: plots, JSON, jobs, reports, pictures.
OTHER_ENDINGS = frozenset(
    {".svg", ".png", ".pdf", ".jpg", ".jpeg", ".json", ".yaml", ".yml", ".html", ".htm", ".md"}
)


@dataclass(frozen=True, slots=True)
class FoundMeasurements:
    """The measurement files found at a path, the files skipped there, and the inner ``folders``,
    which were not searched.
    """

    files: tuple[Path, ...]
    skipped: tuple[Path, ...] = ()
    folders: tuple[Path, ...] = ()


def load_profile(session: Session, path: Path) -> Profile:
    """Read a mapping profile. Raises UsageError with all faults, or InputError."""
    # slow to import, and few measurements need a profile
    from compwright.instruments.profile_reading import read_profile

    return read_profile(storage.read_bytes(session, path, PROFILE), shown_path(path))


def measurement_files(session: Session, path: Path) -> FoundMeasurements:
    """Return the measurement files of ``path``. Plots, JSON, jobs and pages in a folder are left
    out.

    Whether the other files are measurements is known only when they are read. Raises InputError for
    a folder without any.
    """
    entries = storage.list_files(session, path)
    if entries == [path]:
        return FoundMeasurements((path,))
    folders = tuple(storage.folders_in(path))
    files: list[Path] = []
    skipped: list[Path] = []
    for entry in entries:
        other = entry.suffix.lower() in OTHER_ENDINGS
        (skipped if other else files).append(entry)
    if not files:
        named = ", ".join(shown_path(Path(entry.name)) for entry in skipped)
        names = ", ".join(shown_path(Path(folder.name)) for folder in folders)
        below = f"folders, which are read when they are named: {names}" if folders else ""
        raise InputError(
            Fault(
                message="the folder contains no measurement files"
                if skipped
                else "the folder contains no files",
                file=shown_path(path),
                expected="measurement files" if skipped else "",
                found="; ".join(part for part in (named, below) if part),
                hint="give the measurement files, or the folder they are in",
            )
        )
    return FoundMeasurements(tuple(files), tuple(skipped), folders)
