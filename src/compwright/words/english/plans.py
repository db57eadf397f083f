"""Sentences about the corrections that a run plans or refuses, with the reasons."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-P001": "No table is written for axis {axis}: {why}.",
    "CW-P001.measured": (
        "by calculation from the readings of the first test, {parameter} is {with_table} with the"
        " table and {without} without it"
    ),
    "CW-P001.new_targets": (
        "in a test at new targets, {parameter} is expected to be {with_table} with the"
        " table and {without} without it"
    ),
    "CW-P001.not_seen": (
        "in a test at new targets, {parameter} is expected to be {with_table} with a"
        " table of another correction round and {without} without it. It differs by {spread} from"
        " one test to the next, so the gain is within the uncertainty"
    ),
    "CW-P001.old_table": (
        "the tests {off} and {on} contradict the control's files ({percent:.1f} % sure). In {on}"
        " the existing table (states.{state} in the job) {did:choose|not_active=was not active|"
        "inverted=was active with the opposite sign|scaled=was active with factor {factor:2sig}|"
        "shifted=was active, shifted by {shift:+d} points|mirrored=was active, mirrored over the"
        " travel|wrong_axis=was not active; the table of another axis was|one_direction=was active"
        " in one direction only|backlash=was active with a different backlash|partial=was active"
        " over a part of the travel only|measurement=does not fit the readings: one of the tests"
        " was measured wrongly|undecided=behaved differently ({likely:join|, or })}{detail:if|"
        " ({detail})}.{off_too:if| Or it was active in {off} too: both tests show the same error."
        " Check whether it was switched off for {off}.}{exchanged:if| Or the two tests are"
        " exchanged.} A table made from these tests would be wrong for the same reason{look_at:if|."
        " Look at: {look_at:join|. }}"
    ),
    "CW-P101": (
        "Circle {circle}: the job does not give its centre in the machine, so the middle of the"
        " travel is assumed ({centre}). Give the centre, because the effect of the tables depends"
        " on it."
    ),
    "CW-P101.axis": "{axis} {position:g}",
    "CW-P102": (
        "Circle {circle}: about its centre it reaches from {low:.6g} to {high:.6g} on axis {axis},"
        " which is beyond the travel. Check centre, radius and travel."
    ),
    "CW-P102.rotary": (
        "Circle {circle}: axis {axis} is a rotary axis in the job, but a circular test moves two"
        " linear axes. Check `kind` of axis {axis} and the axes of the circle."
    ),
    "CW-P103": (
        "The table that corrects {output} over {input} has equally spaced points. At the measured"
        " positions it therefore differs from the wanted correction by up to {missed}."
    ),
    "CW-P104": (
        "{measured}, but {circle} according to {tests}. The two contradict each other. The"
        " {measurements:plural|table is computed from the direct measurement. Check its"
        " sign|tables are computed from the direct measurements. Check their signs}, and repeat the"
        " measurement that is wrong."
    ),
    "CW-P105": "{measured}. {tests} confirms it ({circle}).",
    "CW-P106.contradictory": (
        "The squareness of plane {plane} is not corrected, because its circles contradict each"
        " other (CW-P110). Repeat the circle that deviates, or acknowledge CW-P110 in the job."
    ),
    "CW-P106.no_circle": (
        "The squareness of plane {plane} is not corrected: the job has no circle of this plane."
        " Measure one in both directions."
    ),
    "CW-P106.uncertain": "The squareness of plane {plane} is not corrected: {why}.",
    "CW-P106.undetermined": (
        "The squareness of plane {plane} is not corrected, because the circles do not determine"
        " it. {reasons:join|; }."
    ),
    "CW-P107": "Plane {plane}: the squareness is {angle_words}. There is nothing to correct.",
    "CW-P108": (
        "Plane {plane}: the squareness is {squareness} according to {tests}. It is not corrected,"
        " because the job does not ask for it: add `apply: {{squareness: {{{plane}: AXIS}}}}` with"
        " the axis to be corrected as AXIS."
    ),
    "CW-P109": (
        "{plane}: the squareness{existing:if| with the control's existing table|} is {squareness}"
        " according to {tests}{converted:if|, measured in another state|}. A correction moves axis"
        " {output} as a function of axis {input}."
    ),
    "CW-P110": (
        "Plane {plane}: the circles contradict each other about the squareness (µm/m: {values})."
        " Repeat the circle that deviates."
    ),
    "CW-P110.circle": "{circle} {squareness:+.1f}",
    "CW-P111": (
        "{pair}: the correction reaches over {travel:g} mm of axis {axis}, but the"
        " {diameter:if|diameter|range} of the measurement is only {length:g} mm. Beyond the"
        " measured part it is extrapolated: check it there."
    ),
    "CW-P112": (
        "{axis} is a gantry axis. Moving it by micrometres while another axis travels can cause"
        " stick-slip. Correct its squareness first by the reference offset of the synchronised"
        " axis."
    ),
    "CW-P113.column": (
        "{what} is corrected in {where} (the values there are"
        " {values:choose|correction=corrections|error=errors})."
    ),
    "CW-P113.not_held": "{what} {several:if|are|is} not corrected: {why}.",
    "CW-P113.own_table": (
        "{what} is corrected in table {table} of the control, which is active now: its values get"
        " the old and the new correction. To leave it as it is, allow only free tables:"
        " `{option}: [{free}]`."
    ),
    "CW-P113.sheet": (
        "{what} is corrected by parameters that this run does not write into the control's files."
        " Type them in from the entry sheet {sheet}, which is in the folder of the commissioning"
        " card. All of them are unconfirmed. The prediction counts them as typed in."
    ),
    "CW-P113.straightness": (
        "{what} is corrected in the files by straightness compensation: {values}."
    ),
    "CW-P113.switches": (
        "{what} is not corrected. The job says (`active`) that the table between {input} and"
        " {output} was {active:if|active|not active} during the test. The control's files do not"
        " say so. Next: give the files with all switches as they were during the test, without the"
        " tables that were off, and leave out `active`."
    ),
    "CW-P113.typed": (
        "{what} is corrected by values that are in no file for the control ({why})."
        " {total:if|Replace the values in {where} by these|Add these to the values in {where}}:"
        " {rows}. The commissioning card and the entry sheet in its folder describe how. The values"
        " are {values:choose|correction=corrections|error=errors}; their sign is unconfirmed: check"
        " it by a measurement before production. The prediction counts them as typed in."
    ),
    "CW-P114": (
        "{axis}: laser and circle disagree about the lost motion. It is {laser} according to"
        " the laser, and {circle} according to {test}, measured in motion. The value of the"
        " {counts:choose|circle=circle|laser=laser} is used."
    ),
    "CW-P115": (
        "{axis}: laser and circle disagree about the scale from {low:.6g} to {high:.6g} mm, where"
        " the circle lies. It is {laser} according to the laser and {circle} according to {test}."
        " The value of the laser is used."
    ),
    "CW-P116": (
        "Scale of {pair}: laser and circle disagree. It is {laser} according to the laser and"
        " {circle} according to {test}. The value of the laser is used."
    ),
    "CW-P117": (
        "{axis}: the lost motion is taken from the circles. It differs from the laser's value by"
        " {shift}."
    ),
    "CW-P118": (
        "{axis}: the scale comes from the positioning test of this axis. The circles only check it."
    ),
    "CW-P119.contradictory": (
        "{axis}: the scale is not corrected, because its circles contradict each other (CW-P136)."
        " Repeat the circle that deviates, or acknowledge CW-P136 in the job."
    ),
    "CW-P119.impossible": "{scale}. It is not corrected: {reasons:join|; }.",
    "CW-P119.negligible": "{scale}. There is nothing to correct.",
    "CW-P119.not_taken": (
        "{axis}: no circle gives the scale of this axis: {reasons:if|{reasons:join|; }|none was"
        " measured with it}."
    ),
    "CW-P119.undetermined": (
        "{axis}: the scale from {tests:join|; } is not corrected: {why}. Measure the axis with a"
        " laser, or a circle at a low feed."
    ),
    "CW-P119.lag": (
        "servo lag may make circle {circle} smaller by {lag:.0f} µm/m (measure a circle at"
        " {feed:.0f} mm/min or slower, or the other axis with a laser)"
    ),
    "CW-P119.low_feed": "circular test {circle} at a low feed",
    "CW-P119.mismatch": "circular test {circle} and the laser on axis {axis}",
    "CW-P119.not_calibrated": (
        "the bar of circle {circle} was not calibrated, and the other axis of this circle has no"
        " positioning test"
    ),
    "CW-P119.together": "circular tests {circles:join|, } together",
    "CW-P120": (
        "{scale}. The table corrects this scale error. It includes the effect of the temperatures"
        " of the bar and of the machine's scale during the test: 1 K changes steel by 11 µm/m."
    ),
    "CW-P130.no_circle": (
        "{axis}: the job requests the lost motion from circles, but no circle was measured with"
        " this axis. The value of the laser is used."
    ),
    "CW-P130.no_test": (
        "{axis}: the lost motion that the circles show is not corrected. The axis has no"
        " positioning test, so no table is made for it."
    ),
    "CW-P130.none": (
        "apply.backlash_from has no effect: no circle of the job shows the lost motion of an axis."
    ),
    "CW-P130.unknown": (
        "{axis}: the job requests the lost motion from circles, but it is not used. Either the"
        " circles do not show it, or the positioning test has one direction only."
    ),
    "CW-P131": (
        "Circle {circle}: with these tables {parameter} is predicted to grow from {was:.1f} to"
        " {median:.1f} µm ({p05:.1f} to {p95:.1f}). Either positioning test and circle contradict"
        " each other, or only one axis of the plane is corrected. The limits of the circle stay"
        " undecided: find out why before you load anything."
    ),
    "CW-P132": (
        "{test:choose|circular=Circle|=Axis} {name}: a guarded decision needs the uncertainty U of"
        " {lacking}, which is unknown. The decision stays undecided."
        " {test:choose|vdi3441=VDI/DGQ 3441 states no uncertainty: give another"
        " standard|linear=Give `uncertainty` in the job (device.U in µm and what else is"
        " known)|rotary=Give `uncertainty.rotary` in the job (U of the instrument in arcsec, setup,"
        " E_VE)|circular=Give `uncertainty.circular` in the job (U of the instrument in µm, length,"
        " setup, E_VE)}, or `decision_rule: simple`."
    ),
    "CW-P133": (
        "Axis {axis}: the limit is predicted to be kept at the same targets, but not at new targets"
        " between them. There, 5 % of the tests show more than {parameters}, so the limit stays"
        " undecided.{reasons:if| The error may repeat {reasons:join|, or }.} Measure a new test at"
        " {better}.{known:if|| Give the lead of the screw, if it is known (screw_pitch).}"
    ),
    "CW-P133.open": (
        "with a period that these targets cannot show ({probability:.0%}; most likely"
        " {periods:3sig} {unit})"
    ),
    "CW-P133.parameter": "{parameter} {value} (limit {limit:g})",
    "CW-P133.period": "every {period:.5g} {unit} ({probability:.0%})",
    "CW-P134": (
        "The causes of the deviation of a circle are unknown (circle {causes}). Therefore nothing"
        " is predicted for this circle, and its limits stay undecided."
        " {lacking:choose|samples=Measure with at least {least:d} samples per run away from the"
        " reversal points|circle=Measure a full circle in both directions|noise=Export the samples"
        " without smoothing}, or decide by the test after loading."
    ),
    "CW-P135": (
        "Circles {circles} together. {machine:if|{machine:join| }|They show no error of the"
        " machine.}"
    ),
    "CW-P135.error": (
        "{kind:choose|squareness=Squareness|scale=Scale|lost motion=Lost motion|position"
        " loop=Time constant of the position loop}: {values}."
    ),
    "CW-P135.value": "{of} {value}",
    "CW-P136": (
        "{kind:choose|squareness=Squareness|scale=Scale|lost motion=Lost motion|servo"
        " mismatch=Servo mismatch}: the circles contradict each other ({values:join|; }). Either"
        " the machine changed between the tests, or its errors depend on place, feed or"
        " temperature. Repeat the circle that deviates."
    ),
    "CW-P136.circle": "{circle}: {axes} {value}",
    "CW-P136.growth": (
        "Axis {axis}: the radius of the circles grows with the feed, by more than a position loop"
        " can cause. A feed, radius, bar length or temperature is not as stated. Check them for"
        " {circles:join|, }, or repeat the circle that deviates."
    ),
    "CW-P136.lag": (
        "Axis {axis}: the radius of the circles shrinks with the feed as if the position loop had a"
        " time constant of {lag} (usual: up to {most}). Check feed, radius and temperature of"
        " {circles:join|, }: the scale depends on them."
    ),
    "CW-P140": (
        "Axis {axis}: the new table gets new points, {grid}. The points of the existing table,"
        " {existing}, cannot be kept: {why}"
    ),
    "CW-P141": (
        "Axis {axis}: {stays:if|the new table keeps the points of the existing table|no table with"
        " the points of the existing table improves the axis} ({existing}). Predicted"
        " {parameter}{stays:if|| without a table}: {same} at the same targets, {new} at new"
        " targets. Predicted {parameter} with new points ({grid}): {better} at the same targets,"
        " {better_new} at new targets. To use the new points, set `spacing: auto` in the table of"
        " the axis. Settings that depend on the old points are adapted too; those that cannot be"
        " adapted are listed"
    ),
    "CW-P142.line": (
        "The slope of {slope} is corrected by the control's separate linear parameter (a"
        " straight line). At the table points an error of {left} rms would be left without this"
        " line, and {with_line} with it"
    ),
    "CW-P142.table": (
        "The slope of {slope} stays in the table. At the table points an error of {left} rms is"
        " left without the separate linear parameter, and {with_line} would be left with it"
    ),
    "CW-P143.none": (
        "No cyclic table (a second table, which repeats with the period) is written. {period}"
    ),
    "CW-P143.period": (
        "The error has a period of {period:g} {unit}, which is too short for table points"
        " {sections:g} {unit} apart. Without a cyclic table an error of {left} rms is left, with it"
        " {with_it}"
    ),
    "CW-P143.second": (
        "A cyclic table (a second table, which repeats with the period) is written too. {period}"
    ),
    "CW-P144": (
        "Axis {axis}: the points have to be typed by hand, so the table has few of them: {few},"
        " {mine}. The other choice is {many}, {other}. To use it, set `start: {start:key}, end:"
        " {end:key}, spacing: {spacing:key}` in the table of the axis"
    ),
    "CW-P150": (
        "Axis {axis}: a table will not help here. {parameter} at new targets, between the measured"
        " ones, is {now}{with_table:if| without a table and {with_table} with one}. The largest"
        " cause of this value is {cause} ({value:.2f} {unit}, {share:.0%}): {advice}"
    ),
    "CW-P151.cause": (
        "Axis {axis}: {parameter} at new targets, between the measured ones, is {now} now, and the"
        " table reduces it by {taken:.0%}. Most of the rest is {cause} ({value:.2f} of {left}):"
        " {advice}"
    ),
    "CW-P151.scatter": (
        "Axis {axis}: {parameter} at new targets, between the measured ones, is {now} now, and the"
        " table reduces it by {taken:.0%}. {scatter:.0%} of the present value is scatter of the"
        " readings, which no table reduces"
    ),
    "CW-P152": (
        "Axis {axis}: {tables:choose|left=the table with the least expected squared error is used,"
        " not a table made for the smallest {goal}|same=the table with the least expected squared"
        " error also gives the smallest {goal}|taken=the table was made for the smallest"
        " {goal}|no_gain=a table made for the smallest {goal} shows no smaller {goal} in new"
        " simulated tests, so the table with the least expected squared error is used}. Expected"
        " values at new targets{tables:choose|left=|same=|taken= (in brackets: with the table that"
        " has the least expected squared error)|no_gain= (in brackets: with the table made for the"
        " smallest {goal})}: {parameters} {unit}"
    ),
    "CW-P152.parameter": "{parameter} {value:.2f}{other:if| ({other:.2f})}",
    "CW-P153": (
        "Axis {axis}: the difference between the two tables (one for each direction) may contain"
        " the drift of this test. The reversal changes by {risen} along the travel. The readings"
        " drift by {drifted} from the first run to the last. If this drift goes on within every"
        " run, out and back, it alone changes the reversal by {shown}, even if the backlash is"
        " constant. Warm the axis up and measure again before you load two tables, or use one table"
        " (`mode: single` in the table of the axis)"
    ),
    "CW-P154": (
        "Axis {axis}: the backlash value may contain the drift of this test. The mean reversal is"
        " {measured}. The readings drift by {drifted} from the first run to the last. If this"
        " drift goes on within every run, out and back, it changes the mean reversal by {shown}."
        " Warm the axis up and measure again before you load the backlash value"
    ),
    "CW-P155": (
        "Axis {axis}: stop here. Of {parameter} = {left:.2f} {unit} at new targets, {value:.2f}"
        " {unit} come from the largest cause: {cause}. Another correction round would change less"
        " than the difference between one test and the next."
    ),
    "CW-P156": (
        "Axis {axis}: the control never applies a step of the correction whose size is between"
        " {least:.2f} {unit} and {most:.2f} {unit}. The reversal in the table is"
        " such a step: {reversal:.2f}{reversal_to:if| to {reversal_to:.2f}} {unit}. After a"
        " reversal the old correction therefore stays until the table itself changes enough; the"
        " prediction allows for this. To have these steps applied, set the acceleration limit of"
        " the axis below {low:3sig} times its present value, or to at least {high:3sig} times,"
        " and run again"
    ),
    "CW-P160": (
        "The readings of test {test} contradict what its file or the job states about them. They"
        " are {ways:join|, or }. A table made from such readings would be wrong. {checks:join| }"
    ),
    "CW-P160.check": (
        "{way:choose|off=Was compensation active, and the axis referenced, during this test? If"
        " not, add an entry for this test to `states` and name this entry under `measured_in`.|"
        "sign=Compare one reading with the instrument: too far in + is a positive deviation.|"
        "directions=Look into the instrument's file which way the axis went in the first run.|"
        "order=Compare the readings at the first and the last target with the instrument's file.|"
        "against=Move the axis in +: if the instrument counts down, the test needs `position_map:"
        " {{sense: -1, offset: ..}}`.}"
    ),
    "CW-P160.way": (
        "{odds:odds} times more likely {way:choose|off=if the table of the control was not"
        " active in this test|sign=if the sign of the deviations is reversed (target minus"
        " measured)|directions=if + and − are exchanged|order=if the readings are in the opposite"
        " order of the targets|against=if the instrument counts against the machine}"
    ),
    "CW-P161": (
        "The table in states.{measured_in} of the job looks like the mirror image of test {test}"
        " ({size:.1f} {unit}). By chance, curves as smooth as these are so similar in {less:if|less"
        " than }{chance:2sig} % of cases. If the table was made from this test, it was not active"
        " in it, and a new table would correct the same error twice. Measure again with the table"
        " active, or name under measured_in the entry of `states` that was in the control during"
        " the test. If the table was active in this test, write in the job how you know it:"
        " `acknowledged: {{CW-P161: reason}}`"
    ),
    "CW-P162.after": (
        "the file of the test after loading states that compensation was {both:if|both on and off|"
        "off}, but the plan loads tables for {names:and}. Check at the control that they are active"
        " and measure again, or correct the key `compensation` in the file."
    ),
    "CW-P162.both": (
        "the files state that compensation was both on and off. If the job states the wrong"
        " compensation, the new table is wrong too. Check at the control what was active. Then"
        " correct the key `compensation` in the file, or `measured_in` and `states` in the job."
    ),
    "CW-P162.state": (
        "the file states that compensation was {on:if|on|off}, but states.{state} of the job"
        " {active:if|has an active table or backlash|has nothing active} for {names:and}. If the"
        " job states the wrong compensation, the new table is wrong too. Check at the control what"
        " was active. Then correct the key `compensation` in the file, or `measured_in` and"
        " `states` in the job."
    ),
    "CW-P163": (
        "Axis {axis}, test {test}: the files of this test state different values: {keys:join|; }."
        " Check that all of them belong to this test"
    ),
    "CW-P164": (
        "Axis {axis}: the error may repeat with a period that these targets cannot show (most"
        " likely {periods:3sig} {unit}). For a test that shows it, add {targets:.7g} {unit} to"
        " these targets: all together show such an error if its amplitude is at least {amplitude}."
    ),
    "CW-P165": (
        "Axis {axis}: {seen}: {parameter} {low:.2f} to {high:.2f} {unit} at new targets."
        " {otherwise}, {parameter} is {least:.2f} to {most:.2f} {unit}. To find out which is true,"
        " measure a second test in the same way, and add its file to `before` of the axis"
    ),
    "CW-P165.drift": (
        "the test drifts by {drift}, and the prediction assumes the same drift in the next test"
    ),
    "CW-P165.no_rest": "If the readings scatter around one value",
    "CW-P165.other_drift": "If each test has its own drift of this size",
    "CW-P165.other_scatter": "If all runs of a test scatter as one of these runs does",
    "CW-P165.rest": (
        "the readings at a target may lie between two limits, as if the axis stopped at either of"
        " two positions ({probability:.0%})"
    ),
    "CW-P165.scatter": (
        "the scatter of one reading is {least} to {most}, depending on the run, and the prediction"
        " assumes runs with small and with large scatter in the same proportion in the next test"
    ),
    "CW-P166": (
        "{plane:if|The squareness of plane {plane}|The scale of axis {axis}} is corrected, but is"
        " not known well: the correction makes it worse with a probability of {percent:2sig} %."
        " Measure more full circles in both directions, and give all of them"
    ),
    "CW-P167": (
        "What would be added to {output} over {input} (up to {largest}) equals what the control"
        " already adds between these two axes. If that table was made from this measurement,"
        " the same error would be corrected twice. Measure again with the table active, or name"
        " under measured_in the entry of `states` that was in the control during the"
        " measurement. If the table was active, write in the job how you know it: `acknowledged:"
        " {{CW-P167: reason}}`"
    ),
    "CW-P168": (
        "The correction of {output} over {input} reaches {largest}, more than 1 {unit}. Check"
        " {source:choose|cross=`unit` and `positions` of this measurement under `cross`|circle=unit"
        " and radius of the circle and `travel` of {input}}. If the error is that large, write in"
        " the job how you know it: `acknowledged: {{CW-P168: reason}}`"
    ),
    "CW-P169": (
        "Two measurements under `cross` correct the squareness of plane {plane}: {slopes:and}."
        " Together they remove {total:+.1f} µm/m. If each shows the whole squareness, it is"
        " corrected twice: subtract the straight line from the deviations of one of them. If both"
        " were measured against one square, write that in the job: `acknowledged: {{CW-P169:"
        " reason}}`. A circle of this plane in the job also shows which is right"
    ),
    "CW-P169.slope": "{slope:+.1f} µm/m in {output} over {input}",
    "CW-P170": (
        "{output} over {input}: the positions {first} to {last} lie outside the travel"
        " {travel_start} to {travel_end} of the job. Check the offset and the direction of the"
        " positions, and the travel."
    ),
    "CW-P171": (
        "a file is of the machine with the serial number {found:join| or }, but this machine has"
        " {known}. A table from a test of another machine would be wrong. Give the file of this"
        " machine, or correct the number in the job or the file."
    ),
    "CW-P172": (
        "{pair}: the scale mismatch has opposite signs: {laser} according to the laser and"
        " {circle} according to {test}. The angles count from the wrong axis, the axes of"
        " the plane are exchanged, or a sign is turned. Squareness may have the wrong sign too."
        " Check at the machine at which angle each axis is. Correct the file, or acknowledge"
        " CW-P172 in the job."
    ),
    "grid.even": "{points} points from {start:.10g} to {end:.10g} {unit}, every {step:.6g} {unit}",
    "grid.few": "{points} points",
    "grid.predicted": "predicted {name} {value:.2f} {unit} ({elsewhere:.2f} at new targets)",
    "grid.uneven": (
        "{points} points from {start:.10g} to {end:.10g} {unit}, {least:.6g} to {most:.6g} {unit}"
        " apart"
    ),
    "run.no_state": (
        "no table is written: the job does not say what is active in the control; add `states:"
        " {{as_found: none}}` or `states: {{as_found: [files of the control]}}`"
    ),
}
