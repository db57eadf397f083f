"""Read an axis' backlash from its lists, and refuse kinds of compensation that are unknown."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal, InvalidOperation

from compwright.formats.families.lists.statements import AxisStatements
from compwright.formats.families.lists.table import TENTH
from compwright.formats.text.gathering import FoundValue, same_value
from compwright.formats.text.notes import ADD_FILE, CORRECT_VALUE, NOT_COUNTED
from compwright.records.axis import Direction

#: A backlash holds numbers up to this one.
_MOST = 32767


def backlash_of(of: AxisStatements, *, two: bool) -> float:
    """Return the backlash of the axis with the statements ``of``, in mm or deg. ``two``: the axis
    has an active table with one column per direction.
    """
    switch = of.one("backlash_switch")
    gears = of.rows("backlash")
    lose = gears.get(0)
    on = switch is not None and not same_value(switch.text, "0")
    if switch is not None and switch.text.strip("0") not in ("", "1", "2"):
        message = "the switch of the backlash has a value that is not known"
        of.notes.refuse(of.label, message, switch, expected="0, 1 or 2", hint=CORRECT_VALUE)
    if lose is None:
        if switch is not None and on:
            message = f"the backlash is switched on, but {_name(of)} is missing"
            expected = "the axis parameter list with it too"
            of.notes.refuse(of.label, message, switch, expected=expected, hint=ADD_FILE)
        else:
            value = of.values.absent("backlash", tell=False)
            evidence = "unconfirmed: in no list that was given"
            of.notes.assume(f"{of.label}: {_name(of)}", str(value), evidence)
    _check_gears(of, gears)
    if lose is None or Decimal(lose.text) == 0:
        return 0.0
    if switch is None:
        message = f"{_name(of)} is not 0, but no list shows whether it is active"
        expected = f"{of.lists.name('backlash_switch')} in the lists too"
        of.notes.refuse(of.label, message, lose, expected=expected, hint=ADD_FILE)
    return _checked_backlash(of, Decimal(lose.text), lose, two=two) if on else 0.0


def _name(of: AxisStatements) -> str:
    return of.lists.name("backlash").replace("..", "0")


def _checked_backlash(
    of: AxisStatements, number: Decimal, place: FoundValue, *, two: bool
) -> float:
    if number != int(number) or abs(number) > _MOST:
        expected = f"a whole number, {-_MOST} to {_MOST}"
        of.notes.refuse(
            of.label,
            "a backlash must be a whole number",
            place,
            expected=expected,
            hint=CORRECT_VALUE,
        )
    elif number < 0:
        message = "a backlash less than 0 (play before the measuring system) is not understood"
        of.notes.refuse(
            of.label, message, place, expected="0 or more, or switched off", hint=NOT_COUNTED
        )
    elif two:
        message = (
            "a backlash is active in addition to a table with two columns, which contains the"
            " reversal"
        )
        of.notes.refuse(of.label, message, place, expected="0, or switched off", hint=NOT_COUNTED)
    other = "-" if of.returns is Direction.POSITIVE else "+"
    of.notes.assume(
        f"{of.label}: direction in which {_name(of)} acts",
        f"arriving in {other}",
        "unconfirmed: no page says which direction gets the backlash",
    )
    return float(number * Decimal(str(TENTH)))


def _check_gears(of: AxisStatements, gears: Mapping[int, FoundValue]) -> None:
    """Check that each gear stage has the backlash of the first one, or zero."""
    first = gears.get(0)
    for gear, found in gears.items():
        same = first is not None and same_value(found.text, first.text)
        if Decimal(found.text) and not same:
            message = f"the backlash of gear {gear} differs from that of gear 0"
            of.notes.refuse(of.label, message, found, expected="the same, or 0", hint=NOT_COUNTED)


def check_others(of: AxisStatements) -> None:
    """Add faults for active compensations that compwright does not read, such as one by the
    positions of two other axes. ``of``: the statements of the axis.
    """
    for found in of.lists.places(of.address, "other"):
        if not _is_zero(found.text):
            name = found.occurrence.tokens["name"].text
            message = f"kw.{name} is unknown; it may be active"
            of.notes.refuse(
                of.label, message, found, expected="0, or a list without it", hint=NOT_COUNTED
            )
    switch = of.one("plane_switch")
    if switch is not None and same_value(switch.text, "0"):
        return
    for found in of.lists.places(of.address, "plane"):
        if not _is_zero(found.text):
            message = (
                "a compensation over two other axes (kw.crosscomp2) is active, which compwright"
                " does not read"
            )
            expected = f"{of.lists.name('plane_switch')} 0, or values of 0"
            of.notes.refuse(of.label, message, found, expected=expected, hint=NOT_COUNTED)


def _is_zero(text: str) -> bool:
    try:
        return Decimal(text) == 0
    except InvalidOperation:
        return False
