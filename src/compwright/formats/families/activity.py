"""Decide whether tables were active during a test if the control's files do not show it.

The job's answer (`active`) applies only where the files do not decide. A table was active if the
last value in the files activates it. The files may deactivate a cross-axis table while the
leadscrew table of its axis was active. Then the cross-axis table was not active: one answer never
covers two mechanisms.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from compwright.formats.text.gathering import FoundValue
from compwright.formats.text.notes import Notes
from compwright.foundations.errors import Fault
from compwright.words.sentences import control_text

#: Next step where the files show an active table that was not active in a test.
IDLE_TEST: Final = (
    "If nothing was active during the test (no restart yet, not homed), add `idle: none` to "
    "`states` and `measured_in: idle` to the test"
)


@dataclass(frozen=True, slots=True)
class Activity:
    """What the job states on whether the tables were active during the test (``stated``; None:
    nothing).

    ``asking``: the answer is required, because measurements depend on it. ``carried_out``: all
    assignments in programs count as executed. Either the job's answer says so, or it was checked
    before.
    """

    stated: bool | None = None
    asking: bool = False
    carried_out: bool = False

    def was_active(
        self, label: str, switches: str, word: str | None, place: FoundValue | None, notes: Notes
    ) -> bool | None:
        """Return whether a table with values other than zero was active during the test.
        ``switches``: the name of its activation parameter; ``word``: the parameter's last value in
        the files (``yes``, ``no``, None: not stated), in the line ``place``.

        The result is None if the files do not activate the table and the job states nothing. If an
        answer is required, ``notes`` then gets the question to the user.
        """
        during = control_text("{label}: compensation during the test", label=label)
        if word == "yes":
            if self.stated is False:
                notes.assume(
                    during,
                    control_text("on"),
                    control_text("the files end with it switched on (active: no is of the others)"),
                )
                notes.contradictions.append(
                    Fault(
                        message=(
                            f"{label}: the job states `active: no`, but the files end with "
                            f"the table switched on ({switches})"
                        ),
                        file=place.occurrence.file if place is not None else "",
                        place=place.occurrence.place if place is not None else "",
                        expected="no key `active`",
                        found=place.text if place is not None else "",
                        hint=f"leave out `active` in this entry of `states`. {IDLE_TEST}",
                    )
                )
            return True
        notes.open_answers += 1
        if self.stated is not None:
            notes.assume(
                during,
                control_text("on") if self.stated else control_text("off"),
                control_text("the job's answer (active)"),
            )
            return self.stated
        if self.asking:
            ends = (
                f"end with the table switched off ({switches} = 0)"
                if word == "no"
                else f"do not show whether it is active ({switches})"
            )
            notes.ask(
                Fault(
                    message=(
                        f"{label}: its table is not zero, and the control's files "
                        f"{ends}, so it is unknown whether the table was active during the test"
                    ),
                    file=place.occurrence.file if place is not None else "",
                    place=place.occurrence.place if place is not None else "",
                    expected=(
                        "the answer `active: yes` or `active: no` for all tables of these files, or"
                        " files with the switches as they were during the test"
                    ),
                    found="no answer",
                    hint=(
                        "write `active: yes` or `active: no` into this entry of `states` in the "
                        "job (without a job: `--option active=yes`); if some tables were active "
                        "and others not, give the files with the switches"
                    ),
                )
            )
        return None
