"""Consistency of a commissioning archive: values in two of its members must agree; nothing else in
the container checks them.
"""

from __future__ import annotations

import re
from decimal import Decimal
from functools import lru_cache

from compwright.formats.families.grid.tables import value_fields
from compwright.formats.text.container import opened
from compwright.formats.text.gathering import FoundValue, Gathered, same_value
from compwright.formats.text.values import name_of
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile

_LINE = re.compile(
    rb"^[ \t]*(?:N\d+[ \t]+)?(\$\w+(?:[ \t]*\[[^\]\r\n]*\])?)[ \t]*=[ \t]*([^;\r\n]*?)"
    rb"[ \t]*(?:;[^\r\n]*)?\r?$",
    re.MULTILINE,
)
#: What a member does at the beginning of a load, and not what it leaves behind.
_PASSING = frozenset({"$MN_INIT_MD"})
#: Values by index and quantities of an axis that somebody compares with the control's display.
_SHOWN = 2


@lru_cache(maxsize=8)
def contradictions(file: ControlFile) -> tuple[Fault, ...]:
    """Return the faults of variables with two values in two members of an archive, with both
    lines.
    """
    container, _ = opened(file)
    seen: dict[str, tuple[str, str, int]] = {}
    faults = []
    for member in () if container is None else container.state:
        for name, (value, line) in _assigned(member.content).items():
            first, where, at = seen.setdefault(name, (value, member.name, line))
            if not same_value(first, value):
                faults.append(
                    Fault(
                        message=(
                            f"{name} contradicts {where}, line {at}. A control writes one "
                            "value into "
                            "both members, so one of them was changed"
                        ),
                        file=member.name,
                        place=f"line {line}",
                        expected=first,
                        found=value,
                        hint="export the archive from the control again",
                    )
                )
    return tuple(faults)


def _assigned(content: bytes) -> dict[str, tuple[str, int]]:
    """Return the last value of every system variable of a member, and its line."""
    found: dict[str, tuple[str, int]] = {}
    line, place = 1, 0
    for match in _LINE.finditer(content):
        line += content.count(b"\n", place, match.start())
        place = match.start()
        name = re.sub(r"\s", "", match[1].decode("latin-1")).upper()
        if name not in _PASSING:
            found[name] = match[2].decode("latin-1").partition(" '")[0].strip(), line
    return found


def compared(gathered: Gathered, address: str, system: str, unit: str) -> str:
    """Return the three values of an axis to be compared with the control's display, as in the
    archive, in ``unit``: the largest and the smallest of its table, and the backlash.
    """
    definition = gathered.definition
    rows = gathered.rows.get((address, system), [])
    field = value_fields(definition)[0]
    by_value = sorted(rows, key=lambda row: Decimal(row.occurrence.tokens[field].text))
    points = {row.occurrence.line: row for row in (*by_value[-1:], *by_value[:1], *rows[-1:])}
    shown = [
        f"{name_of(definition, 'value')}[{system},{row.occurrence.tokens['index'].text},{address}]"
        f" = {row.occurrence.tokens[field].text} {unit}"
        for row in list(points.values())[:_SHOWN]
    ]
    quantities = ("backlash", "table_end", "table_spacing", "enabled")
    places = (gathered.found(quantity, address, system)[-1:] for quantity in quantities)
    shown += [
        _single(gathered, found, f"[{system},{address}]", unit)
        for group in places
        for found in group
    ]
    return ", ".join(shown[: _SHOWN + 1])


def _single(gathered: Gathered, found: FoundValue, index: str, unit: str) -> str:
    name = gathered.definition.statements[found.occurrence.statement].form.partition("[")[0]
    counted = "" if "ENABLE" in name else f" {unit}"
    return f"{name}{index} = {found.text}{counted}"
