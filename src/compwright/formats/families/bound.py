"""What a definition, its options and what the control's own files say settle together, the same way
for every family.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Self

from compwright.formats.definition.options import axis_options, resolve_options
from compwright.formats.definition.schema import Choice, Definition, OptionRule
from compwright.formats.text.addresses import normal_address
from compwright.formats.text.scale import NumberScale
from compwright.records.axis import Axis
from compwright.records.correction import Assumption, ControlState


class Bound:
    """A definition bound to its options and to a ``state``: what the control's own files said;
    nothing before they are read.

    Raises UsageError for a wrong option, or one that contradicts the control's files.
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
        """Return the control with the options that its own files answer taken from them.

        ``strict``: every option was given by somebody, not taken from defaults. Raises UsageError
        where an option that was given contradicts the files.
        """
        return type(self)(self.definition, self.given, state, strict=strict)

    def with_options(self, **options: object) -> Self:
        """Return the control with some of its settled options set otherwise."""
        return type(self)(self.definition, {**self.options, **options})

    def address(self, axis: Axis) -> tuple[str, Assumption | None]:
        """Return how the control names an axis, and what had to be assumed for that.

        Raises UsageError for an address that the control cannot have.
        """
        return normal_address(self.definition, axis)

    def options_of(self, axis: Axis | None, *, unit_needed: bool = True) -> Mapping[str, object]:
        """Return the options of an axis: its own over the controller's, which alone count for an
        axis that no job knows. ``unit_needed`` as `axis_options`. Raises UsageError.
        """
        return axis_options(self.definition, self.options, axis, unit_needed=unit_needed)

    def grid_there(self, axis: Axis) -> tuple[float, ...]:
        """Return the nodes (ascending, mm or deg) of the table that the control's own files hold
        for an axis, whether it acts or not; none where they hold none.
        """
        address, _ = self.address(axis)
        acting = self.state.axes.get(address)
        if acting is not None and acting.positions.size > 1:
            return tuple(float(node) for node in acting.positions)
        return self.state.facts_of(address).grid

    def scale_of(self, axis: Axis) -> NumberScale:
        """Return how numbers of an axis are written; choices are those that its options ask for."""
        options = self.options_of(axis)
        choices = {
            name: binding.values[binding.written(options)]
            for name, binding in self.definition.bindings.items()
            if isinstance(binding, Choice)
        }
        return NumberScale(self.definition, axis.kind, options, choices)

    @property
    def says_activity(self) -> bool:
        """Whether the control's files can say, or leave open, that a table does not act."""
        return "enabled" in self.definition.bindings

    @property
    def repeats_turns(self) -> bool:
        """Whether the table of a rotary axis over several turns holds its turn again and again."""
        return False

    @property
    def counts_systems(self) -> bool:
        """Whether the control's files count measuring systems."""
        return any("system" in each.fields for each in self.definition.statements.values())

    @property
    def knows_motion(self) -> bool:
        """Whether backlash at rapid traverse may be another one than at cutting feed."""
        return "backlash_rapid" in self.definition.bindings

    def judged_at(self, axis: Axis) -> Mapping[str, str]:
        """Return the motion at which an axis is judged, where it makes a difference."""
        return {"motion": axis.motion} if self.knows_motion and axis.motion != "feed" else {}

    @property
    def length_unit(self) -> tuple[OptionRule, str] | None:
        """The option that says the machine's unit of lengths, and the file that would say it
        instead; None where the definition itself says the unit.
        """
        rules = self.definition.options.values()
        rule = next((rule for rule in rules if rule.settled_by == "length_unit"), None)
        if rule is None:
            return None
        statement = self.definition.statements[self.definition.bindings["length_unit"].statement]
        key = statement.form.partition("{")[0].rstrip(" =")
        one = len(self.definition.texts) == 1
        file = "a file" if one else f"the whole {statement.text.upper()} file"
        return rule, f"{file} with {key} among the files"
