"""The schema of a job file as pydantic models: keys, types, ranges of values, defaults.

What ties several keys together (names that must exist, start before end) is in
`compwright.jobs.consistency`, so that its faults are listed together with those found here. Units:
mm or deg for positions; others at the field. The job file is explained in
``docs/job-file.md``; the text below a key becomes its row in ``docs/job-keys.md``.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any, Literal, get_args

from pydantic import BaseModel, BeforeValidator, ConfigDict, Discriminator, Field, Tag

from compwright.foundations.key_faults import KeyPath
from compwright.jobs.value_types import (
    CircularLimits,
    NotNegative,
    Positive,
    Sense,
    Sign,
    Spacing,
    Temperature,
    Text,
    acknowledgements,
    drift_file,
    drift_or_number,
    files_or_mapping,
    listed,
    named_axis,
    named_file,
    no_truth_value,
    yes_or_no,
)

SCHEMA_VERSION = 1

Standard = Literal[
    "iso230-2:1988", "iso230-2:1997", "iso230-2:2006", "iso230-2:2014", "gost27843:2006", "vdi3441"
]


class JobMapping(BaseModel):
    """Base of all mappings in the job file. Unknown keys are refused, and no value is converted."""

    model_config = ConfigDict(strict=True, extra="forbid")


class MachineSection(JobMapping):
    """The machine: name, serial number, type."""

    name: Text | None = None
    serial: Text | None = None
    type: Text | None = None


class ControllerSection(JobMapping):
    """The control's format and its options for all axes."""

    format: Text
    """Id of the control's format, as `compwright formats list` shows it, or the path of a
    [definition of one's own](formats.md) (`*.yaml`). Required.
    """
    options: dict[str, Any] = {}
    """Options of the format for all axes, as `compwright formats show ID` lists them. Some have no
    default, because a wrong one doubles an error or overwrites a table, and are asked for (exit
    2) where the control's files do not say it; see the page of the control. Default: by the
    format.
    """


class PositionMapSection(JobMapping):
    """The conversion of positions: machine = sense * instrument + offset."""

    sense: Sense = 1
    offset: float = 0.0


class EncoderSection(JobMapping):
    """The measuring system. ``system``: 1 or 2, by default as in the control's files, else 1."""

    type: Literal["incremental", "absolute", "distance_coded"] = "incremental"
    system: Annotated[Literal[1, 2] | None, BeforeValidator(no_truth_value)] = None


class OwnThermalSection(JobMapping):
    """Keys on differential expansion that an axis or a test may override."""

    alpha_m: float | None = None
    """Coefficient of expansion of the machine's scale or of the workpiece. Unit: µm/(m K).
    Required.
    """
    T_m: Temperature | None = None
    """Its temperature; or `[20.4, 22.9]`, at the start and at the end of the test. Unit: °C.
    Required.
    """
    alpha_d: float | None = None
    """The same of the measuring device. Unit: µm/(m K), °C. Default: `0`, `20`."""
    T_d: Temperature | None = None
    """The same of the measuring device. Unit: µm/(m K), °C. Default: `0`, `20`."""
    x_fix: float | None = None
    """Fixed point of the measurement, machine coordinate. Unit: mm. Default: `0`."""
    refer_to: Literal["scale", "workpiece"] | None = None
    """`scale` or `workpiece`: what is referred to 20 °C. Default: `scale`."""


class ThermalSection(OwnThermalSection):
    """Differential expansion in µm/(m K), °C and mm. An environment record may replace ``T_m``."""

    alpha_m: float


class InstrumentAirSection(JobMapping):
    """The air for which the display of a laser is valid."""

    air_c: float = Field(20.0, ge=-20.0, le=60.0)
    """Temperature of the air. Unit: °C. Default: `20`."""
    pressure_hpa: float = Field(1013.25, ge=500.0, le=1100.0)
    """Pressure of the air. Unit: hPa. Default: `1013.25`."""
    humidity_percent: float = Field(50.0, ge=0.0, le=100.0)
    """Relative humidity. Unit: %. Default: `50`."""


class EnvironmentSection(JobMapping):
    """Environment records, and the air for which the laser's display is valid."""

    files: Annotated[list[Text], BeforeValidator(listed), Field(min_length=1)]
    """Path, or list of paths, of CSV files with the columns `time` and `air_c`, `pressure_hpa`,
    `humidity_percent`, or `material_c`, or both. Required.
    """
    equation: Literal["ciddor", "edlen"] = "ciddor"
    """Of the refractive index of air: `ciddor` or `edlen` (modified). Default: `ciddor`."""
    instrument_air: InstrumentAirSection | Literal["vacuum"] | None = None
    """The air for which the display counts: `air_c`, `pressure_hpa`, `humidity_percent`, or
    `vacuum` where it counts in wavelengths of vacuum. Default: 20 °C, 1013.25 hPa, 50 %, named as
    an assumption (CW-T028).
    """


class TestSection(JobMapping):
    """One positioning test: its files, name, state, position map, motion and temperatures."""

    __test__ = False  # not a test class, whatever the name suggests to a collector

    files: Annotated[list[Text], BeforeValidator(listed), Field(min_length=1)]
    """Path, or list of paths. Required."""
    name: Text | None = None
    """Name of the test, once per axis. Default: the first file's name without folder and ending."""
    measured_in: Text = "as_found"
    """The state (of `states`) in which it was measured. Default: `as_found`."""
    position_map: PositionMapSection | None = None
    """As for the axis, for this test alone. Default: that of the axis."""
    motion: Literal["feed", "rapid"] = "feed"
    """How the axis was driven: `feed` or `rapid`. A control may compensate backlash at rapid
    traverse by a value of its own, which is then the active one. The table is made for the
    motion of the first test; both values are written, their difference stays. `verify` takes a
    test after loading at the motion of the one that it repeats. Default: `feed`.
    """
    thermal: OwnThermalSection | None = None
    """Keys of [`thermal`](#thermal) that this test has otherwise than its axis. Default: those of
    the axis.
    """
    profile: Text | None = None
    """Mapping profile (`compwright profile`) for files of another program. Default: none."""


class TableSection(JobMapping):
    """The grid and the goal of a table. By default an existing grid is kept, else one is chosen.

    ``gain``: the least improvement with which a table is written.
    """

    start: float | None = None
    """First and last table point, start < end. Unit: mm, deg. Default: by travel and control."""
    end: float | None = None
    """First and last table point, start < end. Unit: mm, deg. Default: by travel and control."""
    spacing: Spacing | None = None
    """Distance of the points, above 0; more than 100 000 points are refused; `auto`: compwright
    chooses. Unit: mm, deg. Default: the grid that is in the control stays; chosen where there
    is none.
    """
    mode: Literal["auto", "single", "bidirectional"] = "auto"
    """`auto`, `single` (one curve and a backlash value) or `bidirectional`. Default: `auto`."""
    goal: Literal["expected", "A", "E", "M"] = "expected"
    """What the fit makes small: `expected` (expected squared deviation), `A`, `E` or `M`. Default:
    `expected`.
    """
    gain: Literal["any", "seen"] = "any"
    """`any`: every table that improves the axis is written; `seen`: only one whose gain a test
    would show: at new targets A (else E, ...) falls by more than one standard deviation by
    which it differs from test to test. Else the axis keeps what it has, and `CW-P155` says what
    is left. [Next rounds](how-to/second-round.md) ask for it. Default: `any`.
    """


class GantrySection(JobMapping):
    """The slave axis of a gantry, or ``none``, and which table it gets if it has its own."""

    axis: Text
    table: Literal["same", "change"] | None = None


class AxisSection(JobMapping):
    """One axis of a job. `compwright.jobs.consistency` checks its keys together."""

    travel: Annotated[list[float], Field(min_length=2, max_length=2)]
    """`[low, high]` of the travel, low < high; the targets of the tests from which the table is
    made, the first and those that count together with it, have to cover at least half of it
    (exit 3). Unit: mm, deg. Required.
    """
    before: Annotated[
        list[Annotated[TestSection, BeforeValidator(named_file)]], BeforeValidator(listed)
    ]
    """The tests, see below; `[]` for an axis that only circles or cross measurements speak of.
    Required.
    """
    kind: Literal["linear", "rotary"] = "linear"
    """`linear` or `rotary`. Default: `linear`."""
    modulo: Positive | None = None
    """Period of an endless rotary axis; only with `kind: rotary`; its error repeats with it,
    whatever `travel` says. Unit: deg. Default: travel as given.
    """
    address: Text | None = None
    """The axis as the control names it, text or number; two axes cannot share one. Default: the
    axis' name; where the control counts its axes, the one that its own files call by that name,
    listed in `assumed`.
    """
    axis_number: Annotated[int, Field(ge=1, le=99)] | None = None
    """Index of the axis where the control also counts (MP index, `.COM` column), 1 to 99. Default:
    not given.
    """
    gantry: Annotated[GantrySection, BeforeValidator(named_axis)] | None = None
    """Address of the synchronised axis, which gets the table too, or `{axis, table}`: `table:
    same` gives it the same total, `table: change` adds the same change to its own total on its
    own grid; asked for (exit 2) where the axis has a table, grid or backlash of its own that
    differs. The word `none` says that the axis was measured and works alone, where the
    control's files can couple it with another one by a program or the PLC. Default: none; asked
    for where the control's files couple the axis with another one.
    """
    position_map: PositionMapSection = PositionMapSection()
    """`{sense, offset}`: machine = sense · instrument + offset. `sense` is 1 or -1; -1 also swaps
    directions and the sign of deviations. Unit: 1; mm, deg. Default: `{sense: 1, offset: 0}`.
    """
    reference: float | None = None
    """Coordinate of the reference position; the correction is zero there. Unit: mm, deg. Default:
    `0`; where the control's files say where the axis homes, that place.
    """
    reference_return: Sign | None = None
    """Direction in which the reference is approached, `"+"` or `"-"`. Default: `"+"`."""
    encoder: EncoderSection = EncoderSection()
    """`type`: `incremental`, `absolute` or `distance_coded`; `system`: 1 or 2 (no effect on
    controls that know one only: CW-J020). Default: `incremental`; the system that the control's
    files show to be in use, else 1; asked for where they speak of two and do not show it.
    """
    programmed: Literal["radius", "diameter"] = "radius"
    """`radius` or `diameter` (X of a lathe). All positions and deviations of a job count in
    radius, as the machine moves. `diameter` is checked against the control's files, may change
    nothing (the card says what to program then), and is refused (2) where it is not known how
    the control's tables count then. Default: `radius`.
    """
    screw_pitch: Annotated[list[Positive], BeforeValidator(listed), Field(min_length=1)] | None = (
        None
    )
    """Known period of the error, or a list of periods, above 0. Unit: mm, deg. Default: unknown:
    the readings are searched for periods, also in addition to known ones (CW-E012 to CW-E014);
    what the control's files suggest is reported (CW-S049) and expected before others.
    """
    table: TableSection = TableSection()
    """Wishes for the grid, see below. Default: automatic."""
    options: dict[str, Any] = {}
    """Options of the format for this axis; they go over those of `controller`. Default: none."""
    accept: dict[str, Any] | None = None
    """Limits by parameter: `{A: 8, E: 6}`, above 0; for the first test, or for the one named by
    `test`. Unit: µm, arcsec. Default: no verdict.
    """
    thermal: OwnThermalSection | None = None
    """Keys of [`thermal`](#thermal) that this axis has otherwise than the job. Default: those of
    the job.
    """


class CircleSection(JobMapping):
    """One circular test: one file with both runs, or one file per run.

    ``centre`` in machine coordinates, mm; ``accept``: limits in µm by parameter.
    """

    file: Text | None = None
    """One file with both runs; or `ccw` and `cw`, a file for each. One of them is required."""
    ccw: Text | None = None
    cw: Text | None = None
    name: Text | None = None
    """Name of the circle, once per job. Default: the file's name without folder and ending."""
    measured_in: Text = "as_found"
    """As for a test. Default: `as_found`."""
    centre: Annotated[list[float], Field(min_length=2, max_length=3)] | None = None
    """Machine coordinates of the centre: two numbers, in the order of the plane, or X, Y and Z.
    Unit: mm. Default: what the file says, else the middle of the travel (with a warning).
    """
    accept: CircularLimits | None = None
    """Limits by parameter (`{G_bidirectional: 10, F_min_cw: -8}`); F and D by size. Unit: µm.
    Default: none.
    """


class CrossSection(JobMapping):
    """Measured deviations of one axis over the positions of another, in a state ``measured_in``."""

    input: Text
    """The axis that moves, and the one that deviates. Required."""
    output: Text
    """The axis that moves, and the one that deviates. Required."""
    measured_in: Text = "as_found"
    """As for a test. Default: `as_found`."""
    positions: Annotated[list[float], Field(min_length=2)]
    """Positions of the input axis, each once. Unit: mm, deg. Required."""
    deviations: Annotated[list[float], Field(min_length=2)]
    """Deviation of the output axis at each. Unit: `unit`. Required."""
    unit: Literal["um", "mm", "arcsec", "deg"]
    """`um`, `mm` (linear output axis), `arcsec` or `deg` (rotary). Required."""


class ApplySection(JobMapping):
    """What is corrected by the results of circular tests."""

    squareness: dict[str, Text] = {}
    """`{XY: Y}`: in the plane XY the axis Y is bent; each plane once. Default: nothing."""
    scale: list[Text] = []
    """Axes without a positioning test whose scale is taken from circles. Default: none."""
    backlash_from: Literal["positioning", "circle"] = "positioning"
    """`positioning` or `circle`. Default: `positioning`."""


class DeviceSection(JobMapping):
    """Expanded uncertainty (k = 2) of the instrument: µm and µm/m."""

    U: NotNegative = 0.0
    """Measuring instrument, by its certificate: constant and per metre. Unit: µm, µm/m."""
    per_m: NotNegative = 0.0
    """Measuring instrument, by its certificate: constant and per metre. Unit: µm, µm/m."""


class DriftSection(JobMapping):
    """The file of a stand-still test, and how long a positioning test takes (min)."""

    file: Text
    """The readings of an axis at rest over time, see below. Required."""
    duration_min: Positive | None = None
    """Time that one positioning test takes. Unit: min. Default: that of the whole file."""


#: A range, or the stand-still test that shows it.
Variation = Annotated[
    Annotated[NotNegative, Tag("number")]
    | Annotated[DriftSection, BeforeValidator(drift_file), Tag("drift")],
    Discriminator(drift_or_number),
]


class RotaryUncertaintySection(JobMapping):
    """Contributors to the uncertainty of rotary axes (arcsec): instrument, set-up and drift."""

    U: NotNegative = 0.0
    """Instrument (k = 2), from its certificate. Unit: arcsec. Default: `0`."""
    setup: NotNegative = 0.0
    """Mounting the instrument again (k = 2), from experience. Unit: arcsec. Default: `0`."""
    E_VE: Variation = 0.0
    """Range of the readings of the axis at rest, or their file. Unit: arcsec. Default: `0`."""


class CircularUncertaintySection(JobMapping):
    """Contributors for circular tests (µm): instrument, length of the bar, set-up and drift."""

    U: NotNegative = 0.0
    """Instrument (k = 2): a change in length, from its certificate. Unit: µm. Default: `0`."""
    length: NotNegative = 0.0
    """Length of the bar (k = 2), from its calibration; for F and D. Unit: µm. Default: `0`."""
    setup: NotNegative = 0.0
    """Mounting the instrument again (k = 2), from experience. Unit: µm. Default: `0`."""
    E_VE: NotNegative = 0.0
    """Range of the reading at rest over the time of a test: measure it. Unit: µm. Default: `0`."""


class UncertaintySection(JobMapping):
    """Contributors to uncertainty (ISO 230-2:2006, annex A), also of rotary axes and circles."""

    device: DeviceSection = DeviceSection()
    misalignment_mm: NotNegative = 0.0
    """Misalignment of the beam over the travel. Unit: mm."""
    U_theta: NotNegative = 0.0
    """Temperature measurement. Unit: K."""
    U_alpha: NotNegative = 0.0
    """Coefficient of expansion. Unit: µm/(m K)."""
    setup: NotNegative = 0.0
    """Set-up, over the travel of the test. Unit: µm."""
    E_VE: Variation = 0.0
    """Environmental variation: the range of the readings of an axis at rest over the time of a
    positioning test, or the file of such a stand-still test, see below. Unit: µm.
    """
    rotary: RotaryUncertaintySection | None = None
    """Of rotary axes, see below; without it no uncertainty of a rotary axis is stated, and its
    guarded decisions are undecided (CW-P132 says so). Default: none.
    """
    circular: CircularUncertaintySection | None = None
    """Of circular tests, see below. `U_theta` and `U_alpha` count over the radius, for F and D.
    Without it no uncertainty of a circle is stated, and its guarded decisions are undecided
    (CW-P132). Default: none.
    """


class ProvenSection(JobMapping):
    """A proof, on a named machine, that tables for this control are active as planned."""

    control: Text
    machine: Text
    date: Text
    how: Text


class AcknowledgementSection(JobMapping):
    """An acknowledgement of a doubt: the reason, and the ``axis`` it applies to (else all axes)."""

    reason: Text
    axis: Text | None = None


class ReportSection(JobMapping):
    """The language of reports, and the entries and logo in their head."""

    language: Literal["en", "de", "fr", "ru"] = "en"
    number: Text | None = None
    customer: Text | None = None
    operator: Text | None = None
    place: Text | None = None
    logo: Text | None = None


class StateSection(JobMapping):
    """Files of a state, or ``none``. ``active``: whether compensation was active, if unclear."""

    files: Annotated[list[Text], BeforeValidator(listed), Field(min_length=1)]
    active: Annotated[bool | None, BeforeValidator(yes_or_no)] = None


class JobSection(JobMapping):
    """All keys of a job file. Rules for ``states`` are in `compwright.jobs.consistency`."""

    compwright: int
    """Version of this schema: `1`. A newer one is refused before anything else is looked at.
    Required.
    """
    controller: ControllerSection
    """See below. Required."""
    axes: Annotated[dict[str, AxisSection], Field(min_length=1)]
    """One entry per axis, under its name (letters, digits, `_`, `+`, `-`). Required."""
    machine: MachineSection = MachineSection()
    """`name`, `serial`, `type`: text for reports. Default: none."""
    states: dict[str, Annotated[StateSection, BeforeValidator(files_or_mapping)]] = {}
    """What was active in the control (`files`, `active`), see below. Default: unknown: no table
    is written.
    """
    circles: list[CircleSection] = []
    """Circular tests, see below. Default: none."""
    cross: list[CrossSection] = []
    """Deviation of one axis over another, see below. Default: none."""
    apply: ApplySection | None = None
    """What of the circles is to be corrected, see below. Default: nothing."""
    fixed_positions: dict[str, dict[str, float]] = {}
    """Positions that the machine relies on, by name and axis; the card lists how far each moves.
    Unit: mm, deg. Default: none.
    """
    uncertainty: UncertaintySection | None = None
    """Contributors to the uncertainty, see below. Default: none: no U is stated."""
    environment: Annotated[EnvironmentSection, BeforeValidator(files_or_mapping)] | None = None
    """Record of air and material during the tests of a laser, by which each reading is reduced: a
    file, a list of files, or a mapping, see below. Default: none.
    """
    thermal: ThermalSection | None = None
    """Expansion to be removed from the readings, see below. Default: nothing is removed."""
    acknowledged: dict[
        str,
        Annotated[
            list[AcknowledgementSection], BeforeValidator(acknowledgements), Field(min_length=1)
        ],
    ] = {}
    """Doubts (the codes with "yes" in [findings.md](findings.md)) that you checked and that do not
    hold, each with your `reason`: `CW-T032: reason`, or for one axis `CW-T032: {axis: X,
    reason: ..}`; several axes as a list. The decisions then count, and the reason stands on
    report and card. Another code, or an axis that does not exist, is a fault (exit 2); one that
    nothing needed is reported (CW-J021). Default: none.
    """
    decision_rule: Literal["simple", "guarded"] = "simple"
    """`simple` compares the value with the limit; `guarded` uses the uncertainty as guard band
    (ISO 14253-1), after loading and for the prediction: accepted when p95 + U ≤ limit, rejected
    when p05 − U > limit, else undecided; it needs `uncertainty`. Which U:
    [below](job-file.md#what-guards-a-decision). Default: `simple`.
    """
    proven: list[ProvenSection] = []
    """List of machines on which this was seen to act: `control`, `machine`, `date`, `how`, all
    text; a good `verify` writes such lines into [`proven/`](commands.md#what-is-proven).
    Default: none.
    """
    standard: Standard = "iso230-2:2014"
    """`iso230-2:1988`, `iso230-2:1997`, `iso230-2:2006`, `iso230-2:2014`, `gost27843:2006` or
    `vdi3441`. Default: `iso230-2:2014`.
    """
    report: ReportSection = ReportSection()
    """`language`: `en`, `de`, `fr` or `ru`; `number`, `customer`, `operator`, `place`: text;
    `logo`: a file. Printed at the head of reports, "not stated" where missing. `logo`: a whole
    .png, .jpg or .svg file of at most 500 kB, embedded in the page; any other is refused (3).
    The report of `run`, the commissioning card and the page of `verify` are in the language;
    their last line names what is still in English. Default: `en`.
    """


def known_keys(location: KeyPath) -> list[str]:
    """Return the keys that the job's section at the key path ``location`` may have."""
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
