"""Labels and fixed sentences of reports; each further language has all of them."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "basis.gost27843_2006": "Items: GOST 27843-2006, 8.1.",
    "basis.iso230_2_1988": (
        "Items: ISO 230-2:1997, 7.1. The edition of 1988 has no list; its clauses 3.2 and 4.3 ask"
        " for the items that have a clause here."
    ),
    "basis.iso230_2_1997": "Items: ISO 230-2:1997, 7.1.",
    "basis.iso230_2_2006": "Items: ISO 230-2:2006, 7.1.",
    "basis.iso230_2_2014": (
        "Items: ISO 230-2:2006, 7.1. The text of ISO 230-2:2014 was not available; its clauses are"
        " not quoted."
    ),
    "basis.iso230_4_1996": "Items: ISO 230-4:1996, clauses 4.4 and 6 (read as DIN ISO 230-4:1999).",
    "basis.iso230_4_2005": (
        "Items: ISO 230-4:1996, clauses 4.4 and 6. The text of ISO 230-4:2005 was not available;"
        " its clauses are not quoted."
    ),
    "basis.vdi3441": (
        "Items: ISO 230-2:2006, 7.1. The text of VDI/DGQ 3441 was not available; its clauses are"
        " not quoted."
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
        "Contributors of ISO 230-2:2006, annex A. The sum is that of one reading at the far end of"
        " the travel. U of each parameter (above) is not this sum: the same distributions are"
        " propagated through the definition of the parameter (JCGM 101). Every value is the job's,"
        " or counts as 0 where the job gives none; no value is taken from the worked example of the"
        " standard."
    ),
    "budget.setup": "Set-up",
    "budget.title": "Budget of the measurement uncertainty, over {length}",
    "cause.kind": (
        "{kind:choose|squareness=Squareness {first}{second}|scale_mismatch=Scale mismatch {first} −"
        " {second}|servo_mismatch=Servo mismatch {first} − {second}|radius_change=Radius change ccw"
        " − cw|backlash=Lost motion {axis}|lateral_play=Lateral play {axis}|reversal_spike=Reversal"
        " spike {axis}|cyclic=Cyclic error {axis}|straightness=Straightness"
        " {axis}|scale_error=Scale error {axis}|backlash_mismatch=Lost motion {first} −"
        " {second}|offset_change=Centre change {axis}, ccw − cw|spiral=Spiral (drift during a"
        " run)|master_slave=Master-slave changeover|vibration=Vibration|stick_slip=Stick-slip"
        " {axis}|lobes_2=Two lobes|lobes_3=Three lobes|positional_tolerance=Positional tolerance}"
    ),
    "cause.part": (
        "at {axis}{part:choose|at_positive=+|at_negative=−|at_positive_ccw=+ ccw|at_positive_cw=+"
        " cw|at_negative_ccw=− ccw|at_negative_cw=− cw}"
    ),
    "cause.whole": "{cause} {part}",
    "changes.summary": (
        "{count} entries change; {untouched} lines of the control's files stay as they are. The"
        " values are those of the files, in the control's own units.{more:if| {more} more changes"
        " are in `changes.csv`.|}"
    ),
    "chart.angle": "Angle in deg",
    "chart.correction": "Correction that the control adds to the command",
    "chart.described": (
        "{what:choose|deviations=deviations of axis {name}|reversal=reversal of axis"
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
    "circle.about": "{centre:choose|set_up= (set-up centre)|own= (own centre)}",
    "circle.agreement": "{how:choose|agrees=agrees|differs=differs|not_valid=not valid}",
    "circle.cause": "{cause}  {value} {unit}",
    "circle.centre": (
        "{name:choose|common=common least-squares centre|set-up=set-up centre|ccw=least-squares"
        " centre of ccw|cw=least-squares centre of cw}: {first} {x}, {second} {y} µm{H:if|; H {H}"
        " µm|}"
    ),
    "circle.compared": "Comparison",
    "circle.comparison": (
        "Software of the instrument: agrees: within two standard errors of our value. Not valid, in"
        " brackets: the software itself says so. Differs: its model is not published; ours fits"
        " every cause at once, with step and spike of each reversal point of their own."
    ),
    "circle.detail": "– {part}",
    "circle.effect": "Effect on the radius",
    "circle.effects": "Effect, peak to peak, in µm; whiskers 95 %",
    "circle.fit": "fit: what all causes together make of each run",
    "circle.job": (
        "These lines of a job put into tables and backlash compensation what they can correct. Make"
        " the job with `compwright new --from FILE... --format ID --out job.yaml` from the files of"
        " the control, name a positioning test of each axis in it (its slope corrects the scale),"
        " add the lines{file:if| with the file of each direction for FILE|}, then `compwright run"
        " job.yaml`."
    ),
    "circle.least_squares": "least-squares circle, {base} µm from nominal",
    "circle.magnified": "{setting}\nMagnification {magnification} : 1, rings in µm",
    "circle.next": "What to do next",
    "circle.no_table": "No table corrects these causes. Repeat the test after the work.",
    "circle.nominal": "nominal circle",
    "circle.parameter": (
        "{name:choose|G=Circular deviation, minimum zone|G_lsc=by the least-squares"
        " circle|F_max=Radial deviation, largest|F_min=Radial deviation,"
        " smallest|F_max_lsc=largest, least-squares centre|F_min_lsc=smallest, least-squares"
        " centre|H=Circular hysteresis|D=Mean radial deviation}"
    ),
    "circle.ranked": "Causes, the largest effect first",
    "circle.run": "{sense}: G {G}, F{centre} {highest} / {lowest} µm",
    "circle.sense": "{sense:choose|ccw=ccw|cw=cw|both=both}",
    "circle.setting": (
        "R {radius} mm{feed:if|, {feed:.5g} mm/min|}{extent:if|, arc {extent:.4g}° from"
        " {start:.4g}°|}"
    ),
    "circle.share": "Share",
    "circle.shares": "Causes, share of all\npale: less than twice its standard error",
    "circle.software": "Software of the instrument",
    "circle.start": "start of {sense}",
    "circle.step": (
        "{kind:choose|squareness=Mechanic: check level and alignment of the guideways. Table: a job"
        " with `apply` corrects it where the control can.|scale_mismatch=Check the temperature of"
        " both axes. Table: measure {first} and {second} with a laser and run a job with both"
        " tests.|servo_mismatch=Servo: give {first} and {second} the same position loop gain (Kv)"
        " and feedforward.|radius_change=Measurement: repeat both directions with the same feed;"
        " check the seat of the bar.|backlash=Mechanic: check nut, support bearing and coupling of"
        " the {axis} screw. Then correct the control's backlash compensation of"
        " {axis}.|lateral_play=Mechanic: check preload and gibs of the {axis}"
        " guideway.|reversal_spike=Servo: adjust the friction compensation of {axis} at reversal."
        " Mechanic: check its lubrication and wipers.|cyclic=Mechanic: check screw, its bearing and"
        " the encoder mount of {axis}. Table: at least three points in each period correct what is"
        " left.|straightness=Mechanic: check the alignment of the {axis} guideway. Table: a table"
        " between the axes corrects it where the control has one"
        " (cross).|offset_change=Measurement: check the centre mount and the magnet cups; then"
        " repeat.|spiral=Measurement: let machine and bar reach a stable temperature; then"
        " repeat.|vibration=Look for the source by its frequency: pump, fan, motor. Servo: lower"
        " the gain for a trial.|stick_slip=Mechanic: check lubrication, wipers and preload of the"
        " {axis} guideway.|master_slave=Servo: check the interpolation parameters of {first} and"
        " {second}.}"
    ),
    "circle.symbol": (
        "{letter}{sense:if| {sense:choose|ccw=ccw|cw=cw|bidirectional=both}|}{centre:if|,"
        " {centre:choose|G=least-squares circle|F=least-squares centre}|}"
    ),
    "circle.to_do": "{cause} ({share:.0f} % of all effects). {step}",
    "circle.unexplained": "What the causes below leave unexplained: {rms} µm rms.",
    "circle.value_error": "Value ± standard error",
    "circle.zone": (
        "minimum zone{sense:choose|both= of both|ccw=, ccw|cw=, cw}: G {G} µm{D:if|; D {D} µm|}"
    ),
    "decision.accept": "✓ accept",
    "decision.no_limit": "no limit",
    "decision.reject": "✗ reject",
    "decision.undecided": "? undecided",
    "fact.address": "control address",
    "fact.kind": "kind",
    "fact.quantum": "resolution of the table",
    "fact.unit": "unit of deviations",
    "given.approaches": "{counts}; {cycle} cycle",
    "given.arc": "from {start}° to {end}°, {extent}°",
    "given.at_end": "{text} {end:choose|_start=at the start|_end=at the end}",
    "given.axis": "{axis}, {kind}",
    "given.budget": "see the budget of the uncertainty",
    "given.centre": "centre at {places:join|; } mm",
    "given.coefficient": "{value} µm/(m K)",
    "given.compensation": (
        "{how:choose|off=off; the control held|active=on, as active in|stored=on, as stored in}"
        " {files} (job, states.{state})"
    ),
    "given.compensation_loaded": (
        "on, as loaded after the run of this job; what the test shows of it: see Loading"
    ),
    "given.compensation_none": "off: nothing was active in the control (job, states.{state})",
    "given.estimator": (
        "s: {spread:choose|std=standard deviation, n − 1|range=range of the readings}; limits at ±"
        " {coverage} s; no smoothing"
    ),
    "given.expansion": (
        "applied by compwright: readings reduced to 20 °C, {what} {alpha_m} µm/(m K) at {T_m} °C,"
        " instrument {alpha_d} µm/(m K) at {T_d} °C, fixed point {x_fix} mm"
    ),
    "given.list": "{others:if|{others} and |}{last:if|{last}|none}",
    "given.listed": "{items}",
    "given.of_tests": "{names}: {statement}",
    "given.programmed_feed": "mm/min programmed",
    "given.radius": "radius {radius} mm",
    "given.samples": "{counts} samples",
    "given.sense": "{sense:choose|ccw=counter-clockwise|cw=clockwise}",
    "given.sentences": "{sentences:join| }",
    "given.smoothing": "none by compwright: every sample counts",
    "given.statements": "{statements:join|; }",
    "given.targets": "{count} from {first} to {last} {unit}; listed in annex A",
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
    "limits.all": "all together",
    "limits.cause": (
        "{cause:choose|noise=readings scatter: the same position does not come back the same"
        " (repeatability)|single outliers=single outliers|shifts between traverses=whole traverses"
        " that are shifted|drift=drift: the axis changes while it is measured|temperature within"
        " its uncertainty=temperature: a slope within what the job declares uncertain|error that"
        " the test leaves open=error that the test did not show: between targets, and hidden in the"
        " scatter|steps that the control never applies=steps of the correction (reversal) that the"
        " control never applies, because of its acceleration and servo period|no table is"
        " written=error that was measured, and that no table takes away|spacing too wide for the"
        " period=periodic error: the points are too far apart for it|spacing of the points=what"
        " bends between the points of the table|number of points=what bends between the points: the"
        " control has too few of them|one table for both directions=reversal that changes along the"
        " travel: one table and one reversal value cannot hold it|no backlash value=reversal: the"
        " control has no value for it|quantum=resolution of the table's values|value range=largest"
        " value that the control takes|backlash range=largest reversal value that the control"
        " takes|largest increment=largest step from point to point that the control takes|a"
        " straight line instead of a table=what bends: the control holds a straight line, no"
        " table|={cause}}"
    ),
    "limits.left": "Left by the control",
    "limits.note": (
        "Each bar: by how much {parameter} would be smaller without this cause alone, from the same"
        " draws. The parts do not add up, because {parameter} is a range: what two causes do at"
        " different places counts once."
    ),
    "limits.part": "Part of {parameter}",
    "limits.summary": (
        "{parameter} at new targets: {then} {unit} expected, {before} {unit} with what is in the"
        " control now. Scatter alone, without any error of the axis, would give {least} {unit}: no"
        " table goes below that."
    ),
    "mark.loading": (
        "{verdict:choose|loaded=✓ loaded|undecided=? undecided|measurement=? fault of"
        " measurement|not_active=✗ not active|inverted=✗ inverted|scaled=✗ scaled|shifted=✗"
        " shifted|mirrored=✗ mirrored|wrong_axis=✗ wrong axis|increment=✗ increment|on_top=✗ on"
        " top|state=✗ state|one_direction=✗ one direction|backlash=✗ backlash|partial=✗"
        " partial|thermal=✗ thermal|=✗ {verdict}}"
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
    "period.alike": "These targets cannot tell apart: {periods} {unit}.",
    "period.caption": (
        "How much more likely the readings are with an error that repeats at each period than with"
        " none, before it is counted how usual the period is. Dashed: periods that count."
    ),
    "period.described": "odds of each period",
    "period.none": "None is known, and none was found.",
    "period.over": "period / {unit}",
    "period.source": (
        "{source:choose|job=given by the job|found=found in the readings|files=given by the"
        " control's files|={source}}"
    ),
    "report.accreditation": (
        "This is a test report, not a calibration certificate of an accredited laboratory. The"
        " traceability of the values rests on the calibration certificates of the measuring"
        " instruments that are named."
    ),
    "report.acknowledged": "Acknowledged doubts",
    "report.annex_a": "Annex A: target positions and raw readings",
    "report.annex_b": "Annex B: provenance",
    "report.axis": "Axis {axis:if|{axis}|not named}{name:if|, {name}}",
    "report.both": "both",
    "report.circle": "Circle {plane}{name:if|, {name}}",
    "report.compensation": "Compensation of {axes:if|{axes}|{count} axes}",
    "report.conditions": "Conditions of the test, {standard}",
    "report.conform": "The machine conforms to every limit of the table above.",
    "report.conformity_open": (
        "Conformity is not stated: at least one decision, or what it rests on, is open."
    ),
    "report.customer": "Customer",
    "report.date": "Date of the test",
    "report.extreme": (
        "{end:choose|highest=highest|lowest=lowest} mean{what:choose|A="
        " {end:choose|highest=+|lowest=−} {coverage} s|E=|M= ±}"
    ),
    "report.extremes": "Extremes: rings in the figure",
    "report.findings": "Findings",
    "report.footer": "Report {number}",
    "report.in_english": "Names and texts of the job and of the files are as they were given.",
    "report.in_file": "In the file: {name}",
    "report.logo": "Logo",
    "report.no_limits": (
        "No limit was given. This report states values; it does not state conformity."
    ),
    "report.no_number": "Report without a number",
    "report.not_conform": "The machine does not conform to every limit of the table above.",
    "report.number": "Report number",
    "report.open_sections": "Sections that stand open are printed.",
    "report.operator": "Operator",
    "report.other_findings": "Other findings",
    "report.page": "Page",
    "report.page_of": "of",
    "report.parameters": "Parameters",
    "report.place": "Place",
    "report.provenance": (
        "Evaluated by compwright {version}.{command:if| This command repeats the report:}"
    ),
    "report.readings": "Single readings",
    "report.readings_air": "Single readings, the effect of the air on the light removed",
    "report.readings_measured": "Single readings, as measured",
    "report.readings_reduced": "Single readings, reduced to 20 °C",
    "report.results": "Results",
    "report.see_tests": "see the pages of the tests",
    "report.sign_checked": "Checked by",
    "report.sign_measured": "Measured by",
    "report.sign_place": "Place, date",
    "report.signs": (
        "Deviation: measured minus target. Approach +: in the positive machine direction. B is the"
        " mean at + minus the mean at −."
    ),
    "report.statistics": "Means, standard deviations and repeatability at {count} target positions",
    "report.test": "Test {name}",
    "report.title": "Test report{tests:plural|| of {tests} tests}",
    "report.unread": "Files that were not evaluated",
    "report.verification": "Verification of {axes}",
    "rule.band": "{symbol} {U:if|{U} {unit}|not stated}",
    "rule.guarded": (
        "Guarded decision (ISO 14253-1): accepted when the 95 % value plus U lies within the limit,"
        " rejected when the 5 % value less U lies beyond it; U (k = 2) of the coming test, with"
        " what the first one has put into the table: {bands}."
    ),
    "rule.guarded_after": (
        "Guarded decision (ISO 14253-1): accepted when the value plus U lies within the limit,"
        " rejected when the value less U lies beyond it; U (k = 2) of the test after loading:"
        " {bands}."
    ),
    "rule.simple": (
        "Accepted when the 95 % value lies within the limit, rejected when the 5 % value lies"
        " beyond it; the measurement uncertainty is not counted: no guard bands (ISO 14253-1)."
    ),
    "rule.simple_after": (
        "Accepted when the measured value lies within the limit, rejected when it lies beyond it;"
        " the measurement uncertainty is not counted: no guard bands (ISO 14253-1)."
    ),
    "run.annex_c": "Annex C: compensation",
    "run.assumed": "Assumed facts",
    "run.assumed_note": (
        "Not in the files that were given; the results hold only where these are true."
    ),
    "run.axis_table": "Axis {axis}: table",
    "run.bends": "{input} bends {output}",
    "run.bidirectional": "One curve for each direction of approach",
    "run.card": "Commissioning card",
    "run.certificate": "Certificate of the fit",
    "run.changes": "Old to new",
    "run.check_first": "Undecided: check first what is named above",
    "run.circle_worse": "Undecided: a circle is predicted to get worse",
    "run.comparison": "Before and predicted",
    "run.comparison_note": (
        "Before and, on the same scale, what a test at the same targets is expected to show."
    ),
    "run.compensation": "Compensation",
    "run.correction": "Correction: what the control adds to the command.",
    "run.cross": "Cross tables",
    "run.done": (
        "{tests:plural|1 test|{tests} tests} of {count:plural|axis|axes} {axes}"
        " {tests:plural|was|were} evaluated to {standards:if|{standards:and}|no standard}. The"
        " error was estimated over the travel{tables:if|; the best table that"
        " {control:if|{control}|the control} can hold was fitted, written in the control's own"
        " form, and read back from the files to predict the next test. Nothing has been loaded yet:"
        " load the table with the commissioning card, measure again, and run compwright verify.|."
        " No table was written: predicted is the next test without one.}"
    ),
    "run.estimate": "Axis {axis}: estimated error",
    "run.estimate_note": (
        "What the table is meant to remove: the deviation over the travel in the state in which it"
        " was measured, with its uncertainty."
    ),
    "run.files": "Files",
    "run.files_written": "Files written",
    "run.in_english": (
        "Texts of the job, of the files and of the control's definition are as they were given;"
        " assumed facts, reasons why an axis gets no table, and the names in the certificate of the"
        " fit are in English."
    ),
    "run.legend": (
        "Grey: before. Blue: 5 to 95 % of fresh tests at the same targets, upright line: median."
        " Dashed: limit."
    ),
    "run.limit_missed": "At least one limit is predicted to be missed",
    "run.limit_open": "At least one limit may or may not be met",
    "run.limits": "Axis {axis}: what limits it",
    "run.limits_met": "All limits are predicted to be met",
    "run.limits_met_if": (
        "All limits are predicted to be met, as far as what is named above is right"
    ),
    "run.no_axis_table": "No table for this axis{reason:if|: {reason}}.",
    "run.no_limits": "Predicted result; no limits were given to decide against",
    "run.no_statement": (
        "Statement of conformity: none. The decisions are about the predicted next test; the report"
        " of compwright verify decides about the machine."
    ),
    "run.no_table": "No table was written",
    "run.no_table_for": "No table was written for axis {axes}",
    "run.periods": "Axis {axis}: periods of the error",
    "run.points": "Table in numbers: {count} points",
    "run.provenance": "Provenance",
    "run.raw_readings": "Raw readings",
    "run.refusal": "Axis {axis}: {reason}.",
    "run.single": "One curve and one reversal value",
    "run.state": "Axis {axis}: state of the control that was taken",
    "run.state_files": (
        "As in {files}; the table is the total of what was there and what is to be added."
    ),
    "run.state_none": "None: nothing was active in the control when the axis was measured.",
    "run.state_not_given": (
        "Not given. Without it no table is written: the new total has to hold what is active"
        " already."
    ),
    "run.table": (
        "{count} nodes, as read back from the files.{wanted:if| Broad line: what was wanted before"
        " rounding and limits.}"
    ),
    "run.worth": "Axis {axis}: what the points of the table are worth",
    "severity.error": "✗ error",
    "severity.info": "info",
    "severity.warning": "! warning",
    "verify.comparison": "Before, predicted and after",
    "verify.comparison_note": (
        "One scale. Predicted: expected means at the targets of the first test."
    ),
    "verify.equivalent": "cannot be distinguished from",
    "verify.factor": "factor",
    "verify.further_table": "further table",
    "verify.in_english": (
        "Texts of the job, of the files and of the control's definition are as they were given; the"
        " reasons of the next round are in English."
    ),
    "verify.legend": (
        "Grey: before. Blue: predicted 5 to 95 %, upright line: measured after loading. Dashed:"
        " limit."
    ),
    "verify.look_at": "Look at:",
    "verify.next_round": "{written:if|Next round|No next round}",
    "verify.no_further_table": "no further table",
    "verify.outside": "outside",
    "verify.shift": "shift in nodes",
    "verify.table_of": "table of axis",
    "verify.within": "within",
    "worth.caption": (
        "Predicted {symbol} at new targets over the number of points, median and 5 to 95 %. Filled"
        " dot: the table that is written{grid:if|, {grid:choose|ring=ring: the grid that is in the"
        " control|on_it=on the grid that is in the control}|}."
    ),
    "worth.described": "{quantity} over the number of points",
    "worth.over": "points of the table",
    "worth.points": (
        "{points} points, every {spacing} {place}: {symbol} {median} {unit} ({p05} to {p95})"
    ),
    "worth.quantity": "{symbol} in {unit}",
}
