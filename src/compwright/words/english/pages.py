"""Sentences on the report pages of `run`, of `verify` and of circular tests."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "circle.about": "{centre:choose|set_up= (set-up centre)|own= (own centre)}",
    "circle.agreement": (
        "{how:choose|agrees=agrees|differs=differs|not_valid=not valid|uncertain=too uncertain to"
        " compare|definition=other definition{pitch:if| (forward / backward, at a pitch of"
        " {pitch:g} mm)|}}"
    ),
    "circle.cause": "{cause}  {value} {unit}",
    "circle.cause_share": "{cause} ({share:.0f} % of all effects)",
    "circle.centre": (
        "{name:choose|common=common least-squares centre|set-up=set-up centre|ccw=least-squares"
        " centre of ccw|cw=least-squares centre of cw}: {first} {x}, {second} {y} µm{H:if|; H {H}"
        " µm|}"
    ),
    "circle.compared": "Comparison",
    "circle.comparison": (
        'Comparison with the software of the instrument, whose model is not published. "Agrees":'
        ' the two values differ by at most two standard errors of our value. "Differs": by more.'
        " Our value without reversal spikes is then given too, from a plain regression of the same"
        ' readings (harmonics and steps). "Not valid", value in brackets: that software itself'
        ' reports its value as not valid. "Too uncertain to compare": our standard error exceeds'
        ' both values. "Other definition": that of the software is not published; ours is in'
        " docs/evaluation.md."
    ),
    "circle.detail": "– {part}",
    "circle.difference": (
        "differs. Without reversal spikes our value is {plain} {unit}{spikes:if|: the spikes make"
        " {share:.0f} % of the difference|: the spikes are not the reason}"
    ),
    "circle.effect": "Effect on the radius",
    "circle.effects": "Effect, peak to peak, in µm; whiskers 95 %",
    "circle.fit": "fit: path of each run, calculated from all causes of deviation",
    "circle.job": (
        "Add these lines to a job. It then corrects, by tables and backlash compensation, the"
        " causes that can be corrected in this way. To make the job from the control's files:"
        " `compwright new --from FILE... --format ID --out job.yaml`. Name a positioning test of"
        " each axis in it (its slope corrects the scale), add the lines{file:if| and put the file"
        " of each direction in place of FILE|}. Put the machine coordinates of the centre, mm, in"
        " place of the axes of `centre`. Then `compwright run job.yaml`."
    ),
    "circle.least_squares": "least-squares circle, radius {base} µm from nominal",
    "circle.magnified": "{setting}\nMagnification {magnification} : 1, rings in µm",
    "circle.next": "What to do next",
    "circle.no_table": (
        "No table corrects these causes of deviation. Repeat the test after the repair."
    ),
    "circle.nominal": "nominal circle",
    "circle.open_causes": (
        "No action is proposed for {causes}, because the standard error is more than half of the"
        " value. Repeat the circular test, if possible at a lower feed; a cause that appears"
        " again is real."
    ),
    "circle.parameter": (
        "{name:choose|G=Circular deviation, minimum zone|G_lsc=Circular deviation by the"
        " least-squares circle|F_max=Radial deviation, largest|F_min=Radial deviation,"
        " smallest|F_max_lsc=Radial deviation, largest, about the least-squares"
        " centre|F_min_lsc=Radial deviation, smallest, about the least-squares"
        " centre|H=Circular hysteresis|D=Mean radial deviation}"
    ),
    "circle.pictures": (
        "What these causes look like alone, much exaggerated: counter-clockwise thick,"
        " clockwise thin."
    ),
    "circle.ranked": "Causes, the largest effect first",
    "circle.run": "{sense}: G {G}, F{centre} {highest} / {lowest} µm",
    "circle.scales": "{scales:and}. {step}",
    "circle.sense": "{sense:choose|ccw=ccw|cw=cw|both=both}",
    "circle.setting": (
        "R {radius} mm{feed:if|, {feed:.5g} mm/min|}{extent:if|, arc {extent:.4g}° from"
        " {start:.4g}°|}"
    ),
    "circle.share": "Share",
    "circle.shares": (
        "Causes, share of all effects\n(pale: less than twice its standard error, at each end too)"
    ),
    "circle.software": "Software of the instrument",
    "circle.start": "start of {sense}",
    "circle.step": (
        "{kind:choose|squareness=Mechanic: check level and alignment of the guideways. Table: a"
        " job with `apply` corrects it where the control can, if the standard error is below a"
        " quarter of the value and 15 µm/m.|scale_mismatch=Check the"
        " temperature of both axes. Table: measure {first} and {second} with a laser and run a"
        " job with both tests.|servo_mismatch=Servo: give {first} and {second} the same position"
        " loop gain (Kv) and feedforward.|radius_change=Measurement: repeat both directions with"
        " the same feed; check the seat of the bar.|backlash=Mechanic: check nut, support bearing"
        " and coupling of the {axis} screw. Then correct the control's backlash compensation of"
        " {axis}.|overcompensation=Check the sign of the"
        " file first. If it is right, reduce the control's backlash compensation of {axis}."
        "|lateral_play=Mechanic: check preload and gibs of the {axis}"
        " guideway.|reversal_spike=Servo: adjust the friction compensation of {axis} at reversal."
        " Mechanic: check its lubrication and wipers.|cyclic=Mechanic: check screw, its bearing"
        " and the encoder mount of {axis}. Table: at least three points in each period correct"
        " what is left.|straightness=Mechanic: check the alignment of the {axis} guideway. Table:"
        " a cross-axis table corrects it where the control has one (key `cross` of the"
        " job).|offset_change=Measurement: check the centre mount and the magnet cups; then"
        " repeat.|spiral=Measurement: let machine and bar reach a stable temperature; then"
        " repeat.|vibration=Look for the source by its frequency{frequency:if| ({frequency:3sig}"
        " Hz)|}{axis:if| at axis {axis}|}: pump, fan, motor. Servo: lower"
        " the gain for a trial.|stick_slip=Mechanic: check lubrication, wipers and preload of the"
        " {axis} guideway.|master_slave=Servo: check the interpolation parameters of {first} and"
        " {second}.}"
    ),
    "circle.sums": "Values that combine several causes",
    "circle.symbol": (
        "{letter}{sense:if| {sense:choose|ccw=ccw|cw=cw|bidirectional=both}|}{centre:if|,"
        " {centre:choose|G=least-squares circle|F=least-squares centre}|}"
    ),
    "circle.to_do": "{cause} ({share:.0f} % of all effects). {step}",
    "circle.unexplained": "The causes of deviation below leave {rms} µm rms unexplained.",
    "circle.value_error": "Value ± standard error",
    "circle.zone": (
        "minimum zone{sense:choose|both= of both|ccw=, ccw|cw=, cw}: G {G} µm{D:if|; D {D} µm|}"
    ),
    "given.approaches": "{counts}; {cycle} cycle",
    "given.arc": "from {start}° to {end}°, {extent}°",
    "given.at_end": (
        "{text} {end:choose|_start=at the start of the test|_end=at the end of the test}"
    ),
    "given.axis": "{axis}, {kind}",
    "given.budget": "see the budget of the uncertainty",
    "given.by_job": "{text} (job)",
    "given.centre": "centre at {places:join|; } mm",
    "given.coefficient": "{value} µm/(m K)",
    "given.compensation": (
        "{how:choose|off=off; in the control:|active=on, as active in|stored=on, as stored in}"
        " {files} (job, states.{state})"
    ),
    "given.compensation_loaded": (
        "on: the tables of this job were loaded; section Loading states what the test shows of them"
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
    "given.smoothing": "compwright does not smooth the readings: every sample counts",
    "given.statements": "{statements:join|; }",
    "given.targets": "{count} from {first} to {last} {unit}; listed in annex A",
    "given.travel": "{low:g} to {high:g} {unit}",
    "limits.all": "all together",
    "limits.cause": (
        "{cause:choose|noise=readings scatter: repeated approaches to a position give different"
        " readings (repeatability)|single outliers=single outliers|shifts between"
        " traverses=shifts of whole traverses|drift=drift: the axis changes while it is"
        " measured|temperature within its uncertainty=temperature: a slope within the temperature"
        " uncertainty that the job declares|error that the test leaves open=error that the test"
        " did not show: between targets, and hidden in the scatter|periods that the test leaves"
        " open=periodic error that these targets cannot show: what it would add|steps that the"
        " control never applies=steps of the correction (reversal) that the control never"
        " applies, because of its acceleration and servo period|no table is written=error that"
        " was measured, and that no table removes|spacing too wide for the period=periodic error:"
        " the points are too far apart for it|spacing of the points=curved part of the error"
        " between the points of the table|number of points=curved part of the error between the"
        " points: the control has too few of them|one table for both directions=reversal that"
        " changes along the travel: one table and one reversal value cannot correct it|no"
        " backlash value=reversal: the control has no value for it|quantum=resolution of the"
        " table's values|value range=largest table value that the control accepts|backlash"
        " range=largest reversal value that the control accepts|largest increment=largest step"
        " from point to point that the control accepts|a straight line instead of a table=curved"
        " part of the error: the control has a straight line, no table|={cause}}"
    ),
    "limits.left": "Left by the control",
    "limits.name": (
        "{cause:choose|temperature within its uncertainty=uncertainty of the temperature|error that"
        " the test leaves open=error that the test did not show (between targets or in the"
        " scatter)|periods that the test leaves open=periodic error that these targets cannot"
        " show|no table is written=error that no table corrects|spacing of the points=spacing of"
        " the table points|number of points=too few table points|one table for both"
        " directions=reversal that changes along the travel|no backlash value=reversal that the"
        " control cannot correct|quantum=resolution of the table values|value range=largest table"
        " value of the control|backlash range=largest reversal value of the control|largest"
        " increment=largest step between table points|a straight line instead of a table=the"
        " control has a straight line, no table|={cause}}"
    ),
    "limits.note": (
        "Each bar shows how much smaller {parameter} would be without this one cause, calculated on"
        " the same simulated tests. The bars do not add up, because {parameter} is a range, the"
        " largest minus the smallest value: only the causes at these two positions count."
    ),
    "limits.part": "Part of {parameter}",
    "limits.summary": (
        "{parameter} at new targets: {then} {unit} expected, {before} {unit} with what is"
        " in the control now. Scatter alone, without any error of the axis, would give {least}"
        " {unit}: no table can make it smaller."
    ),
    "period.alike": (
        "At these targets the following periods cannot be distinguished: {periods} {unit}."
    ),
    "period.caption": (
        "For each period: how much more likely the readings are with an error of this period than"
        " without it. How usual such a period is on machines is not yet included. Dashed: periods"
        " that are used in the estimate.{gaps:if| In the gaps, an error of this period looks like"
        " the smooth error at these targets: the search cannot find it.}"
    ),
    "period.described": "Likelihood ratio of each period",
    "period.least": "Smallest amplitude that this test shows, in {unit}",
    "period.least_caption": (
        "For each period: the smallest amplitude ({unit}) of a wave that this test shows. Shown"
        " means: in 95 % of such tests the estimated amplitude exceeds three standard errors. In"
        " the gaps the test shows no wave below 10 {unit}. If the job does not give the period, a"
        " wave is mostly found from about 1.5 times this amplitude on{gaps:if|, but not in the gaps"
        " of the figure above}. More targets, at random offsets, show smaller waves."
    ),
    "period.none": "No period is known, and none was found.",
    "period.over": "Period in {unit}",
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
        "Conformity is not stated: {undecided:if|at least one limit is undecided|it is not proven"
        " that the tables are active as planned}, or a finding that a decision depends on is not"
        " yet checked."
    ),
    "report.customer": "Customer",
    "report.date": "Date of the test",
    "report.extreme": (
        "{what:choose|R=|A={end:choose|highest=highest|lowest=lowest} "
        "|E={end:choose|highest=highest|lowest=lowest} "
        "|M={end:choose|highest=highest|lowest=lowest} }mean"
        "{what:choose|E=|M= ±|A= {end:choose|highest=+|lowest=−} {coverage} s"
        "|R= {end:choose|highest=+|lowest=−} {coverage} s}"
    ),
    "report.extremes": "Extremes that give A, E, M and R: rings in the figure",
    "report.findings": "Findings",
    "report.footer": "Report {number}",
    "report.in_english": (
        "Names and texts from the job and from the files are printed as given, not translated."
    ),
    "report.in_file": "In the file: {name}",
    "report.logo": "Logo",
    "report.machine": "{circles}, evaluated together as circles of one machine{name:if|: {name}|}",
    "report.no_limits": (
        "No limit was given. This report states values; it does not state conformity."
    ),
    "report.no_number": "Report without a number",
    "report.not_conform": "The machine does not conform to every limit of the table above.",
    "report.number": "Report number",
    "report.open_sections": "Only sections that are open on this page are printed.",
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
    "report.readings_air": "Single readings, without the effect of the air on the laser wavelength",
    "report.readings_measured": "Single readings, as measured",
    "report.readings_reduced": "Single readings, reduced to 20 °C",
    "report.results": "Results",
    "report.see_tests": "see the pages of the tests",
    "report.sign_checked": "Checked by",
    "report.sign_measured": "Measured by",
    "report.sign_place": "Place, date",
    "report.signs": (
        "Deviation: measured minus target. Approach +: in the positive machine direction. Reversal"
        " error at a target: mean at + minus mean at −; B is its largest absolute value."
    ),
    "report.signs_circle": (
        "Circle: deviation is measured minus nominal radius. Lost motion above zero: after a"
        " reversal the axis lags behind the command. Squareness above zero: the angle between the"
        " positive axes is above 90°."
    ),
    "report.statistics": "Means, standard deviations and repeatability at {count} target positions",
    "report.test": "Test {name}",
    "report.title": "Test report{tests:plural|| of {tests} tests}",
    "report.unnamed_machine": (
        "The files of these circles state no machine and no serial number. They count as one"
        " machine. Evaluate circles of different machines one by one, or add `# machine:` to the"
        " files."
    ),
    "report.unread": "Files that were not evaluated",
    "report.verification": "Verification of {axes}",
    "run.annex_c": "Annex C: compensation",
    "run.assumed": "Assumed facts",
    "run.assumed_note": (
        "These facts are in none of the given files; the results are valid only if they are true."
    ),
    "run.axis_table": "Axis {axis}: table",
    "run.bends": "{input} bends {output}",
    "run.bidirectional": "One curve for each direction of approach",
    "run.card": "Commissioning card",
    "run.certificate": "Certificate of the fit",
    "run.changes": "Old to new",
    "run.check_first": "Undecided: check the findings named above first",
    "run.circle_worse": (
        "The limits of a circle are undecided: it is predicted to get worse. Find out why before"
        " you load anything (CW-P131)"
    ),
    "run.comparison": "Before and predicted",
    "run.comparison_note": (
        "The deviations before and, on the same scale, the deviations that a test at the same"
        " targets is expected to show."
    ),
    "run.compensation": "Compensation",
    "run.correction": "Correction: what the control adds to the command.",
    "run.cross": "Cross tables",
    "run.done": (
        "{tests:plural|1 test|{tests} tests} of {count:plural|axis|axes} {axes} {tests:plural|was|"
        "were} evaluated {standards:if|to {standards:and}|without a standard}. The error was"
        " estimated over the travel{tables:if|. The best table that {control:if|{control}|the"
        " control} can store was calculated and written in the control's own form. The next test"
        " was predicted from these files. Nothing has been loaded yet: load the table step by step"
        " as the commissioning card in the result folder says, measure again, and run compwright"
        " verify.|. No table was written, so the prediction is for a test without a table.}"
    ),
    "run.estimate": "Axis {axis}: estimated error",
    "run.estimate_note": (
        "The error that the table has to remove: the deviation over the travel, with the"
        " compensation that was active during the measurement, and its uncertainty."
    ),
    "run.files": "Files",
    "run.files_written": "Files written",
    "run.in_english": (
        "Texts from the job, from the files and from the control's definition are printed as given."
        " Reasons why a file of the control is refused are in English."
    ),
    "run.legend": (
        "Grey: before. Blue: 5 to 95 % of new tests at the same targets; vertical line: median."
        " Dashed: limit."
    ),
    "run.limit_missed": "At least one limit is predicted to be missed",
    "run.limit_open": "At least one limit may or may not be met",
    "run.limits": "Axis {axis}: what limits its accuracy",
    "run.limits_met": "All limits are predicted to be met",
    "run.limits_met_if": (
        "All limits are predicted to be met, if the findings named above prove to be harmless"
    ),
    "run.no_axis_table": "No table for this axis{reason:if|: {reason}}.",
    "run.no_limits": "Predicted result; no limits were given, so nothing is decided",
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
    "run.state": "Axis {axis}: existing compensation of the control that was used",
    "run.state_files": ("As in {files}; the new table is the total: existing table plus change."),
    "run.state_none": "None: nothing was active in the control when the axis was measured.",
    "run.state_not_given": (
        "Not given. If the present contents of the control are unknown, no table is written,"
        " because the new table has to include what is already active."
    ),
    "run.table": (
        "{count} table points, as read back from the files.{wanted:if| Broad line: the wanted"
        " correction before rounding and limits.}"
    ),
    "run.worth": "Axis {axis}: predicted accuracy by number of table points",
    "verify.comparison": "Before, predicted and after",
    "verify.comparison_note": (
        "All curves have the same scale. Predicted: the means that are expected at the targets of"
        " the first test."
    ),
    "verify.equivalent": "cannot be distinguished from",
    "verify.factor": "factor",
    "verify.further_table": "table for the next correction round",
    "verify.in_english": (
        "Texts from the job, from the files and from the control's definition are printed as given."
        " Reasons why a file of the control is refused are in English."
    ),
    "verify.legend": (
        "Grey: before. Blue: predicted 5 to 95 %, vertical line: measured after loading. Dashed:"
        " limit."
    ),
    "verify.look_at": "Look at:",
    "verify.next_round": "{written:if|Next round|No next round}",
    "verify.no_further_table": "no new table for the next correction round",
    "verify.outside": "outside",
    "verify.shift": "shift in points",
    "verify.table_of": "table of axis",
    "verify.within": "within",
    "worth.caption": (
        "Predicted {symbol} at new targets for each number of table points: median and 5"
        " to 95 %. The filled dot is the table that is written{grid:if|; {grid:choose|ring=the"
        " ring is the existing table of the control|on_it=it keeps the points of the existing"
        " table}|}."
    ),
    "worth.described": "{quantity} over the number of points",
    "worth.over": "points of the table",
    "worth.points": (
        "{points} points, every {spacing} {place}: {symbol} {median} {unit} ({p05} to {p95})"
    ),
    "worth.quantity": "{symbol} in {unit}",
}
