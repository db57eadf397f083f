"""Labels and fixed sentences of reports; each further language has all of them."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "basis.gost27843_2006": "Items: GOST 27843-2006, 8.1.",
    "basis.iso230_2_1988": (
        "Items: ISO 230-2:1997, 7.1. The edition of 1988 has no list; its clauses 3.2 and 4.3 "
        "ask for the items that have a clause here."
    ),
    "basis.iso230_2_1997": "Items: ISO 230-2:1997, 7.1.",
    "basis.iso230_2_2006": "Items: ISO 230-2:2006, 7.1.",
    "basis.iso230_2_2014": (
        "Items: ISO 230-2:2006, 7.1. The text of ISO 230-2:2014 was not available; its clauses "
        "are not quoted."
    ),
    "basis.iso230_4_1996": "Items: ISO 230-4:1996, clauses 4.4 and 6 (read as DIN ISO 230-4:1999).",
    "basis.iso230_4_2005": (
        "Items: ISO 230-4:1996, clauses 4.4 and 6. The text of ISO 230-4:2005 was not "
        "available; its clauses are not quoted."
    ),
    "basis.vdi3441": (
        "Items: ISO 230-2:2006, 7.1. The text of VDI/DGQ 3441 was not available; its clauses "
        "are not quoted."
    ),
    "budget.E_VE": "Environmental variation (range)",
    "budget.U_alpha_instrument": "Expansion coefficient of the instrument",
    "budget.U_alpha_machine": "Expansion coefficient of the machine",
    "budget.U_theta_instrument": "Temperature of the instrument",
    "budget.U_theta_machine": "Temperature of the machine",
    "budget.combined": "Combined standard uncertainty",
    "budget.device": "Measuring instrument (certificate)",
    "budget.distribution": (
        "{distribution:choose|normal=normal, k = 2|rectangular=rectangular, √12}; "
        "{per:choose|length=over the length|test=per test|reading=per reading}"
    ),
    "budget.expanded": "Expanded uncertainty, k = {k}",
    "budget.misalignment_mm": "Misalignment of the measuring line",
    "budget.note": (
        "Contributors of ISO 230-2:2006, annex A. The sum is that of one reading at the far end"
        " of the travel. U of each parameter (above) is not this sum: the same distributions "
        "are propagated through the definition of the parameter (JCGM 101). Every value is the "
        "job's, or counts as 0 where the job gives none; no value is taken from the worked "
        "example of the standard."
    ),
    "budget.setup": "Set-up",
    "budget.title": "Budget of the measurement uncertainty, over {length}",
    "given.approaches": "{counts}; {cycle} cycle",
    "given.arc": "from {start}° to {end}°, {extent}°",
    "given.at_end": "{text} {end:choose|_start=at the start|_end=at the end}",
    "given.axis": "{axis}, {kind}",
    "given.budget": "see the budget of the uncertainty",
    "given.centre": "centre at {places:join|; } mm",
    "given.coefficient": "{value} µm/(m K)",
    "given.estimator": (
        "s: {spread:choose|std=standard deviation, n − 1|range=range of the readings}; limits "
        "at ± {coverage} s; no smoothing"
    ),
    "given.expansion": (
        "applied by compwright: readings reduced to 20 °C, {what} {alpha_m} µm/(m K) at {T_m} "
        "°C, instrument {alpha_d} µm/(m K) at {T_d} °C, fixed point {x_fix} mm"
    ),
    "given.listed": "{items}",
    "given.of_tests": "{names}: {statement}",
    "given.radius": "radius {radius} mm",
    "given.samples": "{counts} samples",
    "given.sense": "{sense:choose|ccw=counter-clockwise|cw=clockwise}",
    "given.smoothing": "none by compwright: every sample counts",
    "given.statements": "{statements:join|; }",
    "given.targets": "{count} from {first} to {last} {unit}; listed in annex A",
    "head.approach": "Approach",
    "head.clause": "Clause",
    "head.contribution": "Contribution u",
    "head.coverage_factor": "Coverage factor k",
    "head.distribution": "Distribution",
    "head.expanded_uncertainty": "Expanded uncertainty U",
    "head.extreme": "Extreme",
    "head.file": "File",
    "head.item": "Item",
    "head.mean": "mean {sign}",
    "head.parameter": "Parameter",
    "head.position": "Position",
    "head.remark": "Remark",
    "head.sensitivity": "Sensitivity",
    "head.source": "Source",
    "head.standard": "Standard",
    "head.stated": "Stated",
    "head.test": "Test",
    "head.unit": "Unit",
    "head.value": "Value",
    "head.value_given": "Value given",
    "item.air_pressure": "Air pressure, start and end",
    "item.air_shower": "Air or oil shower, coolant",
    "item.air_temperature": "Air temperature, start and end",
    "item.approaches": "Number of approaches, test cycle",
    "item.axis": "Axis under test",
    "item.certificate": "Measuring instrument: calibration certificate",
    "item.compensation": "Software compensation of the control: on or off",
    "item.compensation_routine": "Type of the routine for thermal compensation",
    "item.contributors": "Contributors to the measurement uncertainty",
    "item.date": "Date and time of the test",
    "item.diameter": "Diameter or radius of the nominal path",
    "item.dwell": "Dwell time at each target position",
    "item.estimator": "Estimator of s, smoothing",
    "item.expansion": "Correction for thermal expansion (NDE)",
    "item.feed": "Feed between target positions",
    "item.humidity": "Humidity of the air, start and end",
    "item.instrument": "Measuring instrument: maker, type",
    "item.instrument_position": "Position of the measuring instrument",
    "item.instrument_serial": "Measuring instrument: serial numbers of the components",
    "item.machine": "Machine: name and serial number",
    "item.machine_type": "Machine: type",
    "item.measuring_line": "Measuring line: location, offsets to tool and workpiece reference",
    "item.operator": "Operator",
    "item.other_axes": "Positions of the axes not under test",
    "item.path_feed": "Contouring feed",
    "item.place": "Place of the test",
    "item.plane": "Axes that make the path",
    "item.range": "Range of the data, start and end",
    "item.samples": "Number of samples",
    "item.scale": "Type of the machine's scale",
    "item.scale_expansion": "Expansion coefficient of the scale",
    "item.sense": "Sense of contouring",
    "item.sensor_positions": "Places of the temperature sensors",
    "item.smoothing": "Smoothing",
    "item.standard": "Standard and edition",
    "item.targets": "Target positions",
    "item.temperatures": "Temperature of the machine's scale or workpiece, start and end",
    "item.temperatures_circle": "Temperatures of environment, instrument and machine",
    "item.temperatures_instrument": "Temperature of the instrument's sensors, start and end",
    "item.travel": "Travel of the axis",
    "item.warm_up": "Warm-up before the test",
    "label.extreme_at": "{symbol} at {place} {unit}",
    "label.not_stated": "not stated",
    "label.plus_minus": "± {U}",
    "label.test_sentence": (
        "{standard}, {cycle} cycle, {targets} target positions, traverses: "
        "{counts:if|{counts}|none}, limits drawn at ± {coverage} s.{extremes:if| Extremes: "
        "{extremes:join|; }.}{uncertainty:if|| No measurement uncertainty: no contributors were"
        " given.}"
    ),
    "label.test_title": "Axis {axis}, {name:if|{name}|test}{label:if|, {label}}",
    "label.traverses": "{count} in {sign}",
    "label.with_uncertainty": "{unit}; ± U, k = {k}",
    "label.with_unit": "{value} {unit}",
    "parameter.A": "{term:if|{term}|Bidirectional accuracy}",
    "parameter.A_negative": "{term:if|{term}|Accuracy, approach −}",
    "parameter.A_positive": "{term:if|{term}|Accuracy, approach +}",
    "parameter.B": "{term:if|{term}|Reversal value}",
    "parameter.B_mean": "{term:if|{term}|Mean reversal value}",
    "parameter.E": "{term:if|{term}|Bidirectional systematic deviation}",
    "parameter.E_negative": "{term:if|{term}|Systematic deviation, approach −}",
    "parameter.E_positive": "{term:if|{term}|Systematic deviation, approach +}",
    "parameter.M": "{term:if|{term}|Range of the mean deviation}",
    "parameter.P": "{term:if|{term}|Positional uncertainty}",
    "parameter.Pa": "{term:if|{term}|Positional deviation}",
    "parameter.Ps_max": "{term:if|{term}|Largest positional scatter}",
    "parameter.Ps_mean": "{term:if|{term}|Mean positional scatter}",
    "parameter.R": "{term:if|{term}|Bidirectional repeatability}",
    "parameter.R_negative": "{term:if|{term}|Repeatability, approach −}",
    "parameter.R_positive": "{term:if|{term}|Repeatability, approach +}",
    "parameter.U_max": "{term:if|{term}|Largest reversal error}",
    "parameter.U_mean": "{term:if|{term}|Mean reversal error}",
    "report.accreditation": (
        "This is a test report, not a calibration certificate of an accredited laboratory. The "
        "traceability of the values rests on the calibration certificates of the measuring "
        "instruments that are named."
    ),
    "report.acknowledged": "Acknowledged doubts",
    "report.annex_a": "Annex A: target positions and raw readings",
    "report.annex_b": "Annex B: provenance",
    "report.axis": "Axis {axis}{name:if|, {name}}",
    "report.both": "both",
    "report.circle": "Circle {plane}{name:if|, {name}}",
    "report.conditions": "Conditions of the test, {standard}",
    "report.conform": "The machine conforms to every limit of the table above.",
    "report.conformity_open": (
        "Conformity is not stated: at least one decision, or what it rests on, is open."
    ),
    "report.customer": "Customer",
    "report.date": "Date of the test",
    "report.extreme": (
        "{end:choose|highest=highest|lowest=lowest} mean"
        "{what:choose|A= {end:choose|highest=+|lowest=−} {coverage} s|E=|M= ±}"
    ),
    "report.extremes": "Extremes: rings in the figure",
    "report.findings": "Findings",
    "report.footer": "Report {number}",
    "report.in_english": (
        "Findings, the words in figures and the pages of circular tests are in English."
    ),
    "report.in_file": "In the file: {name}",
    "report.logo": "Logo",
    "report.no_limits": (
        "No limit was given. This report states values; it does not state conformity."
    ),
    "report.no_number": "Report without a number",
    "report.not_conform": "The machine does not conform to every limit of the table above.",
    "report.number": "Report number",
    "report.operator": "Operator",
    "report.page": "Page",
    "report.page_of": "of",
    "report.parameters": "Parameters",
    "report.place": "Place",
    "report.provenance": (
        "Evaluated by compwright {version}.{command:if| This command repeats the report:}"
    ),
    "report.readings": "Single readings",
    "report.readings_measured": "Single readings, as measured",
    "report.readings_reduced": "Single readings, reduced to 20 °C",
    "report.results": "Results",
    "report.see_tests": "see the pages of the tests",
    "report.sign_checked": "Checked by",
    "report.sign_measured": "Measured by",
    "report.sign_place": "Place, date",
    "report.signs": (
        "Deviation: measured minus target. Approach +: in the positive machine direction. B is "
        "the mean at + minus the mean at −."
    ),
    "report.statistics": "Means, standard deviations and repeatability at {count} target positions",
    "report.title": "Test report{tests:plural|| of {tests} tests}",
    "report.unread": "Files that were not evaluated",
    "severity.error": "✗ error",
    "severity.info": "info",
    "severity.warning": "! warning",
}
