"""Complete a job from its control's files: names of axes, units, measuring systems, references."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace

from compwright.controls.control import Control
from compwright.controls.decoded_state import DecodedState
from compwright.formats.definition.schema import Definition, OptionRule
from compwright.formats.families.shapes import RULES
from compwright.formats.text.addresses import normal_address, normal_text
from compwright.formats.text.values import name_of
from compwright.foundations.errors import Fault, UsageError, raise_all
from compwright.planning.wanted_correction import LEAST_COVERED, covered_travel
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import Assumption, ControlState
from compwright.records.facts import AxisFacts
from compwright.records.job import AxisJob, Job
from compwright.records.options import DETECTION_UNIT, TABLE_VALUES
from compwright.records.plan import PlannedTest
from compwright.words.sentences import control_text

#: Two places are one within this, mm or deg.
_SAME_PLACE = 1e-6
_TURN = 360.0
#: Names of axes as controls and jobs write them. An axis of the job with a name of another kind
#: says nothing of the control's own letters.
_AXIS_NAME = re.compile(r"[XYZABCUVW](?:[0-9]{0,2}|_\w*)")


def named_axes(
    job: Job, control: Control, by_name: Callable[[], Mapping[str, tuple[str, str]]]
) -> tuple[Job, tuple[Assumption, ...]]:
    """Return the job with each axis' address in the control, and the assumptions made to find these
    addresses. ``by_name``: a function that returns address and evidence for each axis name in the
    control's files.

    ``by_name`` is called only if the control has no axis with the address in the job. Raises
    UsageError if the files do not state the address either, and for two axes with the same address.
    """
    axes: dict[str, AxisJob] = {}
    assumed: list[Assumption] = []
    faults: list[Fault] = []
    for name, entry in job.axes.items():
        try:
            address, assumption = _address(control, entry.axis, by_name)
            gantry = (
                None
                if entry.axis.gantry is None
                else normal_text(control.definition, entry.axis.gantry)
            )
        except UsageError as error:
            faults.extend(
                fault.within(f"axes.{name}.address").in_file(job.file) for fault in error.faults
            )
            continue
        taken = next((other for other, mine in axes.items() if mine.axis.address == address), None)
        if taken is not None:
            faults.append(
                Fault(
                    message=f"axes {taken} and {name} have the same address",
                    file=job.file,
                    place=f"axes.{name}",
                    found=address,
                    hint="give one of them another `address`",
                )
            )
        assumed.extend([assumption] if assumption else [])
        axes[name] = replace(entry, axis=replace(entry.axis, address=address, gantry=gantry))
    raise_all(UsageError, faults)
    return replace(job, format=control.id, axes=axes), tuple(assumed)


def _address(
    control: Control, axis: Axis, by_name: Callable[[], Mapping[str, tuple[str, str]]]
) -> tuple[str, Assumption | None]:
    letters, name = control.definition.addresses.letters or "", axis.address.strip().upper()
    counted = len(name) == 1 and name in letters
    if not counted:
        try:
            return normal_address(control.definition, axis)
        except UsageError:
            stated = by_name().get(name)
            if stated is None:
                raise
    else:
        stated = by_name().get(name)
        if stated is None and name == letters[:1]:
            return normal_address(control.definition, axis)
        if stated is None:
            raise UsageError(_number_question(control, axis, by_name()))
    address, evidence = stated
    return address, Assumption(
        control_text("address of axis {name}", name=axis.name), address, evidence
    )


def _number_question(control: Control, axis: Axis, by_name: Mapping[str, tuple[str, str]]) -> Fault:
    """Return the fault that asks for the axis number of an axis, if the letter of the axis does not
    determine the number. ``by_name``: number and evidence of each axis letter in the files.
    """
    names = ", ".join(f"{letter}: {number}" for letter, (number, _) in by_name.items())
    quantity = name_of(control.definition, "axis_letters")
    return Fault(
        message=(
            f"the number of axis {axis.name} is uncertain: compwright only counted the "
            "machine's axes in order"
        ),
        expected=f"the number, or the file with {quantity} among the control's files",
        found=f"in the files {names}" if names else "only the letter of the axis",
        hint=(
            "look the number up in the control, then add it to the axis, such as `address: 1`, or "
            f"add the file with {quantity} to the control's files (`states` or `--state`)"
        ),
    )


def completed_by_files(job: Job, states: Mapping[str, DecodedState], as_found: str) -> Job:
    """Return the job with detection units, meaning of values and measuring systems from the
    control's files. ``states``: the decoded files of each state that the job names; ``as_found``:
    the name of the present state.
    """
    read = [decoded.state for decoded in states.values()]
    axes = {
        name: replace(entry, axis=completed_axis(entry.axis, read, job.options))
        for name, entry in job.axes.items()
    }
    job = replace(job, axes=axes)
    if as_found not in states:
        return job
    return _with_zero_of_homing(_with_systems_in_use(job, states[as_found].state), states[as_found])


def completed_axis(axis: Axis, states: Sequence[ControlState], given: Mapping[str, object]) -> Axis:
    """Return an axis with the facts in the control's files: its options, the screw lead, and the
    reversal steps that the control leaves out. ``given``: options of the whole control, which the
    files do not replace.
    """
    options = dict(axis.options)
    for name in (DETECTION_UNIT, TABLE_VALUES):
        stated = [state.facts_of(axis.address).stated.get(name) for state in states]
        found = next((one for one in stated if one is not None), None)
        if found is not None and given.get(name) is None:
            options.setdefault(name, found)
    facts = [state.facts_of(axis.address) for state in states]
    suggested = next((one.lead for one in facts if one.lead is not None), None)
    steps = next((one.unapplied_steps for one in facts if one.unapplied_steps is not None), None)
    return replace(axis, options=options, suggested_period=suggested, unapplied_steps=steps)


def _with_zero_of_homing(job: Job, as_found: DecodedState) -> Job:
    """Return the job with the references at which homing sets the correction to zero."""
    axes, faults = {}, []
    for name, entry in job.axes.items():
        facts, axis = as_found.state.facts_of(entry.axis.address), entry.axis
        axes[name] = entry
        if facts.homing == "relative" and facts.reference is not None:
            home = facts.reference_return or axis.reference_return
            for key, given, stated in (
                ("reference", axis.reference, facts.reference),
                ("reference_return", axis.reference_return.sign, home.sign),
            ):
                if key in entry.stated and abs(given - stated) > _SAME_PLACE:
                    faults.append(_other_zero(job, name, key, axis, facts.reference, home))
            completed = replace(
                axis,
                reference=facts.reference,
                reference_return=home,
                zero_at_reference=True,
            )
            axes[name] = replace(entry, axis=completed)
    raise_all(UsageError, faults)
    return replace(job, axes=axes)


def with_counted_turns(
    job: Job, control: Control, tests: Mapping[str, Sequence[PlannedTest]]
) -> tuple[Job, tuple[Assumption, ...]]:
    """Return the job in which rotary axes that travel several turns are treated as endless, and the
    assumptions made for that.

    ``tests``: the tests by axis name. Two conditions must be met: the tests cover less than half of
    the travel, and the control repeats its table at every turn.
    """
    axes, assumed = dict(job.axes), []
    for name, entry in job.axes.items():
        axis, measured = entry.axis, [planned.test for planned in tests.get(name, ())]
        low, high = axis.travel
        if (
            not RULES[control.definition.layout.shape].repeats_turns
            or axis.kind is not AxisKind.ROTARY
            or axis.modulo is not None
            or high - low <= _TURN
            or not measured
            or covered_travel(measured, low, high) >= LEAST_COVERED * (high - low)
        ):
            continue
        axes[name] = replace(entry, axis=replace(axis, modulo=_TURN, counts_turns=True))
        evidence = control_text(
            "its tests cover less than half of its travel, which is more than a turn"
        )
        fact = control_text("axis {name}: its error repeats every", name=name)
        assumed.append(Assumption(fact, "360 deg", evidence))
    return replace(job, axes=axes), tuple(assumed)


def unknown_zeros(job: Job, control: Control, state: ControlState | None) -> Iterator[Fault]:
    """Yield a fault for each axis in the job's ``fixed_positions`` if neither job nor files state
    where homing sets its correction to 0.

    ``state``: the decoded files; None without files. A control whose files have no home offset
    gives no fault.
    """
    if "home_offset" not in control.definition.bindings:
        return
    keys = ("home_offset", "home_latch_velocity")
    offset, latch = (name_of(control.definition, key) for key in keys)
    for name in dict.fromkeys(axis for places in job.fixed_positions.values() for axis in places):
        entry = job.axes.get(name)
        if entry is None or "reference" in entry.stated:
            continue
        if state is None or not state.facts_of(entry.axis.address).homing:
            yield Fault(
                message=(
                    f"the reference position of axis {name} is needed because the job has "
                    "`fixed_positions`, but neither the job nor the control's files state it"
                ),
                file=job.file,
                place=f"axes.{name}.reference",
                expected="the whole INI among the control's files",
                hint=(
                    "add the whole INI to the control's files (`states` or `--state`), or set "
                    f"`reference` of the axis to the {offset} of its joint, and "
                    f"`reference_return` to the sign of its {latch}"
                ),
            )


def _other_zero(job: Job, name: str, key: str, axis: Axis, place: float, home: Direction) -> Fault:
    words = {
        "reference": (f"{place:g} {axis.kind.unit}", f"{axis.reference:g}"),
        "reference_return": (f'"{home.value}"', f'"{axis.reference_return.value}"'),
    }
    expected, found = words[key]
    return Fault(
        message=(
            f"the key {key} of axis {name} contradicts the control's homing, which sets where "
            "the correction is zero"
        ),
        file=job.file,
        place=f"axes.{name}.{key}",
        expected=f"{expected}, as the control's files state, or no {key}",
        found=found,
        hint=f"set `{key}` to {expected}, or leave it out",
    )


def _with_systems_in_use(job: Job, state: ControlState) -> Job:
    """Return the job with the measuring systems of the files for axes without a stated system."""
    axes = {}
    for name, entry in job.axes.items():
        found = state.facts_of(entry.axis.address).encoder_system
        if entry.axis.encoder.stated or found is None:
            axes[name] = entry
        else:
            axes[name] = replace(
                entry,
                axis=replace(
                    entry.axis, encoder=replace(entry.axis.encoder, system=found, stated=True)
                ),
            )
    return replace(job, axes=axes)


def other_joints(axis: Axis, facts: AxisFacts, state: str) -> Iterator[Fault]:
    """Yield a fault if the control's files assign the joint given as the axis' address to another
    axis, or two joints to this axis.
    """
    letters, letter, own = facts.letters, (facts.name or "").upper(), axis.name.upper()
    place, stated = f"axes.{axis.name}", f"{letters}: joint {axis.address} is {letter}"
    if not letters:
        stated = f"{letter} ({facts.name_evidence} of {axis.address})"
    lettered = all(map(_AXIS_NAME.fullmatch, (letter, own)))
    if lettered and letter[0] != own[0]:
        yield Fault(
            message=f"address {axis.address} belongs to a different axis in the control's files "
            f"(`states: {state}`)",
            place=f"{place}.address",
            expected=f"the axis {axis.name} of the control",
            found=stated,
            hint=f"set `address` to that of axis {axis.name} in the control; if {letter} was "
            f"measured, name the axis {letter} in the job and in `# axis:` of its files",
        )
    if not letters or (lettered and letter[0] != own[0]):
        return
    others = [
        str(index)
        for index, other in enumerate(letters)
        if other == letter and str(index) != axis.address
    ]
    if others and axis.gantry not in others:
        yield Fault(
            message=f"two joints drive axis {axis.name}: a table on only one of them would twist "
            "the gantry",
            place=f"{place}.gantry",
            expected=" or ".join(f'gantry: "{other}"' for other in others),
            found=stated,
            hint=f'add `gantry: "{others[0]}"` to axis {axis.name} of the job',
        )


def length_unit(definition: Definition) -> tuple[OptionRule, str] | None:
    """Return the option for the length unit, and as text the file that states the unit; None if the
    definition has no such option.
    """
    rules = definition.options.values()
    rule = next((rule for rule in rules if rule.settled_by == "length_unit"), None)
    if rule is None:
        return None
    statement = definition.statements[definition.bindings["length_unit"].statement]
    key = statement.form.partition("{")[0].rstrip(" =")
    file = "a file" if len(definition.texts) == 1 else f"the whole {statement.text.upper()} file"
    return rule, f"{file} with {key} among the files"


def keys_with_effect(definition: Definition) -> dict[str, bool]:
    """Return, for three groups of job keys by name, whether the keys have an effect on this
    control.

    The groups are ``systems`` (measuring systems), ``numbers`` (axis numbers) and ``motions``
    (backlash at rapid traverse). `idle_keys` uses the result.
    """
    return {
        "systems": "system" in definition.fields,
        "numbers": "datum" in definition.fields,  # columns on an even grid are named by number
        "motions": "backlash_rapid" in definition.bindings,
    }
