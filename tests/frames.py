"""Empty frames in the place of what takes time and only some tests look at: the figures of circles
in pages (a tenth of a second each), and what a run makes beside the control's files.
"""

from __future__ import annotations

from typing import Final

import pytest

from compwright.controls import partial_loads
from compwright.reporting import circles, run_report

FRAME = b'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10"></svg>'
REPORT = b"<!DOCTYPE html><title>empty frame: mark the test `real_pages`</title>"


def _figure(*_: object, **__: object) -> bytes:
    return FRAME


def _report(*_: object, **__: object) -> bytes:
    return REPORT


#: Room, name, and what it is in an empty frame: figures, then the report and the lines of the card
#: about files that are loaded alone.
_FRAMES: Final = (
    (circles, "polar_figure", _figure),
    (run_report, "run_report", _report),
    (partial_loads, "_MOST_FILES", 1),
)
_REAL: Final = tuple(getattr(room, name) for room, name, _ in _FRAMES)


def frame(patch: pytest.MonkeyPatch, *, real: bool, brief: bool) -> None:
    """Let figures of circles be empty frames unless ``real``, where ``brief`` the other pages too."""
    count = 0 if real else len(_FRAMES) if brief else 1
    for place, ((room, name, empty), whole) in enumerate(zip(_FRAMES, _REAL, strict=True)):
        patch.setattr(room, name, empty if place < count else whole)
