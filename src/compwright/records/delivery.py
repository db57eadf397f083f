"""Files that a control loads, and files that restore its old contents."""

from __future__ import annotations

from dataclasses import dataclass

from compwright.records.correction import ControlFile


@dataclass(frozen=True, slots=True)
class Delivery:
    """The files to load into a control, and the files that restore its old contents.

    ``files``: exactly what the control loads; ``back``: small files, in addition to the byte copies
    of its own, which restore the old values. ``own``: the files are its own ones, patched.
    """

    files: tuple[ControlFile, ...]
    back: tuple[ControlFile, ...] = ()
    own: bool = True
