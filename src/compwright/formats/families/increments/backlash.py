"""Backlash at cutting feed (1851) and at rapid traverse (1852, if 1800#4 of the axis' path is 1):
which of them is active, and how both are written.

Source: FANUC B-64120EN/01 page 116, 21i B-63090EN/02 page 97.
"""

from __future__ import annotations

from compwright.formats.families.increments import parameters as known
from compwright.formats.families.increments.axis_values import IncrementAxisValues
from compwright.formats.families.increments.increment_facts import IncrementFacts
from compwright.formats.text.notes import ADD_FILE
from compwright.records.axis import Axis


def active_backlash(values: IncrementAxisValues, feed: int) -> int:
    """Return the active backlash at the motion of the axis' test, detection units; ``feed``: 1851.

    If the files leave it open, that is a fault; if the two differ, a finding.
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
        values.notes.once(bits.fault(f"{values.label}: {message}", expected))
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
        "1800#4 is not in the files" if bit_known else "the bit that makes 1852 active is unknown"
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
    """Return 1851, and 1852 where it may be active, for a table whose backlash is ``count``
    detection units at the motion of the axis' test. The difference of the two stays as in
    ``facts``.
    """
    rapid, feed = facts.backlash_rapid, facts.backlash or 0
    if rapid is None or facts.separate_rapid is False:
        return {"backlash": count}
    if axis.motion == "rapid":
        return {"backlash": count - (rapid - feed), "backlash_rapid": count}
    return {"backlash": count, "backlash_rapid": count + rapid - feed}


def backlash_words(facts: IncrementFacts) -> str:
    """Return the card's text on 1852; empty if no file holds it."""
    if facts.backlash_rapid is None:
        return ""
    active = {
        True: "at rapid traverse; 1851 is active at cutting feed, because 1800#4 = 1",
        False: "is not active and stays as it is: 1851 is active at all feeds, because 1800#4 = 0",
        None: "is active at rapid traverse if 1800#4 = 1, which is in no file",
    }[facts.separate_rapid]
    return f"1852 = {facts.backlash_rapid} detection units ({active})"
