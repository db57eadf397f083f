"""The data files that are installed with compwright."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from compwright.foundations.session import Session
from compwright.foundations.storage.reading import read_bytes


def definition_files(session: Session) -> Iterator[tuple[str, bytes]]:
    """Yield name and bytes of each installed control definition, sorted by name."""
    return _shipped(session, "controller_formats")


def demo_files(session: Session) -> dict[str, bytes]:
    """Return the contents of the demo's files (machine and job) by file name."""
    return dict(_shipped(session, "controller_formats/demo"))


def reference_files(session: Session) -> dict[str, bytes]:
    """Return the reference data of the self-test by file name."""
    return dict(_shipped(session, "reference_data", "*.csv"))


def _shipped(session: Session, folder: str, pattern: str = "*.yaml") -> Iterator[tuple[str, bytes]]:
    """Yield name and bytes of the files in a folder that is installed with compwright.

    In an installed wheel the folder is in the package, in a source checkout it is at the top.
    """
    package = Path(__file__).resolve().parents[2]
    for place in (package / folder, package.parents[1] / folder):
        if place.is_dir():
            for path in sorted(place.glob(pattern)):
                yield path.name, read_bytes(session, path)
            return
