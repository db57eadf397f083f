"""A definition together with its options and with the contents of the control's files."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Self

from compwright.formats.definition.options import axis_options, resolve_options
from compwright.formats.definition.schema import Choice, Definition
from compwright.formats.text.addresses import normal_address
from compwright.formats.text.scale import NumberScale
from compwright.records.axis import Axis
from compwright.records.correction import Assumption, ControlState


class ResolvedDefinition:
    """A definition together with its options and, once read, the contents of the control's files
    (``state``).

    Raises UsageError for a wrong option, or for an option that contradicts the control's files.
    """

    def __init__(
        self,
        definition: Definition,
        given: Mapping[str, object],
        state: ControlState | None = None,
        *,
        strict: bool = False,
    ) -> None:
        self.definition = definition
        self.given = given
        self.state = state or ControlState(format=definition.id, axes={})
        self.options = resolve_options(definition, given, state, strict=strict)

    def in_state(self, state: ControlState | None, *, strict: bool = False) -> Self:
        """Return the same definition with its options completed by the contents of the control's
        own files (``state``). ``strict``: the user stated every option, so one that contradicts the
        files is a fault.

        Raises UsageError if a given option contradicts the files.
        """
        return type(self)(self.definition, self.given, state, strict=strict)

    def address(self, axis: Axis) -> tuple[str, Assumption | None]:
        """Return the control's address of an axis, with the assumption made if the job gives none.

        Raises UsageError for an address that the control cannot have.
        """
        return normal_address(self.definition, axis)

    def options_of(self, axis: Axis | None, *, unit_needed: bool = True) -> Mapping[str, object]:
        """Return the options of an axis; those that the job does not state for the axis have their
        values for the whole control. ``unit_needed``: a missing required value is an error.

        If ``axis`` is None, the values for the whole control are returned. Raises UsageError for
        wrong or missing options.
        """
        return axis_options(self.definition, self.options, axis, unit_needed=unit_needed)

    def existing_grid(self, axis: Axis) -> tuple[float, ...]:
        """Return the positions (ascending, mm or deg) of the points of the table in the control's
        files.

        An inactive table counts too. The result is empty if there is no table.
        """
        address, _ = self.address(axis)
        existing = self.state.axes.get(address)
        if existing is not None and existing.positions.size > 1:
            return tuple(float(point) for point in existing.positions)
        return self.state.facts_of(address).grid

    def scale_of(self, axis: Axis) -> NumberScale:
        """Return unit, sign and resolution of an axis' numbers, which depend on its options."""
        options = self.options_of(axis)
        choices = {
            name: binding.values[binding.written(options)]
            for name, binding in self.definition.bindings.items()
            if isinstance(binding, Choice)
        }
        return NumberScale(self.definition, axis.kind, options, choices)
