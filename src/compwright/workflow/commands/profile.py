"""``profile``: propose a mapping profile, which describes another program's measurement table."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from compwright.foundations import storage
from compwright.foundations.input_sizes import MEASUREMENT
from compwright.foundations.session import Session
from compwright.foundations.utf8 import encoded, shown_path
from compwright.instruments.profile_of_file import proposed_profile
from compwright.workflow.results.single_files import refuse_other_kinds


@dataclass(frozen=True, slots=True, kw_only=True)
class ProfileOutcome:
    """The result of ``profile``: the written file, some readings as sentences, notes, and the keys
    that the user must fill in.
    """

    path: Path
    worked: tuple[str, ...]
    notes: tuple[str, ...]
    open: tuple[str, ...]


def propose_profile(
    session: Session, file: Path, out: Path, *, force: bool = False
) -> ProfileOutcome:
    """Write a proposed profile for ``file`` to ``out``.

    Raises InputError for a file without a table, and UsageError for a file that needs no profile.
    Raises StorageError if ``out`` exists (unless ``force``) or cannot be written.
    """
    proposed = proposed_profile(storage.read_bytes(session, file, MEASUREMENT), shown_path(file))
    target = {out: encoded(proposed.text)}
    refuse_other_kinds(session, target, force=force)
    (path,) = storage.write_files(session, Path(), {}, elsewhere=target, force=force)
    return ProfileOutcome(
        path=path, worked=proposed.worked, notes=proposed.notes, open=proposed.open
    )
