"""What the standards ask a test report to state, item by item, and where each statement comes from:
header keys of the measurement file, the job, or the evaluation itself. Computes nothing.

The lists are those of ISO 230-2:1997 and 2006 (7.1), GOST 27843-2006 (8.1) and ISO 230-4:1996 (6,
with the parameters of 4.4; read as DIN ISO 230-4:1999). ISO 230-2:1988 has no list: its clauses ask
for single statements. The texts of ISO 230-2:2014, ISO 230-4:2005 and VDI/DGQ 3441 were not at
hand; `BASIS` says which list serves instead.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Final

from compwright.reporting.numbers import number, plain, standard_text, unit_text

Document = Mapping[str, Any]

#: By standard: on what the list of items rests.
BASIS: Final[Mapping[str, str]] = {
    "iso230-2:1988": (
        "Items: ISO 230-2:1997, 7.1. The edition of 1988 has no list; its clauses 3.2 and 4.3 ask"
        " for the items that have a clause here."
    ),
    "iso230-2:1997": "Items: ISO 230-2:1997, 7.1.",
    "iso230-2:2006": "Items: ISO 230-2:2006, 7.1.",
    "iso230-2:2014": (
        "Items: ISO 230-2:2006, 7.1. The text of ISO 230-2:2014 was not available; its clauses are"
        " not quoted."
    ),
    "gost27843:2006": "Items: GOST 27843-2006, 8.1.",
    "vdi3441": (
        "Items: ISO 230-2:2006, 7.1. The text of VDI/DGQ 3441 was not available; its clauses are"
        " not quoted."
    ),
    "iso230-4:1996": "Items: ISO 230-4:1996, clauses 4.4 and 6 (read as DIN ISO 230-4:1999).",
    "iso230-4:2005": (
        "Items: ISO 230-4:1996, clauses 4.4 and 6. The text of ISO 230-4:2005 was not available;"
        " its clauses are not quoted."
    ),
}

#: By standard: the edition whose clauses are quoted.
READ_EDITION: Final[Mapping[str, str]] = {
    **{name: name for name in BASIS},
    "iso230-2:2014": "iso230-2:2006",
    "vdi3441": "iso230-2:2006",
    "iso230-4:2005": "iso230-4:1996",
}

_ISO_LIST: Final = {"iso230-2:1997": "7.1", "iso230-2:2006": "7.1"}
_ALL_LISTS: Final = {**_ISO_LIST, "gost27843:2006": "8.1"}
_CIRCLE: Final = "iso230-4:1996"


@dataclass(frozen=True, slots=True)
class ReportItem:
    """One statement of a test report.

    ``clauses``: clause by edition, of those editions that ask for it. ``headers``: keys of the
    measurement file in their plain spelling with the unit of a bare number (empty: none); a key
    ``NAME`` is found as ``NAME_start`` and ``NAME_end`` too. ``given``: what the evaluation itself
    says. ``kinds``: kinds of test that have the item.
    """

    key: str
    label: str
    clauses: Mapping[str, str]
    headers: Mapping[str, str] = field(default_factory=dict)
    given: Callable[[Document], str] | None = None
    kinds: tuple[str, ...] = ("positioning",)


def _targets(result: Document) -> str:
    positions = [target.get("position") for target in result.get("targets") or ()]
    if not positions:
        return ""
    unit = unit_text(result.get("position_unit"))
    return (
        f"{len(positions)} from {plain(positions[0])} to {plain(positions[-1])} {unit}; listed in"
        " annex A"
    )


def _approaches(result: Document) -> str:
    runs = result.get("n_runs") or {}
    counts = [
        f"{sign} n = {runs[key]}"
        for key, sign in (("positive", "+"), ("negative", "−"))
        if runs.get(key)
    ]
    return f"{', '.join(counts)}; {plain(result.get('cycle', 'standard'))} cycle" if counts else ""


def _expansion(result: Document) -> str:
    thermal = result.get("thermal")
    if not thermal:
        return ""
    return (
        f"applied by compwright: readings reduced to 20 °C, {thermal['refer_to']}"
        f" {plain(thermal['alpha_m'])} µm/(m K) at {plain(thermal['T_m'])} °C, instrument"
        f" {plain(thermal['alpha_d'])} µm/(m K) at {plain(thermal['T_d'])} °C, fixed point"
        f" {plain(thermal['x_fix'])} mm"
    )


def _expansion_coefficient(result: Document) -> str:
    thermal = result.get("thermal")
    return f"{plain(thermal['alpha_m'])} µm/(m K)" if thermal else ""


def _contributors(result: Document) -> str:
    return "see the budget of the uncertainty" if result.get("budget") else ""


def _axis(result: Document) -> str:
    axis = result.get("axis")
    return f"{plain(axis)}, {plain(result.get('axis_kind', 'linear'))}" if axis else ""


def _standard(result: Document) -> str:
    return standard_text(result.get("standard", ""))


def _estimator(result: Document) -> str:
    words = {"std": "standard deviation, n − 1", "range": "range of the readings"}
    spread = words.get(str(result.get("spread") or "std"))
    return f"s: {spread}; limits at ± {plain(result.get('coverage') or 2)} s; no smoothing"


def _plane(result: Document) -> str:
    return ", ".join(plain(axis) for axis in result.get("axes") or ())


def _radius(result: Document) -> str:
    radius = result.get("nominal_radius")
    return "" if radius is None else f"radius {plain(radius)} mm"


def _feed(result: Document) -> str:
    feed = result.get("feed")
    return "" if feed is None else f"{number(feed, 0)} mm/min"


def _senses(result: Document) -> str:
    words = {"ccw": "counter-clockwise", "cw": "clockwise"}
    senses = dict.fromkeys(str(run.get("direction")) for run in result.get("runs") or ())
    return ", ".join(words.get(sense, sense) for sense in senses)


def _set_up(result: Document) -> str:
    centre = result.get("set_up")
    return f"centre at {', '.join(plain(value) for value in centre)} mm" if centre else ""


def _range(result: Document) -> str:
    arc = result.get("arc") or {}
    if arc.get("start") is None:
        return ""
    end = float(arc["start"]) + float(arc["extent"])
    return f"from {plain(arc['start'])}° to {plain(end)}°, {plain(arc['extent'])}°"


def _samples(result: Document) -> str:
    counts = [
        f"{run.get('direction')}: {len(run.get('angles') or ())}"
        for run in result.get("runs") or ()
    ]
    return f"{', '.join(counts)} samples" if counts else ""


def _smoothing(result: Document) -> str:
    return "none by compwright: every sample counts" if result.get("runs") else ""


_BOTH: Final = ("positioning", "circular")
_CIRCULAR: Final = ("circular",)

#: Every item, in the order of the page. Header keys are listed in docs/measurement-files.md.
ITEMS: Final[tuple[ReportItem, ...]] = (
    ReportItem(
        "date",
        "Date and time of the test",
        {**_ALL_LISTS, _CIRCLE: "6"},
        {
            "date": "",
            "time": "",
            "date_started": "",
            "date_completed": "",
            "datum": "",
            "messdatum": "",
            "uhrzeit": "",
        },
        kinds=_BOTH,
    ),
    ReportItem("operator", "Operator", {}, {"operator": "", "by": ""}, kinds=_BOTH),
    ReportItem("place", "Place of the test", {}, {"location": "", "place": ""}, kinds=_BOTH),
    ReportItem(
        "machine",
        "Machine: name and serial number",
        {**_ALL_LISTS, _CIRCLE: "6"},
        {"machine": "", "serial": "", "serial_no": ""},
        kinds=_BOTH,
    ),
    ReportItem("machine_type", "Machine: type", _ALL_LISTS, {"machine_type": ""}, kinds=_BOTH),
    ReportItem("travel", "Travel of the axis", _ALL_LISTS, {"travel": ""}),
    ReportItem("axis", "Axis under test", _ALL_LISTS, given=_axis),
    ReportItem(
        "plane", "Axes that make the path", {_CIRCLE: "4.4 d"}, given=_plane, kinds=_CIRCULAR
    ),
    ReportItem(
        "measuring_line",
        "Measuring line: location, offsets to tool and workpiece reference",
        _ALL_LISTS,
        {
            "measuring_line": "",
            "tool_offset": " mm",
            "workpiece_offset": " mm",
            "axis_location": "",
        },
    ),
    ReportItem(
        "other_axes",
        "Positions of the axes not under test",
        {**_ALL_LISTS, "iso230-2:1988": "3.2", _CIRCLE: "4.4 i"},
        {"other_axes": ""},
        kinds=_BOTH,
    ),
    ReportItem("scale", "Type of the machine's scale", _ALL_LISTS, {"scale": ""}),
    ReportItem(
        "scale_expansion",
        "Expansion coefficient of the scale",
        _ISO_LIST,
        {"scale_expansion": " µm/(m K)", "alpha_m": " µm/(m K)"},
        _expansion_coefficient,
    ),
    ReportItem(
        "instrument",
        "Measuring instrument: maker, type",
        {**_ALL_LISTS, "iso230-2:1988": "4.3.4", _CIRCLE: "6"},
        {"instrument": "", "software": "", "software_version": ""},
        kinds=_BOTH,
    ),
    ReportItem(
        "instrument_serial",
        "Measuring instrument: serial numbers of the components",
        _ALL_LISTS,
        {"instrument_serial": "", "ballbar_serial": "", "calibrator_serial": ""},
        kinds=_BOTH,
    ),
    ReportItem(
        "certificate",
        "Measuring instrument: calibration certificate",
        {},
        {
            "certificate": "",
            "calibrated_until": "",
            "ballbar_certificate": "",
            "ballbar_last_calibrated": "",
            "calibrated_length_mm": " mm",
        },
        kinds=_BOTH,
    ),
    ReportItem(
        "instrument_position",
        "Position of the measuring instrument",
        {**_ALL_LISTS, "iso230-2:1988": "4.3.1", _CIRCLE: "4.4 e"},
        {"instrument_position": "", "centre": ""},
        _set_up,
        kinds=_BOTH,
    ),
    ReportItem(
        "sensor_positions",
        "Places of the temperature sensors",
        {**_ISO_LIST, "iso230-2:1988": "4.3.1"},
        {"sensor_positions": ""},
    ),
    ReportItem(
        "temperatures",
        "Temperature of the machine's scale or workpiece, start and end",
        _ISO_LIST,
        {"t_m": " °C", "run_temperature_c": " °C", "machine_temperature": " °C"},
    ),
    ReportItem(
        "temperatures_instrument",
        "Temperature of the instrument's sensors, start and end",
        {"iso230-2:2006": "7.1"},
        {"t_d": " °C"},
    ),
    ReportItem(
        "temperatures_circle",
        "Temperatures of environment, instrument and machine",
        {_CIRCLE: "4.4 f"},
        {
            "air_temperature": " °C",
            "air_temp": " °C",
            "run_temperature_c": " °C",
            "calibrator_temperature_c": " °C",
            "t_m": " °C",
            "t_d": " °C",
            "machine_temperature": " °C",
        },
        kinds=_CIRCULAR,
    ),
    ReportItem(
        "air_temperature",
        "Air temperature, start and end",
        _ALL_LISTS,
        {"air_temperature": " °C", "air_temp": " °C", "temperature": " °C", "temperatur": " °C"},
    ),
    ReportItem(
        "air_pressure",
        "Air pressure, start and end",
        _ALL_LISTS,
        {"air_pressure": " hPa", "air_press": " hPa"},
    ),
    ReportItem(
        "humidity",
        "Humidity of the air, start and end",
        _ALL_LISTS,
        {"humidity": " %", "air_humidity": " %"},
    ),
    ReportItem(
        "expansion",
        "Correction for thermal expansion (NDE)",
        {"iso230-2:2006": "7.1"},
        {"compensated_for": ""},
        _expansion,
    ),
    ReportItem(
        "compensation_routine",
        "Type of the routine for thermal compensation",
        {**_ISO_LIST, "iso230-2:1988": "4.3.1"},
        {"compensation_routine": ""},
    ),
    ReportItem(
        "compensation",
        "Software compensation of the control: on or off",
        {**_ALL_LISTS, _CIRCLE: "4.4 h"},
        {"compensation": ""},
        kinds=_BOTH,
    ),
    ReportItem(
        "feed",
        "Feed between target positions",
        _ALL_LISTS,
        {
            "feed": "",
            "feed_rate": "",
            "feedrate": "",
            "feed_mm_min": " mm/min",
            "feed_deg_min": " deg/min",
        },
    ),
    ReportItem(
        "dwell", "Dwell time at each target position", _ALL_LISTS, {"dwell_s": " s", "dwell": ""}
    ),
    ReportItem("targets", "Target positions", _ALL_LISTS, given=_targets),
    ReportItem(
        "approaches",
        "Number of approaches, test cycle",
        {**_ALL_LISTS, "iso230-2:1988": "4.3.2"},
        given=_approaches,
    ),
    ReportItem("warm_up", "Warm-up before the test", _ALL_LISTS, {"warm_up": ""}, kinds=_BOTH),
    ReportItem(
        "air_shower",
        "Air or oil shower, coolant",
        _ALL_LISTS,
        {"air_shower": "", "oil_shower": "", "coolant": ""},
    ),
    ReportItem(
        "diameter",
        "Diameter or radius of the nominal path",
        {_CIRCLE: "4.4 a"},
        given=_radius,
        kinds=_CIRCULAR,
    ),
    ReportItem(
        "path_feed",
        "Contouring feed",
        {_CIRCLE: "4.4 b"},
        {"programmed_feed_mm_min": " mm/min programmed"},
        _feed,
        kinds=_CIRCULAR,
    ),
    ReportItem("sense", "Sense of contouring", {_CIRCLE: "4.4 c"}, given=_senses, kinds=_CIRCULAR),
    ReportItem(
        "range",
        "Range of the data, start and end",
        {_CIRCLE: "4.4 g"},
        given=_range,
        kinds=_CIRCULAR,
    ),
    ReportItem("samples", "Number of samples", {_CIRCLE: "4.4 g"}, given=_samples, kinds=_CIRCULAR),
    ReportItem(
        "smoothing", "Smoothing", {_CIRCLE: "4.4 g"}, {"smoothing": ""}, _smoothing, kinds=_CIRCULAR
    ),
    ReportItem("standard", "Standard and edition", {}, given=_standard, kinds=_BOTH),
    ReportItem("estimator", "Estimator of s, smoothing", {}, given=_estimator),
    ReportItem(
        "contributors",
        "Contributors to the measurement uncertainty",
        {"iso230-2:2006": "7.1"},
        given=_contributors,
    ),
)


def items_of(kind: str) -> list[ReportItem]:
    """Return the items of a kind of test (``positioning`` or ``circular``)."""
    return [item for item in ITEMS if kind in item.kinds]
