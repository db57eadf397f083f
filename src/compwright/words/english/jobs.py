"""Sentences about a job."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-J002": (
        "The job has the entries {states} under `states`, but not as_found. The entry as_found"
        " states what is in the control now. Without it no table is written. Add `as_found: none`"
        " or `as_found: [files of the control]` under `states`"
    ),
    "CW-J003": "axes.{axis}.modulo has no meaning on a linear axis and is not used",
    "CW-J004": (
        "{place} has no effect, because axis {axis} is not among the axes of the job. Add the axis"
        " with its travel and address (and with `before: []` if it has no positioning test)"
    ),
    "CW-J020": "{key} has no effect on this control ({format})",
    "CW-J021": (
        "The key acknowledged.{code} of the job is not needed, because the finding {code} does not"
        " occur{axis:if| on axis {axis}}. Remove the key."
    ),
}
