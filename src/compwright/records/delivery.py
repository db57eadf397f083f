"""Files that a control loads, and files that restore its old contents."""

from __future__ import annotations

from dataclasses import dataclass

from compwright.records.correction import ControlFile


@dataclass(frozen=True, slots=True)
class Delivery:
    """The files to load into a control, and the files that restore its old contents.

    ``files``: exactly what the control loads. ``back``: small files that restore the old values, in
    addition to exact copies of the control's own files. ``own``: whether the files are changed
    copies of the control's own files.
    """

    files: tuple[ControlFile, ...]
    back: tuple[ControlFile, ...] = ()
    own: bool = True
