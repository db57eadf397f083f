"""Activate new cross-axis tables in the control's own files, without activating other tables."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from compwright.formats.families.pairs.existing_tables import ExistingTables
from compwright.formats.families.pairs.places import ADDED, DATA
from compwright.formats.text.gathering import FoundValue, same_value
from compwright.formats.text.own_files import OwnFiles, TablePlaces
from compwright.foundations.errors import Fault


class Switches:
    """The parameters that activate ``tables``: one for each table (SD41300), and one for all tables
    of an axis (MD32710).
    """

    def __init__(self, tables: ExistingTables) -> None:
        self.tables = tables
        self.own = tables.own

    def table_on(self, index: int) -> None:
        """Activate a written table in the files, with weight 1 and without further settings."""
        if self.own is None:
            return
        switches = self.tables.places_of(index, "cross_table_enabled")
        self._on(self.own, "cross_table_enabled", switches, [index], {"table": str(index)})
        self.own.put("cross_weight", self.tables.places_of(index, "cross_weight"), "1")
        for quantity in ("cross_type", *ADDED):
            self.own.put(quantity, self.tables.places_of(index, quantity), "0")

    def sum_on(self, output: str, faults: list[Fault]) -> None:
        """Set MD32710 of an axis to 1; add a fault if this would also activate tables other than
        the new ones.

        If no file states MD32710, the user has to set it by hand. Other tables on the axis are then
        a fault too.
        """
        if self.own is None:
            return
        self._check_shared(output, faults)
        places = self.tables.axis_places(output, "cross_axis_enabled")
        if places and not same_value(places[-1].text, "0"):
            return
        others = [index for index in self.tables.places if self._may_activate(index, output)]
        if not places:
            foreign = [i for i in others if self.tables.in_use.get(i) != (output, output)]
            self._refuse_missing_switch(output, foreign, faults)
        elif others:
            faults.append(
                Fault(
                    message=(
                        f"axis {output}: MD32710 $MA_CEC_ENABLE switches off all its CEC "
                        "tables. Switching it on for the new table also activates others: "
                        f"{self._listed(others)}"
                    ),
                    file=places[-1].occurrence.file,
                    place=places[-1].occurrence.place,
                    expected="MD32710 = 1, or SD41300 = 0 for the other tables on this axis",
                    found="0",
                    hint=(
                        "set SD41300 = 0 for these tables in the control, then export its files "
                        "again, with all CEC tables (NC_CEC.INI)"
                    ),
                )
            )
        else:
            named = {"axis": self.tables.spelling(output)}
            self._on(self.own, "cross_axis_enabled", places, self.tables.kept, named)

    def _on(
        self,
        own: OwnFiles,
        quantity: str,
        switches: Sequence[FoundValue],
        indices: Collection[int],
        named: Mapping[str, str],
    ) -> None:
        """Activate the tables ``indices``: set their activation parameter ``quantity`` to 1 in that
        one of its lines (``switches``) which is the last in each file. ``named``: axis or table of
        a new line.

        If that line comes before the tables' values, it stays off, and a new line with 1 is put
        after the values.
        """
        first = self.tables.first_values(indices)
        early = set()
        for number in dict.fromkeys(switch.number for switch in switches):
            last = max(one.occurrence.line for one in switches if one.number == number)
            if last < first.get(number, 0):
                early.add(number)
        own.put(quantity, [switch for switch in switches if switch.number not in early], "1")
        every = [self.tables.table_places(index) for index in sorted(indices)]
        rows = [row for places in every for group in places.rows.values() for row in group]
        for number in early:
            own.put_after_table(
                TablePlaces({0: rows}, {}, "cross_value", named), number, quantity, "1"
            )

    def _refuse_missing_switch(
        self, output: str, others: Sequence[int], faults: list[Fault]
    ) -> None:
        if not others:
            return
        places = self.tables.places[others[0]]
        place = (places.get("cross_output") or places["cross_table_enabled"])[0]
        faults.append(
            Fault(
                message=(
                    f"axis {output}: no given file shows whether its CEC tables are "
                    "switched on (MD32710 $MA_CEC_ENABLE). If they are off, switching on "
                    f"the new table also activates others: {self._listed(others)}"
                ),
                file=place.occurrence.file,
                place=place.occurrence.place,
                expected=(
                    f"MD32710 of {output} among the files, or SD41300 = 0 for the other tables on"
                    " this axis"
                ),
                found="in no file",
                hint=(
                    f"add the file with MD32710 of {output} to the control's files (`states` or"
                    " `--state`)"
                ),
            )
        )

    def _may_activate(self, index: int, output: str) -> bool:
        """Return whether setting MD32710 of the axis ``output`` possibly activates the table
        ``index``, although this is not one of the new tables.

        True also for a table whose activation parameter is in the files but whose values are in no
        file.
        """
        tables = self.tables
        if index in tables.kept or tables.off(index):
            return False
        if self._is_unread(index):
            return True
        if index not in tables.in_use or tables.is_empty(index):
            return False
        corrected = tables.in_use[index][1]
        names = self.own.gathered.names if self.own is not None else None
        unlisted = names is not None and bool(names.places) and not names.known(corrected)
        return corrected == output or unlisted

    def _is_unread(self, index: int) -> bool:
        """Return whether the files state the activation parameter of a table, but no values of the
        table.
        """
        places = self.tables.places[index]
        return "cross_table_enabled" in places and not any(name in places for name in DATA)

    def _listed(self, indices: Sequence[int]) -> str:
        """Return table numbers as text, marking those without values in the files."""
        unread = ", ".join(str(index) for index in indices if self._is_unread(index))
        return ", ".join(map(str, indices)) + (
            f" (values in no given file: {unread})" if unread else ""
        )

    def _check_shared(self, output: str, faults: list[Fault]) -> None:
        """Check that no table of compwright multiplies another table, and that the unit is mm."""
        tables = self.tables
        faults.extend(tables.factors(tables.kept))
        faults.extend(
            Fault(
                message=(
                    f"axis {output}: its CEC values are in inch (MD32711), which compwright does"
                    " not write"
                ),
                file=place.occurrence.file,
                place=place.occurrence.place,
                expected="1 (metric)",
                found=place.text,
                hint=(
                    "remove this axis from `cross`, or set MD32711 to 1 in the control and "
                    "export its files again"
                ),
            )
            for place in tables.axis_places(output, "cross_metric")[-1:]
            if same_value(place.text, "0")
        )
