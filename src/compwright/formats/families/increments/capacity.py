"""What one axis of a control with increments by section (FANUC) can hold."""

from __future__ import annotations

from collections.abc import Mapping

from compwright.formats.definition.options import axis_options
from compwright.formats.definition.schema import Definition
from compwright.formats.families.increments.axis import increment_limit
from compwright.formats.families.increments.entries import OFFSETS, first_point, length_step
from compwright.formats.families.increments.numbering import longest_gap
from compwright.formats.families.increments.reading import used_numbers
from compwright.formats.text.addresses import normal_address
from compwright.formats.text.scale import Scale
from compwright.foundations.errors import Fault, UsageError
from compwright.records.axis import Axis
from compwright.records.capacity import Capacity, Lattice
from compwright.records.correction import Assumption, ControlState
from compwright.records.facts import Fact

#: A table has two sections or more.
MIN_SECTIONS = 2


def increments_capacity(
    definition: Definition, axis: Axis, options: Mapping[str, object], state: ControlState | None
) -> Capacity:
    """Return the limits of one axis' table in mm or deg; ``options`` are the controller's,
    resolved.

    Raises UsageError for a wrong option of the axis, or where nobody says its detection unit or
    which numbers are free.
    """
    own = axis_options(definition, options, axis)
    address, assumption = normal_address(definition, axis)
    scale = Scale(definition, axis.kind, own, {})
    unit = scale.quantum("value")
    limit = increment_limit(own)
    highest = definition.limit_number("max_number") or 0
    said = state.facts_of(address).said if state is not None else {}
    gap = longest_gap(highest, used_numbers(state, [address]), first_point(own))
    assumed = [assumption] if assumption is not None else []
    unread = said.get("unread_numbers")
    if unread:
        _check_free(axis, gap, str(unread), assumed)
    least, reason = _least_spacing(definition, axis, own, said, assumed)
    bound = 10.0 if axis.kind.unit == "mm" else 1.0
    return Capacity(
        format=definition.id,
        curves=2 if axis.modulo is None else 1,
        second_curve="asked",
        spacing="equidistant",
        quantum=unit,
        position_quantum=float(length_step(axis.kind, said)),
        value_range=(-bound, bound),
        backlash_quantum=scale.quantum("backlash"),
        backlash_range=scale.range("backlash"),
        min_points=definition.limit_number("min_points") or 2,
        # sections, not nodes, have numbers; one more is needed where the table starts or ends at
        # the reference
        max_points=max(2, gap + (axis.travel[0] < axis.reference < axis.travel[1])),
        shared_points=True,
        lattice=Lattice(
            unit=unit,
            increments=(-limit, limit),
            magnifications=tuple(range(1, (definition.limit_number("max_magnification") or 1) + 1)),
            offset_range=OFFSETS,
            offset_magnified=own.get("offset_magnified") == "yes",
        ),
        interpolation="linear" if own.get("output") == "ramp" else "step",
        anchored=True,
        min_spacing=least,
        min_spacing_reason=reason,
        period=axis.modulo,
        below=definition.layout.below,
        above=definition.layout.above,
        assumed=tuple(assumed),
    )


def _check_free(axis: Axis, gap: int, unread: str, assumed: list[Assumption]) -> None:
    """Numbers of which no file says what they hold are not free: say how many are left, or ask
    where there are none.

    Raises UsageError.
    """
    if gap >= MIN_SECTIONS:
        evidence = (
            f"no file says what the numbers {unread} hold; give all of the control's pitch data, or"
            " first_point"
        )
        assumed.append(
            Assumption(
                f"axis {axis.name}: point numbers for its table",
                f"at most {gap} in a row",
                evidence,
            )
        )
        return
    raise UsageError(
        Fault(
            message=(
                f"axis {axis.name}: no file says which point numbers are free for its table; nobody"
                f" knows what the numbers {unread} hold"
            ),
            place="first_point",
            expected=(
                "the control's whole pitch data among the files of the state, or the first free"
                " number (look at 3621 and 3622 of all axes)"
            ),
            found="nothing",
        )
    )


def _least_spacing(
    definition: Definition,
    axis: Axis,
    options: Mapping[str, object],
    said: Mapping[str, Fact],
    assumed: list[Assumption],
) -> tuple[float, str]:
    """Return the smallest interval for the largest feed: that of the option, and the rapid traverse
    of the control's files.
    """
    rule = definition.limit("feed_per_spacing")
    if rule is None or rule.number is None:
        return 0.0, ""
    named = {
        "option max_feed": options.get("max_feed"),
        "rapid traverse 1420": said.get("rapid_feed"),
    }
    feeds = {
        name: float(feed)
        for name, feed in named.items()
        if isinstance(feed, (int, float)) and feed > 0
    }
    if not feeds:
        assumed.append(
            Assumption(
                fact=f"axis {axis.name}: smallest interval for its feed",
                value=(
                    "not checked: the option max_feed is not given, and no file says the rapid"
                    " traverse (1420)"
                ),
                evidence=str(rule.evidence),
            )
        )
        return 0.0, ""
    name = max(feeds, key=lambda one: feeds[one])
    least = feeds[name] / rule.number
    reason = (
        f"at {feeds[name]:g} {axis.kind.unit}/min ({name}) the control needs at least {least:g}:"
        f" feed / {rule.number} ({rule.evidence.state})"
    )
    return least, reason
