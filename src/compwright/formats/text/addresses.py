"""Address of an axis in the control's files."""

from __future__ import annotations

from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import field_matches
from compwright.foundations.errors import Fault, UsageError
from compwright.records.axis import Axis
from compwright.records.correction import Assumption


def normal_text(definition: Definition, address: str) -> str:
    """Return an address in its normal form: one spelling for each axis (``ax1`` -> ``AX1``, ``00``
    -> ``0``).

    Raises UsageError when the control cannot have such an axis.
    """
    rule = definition.addresses
    text = address.strip()
    if not field_matches(rule.type, text):
        expected = (
            "a number" if rule.type == "integer" else "a name of letters, digits and _, such as AX1"
        )
        raise UsageError(
            Fault(
                message=f"this is no address of an axis in {definition.id}",
                expected=expected,
                found=repr(address)[:40],
                hint=(
                    "set `address` of the axis in the job as the control names the axis, or "
                    "give `--option address=...`"
                ),
            )
        )
    if rule.type == "integer":
        return str(int(text))
    return text.upper() if rule.case == "ignored" else text


def normal_address(definition: Definition, axis: Axis) -> tuple[str, Assumption | None]:
    """Return the control's address of an axis, and the assumption made to find it.

    If the control numbers its axes and the job gives only an axis letter, the number is the
    letter's index in the list of the definition (such as XYZABCUVW). Raises UsageError when the
    control cannot name the axis.
    """
    letters = definition.addresses.letters
    letter = axis.address.strip().upper()
    if letters is not None and len(letter) == 1 and letter in letters:
        number = str(letters.index(letter))
        return number, Assumption(
            fact=f"address of axis {axis.name}",
            value=number,
            evidence=str(definition.addresses.evidence),
        )
    try:
        return normal_text(definition, axis.address), None
    except UsageError as error:
        numbered = definition.addresses.type == "integer"
        what, example = ("number", "1") if numbered else ("address", "AX1")
        raise UsageError(
            Fault(
                message=f"{definition.id} needs the {what} of axis {axis.name}",
                expected=f"the {what} of the control",
                found=error.faults[0].found,
                hint=(
                    f"add `address: {example}` to the axis in the job, or give `--option "
                    f"address={example}`"
                ),
            )
        ) from error
