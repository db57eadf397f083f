"""What is noticed about a job."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-J002": "states names {states} but not as_found: no table is written without it",
    "CW-J003": "axes.{axis}.modulo has no meaning on a linear axis and is not used",
    "CW-J004": (
        "{place} does nothing: axis {axis} is not among the axes of the job, which give its"
        " travel and address (before: [] where it has no positioning test)"
    ),
    "CW-J020": "{key} has no effect on this control ({format})",
    "CW-J021": (
        "acknowledged.{code} is not needed: nothing of the kind was found{axis:if| on axis"
        " {axis}}. Take it out of the job."
    ),
}
