"""Parameters as lines of text, including bit masks -> values of each axis."""

from __future__ import annotations

import re
from collections.abc import Iterable

from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import Occurrence, readable
from compwright.formats.families.columns.sources import PARAMETERS, Sources
from compwright.formats.text.gathering import FoundValue
from compwright.formats.text.texts import TextReader
from compwright.formats.text.values import name_of
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile

_MASK = re.compile(r"%([01]{1,32})|([0-9]{1,9})")


def take_parameters(
    sources: Sources, reader: TextReader, file: ControlFile, number: int, faults: list[Fault]
) -> None:
    """Add the parameters of a text to the sources; ``number``: its index among the files."""
    known = len(faults)
    text = reader.read(file, faults, number)
    sources.findings.extend(text.findings if text is not None else ())
    lines = _parameter_lines(sources.definition)
    found = [
        place
        for place in (text.occurrences if text is not None else ())
        if place.statement in lines
    ]
    if not found and len(faults) == known:
        faults.append(_nothing(sources.definition, file, lines))
    for place in found:
        quantity = lines[place.statement]
        if quantity == "enabled":
            _take_mask(sources, place, number, faults)
        else:
            address = sources.numbers.address(int(place.tokens["number"].text) + 1)
            given = FoundValue(place.tokens["value"].text, place, number)
            sources.given.setdefault((address, quantity), []).append(given)


def _parameter_lines(definition: Definition) -> dict[str, str]:
    """Return the statements of lines that hold parameters, with their quantities."""
    return {
        statement.name: quantity
        for quantity in PARAMETERS
        if quantity in definition.bindings
        for statement in definition.statements.values()
        if statement.text == "parameters"
        and statement.form.startswith(name_of(definition, quantity))
    }


def _nothing(definition: Definition, file: ControlFile, lines: Iterable[str]) -> Fault:
    kinds = "an entry sheet, or a table that begins with BEGIN"
    forms = [readable(definition.statements[name].form) for name in lines]
    return Fault(
        message=f"contains no compensation data of {definition.id}",
        file=file.name,
        expected=f"{kinds}, or lines such as {', '.join(forms)}" if forms else kinds,
        hint=(
            "give the file with tables or compensation parameters of this control, or "
            "correct `format`"
        ),
    )


def _take_mask(sources: Sources, place: Occurrence, file: int, faults: list[Fault]) -> None:
    text = place.tokens["value"].text
    mask = mask_of(text)
    if ambiguous(text):
        name = name_of(sources.definition, "enabled")
        message = (
            f"{name} is a mask or a decimal number: with these digits it can be read in two ways"
        )
        faults.append(
            Fault(
                message=message,
                file=place.file,
                place=place.place,
                expected=f"%{text}, or %{int(text):b}",
                found=text[:60],
                hint=(
                    "correct the bits in a copy of this file, or export it from the control again"
                ),
            )
        )
        return
    if mask is None:
        faults.append(
            Fault(
                message="the bits cannot be read",
                file=place.file,
                place=place.place,
                expected="%00011, or 3",
                found=text[:60],
                hint=(
                    "correct the bits in a copy of this file, or export it from the control again"
                ),
            )
        )
        return
    for number, address in sources.numbers.by_number.items():
        bit = str(mask >> (number - 1) & 1)
        sources.given.setdefault((address, "enabled"), []).append(FoundValue(bit, place, file))


def ambiguous(text: str) -> bool:
    """Return whether digits without ``%`` mean different numbers as bits and as decimal (``11``: 3
    or 11).
    """
    return re.fullmatch("[01]{1,32}", text) is not None and int(text, 2) != int(text)


def mask_of(text: str) -> int | None:
    """Return a bit mask (``%00011`` or ``3``) as a number, bit 0 the first axis; None for other
    text.
    """
    match = _MASK.fullmatch(text)
    if match is None:
        return None
    return int(match[1], 2) if match[1] else int(match[2])
