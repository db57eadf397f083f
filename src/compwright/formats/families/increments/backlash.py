"""Backlash at cutting feed (parameter 1851) and at rapid traverse (1852): read and written.

Source: FANUC B-64120EN/01 page 116, 21i B-63090EN/02 page 97.

With smooth backlash the control puts out a part of the backlash at once after a reversal. It puts
out the rest between two distances from the reversal. After the second distance all of 1851 (1852)
has been put out, so a target farther away shows the full backlash. It is known from memory only
which of 1846 to 1849 is a distance and which is a part. Therefore the largest of these four values
is taken as the second distance.
"""

from __future__ import annotations

from dataclasses import dataclass

from compwright.formats.families.increments import parameters as known
from compwright.formats.families.increments.axis_values import IncrementAxisValues
from compwright.formats.families.increments.increment_facts import IncrementFacts
from compwright.formats.families.increments.parameters import AxisParameters, ParameterValue
from compwright.formats.text.notes import ADD_FILE, Notes
from compwright.records.axis import Axis, AxisKind
from compwright.words.sentences import control_text

#: A test turns further outside its first and last target than this, mm or deg: the standard's
#: cycles overrun by more, so that its targets see the whole backlash.
NEAR = 1.0


@dataclass(frozen=True, slots=True)
class SmoothBacklash:
    """The parameters of an axis' smooth backlash compensation that are not zero."""

    values: tuple[ParameterValue, ...]

    def note(self, label: str, kind: AxisKind, unit: float, notes: Notes) -> None:
        """Report the effect of smooth backlash compensation; add a fault if its stages reach so far
        behind a reversal that targets of a test can lie within them. ``unit``: the detection unit,
        mm or deg.
        """
        farthest = max(self.values, key=lambda value: abs(value.whole))
        reach = abs(farthest.whole) * unit
        names = [value.label for value in self.values]
        notes.find("CW-S047", "warning", label=label, parameters=names, reach=reach, unit=kind.unit)
        if reach <= NEAR:
            return
        fault = farthest.fault(
            f"{label}: smooth backlash compensation divides 1851 into stages, perhaps up to "
            f"{reach:g} {kind.unit} behind a reversal: the backlash at the targets of a test is "
            "unknown",
            f"at most {NEAR:g} {kind.unit} in detection units of {unit:g}, or 0 and a new test",
        )
        notes.faults.append(fault)


def smooth_backlash(own: AxisParameters) -> SmoothBacklash | None:
    """Return the smooth backlash compensation of the axis with the parameters ``own``; None if it
    has none.
    """
    values = (own.get(number) for number in known.SMOOTH_BACKLASH)
    active = tuple(value for value in values if value is not None and value.nonzero)
    return SmoothBacklash(active) if active else None


def first_stage(own: AxisParameters) -> int:
    """Return the part of the backlash that is output at once (1848), in detection units, by an
    axis' parameters ``own``; 0 if none.
    """
    value = own.get(known.SMOOTH_FIRST)
    return 0 if value is None else value.whole


def covers(backlash: int | None, stage: int) -> bool:
    """Return whether the backlash includes its first stage (1848): same sign, and at least as
    large.
    """
    return stage == 0 or (backlash is not None and backlash * stage >= stage * stage)


def active_backlash(values: IncrementAxisValues, feed: int) -> int:
    """Return the backlash, in detection units, that was active when the axis was measured: at rapid
    traverse (1852) or at cutting feed (``feed``, the value of 1851).

    If the files do not show which of them was active, a fault is added. If both values can be
    active and differ, a finding is added.
    """
    rapid, separate = values.integer("backlash_rapid"), values.separate_rapid()
    at_rapid = values.axis is not None and values.axis.motion == "rapid"
    bit_known = values.own.all.counts(known.BACKLASH_BITS)
    bits = values.own.get(known.BACKLASH_BITS)
    if at_rapid and separate and rapid is None and bits is not None:
        message = (
            "its test was taken at rapid traverse (motion: rapid), where 1852 is active (1800#4)"
        )
        expected = "the line of 1852 among the files"
        values.notes.once(bits.fault(f"{values.label}: {message}", expected, ADD_FILE))
    if separate is False or rapid is None or rapid == feed:
        return feed
    if at_rapid and separate is None:
        message = (
            "its test was taken at rapid traverse (motion: rapid), and no file says whether 1852"
            f" = {rapid} is active there or 1851 = {feed}"
        )
        help_ = "the line of 1800 (bit 4) among the files"
        alone = "a test at cutting feed: which bit says it on this series is not known"
        values.wrong(
            "backlash_rapid",
            message,
            help_ if bit_known else alone,
            hint=ADD_FILE
            if bit_known
            else "repeat the test at cutting feed, or leave the axis out of the job",
        )
    silent = (
        control_text("1800#4 is not in the files")
        if bit_known
        else control_text("the bit that makes 1852 active is unknown")
    )
    why = "1800#4 = 1" if separate else silent
    values.notes.find(
        "CW-S015",
        "warning",
        label=values.label,
        feed=feed,
        rapid=rapid,
        why=why,
        rapid_shown=at_rapid,
    )
    return rapid if at_rapid else feed


def both_backlashes(axis: Axis, facts: IncrementFacts, count: int) -> dict[str, int]:
    """Return the new values of the backlash parameters: 1851, and 1852 if it is in the files and
    not switched off. ``count``: the new backlash, in detection units, at the kind of motion at
    which the axis was measured.

    The difference between 1852 and 1851 stays the same as in ``facts``.
    """
    rapid, feed = facts.backlash_rapid, facts.backlash or 0
    if rapid is None or facts.separate_rapid is False:
        return {"backlash": count}
    if axis.motion == "rapid":
        return {"backlash": count - (rapid - feed), "backlash_rapid": count}
    return {"backlash": count, "backlash_rapid": count + rapid - feed}


def backlash_words(facts: IncrementFacts) -> str:
    """Return the card's text on parameter 1852; empty if no file contains it."""
    if facts.backlash_rapid is None:
        return ""
    active = {
        True: control_text("at rapid traverse; 1851 is active at cutting feed, because 1800#4 = 1"),
        False: control_text(
            "is not active and stays as it is: 1851 is active at all feeds, because 1800#4 = 0"
        ),
        None: control_text("is active at rapid traverse if 1800#4 = 1, which is in no file"),
    }[facts.separate_rapid]
    return control_text(
        "1852 = {value} detection units ({active})", value=str(facts.backlash_rapid), active=active
    )
