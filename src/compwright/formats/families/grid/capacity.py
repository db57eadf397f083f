"""The limits of one axis' table, from the definition, the options and the control's own files."""

from __future__ import annotations

from compwright.formats.definition.consistency import curves
from compwright.formats.definition.options import resolved_number
from compwright.formats.families.family import Family
from compwright.formats.families.grid.axis_settings import MODULO_START
from compwright.formats.families.grid.modulo_range import (
    RANGE_QUANTITY,
    most_points_of_turn,
    spacings_from,
)
from compwright.formats.families.grid.table_shapes import shape_of
from compwright.formats.text.values import name_of
from compwright.records.axis import Axis, AxisKind
from compwright.records.capacity import Capacity
from compwright.records.correction import Assumption
from compwright.words.sentences import control_text, unconfirmed


class GridLimits:
    """The limits of the table that corrects an axis by its own position."""

    def __init__(self, control: Family, axis: Axis) -> None:
        self.control = control
        self.definition = control.definition
        self.axis = axis
        self.options = control.options_of(axis)
        self.address, self.assumption = control.address(axis)
        self.facts = control.state.facts_of(self.address)
        self.shape = shape_of(self.definition)

    def capacity(self) -> Capacity:
        """Return the limits of an axis' table, such as point count and spacing, in mm or deg."""
        definition, scale = self.definition, self.control.scale_of(self.axis)
        assumed = [self.assumption] if self.assumption is not None else []
        assumed += self._turn_unknown()
        max_points = self._max_points(assumed)
        value, quantum = curves(definition)[0], scale.quantum(self.shape.rules.grid[0])
        in_addition = (
            "backlash" in definition.bindings
            and definition.limit("no_backlash_beside_table") is None
        )
        return Capacity(
            format=definition.id,
            curves=1 if definition.layout.pairing == "none" else 2,
            spacing=self.shape.spacing,
            quantum=scale.quantum(value),
            position_quantum=quantum,
            value_range=scale.range(value),
            backlash_quantum=scale.quantum("backlash") if in_addition else None,
            backlash_range=scale.range("backlash") if in_addition else (0.0, 0.0),
            min_points=definition.limit_number("min_points") or 1,
            max_points=max_points,
            reserved_by=self._reserved_by(),
            below=definition.layout.below,
            above=definition.layout.above,
            most_points=definition.limit_number("max_points"),
            period=self._period(),
            there=() if self.axis.counts_turns else self.control.existing_grid(self.axis),
            spacings=self._spacings(quantum),
            stays=self.control.state.stays.get(self.address, ()),
            assumed=tuple(assumed),
        )

    def points_option(self) -> str:
        """Return the name of the option for the number of points that the control reserves."""
        options = self.definition.options.items()
        return next(name for name, option in options if option.settled_by == "max_points")

    def _period(self) -> float | None:
        """Return the turn (deg) of an endless axis whose table repeats; None for any other axis."""
        if self.axis.counts_turns:
            return self.axis.modulo
        if not self.shape.repeats or self.definition.limit("no_endless_axis") is not None:
            return None
        return self.axis.modulo if self.axis.kind is AxisKind.ROTARY else None

    def _turn_unknown(self) -> list[Assumption]:
        """Return the assumptions made for an endless axis whose turn is in no file."""
        turn = self.facts.turn
        if (
            self._period() is None
            or RANGE_QUANTITY not in self.definition.bindings
            or (turn is not None and turn.stated)
        ):
            return []
        wraps = control_text("that the control wraps it (MD30310)"), control_text("yes")
        unsaid = [] if turn is not None else [wraps]
        begins = control_text("where its turn begins (MD30340)")
        degrees = control_text("{value} deg", value=f"{MODULO_START:g}")
        return [
            Assumption(
                control_text("axis {name}: {fact}", name=self.axis.name, fact=fact),
                value,
                unconfirmed(control_text("in no file")),
            )
            for fact, value in (*unsaid, (begins, degrees))
        ]

    def _spacings(self, quantum: float) -> tuple[float, ...] | None:
        """Return the spacings that the reference and turn of an endless axis allow; None: any."""
        period, turn = self._period(), self.facts.turn
        if period is None or RANGE_QUANTITY not in self.definition.bindings:
            return None
        start = MODULO_START if turn is None else turn.start
        return spacings_from(self.axis.reference, start, period, quantum)

    def _reserved_by(self) -> str:
        """Return the parameter that reserves the points of a table, "" if the control has none."""
        if self.definition.limit("points_reserved") is None:
            return ""
        return f"MD38000 ({name_of(self.definition, 'max_points')})"

    def _max_points(self, assumed: list[Assumption]) -> int | None:
        hard = self.definition.limit_number("max_points")
        if self.axis.counts_turns and hard is not None:
            return most_points_of_turn(self.axis, hard)
        if self.definition.limit("points_reserved") is None:
            return hard
        fact = self.facts.stated.get("max_points")
        reserved = resolved_number(self.definition, self.points_option(), self.options, fact)
        if reserved is not None:
            return reserved if hard is None else min(reserved, hard)
        none = control_text("the control has reserved none yet")
        what = none if fact == 0 else control_text("the control's files do not say it")
        assumed.append(
            Assumption(
                fact=control_text(
                    "axis {name}: number of points the control can store", name=self.axis.name
                ),
                value=control_text("as many as are needed; the card says how many to set"),
                evidence=unconfirmed(what),
            )
        )
        return None
