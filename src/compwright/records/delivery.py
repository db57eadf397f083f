"""What a control loads, and what brings back what was in it."""

from __future__ import annotations

from dataclasses import dataclass

from compwright.records.correction import ControlFile


@dataclass(frozen=True, slots=True)
class Delivery:
    """``files``: exactly what the control loads; ``back``: small files beside the byte copies of
    its own, which bring the old values back. ``own``: the files are its own ones, as patched.
    """

    files: tuple[ControlFile, ...]
    back: tuple[ControlFile, ...] = ()
    own: bool = True
