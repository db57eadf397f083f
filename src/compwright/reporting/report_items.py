"""The items that standards require in a test report, and from where the statement on each item is
taken.

A statement is taken from the header keys of the measurement file, from the job, or from the
evaluation. Nothing is calculated here.

The lists are those of ISO 230-2:1997 and 2006 (7.1), GOST 27843-2006 (8.1) and ISO 230-4:1996 (6,
with the parameters of 4.4; read as DIN ISO 230-4:1999). ISO 230-2:1988 has no list, but its clauses
require single statements. The texts of ISO 230-2:2014, ISO 230-4:2005 and VDI/DGQ 3441 were not
available; `BASIS` states which list is used instead.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Final

from compwright.reporting.numbers import number, plain, standard_text, unit_text
from compwright.words.sentences import Sentence, say

Document = Mapping[str, Any]

#: By standard: on what the list of items rests.
BASIS: Final[Mapping[str, Sentence]] = {
    "iso230-2:1988": say("basis.iso230_2_1988"),
    "iso230-2:1997": say("basis.iso230_2_1997"),
    "iso230-2:2006": say("basis.iso230_2_2006"),
    "iso230-2:2014": say("basis.iso230_2_2014"),
    "gost27843:2006": say("basis.gost27843_2006"),
    "vdi3441": say("basis.vdi3441"),
    "iso230-4:1996": say("basis.iso230_4_1996"),
    "iso230-4:2005": say("basis.iso230_4_2005"),
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
    """One item of a test report: label, clauses of the standards, and source of the statement.

    ``clauses``: the clause of each edition that requires the item. ``headers``: keys of the
    measurement file in their plain spelling, with the unit of a number without unit (empty for
    none); a key ``NAME`` is also found as ``NAME_start`` and ``NAME_end``. ``given``: what the
    evaluation itself states. ``kinds``: the kinds of test that have the item.
    """

    key: str
    label: Sentence
    clauses: Mapping[str, str]
    headers: Mapping[str, str | Sentence] = field(default_factory=dict)
    given: Callable[[Document], str | Sentence] | None = None
    kinds: tuple[str, ...] = ("positioning",)


def _targets(result: Document) -> str | Sentence:
    positions = [target.get("position") for target in result.get("targets") or ()]
    if not positions:
        return ""
    unit = unit_text(result.get("position_unit"))
    return say(
        "given.targets",
        count=len(positions),
        first=plain(positions[0]),
        last=plain(positions[-1]),
        unit=unit,
    )


def _approaches(result: Document) -> str | Sentence:
    runs = result.get("n_runs") or {}
    counts = [
        f"{sign} n = {runs[key]}"
        for key, sign in (("positive", "+"), ("negative", "−"))
        if runs.get(key)
    ]
    cycle = plain(result.get("cycle", "standard"))
    return say("given.approaches", counts=counts, cycle=cycle) if counts else ""


def _expansion(result: Document) -> str | Sentence:
    thermal = result.get("thermal")
    if not thermal:
        return ""
    return say(
        "given.expansion",
        what=str(thermal["refer_to"]),
        alpha_m=plain(thermal["alpha_m"]),
        T_m=plain(thermal["T_m"]),
        alpha_d=plain(thermal["alpha_d"]),
        T_d=plain(thermal["T_d"]),
        x_fix=plain(thermal["x_fix"]),
    )


def _expansion_coefficient(result: Document) -> str | Sentence:
    thermal = result.get("thermal")
    return say("given.coefficient", value=plain(thermal["alpha_m"])) if thermal else ""


def _contributors(result: Document) -> str | Sentence:
    return say("given.budget") if result.get("budget") else ""


def _axis(result: Document) -> str | Sentence:
    axis, kind = result.get("axis"), plain(result.get("axis_kind", "linear"))
    return say("given.axis", axis=plain(axis), kind=kind) if axis else ""


def _standard(result: Document) -> str:
    return standard_text(result.get("standard", ""))


def _estimator(result: Document) -> Sentence:
    spread, coverage = str(result.get("spread") or "std"), plain(result.get("coverage") or 2)
    return say("given.estimator", spread=spread, coverage=coverage)


def _plane(result: Document) -> str:
    return ", ".join(plain(axis) for axis in result.get("axes") or ())


def _radius(result: Document) -> str | Sentence:
    radius = result.get("nominal_radius")
    return "" if radius is None else say("given.radius", radius=plain(radius))


def _feed(result: Document) -> str | Sentence:
    feed = result.get("feed")
    return "" if feed is None else say("label.with_unit", value=number(feed, 0), unit="mm/min")


def _senses(result: Document) -> str | Sentence:
    senses = dict.fromkeys(str(run.get("direction")) for run in result.get("runs") or ())
    words = [say("given.sense", sense=sense) for sense in senses]
    return say("given.listed", items=words) if words else ""


def _set_up(result: Document) -> str | Sentence:
    centre = result.get("set_up")
    return say("given.centre", places=[plain(value) for value in centre]) if centre else ""


def _range(result: Document) -> str | Sentence:
    arc = result.get("arc") or {}
    if arc.get("start") is None:
        return ""
    end = float(arc["start"]) + float(arc["extent"])
    return say("given.arc", start=plain(arc["start"]), end=plain(end), extent=plain(arc["extent"]))


def _samples(result: Document) -> str | Sentence:
    counts = [
        say(
            "label.coded",
            code=say("circle.sense", sense=run.get("direction")),
            text=len(run.get("angles") or ()),
        )
        for run in result.get("runs") or ()
    ]
    return say("given.samples", counts=counts) if counts else ""


def _smoothing(result: Document) -> str | Sentence:
    return say("given.smoothing") if result.get("runs") else ""


_BOTH: Final = ("positioning", "circular")
_CIRCULAR: Final = ("circular",)

#: Every item, in the order of the page. Header keys are listed in docs/measurement-files.md.
ITEMS: Final[tuple[ReportItem, ...]] = (
    ReportItem(
        "date",
        say("item.date"),
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
    ReportItem("operator", say("item.operator"), {}, {"operator": "", "by": ""}, kinds=_BOTH),
    ReportItem("place", say("item.place"), {}, {"location": "", "place": ""}, kinds=_BOTH),
    ReportItem(
        "machine",
        say("item.machine"),
        {**_ALL_LISTS, _CIRCLE: "6"},
        {"machine": "", "serial": "", "serial_no": ""},
        kinds=_BOTH,
    ),
    ReportItem(
        "machine_type", say("item.machine_type"), _ALL_LISTS, {"machine_type": ""}, kinds=_BOTH
    ),
    ReportItem("travel", say("item.travel"), _ALL_LISTS, {"travel": ""}),
    ReportItem("axis", say("item.axis"), _ALL_LISTS, given=_axis),
    ReportItem("plane", say("item.plane"), {_CIRCLE: "4.4 d"}, given=_plane, kinds=_CIRCULAR),
    ReportItem(
        "measuring_line",
        say("item.measuring_line"),
        _ALL_LISTS,
        {
            "measuring_line": "",
            "tool_offset": "mm",
            "workpiece_offset": "mm",
            "axis_location": "",
        },
    ),
    ReportItem(
        "other_axes",
        say("item.other_axes"),
        {**_ALL_LISTS, "iso230-2:1988": "3.2", _CIRCLE: "4.4 i"},
        {"other_axes": ""},
        kinds=_BOTH,
    ),
    ReportItem("scale", say("item.scale"), _ALL_LISTS, {"scale": ""}),
    ReportItem(
        "scale_expansion",
        say("item.scale_expansion"),
        _ISO_LIST,
        {"scale_expansion": "µm/(m K)", "alpha_m": "µm/(m K)"},
        _expansion_coefficient,
    ),
    ReportItem(
        "instrument",
        say("item.instrument"),
        {**_ALL_LISTS, "iso230-2:1988": "4.3.4", _CIRCLE: "6"},
        {"instrument": "", "software": "", "software_version": ""},
        kinds=_BOTH,
    ),
    ReportItem(
        "instrument_serial",
        say("item.instrument_serial"),
        _ALL_LISTS,
        {"instrument_serial": "", "ballbar_serial": "", "calibrator_serial": ""},
        kinds=_BOTH,
    ),
    ReportItem(
        "certificate",
        say("item.certificate"),
        {},
        {
            "certificate": "",
            "calibrated_until": "",
            "ballbar_certificate": "",
            "ballbar_last_calibrated": "",
            "calibrated_length_mm": "mm",
        },
        kinds=_BOTH,
    ),
    ReportItem(
        "instrument_position",
        say("item.instrument_position"),
        {**_ALL_LISTS, "iso230-2:1988": "4.3.1", _CIRCLE: "4.4 e"},
        {"instrument_position": "", "centre": ""},
        _set_up,
        kinds=_BOTH,
    ),
    ReportItem(
        "sensor_positions",
        say("item.sensor_positions"),
        {**_ISO_LIST, "iso230-2:1988": "4.3.1"},
        {"sensor_positions": ""},
    ),
    ReportItem(
        "temperatures",
        say("item.temperatures"),
        _ISO_LIST,
        {"t_m": "°C", "run_temperature_c": "°C", "machine_temperature": "°C"},
    ),
    ReportItem(
        "temperatures_instrument",
        say("item.temperatures_instrument"),
        {"iso230-2:2006": "7.1"},
        {"t_d": "°C"},
    ),
    ReportItem(
        "temperatures_circle",
        say("item.temperatures_circle"),
        {_CIRCLE: "4.4 f"},
        {
            "air_temperature": "°C",
            "air_temp": "°C",
            "run_temperature_c": "°C",
            "calibrator_temperature_c": "°C",
            "t_m": "°C",
            "t_d": "°C",
            "machine_temperature": "°C",
        },
        kinds=_CIRCULAR,
    ),
    ReportItem(
        "air_temperature",
        say("item.air_temperature"),
        _ALL_LISTS,
        {"air_temperature": "°C", "air_temp": "°C", "temperature": "°C", "temperatur": "°C"},
    ),
    ReportItem(
        "air_pressure",
        say("item.air_pressure"),
        _ALL_LISTS,
        {"air_pressure": "hPa", "air_press": "hPa"},
    ),
    ReportItem(
        "humidity",
        say("item.humidity"),
        _ALL_LISTS,
        {"humidity": "%", "air_humidity": "%"},
    ),
    ReportItem(
        "expansion",
        say("item.expansion"),
        {"iso230-2:2006": "7.1"},
        {"compensated_for": ""},
        _expansion,
    ),
    ReportItem(
        "compensation_routine",
        say("item.compensation_routine"),
        {**_ISO_LIST, "iso230-2:1988": "4.3.1"},
        {"compensation_routine": ""},
    ),
    ReportItem(
        "compensation",
        say("item.compensation"),
        {**_ALL_LISTS, _CIRCLE: "4.4 h"},
        {"compensation": ""},
        kinds=_BOTH,
    ),
    ReportItem(
        "feed",
        say("item.feed"),
        _ALL_LISTS,
        {
            "feed": "",
            "feed_rate": "",
            "feedrate": "",
            "feed_mm_min": "mm/min",
            "feed_deg_min": "deg/min",
        },
    ),
    ReportItem("dwell", say("item.dwell"), _ALL_LISTS, {"dwell_s": "s", "dwell": ""}),
    ReportItem("targets", say("item.targets"), _ALL_LISTS, given=_targets),
    ReportItem(
        "approaches",
        say("item.approaches"),
        {**_ALL_LISTS, "iso230-2:1988": "4.3.2"},
        given=_approaches,
    ),
    ReportItem("warm_up", say("item.warm_up"), _ALL_LISTS, {"warm_up": ""}, kinds=_BOTH),
    ReportItem(
        "air_shower",
        say("item.air_shower"),
        _ALL_LISTS,
        {"air_shower": "", "oil_shower": "", "coolant": ""},
    ),
    ReportItem(
        "diameter",
        say("item.diameter"),
        {_CIRCLE: "4.4 a"},
        given=_radius,
        kinds=_CIRCULAR,
    ),
    ReportItem(
        "path_feed",
        say("item.path_feed"),
        {_CIRCLE: "4.4 b"},
        {"programmed_feed_mm_min": say("given.programmed_feed")},
        _feed,
        kinds=_CIRCULAR,
    ),
    ReportItem("sense", say("item.sense"), {_CIRCLE: "4.4 c"}, given=_senses, kinds=_CIRCULAR),
    ReportItem(
        "range",
        say("item.range"),
        {_CIRCLE: "4.4 g"},
        given=_range,
        kinds=_CIRCULAR,
    ),
    ReportItem("samples", say("item.samples"), {_CIRCLE: "4.4 g"}, given=_samples, kinds=_CIRCULAR),
    ReportItem(
        "smoothing",
        say("item.smoothing"),
        {_CIRCLE: "4.4 g"},
        {"smoothing": ""},
        _smoothing,
        kinds=_CIRCULAR,
    ),
    ReportItem("standard", say("item.standard"), {}, given=_standard, kinds=_BOTH),
    ReportItem("estimator", say("item.estimator"), {}, given=_estimator),
    ReportItem(
        "contributors",
        say("item.contributors"),
        {"iso230-2:2006": "7.1"},
        given=_contributors,
    ),
)


def items_of(kind: str) -> list[ReportItem]:
    """Return the items of a kind of test (``positioning`` or ``circular``)."""
    return [item for item in ITEMS if kind in item.kinds]
