"""What a FANUC's files state about one axis, and the screw lead that its parameters suggest."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from decimal import Decimal

from compwright.formats.families.increments import parameters as known
from compwright.formats.families.increments.axis_values import INCH, IncrementAxisValues
from compwright.formats.families.increments.backlash import first_stage
from compwright.formats.families.increments.detection_unit import detection_unit
from compwright.formats.families.increments.increment_facts import IncrementFacts, increments_of
from compwright.formats.families.increments.neighbour_functions import (
    OPTION_OF,
    functions,
    functions_on_points,
    left_alone,
    straightness_functions,
)
from compwright.formats.families.increments.parameters import AxisParameters
from compwright.formats.families.increments.sections import idle_points
from compwright.formats.text.notes import Notes
from compwright.records.axis import AxisKind
from compwright.records.facts import AxisFacts
from compwright.records.options import DETECTION_UNIT
from compwright.words.sentences import control_text, say

#: What `new` says of the limits of an axis in diameter programming.
_HALVED = (
    "half of 1320 and 1321: the control shows positions of a diameter axis (1006#3) in diameter"
    " (B-62754EN/01 page 104), a job counts in radius; that 1320 and 1321 do too is inferred: check"
)
#: Numbers, magnification and interval of a grid.
_GRID = (3620, 3621, 3622, 3623, 3624)


#: What would let straightness compensation be counted with.
_UNCOUNTED_HELP = "the option `straightness: available` of the controller"


def facts_of(values: IncrementAxisValues) -> AxisFacts:
    """Return what the files state about an axis: kind, name, turn, limits, unit, point numbers."""
    increments = _increments(values)
    kind, wraps = values.kind(quiet=True), values.wraps()
    unit = detection_unit(values.own, kind)
    turn = None if wraps is None else values.turn(kind)
    rotary = values.word("rotary", values.found("rotary"))
    first, last = increments.first_number, increments.last_number
    diameter, absolute, two_sets = (
        values.yes(name) for name in ("diameter", "absolute_encoder", "bidirectional")
    )
    lead = screw_lead(values.own, kind)
    low, high, reference = (
        _coordinate(values, name, kind)
        for name in ("limit_low", "limit_high", "reference_coordinate")
    )
    limits = None if low is None or high is None else (low, high)
    halved = bool(diameter) and kind is AxisKind.LINEAR and limits is not None
    if halved and limits is not None:
        limits = (limits[0] / 2, limits[1] / 2)
    return AxisFacts(
        name=name_of(values),
        name_evidence="1020",
        kind=None if rotary is None else AxisKind(rotary),
        limits=limits,
        limits_evidence=_HALVED if halved else "",
        enabled=bool(increments.magnification) and first != last,
        endless=turn if wraps else None,
        reference=reference,
        reference_return=values.returning(),
        absolute_encoder=absolute,
        diameter=diameter,
        grid=idle_points(values, kind),
        unit_evidence="" if unit is None else unit.evidence,
        lead=None if lead is None else lead.size,
        lead_evidence="" if lead is None else lead.evidence,
        of_family=replace(increments, two_sets=bool(two_sets)),
        stated={} if unit is None else {DETECTION_UNIT: unit.size},
    )


def name_of(values: IncrementAxisValues) -> str | None:
    """Return the axis name from its character codes in parameters 1020, 1025 and 1026."""
    code = values.integer("axis_name")
    if code is None or not ord("A") <= code <= ord("Z"):
        return None
    further = (values.own.get(number) for number in known.NAME_MORE)
    codes = [value.whole for value in further if value is not None and value.nonzero]
    return chr(code) + "".join(chr(one) for one in codes if chr(one).isalnum() and one < 128)


def with_neighbours(
    facts: AxisFacts, own: AxisParameters, options: Mapping[str, object]
) -> AxisFacts:
    """Return ``facts`` completed by the functions that are active on an axis in addition to its
    table, and that a new table leaves unchanged. ``own``: the parameters of the axis.
    """
    every = tuple(functions(own))
    alone = left_alone(every, options)
    by_option = {OPTION_OF.get(each.words): each.description for each in every}
    increments = replace(
        increments_of(facts),
        hung=functions_on_points(own, every),
        foreign=tuple(numbers for _, numbers in own.all.second_tables),
        first_stage=first_stage(own),
        inclined=by_option.get("inclination", ""),
        waved=by_option.get("cyclic", ""),
    )
    words = [function.description for function in alone if function.moves]
    if words:  # their effect depends on the grid
        grid = (
            *(increments.reference_number, increments.first_number, increments.last_number),
            *(increments.magnification, increments.interval),
        )
        words += [f"{number} = {value}" for number, value in zip(_GRID, grid, strict=True)]
    pairs = replace(
        facts.pairs, uncounted=straightness_functions(own, alone), uncounted_help=_UNCOUNTED_HELP
    )
    return replace(facts, other_functions="; ".join(words), of_family=increments, pairs=pairs)


def _increments(values: IncrementAxisValues) -> IncrementFacts:
    return IncrementFacts(
        reference_number=values.integer("reference_number"),
        first_number=values.integer("first_number"),
        last_number=values.integer("last_number"),
        magnification=values.integer("magnification"),
        negative_first=values.integer("negative_first"),
        negative_offset=values.integer("negative_offset"),
        backlash_rapid=values.integer("backlash_rapid"),
        backlash=values.integer("backlash"),
        separate_rapid=values.separate_rapid(),
        inch=values.own.bit(known.INCH, 0),
        rapid_feed=_rapid_feed(values),
        interval=_length(values, "table_spacing"),
        turn=_length(values, "turn"),
    )


def _rapid_feed(values: IncrementAxisValues) -> float | None:
    rapid = values.own.get(known.RAPID)
    if rapid is None or not rapid.nonzero:
        return None
    inch = values.in_inches(rapid.key, values.kind(quiet=True))
    return float(Decimal(rapid.text) * (INCH if inch else 1))


def _length(values: IncrementAxisValues, quantity: str) -> float | None:
    """Return parameter 3624 or 3625 as a length, mm or deg; None if it is not readable."""
    length = replace(values, notes=Notes()).length(quantity, values.kind(quiet=True))
    return None if length is None else float(length)


def _coordinate(values: IncrementAxisValues, quantity: str, kind: AxisKind) -> float | None:
    """Return a machine coordinate, mm or deg. None without a decimal point, because its unit is
    then unknown.
    """
    found = values.found(quantity)
    if found is None or "." not in found.text:
        return None
    return float(values.length(quantity, kind) or 0)


#: Lengths are the same within this part: what a job says in few digits.
_SAME_LENGTH = 1e-3


@dataclass(frozen=True, slots=True)
class Lead:
    """The travel per motor turn, mm or deg, and (as text) the parameters that state it."""

    size: float
    evidence: str


def screw_lead(own: AxisParameters, kind: AxisKind) -> Lead | None:
    """Return the travel between two reference marks of the motor encoder, which on a screw is its
    lead. None if the parameters of the axis (``own``) do not show it.

    Parameter 1821 states the detection units from one mark to the next. For an encoder on the motor
    this is one turn of the motor, on a screw its lead (B-63943EN-1/02 page 109). With a separate
    detector (1815#1 = 1, from memory) it is the distance of the marks of a scale, which does not
    show the lead.
    """
    unit, counter = detection_unit(own, kind), own.get(known.REFERENCE_COUNTER)
    if unit is None or counter is None or own.bit(known.ENCODER, 1) is not False:
        return None
    size = round(counter.whole * unit.size, 9)
    if size <= 0 or (kind is AxisKind.ROTARY and size >= 360.0):
        return None
    evidence = control_text(
        "1821 = {count} detection units of {size} {unit} between two marks, encoder on the motor"
        " (1815#1 = 0); inferred",
        count=counter.text,
        size=f"{unit.size:g}",
        unit=kind.unit,
    )
    return Lead(size, evidence)


def note_lead(values: IncrementAxisValues, kind: AxisKind) -> None:
    """Report the screw lead that the parameters suggest, unless it is one of the periods that the
    job states for the axis.
    """
    lead = screw_lead(values.own, kind)
    if values.axis is None or lead is None:
        return
    named = values.axis.screw_pitch
    if any(abs(period - lead.size) <= _SAME_LENGTH * lead.size for period in named):
        return
    suggested = say(
        "CW-S049.suggested",
        label=values.label,
        lead=lead.size,
        unit=kind.unit,
        evidence=lead.evidence,
    )
    if named:
        values.notes.find("CW-S049.other", "warning", suggested=suggested, periods=named)
        return
    values.notes.find("CW-S049.none", "info", suggested=suggested, lead=lead.size)
