"""Which HEIDENHAIN table is active for which axis: by the active .CMA line, else by its name."""

from __future__ import annotations

from compwright.controllers.heidenhain.given import Given, filled
from compwright.controllers.heidenhain.table import Cma, Com
from compwright.controllers.heidenhain.words import ITNC530, LETTERS
from compwright.records.correction import Assumption


class AxisAssignment:
    """Assigns a moving axis to every .COM; faults and notes go to ``given``."""

    def __init__(self, given: Given) -> None:
        self.given = given

    def moving_axes(self) -> list[tuple[Com, str | None]]:
        """Return every .COM with the axis that moves it, None if it is not active.

        A .COM that is active twice is listed twice.
        """
        if len(self.given.cmas) > 1:
            self.given.faults += [
                cma.place.fault("a second .CMA; only one is active", found=str(cma.place))
                for cma in self.given.cmas[1:]
            ]
            return []
        if not self.given.cmas:
            return [
                (com, axis)
                for com in self.given.coms
                if (axis := self._named_axis(com)) is not None
            ]
        cma = self.given.cmas[0]
        if cma.active is None:
            self.given.notes.append(
                f"{cma.place}: no line of the .CMA is active: its tables do not act"
            )
        elif not cma.marked:
            self.given.assumed.append(
                Assumption("active line of the .CMA", "the only one", "it bears no mark")
            )
        self._check_keys(cma)
        found: list[tuple[Com, str | None]] = []
        for moving, name in (cma.active or {}).items():
            held = [com for com in self.given.coms if name in com.names]
            if len(held) == 1:
                found.append((held[0], moving))
            else:
                message = f"the table {name}.COM under {moving} " + (
                    "was given twice" if held else "was not given"
                )
                self.given.faults.append(
                    cma.place.fault(message, expected="each .COM of the active line once")
                )
        assigned = {id(com) for com, _ in found}
        for com in self.given.coms:
            if id(com) not in assigned:
                found.append((com, None))
                self.given.notes.append(
                    f"{com.place}: {com.name}.COM does not act: the active line of the .CMA does"
                    " not name it"
                )
        return found

    def _check_keys(self, cma: Cma) -> None:
        """Check that .COM and .CMA of an NCK have the same axis keys as columns
        (CfgAxes/axisList).
        """
        if self.given.generation.name == ITNC530.name:
            return
        for com in self.given.coms:
            self.given.faults += [
                com.place.fault(
                    "column of an axis that the .CMA does not know",
                    expected=" or ".join(cma.axes),
                    found=axis,
                )
                for axis in filled(com)
                if axis not in cma.axes
            ]

    def _named_axis(self, com: Com) -> str | None:
        """Return the axis of a .COM without a .CMA: named in its head or its file name, else the
        option ``axis``.
        """
        known = dict.fromkeys(
            [
                *LETTERS,
                "U",
                "V",
                "W",
                *(a for one in self.given.coms for a in one.columns),
                *(s.address for s in self.given.sheets),
            ]
        )
        axes = {self._by_case(name, known) for name in com.names} - {None}
        option = self.given.request.options.get("axis")
        if not axes and len(self.given.coms) == 1 and option:
            axes = {self.given.generation.address(str(option))}
        if len(axes) != 1:
            self.given.faults.append(
                com.place.fault(
                    "nothing says which axis moves this table",
                    expected="its .CMA, or one axis as its name",
                    found=" and ".join(sorted(com.names)),
                )
            )
            return None
        moving = axes.pop()
        if sum(1 for other in self.given.coms if other.names & com.names) > 1:
            self.given.faults.append(
                com.place.fault("two tables of one name", expected="each .COM once", found=com.name)
            )
        self.given.assumed.append(
            Assumption(
                f"axis that moves {com.name}.COM", str(moving), "no .CMA was given: by its name"
            )
        )
        return moving

    def _by_case(self, name: str, known: dict[str, None]) -> str | None:
        found = [axis for axis in known if axis == name] or [
            axis for axis in known if axis.upper() == name
        ]
        return found[0] if len(found) == 1 else None
