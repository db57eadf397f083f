"""Options of a control: defaults, values from a job or the command line, and values in the
control's own files.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import TypeVar

from compwright.formats.definition.schema import Definition, OptionRule
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.foundations.key_faults import nearest
from compwright.records.axis import Axis, AxisKind
from compwright.records.correction import ControlState
from compwright.records.options import KIND, REFERENCE, REFERENCE_RETURN

_T = TypeVar("_T")


class Required(dict[str, _T]):
    """A section of a definition as a dict; access to an entry that the section does not have raises
    InputError.
    """

    def __init__(
        self,
        entries: Mapping[str, _T] | Iterable[tuple[str, _T]] = (),
        *,
        section: str = "",
        file: str = "",
    ) -> None:
        super().__init__(entries)
        self._section, self._file = section, file

    def __missing__(self, name: str) -> _T:
        """Raise InputError that names the entry which the definition lacks."""
        raise InputError(
            Fault(
                message=f"the definition lacks the entry {name} in its section {self._section}, "
                "which its kind of files needs",
                file=self._file,
                place=f"{self._section}.{name}",
                hint=f"add `{name}` to the section `{self._section}` of the definition",
            )
        )


#: Least and largest number that an option may hold, apart from 0: every length, count and feed of a
#: machine tool lies within, and products of two such numbers stay finite.
_SIZES = (1e-9, 1e9)


def resolve_options(
    definition: Definition,
    given: Mapping[str, object],
    state: ControlState | None = None,
    *,
    strict: bool = False,
) -> Mapping[str, object]:
    """Return the value of every option by name: the value in ``given``, else the one in the
    control's files (``state``), else the default. ``strict``: the user stated each value of
    ``given``, so one that contradicts the files is a fault.

    ``given`` may contain text from the command line (``"0.001"``, ``"3,4"``). An option is taken
    from ``state`` only if the control's files give the same value for all axes (such as the unit).
    Raises UsageError with every fault: unknown option, wrong type, contradiction to the control's
    files.
    """
    faults: list[Fault] = []
    known = [*definition.options, REFERENCE, REFERENCE_RETURN, KIND]
    for name in given:
        if name not in known:
            near = nearest(name, known)
            faults.append(
                Fault(
                    message=f"{definition.id} has no option {name}",
                    place=name,
                    expected=near or f"one of {', '.join(known)}",
                    hint=f"{f'write `{near}`, or ' if near else ''}leave this option out; see "
                    f"`compwright formats show {definition.id}`",
                )
            )
    values: dict[str, object] = {
        name: _value(rule, given[name], definition, faults) if name in given else rule.default
        for name, rule in definition.options.items()
    }
    values[REFERENCE] = _number(
        REFERENCE, given.get(REFERENCE, 0.0), definition, faults, whole=False
    )
    values[REFERENCE_RETURN] = str(given.get(REFERENCE_RETURN, "+"))
    if values[REFERENCE_RETURN] not in ("+", "-"):
        faults.append(_wrong(REFERENCE_RETURN, definition, "+ or -", values[REFERENCE_RETURN]))
    values[KIND] = given.get(KIND)
    if values[KIND] is not None and not isinstance(values[KIND], Mapping):
        values[KIND] = str(values[KIND])
        if values[KIND] not in tuple(AxisKind):
            faults.append(_wrong(KIND, definition, "linear or rotary", values[KIND]))
    if state is not None:
        _take_file_answers(definition, values, given, state, faults, strict=strict)
    raise_all(UsageError, faults)
    return Required(values, section="options", file=definition.file)


def known_kind(options: Mapping[str, object], address: str) -> AxisKind | None:
    """Return the axis kind (linear, rotary) that an option gives for an axis; None if none does."""
    given = options[KIND]
    word = given.get(address) if isinstance(given, Mapping) else given
    return None if word is None else AxisKind(str(word))


def axis_options(
    definition: Definition,
    resolved: Mapping[str, object],
    axis: Axis | None,
    *,
    unit_needed: bool = True,
) -> Mapping[str, object]:
    """Return the options of one axis by name. An option that the job does not state for the axis
    has its value for the whole control (``resolved``).

    ``axis``: None for an axis without a job. ``unit_needed``: a missing required value is an error;
    False as long as files that may contain the value are not read. Raises UsageError with every
    fault: unknown option, wrong value, a required value that is missing.
    """
    faults: list[Fault] = []
    values = dict(resolved)
    for name, given in (axis.options if axis is not None else {}).items():
        rule = definition.options.get(name)
        if rule is None:
            known = ", ".join(definition.options)
            faults.append(
                Fault(
                    message=f"{definition.id} has no option {name}",
                    place=name,
                    expected=f"one of {known}",
                    hint=f"see `compwright formats show {definition.id}` for the options it has",
                )
            )
        elif rule.whole_control:
            faults.append(
                Fault(
                    message=f"this option of {definition.id} applies to the whole control, not "
                    "to one axis",
                    place=name,
                    expected=f"controller.options.{name}",
                    found="an option of one axis",
                    hint=(
                        f"move it to `controller.options.{name}`; without a job give `--option "
                        f"{name}=VALUE`"
                    ),
                )
            )
        else:
            values[name] = _value(rule, given, definition, faults)
    for rule in () if faults else definition.options.values():
        value = values[rule.name]
        silent = not unit_needed and value is None
        if rule.asked is not None and not silent and not _positive(value):
            faults.append(
                Fault(
                    message=(
                        f"{definition.id} needs the {rule.name.replace('_', ' ')} of the axis, and "
                        "no given file contains it"
                    ),
                    place=rule.name,
                    expected=rule.asked,
                    found="nothing" if value is None else str(value),
                    hint=(
                        f"write `{rule.name}: VALUE` into this axis of the job, or add the file "
                        "that contains it to the control's files (`states` or `--state`); without "
                        f"a job give `--option {rule.name}=VALUE`"
                    ),
                )
            )
    raise_all(
        UsageError,
        faults if axis is None else [fault.within(f"axis {axis.name}") for fault in faults],
    )
    return Required(values, section="options", file=definition.file)


def _positive(value: object) -> bool:
    return isinstance(value, (int, float)) and value > 0


def describe_options(definition: Definition) -> tuple[str, ...]:
    """Return one line per option: name, default, choices, effect, evidence."""
    lines = []
    for name, rule in definition.options.items():
        default = "not given" if rule.default is None else _shown(rule.default)
        choices = f"; one of {', '.join(rule.choices)}" if rule.choices else ""
        lines.append(f"{name} (default {default}{choices}): {rule.help} [{rule.evidence}]")
    lines.append(
        f"{REFERENCE} (default 0): position at which the correction is zero, for reading files"
        " without a job"
    )
    lines.append(
        f"{REFERENCE_RETURN} (default +): direction in which the reference is approached, for"
        " reading files without a job"
    )
    lines.append(
        f"{KIND} (no default; one of linear, rotary): kind of the axes of which the files do not"
        " say it, for reading files without a job"
    )
    return tuple(lines)


def resolved_number(
    definition: Definition, name: str, options: Mapping[str, object], fact: object
) -> int | None:
    """Return a whole number that an option, the control's files (``fact``), or both can state. None
    if neither states it.

    If both state it, ``fact`` applies, unless the option's rule gives priority to the option. A
    fact of 0 means that nothing is reserved yet, which is no limit.
    """
    given = options.get(name)
    rule = definition.options[name]
    if isinstance(given, int) and (rule.option_wins or not isinstance(fact, int)):
        return given
    return fact if isinstance(fact, int) and fact > 0 else None


def _take_file_answers(
    definition: Definition,
    values: dict[str, object],
    given: Mapping[str, object],
    state: ControlState,
    faults: list[Fault],
    *,
    strict: bool,
) -> None:
    for name, rule in definition.options.items():
        if rule.settled_by is None or rule.option_wins:
            continue
        answers = {
            facts.stated[rule.settled_by]
            for facts in state.facts.values()
            if rule.settled_by in facts.stated
        }
        if len(answers) != 1:
            continue
        fact = answers.pop()
        if name in given and values[name] not in ((fact,) if strict else (fact, rule.default)):
            faults.append(
                Fault(
                    message=f"the option {name} contradicts the control's own files "
                    f"({definition.id})",
                    place=name,
                    expected=str(fact),
                    found=str(values[name]),
                    hint=f"leave the option out, or set it to {fact}",
                )
            )
        values[name] = fact


def _value(rule: OptionRule, value: object, definition: Definition, faults: list[Fault]) -> object:
    if value is None and rule.default is None:
        return None
    if rule.type == "choice":
        text = str(value)
        if text not in rule.choices:
            faults.append(_wrong(rule.name, definition, f"one of {', '.join(rule.choices)}", value))
        return text
    if rule.type == "text":
        return str(value)
    if rule.type == "integers":
        return _integers(rule.name, value, definition, faults)
    return _number(rule.name, value, definition, faults, whole=rule.type == "integer")


def _integers(
    name: str, value: object, definition: Definition, faults: list[Fault]
) -> tuple[int, ...]:
    items = (
        value.split(",")
        if isinstance(value, str)
        else value
        if isinstance(value, (list, tuple))
        else [value]
    )
    numbers = [_number(name, item, definition, faults, whole=True) for item in items if item != ""]
    return tuple(int(number) for number in numbers)


def _number(
    name: str, value: object, definition: Definition, faults: list[Fault], *, whole: bool
) -> float | int:
    kind = "a whole number, 0 or more" if whole else "a number with a decimal point"
    least, most = _SIZES
    try:
        number = (
            float(value)
            if isinstance(value, (str, int, float)) and not isinstance(value, bool)
            else math.nan
        )
    except (ValueError, OverflowError):
        number = math.nan
    if (
        not abs(number) <= most  # not a number is not either
        or 0 < abs(number) < least
        or (whole and (number != int(number) or number < 0))
    ):
        faults.append(_wrong(name, definition, kind, value))
        return 0
    return int(number) if whole else number


def _wrong(name: str, definition: Definition, expected: str, found: object) -> Fault:
    return Fault(
        message=f"the option {name} of {definition.id} has a wrong value",
        place=name,
        expected=expected,
        found=repr(found)[:60],
        hint=(
            f"correct the value; `compwright formats show {definition.id}` lists what is allowed"
        ),
    )


def _shown(value: object) -> str:
    if isinstance(value, tuple):
        return ",".join(str(item) for item in value) or "none"
    return str(value)
