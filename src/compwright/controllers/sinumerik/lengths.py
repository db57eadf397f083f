"""Lengths in inch in the files of a SINUMERIK, and their conversion to mm."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from compwright.controllers.request import Request
from compwright.controllers.sinumerik.axes import MachineAxisNames
from compwright.controllers.sinumerik.text import ProgramContent, VariableAssignment
from compwright.foundations.errors import Fault

_MM = 25.4  # mm in an inch, the default of MD10250
#: What is a length of a linear axis, in the basic system.
_LENGTHS = frozenset(
    {
        "AA_ENC_COMP",
        "AA_ENC_COMP_STEP",
        "AA_ENC_COMP_MIN",
        "AA_ENC_COMP_MAX",
        "MA_BACKLASH",
        "MA_BACKLASH_DYN",
        "MA_CEC_MAX_SUM",
    }
)
#: Bits of MD10220 that put another unit on positions or compensation values.
_OWN_UNITS = {"linear": (0, 11), "rotary": (1, 12)}


@dataclass(frozen=True, slots=True)
class Lengths:
    """The length units of the files. ``inch``: the basic system is inch; ``rotary``: upper-case
    axis -> whether it is rotary.
    """

    inch: bool
    rotary: Mapping[str, bool]

    def is_linear(self, axis: str) -> bool:
        """Return whether an axis is linear; an axis of unknown kind counts as linear."""
        return not self.rotary.get(axis.upper(), False)

    def in_mm(self, entry: VariableAssignment) -> VariableAssignment:
        """Return an assignment with its length converted to mm if the files are in inch; any other
        value stays as it is.
        """
        if not self.inch or entry.name not in _LENGTHS or not self.is_linear(entry.axis):
            return entry
        return replace(entry, value=entry.value * _MM)


def inches_in_mm(
    data: Sequence[VariableAssignment], *, values: bool, positions: bool
) -> list[VariableAssignment]:
    """Return the assignments of a CEC table in inch (MD32711), in which the corrections (if
    ``values``) and the positions (if ``positions``) are converted to mm.

    ``values`` is true if the output axis is linear, ``positions`` if the input axis is linear.
    """
    scaled = {"AN_CEC": values} | dict.fromkeys(
        ("AN_CEC_MIN", "AN_CEC_MAX", "AN_CEC_STEP"), positions
    )
    return [
        replace(entry, value=entry.value * _MM) if scaled.get(entry.name) else entry
        for entry in data
    ]


def lengths_of(
    contents: Sequence[ProgramContent], names: MachineAxisNames, request: Request
) -> tuple[Lengths, list[Fault]]:
    """Return the length units of the files; contradictions, unusual units and invalid kinds of axes
    are faults.

    If no file states the basic system, it is inch if the option ``units`` is ``inch``, else metric.
    """
    systems = [
        (metric, content.name, line)
        for content in contents
        for line, metric in content.units.metric
    ]
    inch = not systems[0][0] if systems else request.options.get("units") == "inch"
    rotary = {
        names.name(entry.axis).upper(): entry.value == 1.0
        for content in contents
        for entry in content.facts
        if entry.name == "MA_IS_ROT_AX"
    }
    rotary |= {names.name(axis).upper(): kind == "rotary" for axis, kind in request.kinds.items()}
    faults = [
        Fault(
            message=(
                "the files contradict each other about the basic unit system (MD10240, "
                "METRIC or INCH)"
            ),
            expected="inch" if inch else "metric",
            found="metric" if metric else "inch",
            file=file,
            place=f"line {line}",
            hint="export all files from the control again, at one time",
        )
        for metric, file, line in systems
        if metric is inch
    ]
    faults += [
        Fault(
            message=f"MD30300 $MA_IS_ROT_AX[{entry.axis}] has a value that is not known",
            file=entry.file,
            place=f"line {entry.line}",
            expected="0 or 1",
            found=f"{entry.value:g}",
            hint="export all files from the control again",
        )
        for content in contents
        for entry in content.facts
        if entry.name == "MA_IS_ROT_AX" and entry.value not in {0.0, 1.0}
    ]
    faults += _wrong_units(contents, request, inch=inch)
    return Lengths(inch=inch, rotary=rotary), faults


def _wrong_units(
    contents: Sequence[ProgramContent], request: Request, *, inch: bool
) -> list[Fault]:
    kinds = {str(kind) for kind in request.kinds.values()} or {"linear", "rotary"}
    own = [bit for kind in sorted(kinds) for bit in _OWN_UNITS[kind]]
    faults: list[Fault] = []
    for content in contents:
        faults += [
            Fault(
                message=(
                    "MD10250 $MN_SCALING_VALUE_INCH is changed: the control uses another "
                    "length for an inch"
                ),
                file=content.name,
                place=f"line {line}",
                expected=f"{_MM:g}",
                found=f"{value:g}",
                hint=f"set MD10250 to {_MM:g} in the control and export its files again",
            )
            for line, value in content.units.inch
            if inch and "linear" in kinds and value != _MM
        ]
        faults += [
            Fault(
                message=(
                    "MD10220 $MN_SCALING_USER_DEF_MASK: user-defined units are active (MD10230)"
                ),
                file=content.name,
                place=f"line {line}",
                expected="bits " + ", ".join(map(str, sorted(own))) + " not set",
                found=f"'H{mask:X}'",
                hint="clear these bits in the control and export its files again",
            )
            for line, mask in content.units.own
            if any(mask >> bit & 1 for bit in own)
        ]
    return faults


def encoders_of(contents: Sequence[ProgramContent], names: MachineAxisNames) -> dict[str, int]:
    """Return the number of measuring systems (MD30200) of each axis, by upper-case name."""
    return {
        names.name(entry.axis).upper(): int(entry.value)
        for content in contents
        for entry in content.facts
        if entry.name == "MA_NUM_ENCS" and entry.value in (0.0, 1.0, 2.0)
    }
