"""The limits of the table of one axis on a FANUC control."""

from __future__ import annotations

from compwright.formats.families.family import Family
from compwright.formats.families.increments.axis_reading import increment_limit
from compwright.formats.families.increments.entries import (
    OFFSETS,
    first_point,
    length_step,
    magnifications,
)
from compwright.formats.families.increments.increment_facts import increments_of
from compwright.formats.families.increments.job_checks import points_question
from compwright.formats.families.increments.numbering import longest_gap, used_numbers
from compwright.foundations.errors import Fault, UsageError, raise_all
from compwright.records.axis import Axis, AxisKind
from compwright.records.capacity import Capacity, Lattice, Wave
from compwright.records.correction import Assumption
from compwright.words.sentences import Sentence, control_text, say

#: A table has two sections or more.
MIN_SECTIONS = 2


class IncrementLimits:
    """The limits of one axis' table on a FANUC control.

    ``assumed``: the assumptions made for these limits. ``shares``: other axes also use some of the
    axis' point numbers.
    """

    def __init__(self, family: Family, axis: Axis) -> None:
        self.definition = family.definition
        self.axis = axis
        self.there = family.existing_grid(axis)
        self.scale = family.scale_of(axis)
        self.options = self.scale.options
        address, assumption = family.address(axis)
        self.facts = increments_of(family.state.facts_of(address))
        active = family.state.axes.get(address)
        self.stays = () if active is None else active.others
        self.used = used_numbers(family.state, [address])
        self.shares = any(
            set(own) & set(taken) for own in self.facts.claimed for taken in self.used
        )
        self.assumed = [assumption] if assumption is not None else []

    def capacity(self) -> Capacity:
        """Return the limits of an axis' table, such as point count and spacing, in mm or deg.

        Raises UsageError for a wrong option of the axis, or if its detection unit or the free
        numbers are unknown.
        """
        definition, axis, scale = self.definition, self.axis, self.scale
        raise_all(UsageError, list(points_question(axis, self.options.get("points_from"))))
        limit, gap = increment_limit(self.options), self._free_numbers()
        least, reason = self._least_spacing()
        bound = 10.0 if axis.kind.unit == "mm" else 1.0
        return Capacity(
            format=definition.id,
            curves=2 if axis.modulo is None and "bidirectional" in definition.bindings else 1,
            second_curve="asked",
            spacing="equidistant",
            quantum=scale.quantum("value"),
            position_quantum=float(length_step(scale, self.facts)),
            value_range=(-bound, bound),
            backlash_quantum=scale.quantum("backlash"),
            backlash_range=scale.range("backlash"),
            min_points=definition.limit_number("min_points") or 2,
            max_points=max(2, self._points(gap), 0 if self.shares else len(self.there)),
            shared_points=self._shared_numbers(),
            own_points=self._own_points(),
            lattice=Lattice(
                unit=scale.quantum("value"),
                increments=(-limit, limit),
                magnifications=magnifications(definition, self.facts),
                offset_range=OFFSETS,
                offset_magnified=self.options.get("offset_magnified") == "yes",
                there=self.facts.magnification or None,
            ),
            interpolation="linear" if self.options.get("output") == "ramp" else "step",
            anchored=True,
            min_spacing=least,
            min_spacing_reason=reason,
            period=axis.modulo,
            there=self.there,
            there_shared=self.shares,
            stays=self.stays,
            slope=scale.quantum("value") if self._may_incline() else None,
            wave=self._wave(limit, gap),
            below=definition.layout.below,
            above=definition.layout.above,
            assumed=tuple(self.assumed),
        )

    def _points(self, numbers: int) -> int:
        """Return how many table points the axis can have with so many successive point numbers.

        Each point number belongs to one section, the interval between two table points. So k
        numbers give k + 1 points. If the travel starts or ends at the reference position, they give
        only k points, because the reference needs a number too.
        """
        axis = self.axis
        return numbers + (axis.travel[0] < axis.reference < axis.travel[1])

    def _own_points(self) -> int:
        """Return how many table points fit into the longest block of numbers that only this axis
        uses.
        """
        highest = self.definition.limit_number("max_number") or 0
        rows = (
            longest_gap(min(claimed.stop - 1, highest), self.used, claimed.start)
            for claimed in self.facts.claimed
        )
        most = max(rows, default=0)
        return self._points(most) if most else 0

    def _shared_numbers(self) -> int:
        """Return the length of the longest block of point numbers that no axis uses."""
        highest = self.definition.limit_number("max_number") or 0
        return longest_gap(highest, [*self.used, *self.facts.claimed], first_point(self.options))

    def _assume(self, fact: str, value: str, evidence: str) -> None:
        of_axis = control_text("axis {name}: {fact}", name=self.axis.name, fact=fact)
        self.assumed.append(Assumption(of_axis, value, evidence))

    def _wave(self, limit: int, gap: int) -> Wave | None:
        """Return the limits of a new second (cyclic) table; None if this axis cannot get such a
        table. ``limit``: the largest increment; ``gap``: how many successive point numbers are free
        for it.

        Only a rotary axis can get one, because the only page that describes this table is about a
        worm gear.
        """
        has = self.options.get("cyclic") == "available" and not self.facts.waved
        if self.axis.kind is not AxisKind.ROTARY or not has:
            return None
        step = float(length_step(self.scale, self.facts))
        return Wave(unit=self.scale.quantum("value"), increment=limit, room=gap, step=step)

    def _may_incline(self) -> bool:
        """Return whether inclination compensation is available on the control and not used yet."""
        return self.options.get("inclination") == "available" and not self.facts.inclined

    def _free_numbers(self) -> int:
        """Return how many successive point numbers are free; numbers whose contents no file shows
        count as used.

        Raises UsageError if too few are left for a table.
        """
        highest = self.definition.limit_number("max_number") or 0
        gap = longest_gap(highest, self.used, first_point(self.options))
        if not self.facts.unread:
            return gap
        unread = sorted(self.facts.unread)
        used_numbers = control_text(
            "{first} to {last} ({count} numbers)",
            first=str(unread[0]),
            last=str(unread[-1]),
            count=str(len(unread)),
        )
        if gap < MIN_SECTIONS:
            raise UsageError(
                Fault(
                    message=(
                        f"axis {self.axis.name}: no given file shows which point numbers are free "
                        f"for its table. The numbers {used_numbers} may be in use"
                    ),
                    place="first_point",
                    expected=(
                        "the control's whole pitch data among its files, or the first free"
                        " number (look at 3621 and 3622 of all axes)"
                    ),
                    found="nothing",
                    hint=(
                        "add the control's whole pitch data to its files (`states` or "
                        "`--state`), or give `first_point` after a look at 3621 and 3622 of all "
                        "axes"
                    ),
                )
            )
        evidence = control_text(
            "no file says what the numbers {numbers} hold; give all of the control's pitch"
            " data, or first_point",
            numbers=used_numbers,
        )
        most = control_text("at most {gap} in a row", gap=str(gap))
        self._assume(control_text("point numbers for its table"), most, evidence)
        return gap

    def _least_spacing(self) -> tuple[float, Sentence | None]:
        """Return the smallest interval that the highest feed permits, and a sentence about it. The
        feed is the option ``max_feed`` or the rapid traverse in the files, whichever is higher.
        """
        rule = self.definition.limit("feed_per_spacing")
        if rule is None or rule.number is None:
            return 0.0, None
        named = {"option": self.options.get("max_feed"), "rapid": self.facts.rapid_feed}
        feeds = {
            name: float(feed)
            for name, feed in named.items()
            if isinstance(feed, (int, float)) and feed > 0
        }
        if not feeds:
            why = control_text(
                "not checked: the option max_feed is not given, and no file says the rapid traverse"
                " (1420)"
            )
            fact = control_text("smallest interval for its feed")
            self._assume(fact, why, rule.evidence.text)
            return 0.0, None
        name = max(feeds, key=lambda one: feeds[one])
        least = feeds[name] / rule.number
        return least, say(
            "CW-F011.feed",
            feed=feeds[name],
            unit=self.axis.kind.unit,
            of=name,
            least=least,
            rule=rule.number,
            evidence=rule.evidence.state,
        )
