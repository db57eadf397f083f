"""The schema of a job file as pydantic models: keys, types, ranges of single values, defaults.

What ties several keys together (names that must exist, ends in order) is in
`compwright.jobs.consistency`, so that its faults are listed together with those found here. Units:
mm or deg for positions; others at the field. Source: the job file of ``docs/contract.md``,
explained key by key in ``docs/job-file.md``.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Annotated, Any, Literal, get_args

from pydantic import BaseModel, BeforeValidator, ConfigDict, Discriminator, Field, Tag
from pydantic_core import PydanticCustomError

from compwright.foundations.key_faults import KeyPath

SCHEMA_VERSION = 1

#: What is expected under a key that is missing.
MISSING = {
    "compwright": "1, the version of the schema",
    "controller": "a mapping with the key format",
    "format": "the id of a controller format, as `compwright formats list` shows it",
    "axes": "at least one axis",
    "travel": "[low, high] in machine coordinates, mm or deg",
    "before": "at least one measurement file",
    "files": "the measurement files of the test",
}

Standard = Literal[
    "iso230-2:1988", "iso230-2:1997", "iso230-2:2006", "iso230-2:2014", "gost27843:2006", "vdi3441"
]


def _one_line_of_text(value: Any) -> Any:
    """Accept a word or a whole number as text; a decimal number may have lost digits (1.10) and
    must stand in quotes.
    """
    if isinstance(value, int) and not isinstance(value, bool):
        return str(value)
    if not isinstance(value, str):
        kind = "text_in_quotes"
        raise PydanticCustomError(kind, "is not text")
    if not value.strip() or any(
        ord(character) < ord(" ") or character == "\x7f" for character in value
    ):
        kind = "one_line"
        raise PydanticCustomError(kind, "is blank or holds control characters")
    return value


def _listed(value: Any) -> Any:
    return value if isinstance(value, list) else [value]


def _named_file(value: Any) -> Any:
    return {"files": [value]} if isinstance(value, str) else value


def _named_axis(value: Any) -> Any:
    return value if isinstance(value, dict) else {"axis": value}


def _acknowledgements(value: Any) -> Any:
    """Accept a reason alone, one mapping, or several, one for each axis."""
    return [{"reason": one} if isinstance(one, str) else one for one in _listed(value)]


def _no_truth_value(value: Any) -> Any:
    """Keep ``true`` from passing for 1, which it equals."""
    if isinstance(value, bool):
        kind = "truth_value"
        raise PydanticCustomError(kind, "is a truth value")
    return value


def _yes_or_no(value: Any) -> Any:
    """Read ``yes`` and ``no``, which are text in a job file; ``true`` and ``false`` are what they
    are.
    """
    return {"yes": True, "no": False}.get(value, value) if isinstance(value, str) else value


def _state(value: Any) -> Any:
    return value if isinstance(value, dict) else {"files": value}


def _auto_or_number(value: Any) -> str:
    return "auto" if value == "auto" else "number"


def _drift_file(value: Any) -> Any:
    return {"file": value} if isinstance(value, str) else value


def _drift_or_number(value: Any) -> str:
    """Tell a file from a number, and from text that was meant as one (``1,5``)."""
    if isinstance(value, dict):
        return "drift"
    named = isinstance(value, str) and re.search(r"[^\W\d_]", value) is not None
    return "drift" if named else "number"


Text = Annotated[str, BeforeValidator(_one_line_of_text)]
Positive = Annotated[float, Field(gt=0)]
NotNegative = Annotated[float, Field(ge=0)]
#: A complaint about a number that is none speaks of a number, not of the word too.
Spacing = Annotated[
    Annotated[Positive, Tag("number")] | Annotated[Literal["auto"], Tag("auto")],
    Discriminator(_auto_or_number),
]
#: °C: one temperature, or that at the start and at the end of the test.
Temperature = Annotated[list[float], BeforeValidator(_listed), Field(min_length=1, max_length=2)]
Sense = Annotated[Literal[1, -1], BeforeValidator(_no_truth_value)]
Sign = Literal["+", "-"]


class JobMapping(BaseModel):
    """A mapping of the job file: unknown keys are refused and no value is converted."""

    model_config = ConfigDict(strict=True, extra="forbid")


class MachineSection(JobMapping):
    """Which machine it is."""

    name: Text | None = None
    serial: Text | None = None
    type: Text | None = None


class ControllerSection(JobMapping):
    """The control's format and the options that hold for all axes."""

    format: Text
    options: dict[str, Any] = {}


class PositionMapSection(JobMapping):
    """machine = sense * instrument + offset."""

    sense: Sense = 1
    offset: float = 0.0


class EncoderSection(JobMapping):
    """The measuring system; without ``system`` the one that the control's files show to be in use,
    else 1.
    """

    type: Literal["incremental", "absolute", "distance_coded"] = "incremental"
    system: Annotated[Literal[1, 2] | None, BeforeValidator(_no_truth_value)] = None


class OwnThermalSection(JobMapping):
    """Keys of the differential expansion that an axis, or a test, has otherwise than what stands
    above it.
    """

    alpha_m: float | None = None
    T_m: Temperature | None = None
    alpha_d: float | None = None
    T_d: Temperature | None = None
    x_fix: float | None = None
    refer_to: Literal["scale", "workpiece"] | None = None


class ThermalSection(OwnThermalSection):
    """Nominal differential expansion: µm/(m K), °C, µm/(m K), °C, mm."""

    alpha_m: float
    T_m: Temperature


class TestSection(JobMapping):
    """One test: its files, name, state, position map (None: that of the axis), motion and
    temperatures.
    """

    __test__ = False  # not a test class, whatever the name suggests to a collector

    files: Annotated[list[Text], BeforeValidator(_listed), Field(min_length=1)]
    name: Text | None = None
    measured_in: Text = "as_found"
    position_map: PositionMapSection | None = None
    motion: Literal["feed", "rapid"] = "feed"
    thermal: OwnThermalSection | None = None
    profile: Text | None = None


class TableSection(JobMapping):
    """Wishes for the grid; None: as it is in the control, or as compwright chooses. ``gain``: from
    which gain on a table is written.
    """

    start: float | None = None
    end: float | None = None
    spacing: Spacing | None = None
    mode: Literal["auto", "single", "bidirectional"] = "auto"
    goal: Literal["expected", "A", "E", "M"] = "expected"
    gain: Literal["any", "seen"] = "any"


class GantrySection(JobMapping):
    """The synchronised axis, or the word none; what it gets where it has a table of its own."""

    axis: Text
    table: Literal["same", "change"] | None = None


class AxisSection(JobMapping):
    """One axis. ``accept`` (parameter names beside ``test``) and an empty ``before``: see
    `compwright.jobs.consistency`.
    """

    travel: Annotated[list[float], Field(min_length=2, max_length=2)]
    before: Annotated[
        list[Annotated[TestSection, BeforeValidator(_named_file)]], BeforeValidator(_listed)
    ]
    kind: Literal["linear", "rotary"] = "linear"
    modulo: Positive | None = None
    address: Text | None = None
    axis_number: Annotated[int, Field(ge=1, le=99)] | None = None
    gantry: Annotated[GantrySection, BeforeValidator(_named_axis)] | None = None
    position_map: PositionMapSection = PositionMapSection()
    reference: float | None = None
    reference_return: Sign | None = None
    encoder: EncoderSection = EncoderSection()
    programmed: Literal["radius", "diameter"] = "radius"
    screw_pitch: Annotated[list[Positive], BeforeValidator(_listed), Field(min_length=1)] | None = (
        None
    )
    table: TableSection = TableSection()
    options: dict[str, Any] = {}
    accept: dict[str, Any] | None = None
    thermal: OwnThermalSection | None = None


class CircleSection(JobMapping):
    """One circular test: one file with both runs, or a file per run. ``centre`` in machine
    coordinates, mm; ``accept``: limits in µm by parameter.
    """

    file: Text | None = None
    ccw: Text | None = None
    cw: Text | None = None
    name: Text | None = None
    measured_in: Text = "as_found"
    centre: Annotated[list[float], Field(min_length=2, max_length=3)] | None = None
    accept: Annotated[dict[str, Positive], Field(min_length=1)] | None = None


class CrossSection(JobMapping):
    """Deviation of one axis over another, in ``unit``, and the state (of ``states``) in which it
    was measured.
    """

    input: Text
    output: Text
    measured_in: Text = "as_found"
    positions: Annotated[list[float], Field(min_length=2)]
    deviations: Annotated[list[float], Field(min_length=2)]
    unit: Literal["um", "mm", "arcsec", "deg"]


class ApplySection(JobMapping):
    """What of the circular tests is to be corrected."""

    squareness: dict[str, Text] = {}
    scale: list[Text] = []
    backlash_from: Literal["positioning", "circle"] = "positioning"


class DeviceSection(JobMapping):
    """Expanded uncertainty (k = 2) of the instrument: µm and µm/m."""

    U: NotNegative = 0.0
    per_m: NotNegative = 0.0


class DriftSection(JobMapping):
    """The file of a stand-still test, and how long a positioning test takes, min."""

    file: Text
    duration_min: Positive | None = None


#: A range, or the stand-still test that shows it.
Variation = Annotated[
    Annotated[NotNegative, Tag("number")]
    | Annotated[DriftSection, BeforeValidator(_drift_file), Tag("drift")],
    Discriminator(_drift_or_number),
]


class RotaryUncertaintySection(JobMapping):
    """The contributors of rotary axes, arcsec: certificate of the instrument, set-up, drift of a
    stand-still test.
    """

    U: NotNegative = 0.0
    setup: NotNegative = 0.0
    E_VE: Variation = 0.0


class CircularUncertaintySection(JobMapping):
    """The contributors of circular tests, µm: certificate of the instrument, calibration of the
    bar's length, set-up, range of the reading of a machine at rest.
    """

    U: NotNegative = 0.0
    length: NotNegative = 0.0
    setup: NotNegative = 0.0
    E_VE: NotNegative = 0.0


class UncertaintySection(JobMapping):
    """Contributors of ISO 230-2:2006 annex A: mm, K, µm/(m K), µm, µm; of rotary axes and circular
    tests apart.
    """

    device: DeviceSection = DeviceSection()
    misalignment_mm: NotNegative = 0.0
    U_theta: NotNegative = 0.0
    U_alpha: NotNegative = 0.0
    setup: NotNegative = 0.0
    E_VE: Variation = 0.0
    rotary: RotaryUncertaintySection | None = None
    circular: CircularUncertaintySection | None = None


class ProvenSection(JobMapping):
    """A machine on which tables of this kind were seen to act."""

    control: Text
    machine: Text
    date: Text
    how: Text


class AcknowledgementSection(JobMapping):
    """Why a doubt does not count; ``axis``: for one axis only."""

    reason: Text
    axis: Text | None = None


class ReportSection(JobMapping):
    """How reports are written, and what stands at their head; ``logo``: a file."""

    language: Literal["en", "de", "fr", "ru"] = "en"
    number: Text | None = None
    customer: Text | None = None
    operator: Text | None = None
    place: Text | None = None
    logo: Text | None = None


class StateSection(JobMapping):
    """The files of a state, or the word none; whether compensation acted, where the files switch it
    off or do not say.
    """

    files: Annotated[list[Text], BeforeValidator(_listed), Field(min_length=1)]
    active: Annotated[bool | None, BeforeValidator(_yes_or_no)] = None


class JobSection(JobMapping):
    """The whole file. What ties ``states`` together is checked in `compwright.jobs.consistency`."""

    compwright: int
    controller: ControllerSection
    axes: Annotated[dict[str, AxisSection], Field(min_length=1)]
    machine: MachineSection = MachineSection()
    states: dict[str, Annotated[StateSection, BeforeValidator(_state)]] = {}
    circles: list[CircleSection] = []
    cross: list[CrossSection] = []
    apply: ApplySection | None = None
    fixed_positions: dict[str, dict[str, float]] = {}
    uncertainty: UncertaintySection | None = None
    environment: Text | None = None
    thermal: ThermalSection | None = None
    acknowledged: dict[
        str,
        Annotated[
            list[AcknowledgementSection], BeforeValidator(_acknowledgements), Field(min_length=1)
        ],
    ] = {}
    decision_rule: Literal["simple", "guarded"] = "simple"
    proven: list[ProvenSection] = []
    standard: Standard = "iso230-2:2014"
    report: ReportSection = ReportSection()


def known_keys(location: KeyPath) -> list[str]:
    """Return the keys of the section at ``location``; keys of free mappings and indices of lists
    are passed over.
    """
    section: type[BaseModel] = JobSection
    for part in location:
        entry = section.model_fields.get(part) if isinstance(part, str) else None
        if entry is not None:
            section = next(_sections_in(entry.annotation), section)
    return list(section.model_fields)


def _sections_in(annotation: Any) -> Iterator[type[BaseModel]]:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        yield annotation
    for inner in get_args(annotation):
        yield from _sections_in(inner)
