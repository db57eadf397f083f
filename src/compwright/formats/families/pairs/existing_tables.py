"""The existing cross-axis tables in the control's own files, to which new ones are added."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence

from compwright.formats.definition.statements import name_in_form
from compwright.formats.families.family import Family
from compwright.formats.families.pairs.options import allowed_tables
from compwright.formats.families.pairs.places import (
    BETWEEN,
    DATA,
    Pair,
    Places,
    is_elsewhere,
    is_unused,
    is_zero,
    of_axis,
    places_of,
)
from compwright.formats.text.addresses import normal_text
from compwright.formats.text.gathering import FoundValue, same_value
from compwright.formats.text.own_files import OwnFiles, TablePlaces, rows_by_index
from compwright.foundations.errors import Fault
from compwright.words.sentences import control_text


class ExistingTables:
    """The cross-axis tables of one control.

    - ``own``: the files that contain the tables; None if no file is changed.
    - ``allowed``: the table indices that may be written.
    - ``in_use``: by index, the input axis and the output axis of every existing table.
    - ``kept``: the indices of the tables that compwright writes.
    - ``stay``: the indices of tables by which an axis corrects itself and that stay unchanged.
    """

    def __init__(self, control: Family, own: OwnFiles | None) -> None:
        self.definition = control.definition
        self.own = own
        self.allowed = allowed_tables(control.definition, control.options)
        tables = control.state.tables
        self.reserved = tables.reserved
        self.stay = tables.stay
        self.places: Mapping[int, Places] = places_of(own.gathered) if own is not None else {}
        self.in_use: Mapping[int, Pair] = self._used() if own is not None else tables.used
        self.kept: set[int] = set()

    def _used(self) -> dict[int, Pair]:
        """Return the input axis and output axis of every table in the files, by table index."""
        return {
            index: (self._axis_in(places, "cross_input"), self._axis_in(places, "cross_output"))
            for index, places in self.places.items()
            if is_elsewhere(places)
            or (any(name in places for name in DATA) and not is_unused(places))
        }

    def _axis_in(self, places: Places, quantity: str) -> str:
        found = places.get(quantity, ())
        return self.axis(found[-1].text) if found else ""

    def axis(self, name: str) -> str:
        """Return the address of an axis, given by any of its names in the files."""
        if self.own is None:
            return normal_text(self.definition, name)
        return self.own.gathered.axis(name)

    def spelling(self, address: str) -> str:
        """Return the name of an axis as the files spell it."""
        return address if self.own is None else self.own.gathered.spelled(address)

    def places_of(self, index: int, quantity: str) -> Sequence[FoundValue]:
        """Return each value of a quantity of one table, with its file and line."""
        return self.places.get(index, {}).get(quantity, ())

    def unnamed(self, index: int, quantity: str) -> list[FoundValue]:
        """Return the values of a table in lines that have empty brackets, ``()``, in place of an
        axis name.
        """
        statements, bindings = self.definition.statements, self.definition.bindings
        own = name_in_form(statements[bindings[quantity].statement].form)
        before = statements[bindings["cross_other"].statement].form.partition("{")[0]
        return [
            found
            for found in self.places_of(index, "cross_other")
            if found.text == "()"
            and (before + found.occurrence.tokens["key"].text).upper() == own.upper()
        ]

    def axis_places(self, output: str, quantity: str) -> Sequence[FoundValue]:
        """Return the values of a quantity that applies to all tables on one output axis."""
        return () if self.own is None else of_axis(self.own.gathered, output).get(quantity, ())

    def factors(self, changed: Collection[int]) -> Iterator[Fault]:
        """Yield a fault for each unchanged table that the control multiplies by one of the
        ``changed`` tables.
        """
        for index in self.places:
            for place in self.places_of(index, "cross_multiplier")[-1:]:
                if index in changed or int(place.text) - 1 not in changed or self.is_empty(index):
                    continue
                yield Fault(
                    message=control_text(
                        "CEC table {index} has to be written, but the control multiplies it by"
                        " table {other} ($AN_CEC_MULT_BY_TABLE)",
                        index=str(index),
                        other=str(int(place.text) - 1),
                    ),
                    file=place.occurrence.file,
                    place=place.occurrence.place,
                    expected=control_text("other indices in the option cec_tables"),
                    found=place.text,
                    hint=control_text("give other indices in the option `cec_tables`"),
                )

    def is_empty(self, index: int) -> bool:
        """Return whether a table in the files contains only zeros."""
        return index in self.places and is_zero(self.places[index])

    def off(self, index: int, output: str = "") -> bool:
        """Return whether the last value in the files deactivates a table.

        The value is that of SD41300 of the table. If ``output`` is given, that of MD32710 of this
        axis can deactivate it too.
        """
        ends = [self.places_of(index, "cross_table_enabled")]
        if output:
            ends.append(self.axis_places(output, "cross_axis_enabled"))
        return any(places and same_value(places[-1].text, "0") for places in ends)

    def table_places(self, index: int) -> TablePlaces:
        """Return each value of one cross-axis table, with its file and line."""
        places = self.places.get(index, {})
        singles = {name: places[name] for name in DATA if name in places and name != "cross_value"}
        unnamed = [found for name in BETWEEN for found in self.unnamed(index, name)]
        return TablePlaces(
            rows_by_index(places.get("cross_value", ())),
            {**singles, "cross_other": unnamed},
            "cross_value",
            {"table": str(index)},
        )

    def first_values(self, indices: Collection[int]) -> dict[int, int]:
        """Return, by file index, the number of the first line in that file that states a value of
        one of these tables.
        """
        first: dict[int, int] = {}
        for index in indices:
            for row in self.places_of(index, "cross_value"):
                line = row.occurrence.line
                first[row.number] = min(first.get(row.number, line), line)
        return first

    def check_protected(self, index: int, output: str, faults: list[Fault]) -> None:
        """Add a fault for a file that activates a table before the table's values, because the
        control would reject these values.
        """
        for switches in (
            self.places_of(index, "cross_table_enabled"),
            self.axis_places(output, "cross_axis_enabled"),
        ):
            for number, line in self.first_values([index]).items():
                before = [
                    switch
                    for switch in switches
                    if switch.number == number and switch.occurrence.line < line
                ]
                if not before or same_value(before[-1].text, "0"):
                    continue
                fault = Fault(
                    message=control_text(
                        "CEC table {index}: this file switches the table on (SD41300, MD32710)"
                        " before it gives the values. A table that is on is protected, so the"
                        " control takes none of these values",
                        index=str(index),
                    ),
                    file=before[-1].occurrence.file,
                    place=before[-1].occurrence.place,
                    expected=control_text(
                        "0 in the switch, or the values before the switch or in a file of their"
                        " own, as the control exports them (NC_CEC.INI)"
                    ),
                    found=control_text(
                        "{value}, and the first value in line {line}",
                        value=before[-1].text,
                        line=str(line),
                    ),
                    hint=control_text(
                        "export the CEC tables into a file of their own (NC_CEC.INI), then give"
                        " that file"
                    ),
                )
                faults.append(fault)
