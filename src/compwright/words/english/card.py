"""Labels and fixed sentences of the commissioning card."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "card.adds": "Control adds",
    "card.and": "{names:and}",
    "card.axis": "Axis {name}",
    "card.axis_title": "Axis {axis}, control address {address}",
    "card.capital": "{text:capital}",
    "card.check_positions": "Check positions",
    "card.circle": "Circle {name}",
    "card.confirmed": "confirmed",
    "card.date": "date",
    "card.decided": "{name}: {decided:join|; }.",
    "card.evidence": "Evidence: {evidence}",
    "card.expected": "Expected deviation",
    "card.fixed": "Fixed positions that move",
    "card.how_to_check": (
        "Make every check of this card at these positions. If the control has a compensation"
        " display, read there which correction it adds. After loading, make the quick check with"
        " the instrument."
    ),
    "card.inferred": "inferred",
    "card.limit": (
        "{symbol} {limit} {unit}: {decision:choose|accept=accept|reject=reject|=undecided}"
    ),
    "card.limits": "Limits, as predicted",
    "card.lines": "{texts:join|\n}",
    "card.loaded_by": "loaded by",
    "card.look_at": "{text} ({state:choose|inferred=inferred|=unconfirmed})",
    "card.measured": "measured",
    "card.measured_by": "measured after loading, by",
    "card.more_changes": "{more} more changes are in changes.csv.",
    "card.moves_by": "Moves by",
    "card.name": "Name",
    "card.no_title": "Commissioning card",
    "card.not_confirmed": "Not confirmed: check these facts before the axis moves fast",
    "card.note": (
        "Numbers in tables and steps have a decimal point, as they are typed at a control. Names of"
        " parameters, options and files are as in the control and in the job.{foreign:if| Steps of"
        " your own definition have no translation and are in English.}"
    ),
    "card.parameter": "{name} = {value}",
    "card.points": "The control must have room for at least {points} points for this axis.",
    "card.proven": "Proven",
    "card.quantity": "Quantity",
    # A control may have another backlash at rapid traverse.
    "card.rapid": (
        "Measured at rapid traverse: the backlash, corrections and check positions of this card"
        " are valid at rapid traverse. Check them at rapid traverse, not at cutting feed."
    ),
    "card.read": "read",
    "card.same_holds": "This step applies to axis {axes} too.",
    "card.sections": "Numbers of the sections",
    "card.signature": (
        "Loaded by: ______________________   Date: ______________   Measured after loading: [ ]"
    ),
    "card.steps": "Steps",
    "card.stop": "Stop if off by",
    "card.then": "{names:join|, then }",
    "card.title": "Commissioning card: {axes}",
    "card.typed_column": (
        "{what:capital}. {total:if|Replace the values in {where} by|Add to the values in {where}}:"
        " {rows} ({values:choose|correction=corrections|error=errors}; all rows:"
        " {sheet}{total:if||, on straight lines between them}). {more:if|The table gets more rows,"
        " at the same spacing: DATUM is the position of the first row. In a new row, every other"
        " column gets its value in the nearest old row. |}{selected}{check}"
    ),
    "card.unconfirmed": "unconfirmed",
    "card.values": "Values that change",
    "card.way_back": "Way back",
    "card.with_unit": "{text} ({unit})",
    "card.zeroed": "Measure in this order, with the instrument set to zero at the first row.",
    "numbering.label": "numbers of the sections",
    "numbering.mark": "is the reference position",
    "numbering.number": "number",
    "numbering.parameter": "parameter",
    "numbering.position": "position",
    "numbering.position_unit": "position, {unit}",
    "numbering.reference": "reference",
    "numbering.travel_negative": "travel in -",
}
