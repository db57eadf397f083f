"""Labels and fixed sentences of reports. The catalogue of each other language translates all of
them.
"""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "basis.gost27843_2006": "This report gives the information that GOST 27843-2006, 8.1 requires.",
    "basis.iso230_2_1988": (
        "This report gives the information that ISO 230-2:1997, 7.1 requires. The edition of 1988"
        " contains no such list. Where this report names a clause, clauses 3.2 and 4.3 of the"
        " edition of 1988 require the information too."
    ),
    "basis.iso230_2_1997": "This report gives the information that ISO 230-2:1997, 7.1 requires.",
    "basis.iso230_2_2006": "This report gives the information that ISO 230-2:2006, 7.1 requires.",
    "basis.iso230_2_2014": (
        "This report gives the information that ISO 230-2:2006, 7.1 requires. The text of ISO"
        " 230-2:2014 was not available; its clauses are not quoted."
    ),
    "basis.iso230_4_1996": (
        "This report gives the information that ISO 230-4:1996, clauses 4.4 and 6, requires. The"
        " German edition, DIN ISO 230-4:1999, was used."
    ),
    "basis.iso230_4_2005": (
        "This report gives the information that ISO 230-4:1996, clauses 4.4 and 6, requires. The"
        " text of ISO 230-4:2005 was not available; its clauses are not quoted."
    ),
    "basis.vdi3441": (
        "This report gives the information that ISO 230-2:2006, 7.1 requires. The text of"
        " VDI/DGQ 3441 was not available; its clauses are not quoted."
    ),
    "budget.E_VE": "Environmental variation (range)",
    "budget.U_alpha_instrument": "Expansion coefficient of the instrument",
    "budget.U_alpha_machine": "Expansion coefficient of the machine",
    "budget.U_theta_instrument": "Temperature of the instrument",
    "budget.U_theta_machine": "Temperature of the machine",
    "budget.combined": "Combined standard uncertainty",
    "budget.device": "Measuring instrument (certificate)",
    "budget.distribution": (
        "{distribution:choose|normal=normal, k = 2|rectangular=rectangular, √12};"
        " {per:choose|length=over the length|test=per test|reading=per reading}"
    ),
    "budget.expanded": "Expanded uncertainty, k = {k}",
    "budget.misalignment_mm": "Misalignment of the measuring line",
    "budget.note": (
        "Contributors of ISO 230-2:2006, annex A. The sum above is the uncertainty of one reading"
        " at the far end of the travel. It differs from the U of a parameter, because U is"
        " calculated through the definition of the parameter (JCGM 101), from the same"
        " distributions. Every value is from the job. A contributor that the job does not give"
        " counts as 0. No value is taken from the example of the standard."
    ),
    "budget.setup": "Set-up",
    "budget.steel": "{alpha:g} µm/(m K), steel, is assumed",
    "budget.sum": "{fixed:g} µm + {per_m:g} µm/m × {length:g} m",
    "budget.temperature_unknown": "the temperature is unknown: not counted",
    "budget.title": "Budget of the measurement uncertainty, over {length}",
    "cause.kind": (
        "{kind:choose|squareness=Squareness {first}{second}|scale_mismatch=Scale mismatch {first} −"
        " {second}|servo_mismatch=Servo mismatch {first} − {second}|radius_change=Radius change ccw"
        " − cw|backlash=Lost motion {axis}|lateral_play=Lateral play {axis}|reversal_spike=Reversal"
        " spike {axis}|cyclic=Cyclic error {axis}|straightness=Straightness"
        " {axis}|scale_error=Scale error {axis}|backlash_mismatch=Lost motion {first} −"
        " {second}|offset_change=Centre change {axis}, ccw − cw|spiral=Spiral (drift in one"
        " run)|master_slave=Master-slave changeover|vibration=Vibration|stick_slip=Stick-slip"
        " {axis}|lobes_2=Two lobes|lobes_3=Three lobes|position_loop=Lag of the position loop"
        " {axis}|positional_tolerance=Positional tolerance}"
    ),
    "cause.note": (
        "{kind:choose|reversal_spike=raw peak {peak} µm"
        "|cyclic=period {period:.4g} mm{phase:if|, phase {phase}°|}"
        "|vibration={frequency:.4g} Hz}"
    ),
    "cause.noted": "{cause} ({note})",
    "cause.part": (
        "at {axis}{part:choose|at_positive=+|at_negative=−|at_positive_ccw=+ ccw|at_positive_cw=+"
        " cw|at_negative_ccw=− ccw|at_negative_cw=− cw}"
    ),
    "cause.whole": "{cause} {part}",
    "certificate.name": (
        ""
        "{key:choose|primal=primal|stationarity=stationarity|dual=dual|complementarity=complementarity|rounding=rounding|objective=objective|lower_bound=lower"
        " bound|recomputed=recomputed|magnification=magnification|={name}}"
    ),
    "changes.summary": (
        "{count} entries change; {untouched} lines of the control's files stay as they are. The"
        " values are those of the files, in the control's own units.{more:if| {more} more changes"
        " are in `changes.csv`.|}"
    ),
    "chart.angle": "Angle in deg",
    "chart.bar": "Bar: before {before}, now {now}, limit {limit}",
    "chart.correction": "Correction that the control adds to the command",
    "chart.described": (
        "{what:choose|deviations=deviations of axis {name}"
        "|marked=deviations of axis {name}, rings at the extremes of the parameters"
        "|reversal=reversal of axis"
        " {name}|residual=residual of circular test {name}|correction=correction of axis"
        " {name}|comparison=axis {name}, deviations side by side|estimate=estimated error of axis"
        " {name}|circle=circular test {name}}"
    ),
    "chart.estimate": "estimate ({sign})",
    "chart.estimated": "Estimated deviation with ± 2 standard deviations",
    "chart.expected": "expected mean ({sign})",
    "chart.legend": "(+) and (−): approach in the positive and in the negative direction",
    "chart.line": "{parts:join|   }{unit:if| {unit}|}",
    "chart.mean": "mean ({sign})",
    "chart.measured": "measured mean ({sign})",
    "chart.position": "Position in {unit}",
    "chart.quantiles": "{symbol} {median} ({p05} to {p95})",
    "chart.quantity": (
        "{quantity:choose|deviation=Deviation|reversal=Reversal B|correction=Correction} in {unit}"
    ),
    "chart.radius": "Radius in µm",
    "chart.readings": "single readings ({sign})",
    "chart.residual": "Measured minus fit, {sense}",
    "chart.spread": "mean ± {coverage:g} s ({sign})",
    "chart.table": "table ({sign})",
    "chart.table_both": "table (+ and −)",
    "chart.wanted": "wanted ({sign})",
    "decision.accept": "✓ accept",
    "decision.no_limit": "no limit",
    "decision.reject": "✗ reject",
    "decision.undecided": "? undecided",
    "fact.address": "control address",
    "fact.kind": "kind",
    "fact.quantum": "resolution of the table",
    "fact.unit": "unit of deviations",
    "head.after": "After",
    "head.approach": "Approach",
    "head.assumed_value": "Assumed value",
    "head.axis": "Axis",
    "head.before": "Before",
    "head.cause": "Cause",
    "head.causes": "Causes",
    "head.clause": "Clause",
    "head.contribution": "Contribution u",
    "head.correction": "Correction{sign:if| {sign}}",
    "head.coverage_factor": "Coverage factor k",
    "head.decision": "Decision",
    "head.distribution": "Distribution",
    "head.entry": "Entry",
    "head.evidence": "Evidence",
    "head.expanded_uncertainty": "Expanded uncertainty U",
    "head.extreme": "Extreme",
    "head.fact": "Fact",
    "head.file": "File",
    "head.item": "Item",
    "head.limit": "Limit",
    "head.limit_on": "Limit on",
    "head.loading": "Loading",
    "head.mean": "mean {sign}",
    "head.new": "New",
    "head.old": "Old",
    "head.parameter": "Parameter",
    "head.period": "Period",
    "head.position": "Position",
    "head.predicted": "Predicted",
    "head.predicted_new": "Predicted, new targets",
    "head.predicted_same": "Predicted, same targets",
    "head.probability": "Probability",
    "head.quantity": "Quantity",
    "head.remark": "Remark",
    "head.residual": "Residual",
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
    "item.plane": "Axes of the circular path",
    "item.range": "Range of the data, start and end",
    "item.samples": "Number of samples",
    "item.scale": "Type of the machine's scale",
    "item.scale_expansion": "Expansion coefficient of the scale",
    "item.sense": "Sense of contouring",
    "item.sensor_positions": "Locations of the temperature sensors",
    "item.smoothing": "Smoothing",
    "item.standard": "Standard and edition",
    "item.targets": "Target positions",
    "item.temperatures": "Temperature of the machine's scale or workpiece, start and end",
    "item.temperatures_circle": "Temperatures of environment, instrument and machine",
    "item.temperatures_instrument": "Temperature of the instrument's sensors, start and end",
    "item.travel": "Travel of the axis",
    "item.warm_up": "Warm-up before the test",
    "label.after": "after",
    "label.before": "before",
    "label.circular_test": "circular test",
    "label.coded": "{code}: {text}",
    "label.conformity": "Statement of conformity: {statement}",
    "label.control": "control",
    "label.decision_rule": "Decision rule: {rule}",
    "label.extreme_at": "{symbol} at {place} {unit}",
    "label.kind": "{kind}",
    "label.machine": "{key:choose|name=name|serial=serial|type=type|={key}}",
    "label.median": "median",
    "label.not_stated": "not stated",
    "label.of_the_prediction": "of the prediction",
    "label.plus_minus": "± {U}",
    "label.range": "{low} to {high}",
    "label.test_sentence": (
        "{standard}, {cycle} cycle, {targets} target positions, traverses:"
        " {counts:if|{counts}|none}, limits drawn at ± {coverage} s.{extremes:if| Extremes:"
        " {extremes:join|; }.}{uncertainty:if|| No measurement uncertainty: no contributors were"
        " given.}"
    ),
    "label.test_title": (
        "Axis {axis:if|{axis}|not named}, {name:if|{name}|test}{label:if|, {label}}"
    ),
    "label.traverses": "{count} in {sign}",
    "label.unconfirmed": "! unconfirmed",
    "label.value_error": "{value} ± {error}",
    "label.with_range": "{unit}; median, 5–95 %",
    "label.with_uncertainty": "{unit}; ± U, k = {k}",
    "label.with_unit": "{value} {unit}",
    "mark.loading": (
        "{verdict:choose|loaded=✓ loaded|undecided=? undecided|measurement=? fault of"
        " measurement|not_active=✗ not active|inverted=✗ inverted|scaled=✗ scaled|shifted=✗"
        " shifted|mirrored=✗ mirrored|wrong_axis=✗ wrong axis|increment=✗ only the change"
        " loaded|on_top=✗ old plus new table|state=✗ old table not active|one_direction=✗ active"
        " in one direction|backlash=✗ backlash value wrong|partial=✗ partly active|thermal=✗"
        " thermal slope|read_back=✗ differs from the plan|=✗ {verdict}}"
    ),
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
    "rule.band": "{symbol} {U:if|{U} {unit}|not stated}",
    "rule.guarded": (
        "Guarded decision (ISO 14253-1): accepted when the 95th percentile of the predicted tests"
        " plus U lies within the limit, rejected when their 5th percentile minus U lies beyond it;"
        " U (k = 2) of the next test, which includes the uncertainty that the first test has"
        " brought into the table: {bands}."
    ),
    "rule.guarded_after": (
        "Guarded decision (ISO 14253-1): accepted when the value plus U lies within the limit,"
        " rejected when the value minus U lies beyond it; U (k = 2) of the test after loading:"
        " {bands}."
    ),
    "rule.simple": (
        "Accepted when the 95th percentile of the predicted tests lies within the limit, rejected"
        " when their 5th percentile lies beyond it; the measurement uncertainty is not counted: no"
        " guard bands (ISO 14253-1)."
    ),
    "rule.simple_after": (
        "Accepted when the measured value lies within the limit, rejected when it lies beyond it;"
        " the measurement uncertainty is not counted: no guard bands (ISO 14253-1)."
    ),
    "severity.error": "✗ error",
    "severity.info": "info",
    "severity.warning": "! warning",
}
