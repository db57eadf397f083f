"""The detection unit of an axis from the control's files and from the job, which must agree."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from decimal import Decimal
from fractions import Fraction

from compwright.formats.definition.options import axis_options
from compwright.formats.families.increments import parameters as known
from compwright.formats.families.increments.axis_values import IncrementAxisValues
from compwright.formats.families.increments.job_checks import check_diameter
from compwright.formats.families.increments.parameters import AxisParameters, ParameterValue
from compwright.foundations.errors import UsageError
from compwright.records.axis import AxisKind
from compwright.records.options import DETECTION_UNIT
from compwright.words.sentences import control_text

#: Settings of 1820: 2 x CMR for a CMR of 1/2 to 48, 100 + 1/CMR for a CMR of 1 to 1/27.
_DOUBLED, _DIVIDED = range(1, 97), range(101, 128)
#: Detection units are the same within this part: what the job says in few digits.
_SAME_UNIT = 1e-4


@dataclass(frozen=True, slots=True)
class DetectionUnit:
    """The detection unit of an axis in mm or deg, with the parameters that determine it."""

    size: float
    evidence: str
    multiplier: ParameterValue


def detection_unit(own: AxisParameters, kind: AxisKind) -> DetectionUnit | None:
    """Return the detection unit (least command increment / CMR) by an axis' parameters ``own``;
    None if these do not state it.

    Parameter 1820 states the command multiplier CMR. From 1 to 96 its value is 2 x CMR, from 101 to
    127 it is 100 + 1/CMR (B-63950EN/02 page 106, B-63943EN-1/02 page 109).

    The least command increment is 0.001 mm or deg by IS-B (0.01 by IS-A, 0.0001 by IS-C). A linear
    axis of an inch machine (1001#0) has a tenth of this number, in inches. Parameter 1013 states
    the increment system by axis; on older series 1004 states it. No page says which of its bits
    mean IS-D and IS-E. The effect of diameter programming (1006#3) is not known.
    """
    multiplier, system = own.get(known.MULTIPLIER), own.system
    power = None if system is None else _power(system)
    if multiplier is None or system is None or power is None or _unread(own, kind) is not None:
        return None
    inch = kind is AxisKind.LINEAR and bool(own.bit(known.INCH, 0))
    least = Decimal(1).scaleb(power) * (Decimal("2.54") if inch else 1)
    ratio, cmr = _command_multiplier(multiplier.whole)
    evidence = control_text(
        "1820 = {multiplier} (CMR {cmr}) and {system} = {setting} (least command increment {least}"
        " {unit}{inch})",
        multiplier=multiplier.text,
        cmr=cmr,
        system=str(system.number),
        setting=system.text,
        least=f"{least.normalize():f}",
        unit=kind.unit,
        inch=control_text(", inch machine by 1001#0") if inch else "",
    )
    return DetectionUnit(float(Fraction(least) / ratio), evidence, multiplier)


def _command_multiplier(setting: int) -> tuple[Fraction, str]:
    """Return the command multiplier (CMR) for a value of parameter 1820, as number and as text."""
    if setting in _DIVIDED:
        return Fraction(1, setting - 100), f"1/{setting - 100}"
    return Fraction(setting, 2), f"{setting / 2:g}"


def _power(system: ParameterValue) -> int | None:
    """Return the exponent (base 10) of the least command increment by 1013 or 1004; None if not
    documented.
    """
    stated = tuple(
        bit for bit in range(4 if system.number == known.SYSTEM else 2) if system.bit(bit)
    )
    return {(): -3, (0,): -2, (1,): -4}.get(stated)


def _unread(own: AxisParameters, kind: AxisKind) -> ParameterValue | None:
    """Return that one of an axis' parameters ``own`` whose value makes the detection unit unknown;
    None if there is none.
    """
    multiplier, system, bits = own.get(known.MULTIPLIER), own.system, own.get(known.KIND)
    if system is not None and _power(system) is None:
        return system
    if multiplier is None or not (multiplier.whole in _DOUBLED or multiplier.whole in _DIVIDED):
        return multiplier
    diameter = kind is AxisKind.LINEAR and bits is not None and bits.bit(3)
    return bits if diameter and system is not None else None


def two_systems(own: AxisParameters) -> str:
    """Return a sentence on an axis' parameters 1013 and 1004 (in ``own``) if they state different
    increment systems; empty if they agree.

    If they differ, the system in 1013 is used.
    """
    system, number = own.get(known.SYSTEM), known.SYSTEM_OF_MACHINE
    older = own.get(number) or own.another(number)
    if system is None or older is None or _power(system) == _power(older):
        return ""
    stated = (
        f"1004 = {older.text} names another increment system than 1013 = {system.text}; 1013 is"
        " counted (1004 is that of older series)"
    )
    return stated if older.bit(0) or older.bit(1) else ""


def resolved_options(
    values: IncrementAxisValues, options: Mapping[str, object]
) -> Mapping[str, object]:
    """Return the options of an axis, with the detection unit that follows from its files.

    A detection unit in the job must not contradict the files. Raises UsageError for a wrong option,
    and if the unit is unknown.
    """
    axis, kind = values.axis, values.kind(quiet=True)
    stated = detection_unit(values.own, kind)
    mine = axis.options if axis is not None else {}
    given = mine.get(DETECTION_UNIT, options.get(DETECTION_UNIT))
    taken = dict(options)
    if stated is None and given is None and _silent(values, kind):
        taken[DETECTION_UNIT] = 1.0
    elif stated is not None:
        if given is None:
            taken[DETECTION_UNIT] = stated.size
        values.notes.assume(
            control_text("{label}: detection unit", label=values.label),
            f"{stated.size:g} {kind.unit}",
            control_text("read: {evidence}", evidence=stated.evidence),
        )
    resolved = axis_options(values.definition, taken, axis)
    if stated is not None and given is not None:
        _check_unit(values, stated, float(str(resolved[DETECTION_UNIT])), kind.unit)
    return resolved


def _silent(values: IncrementAxisValues, kind: AxisKind) -> bool:
    """Return whether the user need not be asked for the detection unit although it is unknown.

    There are two such cases: nothing is active on an axis without a job, or the axis has other
    faults, which are reported first. Raises UsageError for a parameter value from which the unit
    does not follow.
    """
    if values.axis is None:
        return not values.does_anything()
    check_diameter(values, kind)
    odd = _unread(values.own, kind)
    if odd is not None and not values.notes.faults:
        raise UsageError(
            odd.fault(
                f"{values.label}: the detection unit does not follow from this value",
                "1820 = 1 to 96 or 101 to 127 with IS-A, IS-B or IS-C in 1013 and 1006#3 = 0",
                f"set `{DETECTION_UNIT}` (mm or deg, such as 0.001) in the options of the axis",
            )
        )
    return bool(values.notes.faults)


def _check_unit(values: IncrementAxisValues, stated: DetectionUnit, size: float, unit: str) -> None:
    other = abs(size - stated.size) > _SAME_UNIT * stated.size
    if other and (values.axis is not None or values.does_anything()):
        message = (
            f"{values.label}: the detection unit of the control's files differs from the option"
            " detection_unit"
        )
        fault = stated.multiplier.fault(
            message,
            f"{stated.size:g} {unit} by {stated.evidence}",
            f"delete the option `{DETECTION_UNIT}`, or set it to {stated.size:g}",
        )
        values.notes.faults.append(replace(fault, found=f"detection_unit: {size:g}"))
