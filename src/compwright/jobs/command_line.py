"""Make a job from the options of ``compwright run FILE... --format ID --axis NAME``.

The words are put into the form of a job file and checked by the same schema, so that both ways
accept the same values and refuse the same faults.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Final

from compwright.foundations.command_words import key_values
from compwright.foundations.errors import Fault, UsageError
from compwright.foundations.key_faults import nearest
from compwright.foundations.yaml_reader import YamlDocument
from compwright.jobs.reading import Further, check, job_of
from compwright.records.job import AS_FOUND, Job

#: Keys of ``--option`` that describe the axis -> their place below the axis in a job file, and
#: whether they are numbers.
_AXIS_KEYS: dict[str, tuple[tuple[str, ...], bool]] = {
    "address": (("address",), False),
    "axis_number": (("axis_number",), True),
    "kind": (("kind",), False),
    "reference": (("reference",), True),
    "reference_return": (("reference_return",), False),
    "encoder_system": (("encoder", "system"), True),
    "screw_pitch": (("screw_pitch",), True),
    "spacing": (("table", "spacing"), True),
    "mode": (("table", "mode"), False),
}
#: Likeness from which another name is a slip of the keyboard: a letter more or less.
_TYPING: Final = 0.9
_OPTIONS = "controller.options."
#: The key of ``--option`` that states whether compensation was active, where the files of
#: ``--state`` switch it off or do not state it.
ACTIVE = "active"
_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?", re.ASCII)
_WHOLE = re.compile(r"[-+]?\d{1,15}", re.ASCII)


@dataclass(frozen=True, slots=True)
class StatedJob:
    """A job made from the command line. ``data``: the same job as the keys of a job file."""

    job: Job
    data: Mapping[str, Any]


def job_from_options(
    files: Sequence[str],
    *,
    format: str,  # noqa: A002 - the name of the option
    axis: str,
    travel: str,
    states: Sequence[str],
    options: Sequence[str],
    profile: str | None = None,
    further: Further | None = None,
) -> StatedJob:
    """Return the job that the options of ``run`` describe: one axis, and one test of all ``files``.
    ``further``: a function that makes additional checks of the job's data.

    ``travel`` is ``LO:HI`` in mm or deg. ``states`` are the control's own files, or the single word
    ``none``, or empty (the control's contents are then unknown).

    ``options`` are texts ``K=V``. These keys describe the axis: address, axis_number, kind,
    reference, reference_return, encoder_system, screw_pitch (a number, or numbers with commas),
    spacing and mode. ``active`` (yes or no) states whether the compensation in the files of the
    state was active. All other keys are options of the controller, and their values stay text.
    Raises UsageError with every fault at once; each fault names its option.
    """
    section: dict[str, Any] = {
        "travel": [_number(end) for end in travel.split(":")],
        "before": [{"files": list(files)} | ({"profile": profile} if profile else {})],
    }
    controller, faults = _sorted_options(options, section)
    data: dict[str, Any] = {
        "compwright": 1,
        "controller": {"format": format, "options": controller},
        "axes": {axis: section},
    }
    active = controller.pop(ACTIVE, None)
    if active is not None and not states:
        faults.append(
            Fault(
                message="the option `active` is an answer about the control's files, but none "
                "are given",
                place=f"--option {ACTIVE}",
                expected="--state FILE",
                found=active,
                hint="add `--state FILE` with the control's files",
            )
        )
    elif states:
        data["states"] = {
            AS_FOUND: list(states) if active is None else {"files": list(states), ACTIVE: active}
        }
    document = YamlDocument(data=data)
    checked = check(document, "") if further is None else check(document, "", further)
    faults += [replace(fault, place=_option(fault.place, axis)) for fault in checked.faults]
    faults = [whole_travel(travel) if fault.place == "--travel" else fault for fault in faults]
    if faults or checked.section is None:
        raise UsageError(*dict.fromkeys(faults))
    return StatedJob(job_of(checked.section, file=""), data)


def _sorted_options(
    options: Sequence[str], section: dict[str, Any]
) -> tuple[dict[str, str], list[Fault]]:
    """Put the options of the axis into ``section``; return the control's options, and faults."""
    controller: dict[str, str] = {}
    given, faults = key_values(options)
    for key, value in given.items():
        if key not in _AXIS_KEYS and (near := nearest(key, _AXIS_KEYS, _TYPING)):
            faults.append(
                Fault(
                    message=f"the option `{key}` is unknown",
                    place="--option",
                    expected=f"'{near}', the nearest known name",
                    hint=f"give `--option {near}={value}`",
                )
            )
        elif key in _AXIS_KEYS:
            path, is_number = _AXIS_KEYS[key]
            target = section.setdefault(path[0], {}) if len(path) > 1 else section
            target[path[-1]] = _numbers(value) if is_number else value
        else:
            controller[key] = value
    return controller, faults


def _numbers(text: str) -> Any:
    """Return the number in a text, or the list of numbers separated by commas."""
    return [_number(part) for part in text.split(",")] if "," in text else _number(text)


def _number(text: str) -> Any:
    """Return ``text`` as a number; if it is no number, unchanged, so that the schema refuses the
    text.
    """
    word = text.strip()
    if _WHOLE.fullmatch(word):
        return int(word)
    return float(word) if _NUMBER.fullmatch(word) else text


def whole_travel(travel: str) -> Fault:
    """Return the fault of a ``--travel`` value that does not look like ``0:800``."""
    return Fault(
        message=(
            "the value of `--travel` must look like 0:800 (machine coordinates, mm or deg, "
            "lower end first)"
        ),
        place="--travel",
        found=repr(travel),
        hint="give the two ends with a colon, such as `--travel 0:800` or `--travel=-800:0`",
    )


def _option(place: str, axis: str) -> str:
    """Return the command-line option that sets the value at a key path (``place``) of the job."""
    places = {
        f"axes.{axis}.travel": "--travel",
        f"axes.{axis}.before[0].profile": "--profile",
        f"axes.{axis}.before": "FILE",
        "controller.format": "--format",
        f"states.{AS_FOUND}.{ACTIVE}": f"--option {ACTIVE}",
        f"states.{AS_FOUND}": "--state",
        **{
            ".".join(("axes", axis, *path)): f"--option {key}"
            for key, (path, _) in _AXIS_KEYS.items()
        },
    }
    if place.startswith(_OPTIONS):
        return f"--option {place.removeprefix(_OPTIONS)}"
    for start, option in places.items():
        if re.match(rf"{re.escape(start)}($|[.\[])", place):
            return option
    return "--axis" if place.startswith("axes") else place


def stated_activity(options: dict[str, object]) -> bool | None:
    """Remove ``active`` from the options and return its value. Raises UsageError unless it is yes
    or no.
    """
    text = options.pop(ACTIVE, None)
    words = {None: None, "yes": True, "true": True, "no": False, "false": False}
    word = text if text is None else str(text).lower()
    if word not in words:
        raise UsageError(
            Fault(
                message="the option `active` must be yes or no",
                place=f"--option {ACTIVE}",
                found=repr(text),
                hint="give `--option active=yes` or `--option active=no`",
            )
        )
    return words[word]
