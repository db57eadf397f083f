"""What is decided on the way from results to tables."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-P001": "No table is written for axis {axis}: {why}.",
    "CW-P001.measured": (
        "the measured test re-evaluated with the table gives {parameter} {with_table}, without it"
        " {without}"
    ),
    "CW-P001.new_targets": (
        "at new targets {parameter} is expected to be {with_table} with the table, {without}"
        " without it"
    ),
    "CW-P001.not_seen": (
        "at new targets {parameter} is expected to be {with_table} with a further table, {without}"
        " without it, and differs by {spread} from one test to the next: the gain is within the"
        " uncertainty"
    ),
    "CW-P001.old_table": (
        "the tests {off} and {on} contradict what the files say ({percent:.1f} % sure): the table"
        " of state {state} {did:choose|not_active=was not active|inverted=was active with the"
        " opposite sign|scaled=was active with factor {factor:2sig}|shifted=was active, shifted by"
        " {shift:+d} points|mirrored=was active, mirrored over the travel|wrong_axis=was not the"
        " active one: that of another axis was|one_direction=was active in one direction"
        " only|backlash=was active with a different backlash|partial=was active over a part of the"
        " travel only|measurement=and the readings do not go together: one of the tests was"
        " measured wrongly|undecided=did something else ({likely:join|, or })}"
        "{detail:if| ({detail})} in {on}"
        "{off_too:if|, or it was active in {off} as well: both show the same axis (was it off for"
        " {off}?)}{exchanged:if|, or the two tests are exchanged}. A total of old and new would be"
        " wrong by as much{look_at:if|. Look at: {look_at:join|. }}"
    ),
    "CW-P101": (
        "Circle {circle}: its place in the machine is not given; the middle of the travel is"
        " assumed ({centre}). Give its centre: the effect of the tables depends on it."
    ),
    "CW-P101.axis": "{axis} {position:g}",
    "CW-P102": (
        "Circle {circle}: a whole circle about its centre reaches from {low:g} to {high:g} on"
        " {axis}, beyond the travel."
    ),
    "CW-P103": (
        "{input} on {output}: nodes at equal steps miss the measured points by up to"
        " {missed:2sig} µm."
    ),
    "CW-P104": (
        "{measured}, {circle} by {tests}; they contradict each other. The direct measurement is"
        " corrected. Check its sign, and repeat the one that is wrong."
    ),
    "CW-P105": "{measured}, which {tests} confirms ({circle}).",
    "CW-P106.no_circle": (
        "apply.squareness.{plane} is not corrected: the job has no circle of this plane."
        " Measure one in both directions."
    ),
    "CW-P106.uncertain": "apply.squareness.{plane} is not corrected: squareness {why}.",
    "CW-P106.undetermined": (
        "apply.squareness.{plane} is not corrected: its squareness is not determined."
        " {reasons:join|; }."
    ),
    "CW-P107": "{plane}: squareness {angle_words}: nothing to correct.",
    "CW-P108": (
        "{plane}: squareness {squareness} by {tests}; nothing asks for its correction (apply)."
    ),
    "CW-P109": "{plane}: squareness {squareness} by {tests}; {output} is to follow {input}.",
    "CW-P110": (
        "{plane}: its circles contradict each other about the squareness (µm/m: {values}). Repeat"
        " the circle that deviates."
    ),
    "CW-P110.circle": "{circle} {squareness:+.1f}",
    "CW-P111": (
        "{pair}: corrected over {travel:g} mm of {axis}, the {what} is {length:g} mm: an"
        " extrapolation."
    ),
    "CW-P112": (
        "{axis} is a gantry axis: moving it by micrometres while another axis travels risks"
        " stick-slip; its squareness belongs into the reference offset of the synchronised"
        " axis first."
    ),
    "CW-P113.column": (
        "{what} is in {where} (values are {values:choose|correction=corrections|error=errors})."
    ),
    "CW-P113.not_held": (
        "{what} is not corrected: this control, as the job describes it, cannot hold it; {why}."
    ),
    "CW-P113.sheet": (
        "{what} is in no file: its parameters are in {sheet} next to the card, all unconfirmed."
    ),
    "CW-P113.straightness": "{what} is in the files as straightness compensation: {values}.",
    "CW-P113.typed": (
        "{what} is in no file ({why}): type it into {where}, {rows} (values are"
        " {values:choose|correction=corrections|error=errors}), as the card and its sheet"
        " say; the sign is unconfirmed."
    ),
    "CW-P114": (
        "{axis}: lost motion {laser} by the laser, {circle} by {test} (moving): they"
        " disagree; that of the {counts:choose|circle=circle|laser=laser} counts."
    ),
    "CW-P115": (
        "{axis}: scale {laser} by the laser, {circle} by {test}: they disagree; the laser counts."
    ),
    "CW-P116": (
        "Scale of {pair}: {laser} by the laser, {circle} by {test}: they disagree; the laser"
        " counts."
    ),
    "CW-P117": "{axis}: its lost motion is taken from the circles: {shift} against the laser's.",
    "CW-P118": "{axis}: its scale is that of its positioning test; circles only check it.",
    "CW-P119.impossible": "{scale}; not corrected: {reasons:join|; }.",
    "CW-P119.negligible": "{scale}; nothing to correct.",
    "CW-P119.not_taken": (
        "{axis}: its scale is not taken from a circle: {reasons:if|{reasons:join|; }|no"
        " circle lies on it}."
    ),
    "CW-P119.undetermined": (
        "{axis}: its scale is not corrected: {why}. It comes from {tests:join|; }. Or measure the"
        " axis with a laser, or repeat the circle at a low feed."
    ),
    "CW-P119.lag": (
        "the lag of the axes may shrink {circle} by {lag:.0f} µm/m at its feed (a low feed, two"
        " feeds, or a positioning test of its other axis would decide it)"
    ),
    "CW-P119.low_feed": "{circle} at a low feed",
    "CW-P119.mismatch": "the mismatch of {circle} and the laser on {axis}",
    "CW-P119.not_calibrated": (
        "the bar of {circle} was not calibrated, and its other axis has no positioning test"
    ),
    "CW-P119.two_feeds": "{slow} and {fast} extrapolated to no feed",
    "CW-P120": (
        "{scale}; its table corrects it. The temperature of bar and scale at the test is in"
        " it: 1 K is 11 µm/m of steel."
    ),
    "CW-P130.no_circle": (
        "{axis}: no circle lies on it; its lost motion stays that of the laser, although the"
        " job asks for the circles'."
    ),
    "CW-P130.no_test": (
        "{axis}: its lost motion by the circles is not corrected: it has no positioning test,"
        " and so no table to put it into."
    ),
    "CW-P130.none": (
        "apply.backlash_from: the lost motion of no axis is taken from circles: no circle of"
        " the job shows it."
    ),
    "CW-P130.unknown": (
        "{axis}: its lost motion is not taken from the circles, as the job asks: they do not"
        " show it, or its positioning test has one direction only."
    ),
    "CW-P131": (
        "Circle {circle}: {parameter} is predicted to grow from {was:.1f} to {median:.1f} µm"
        " ({p05:.1f} to {p95:.1f}) with these tables. Positioning and circle contradict each"
        " other, or one axis of the plane is corrected and the other not. Undecided: find out"
        " why before you load anything."
    ),
    "CW-P132": (
        "{what}: no uncertainty U of {lacking} is known, and the decision is guarded:"
        " undecided; {give}."
    ),
    "CW-P133": (
        "Axis {axis}: the limit is predicted to be kept at the same targets, not at new ones:"
        " 5 % of tests there show more than {parameters}. Undecided.{reasons:if| The error"
        " may repeat {reasons:join|, or }.} Measure at {better}.{known:if|| Give the lead of"
        " the screw, where it is known (screw_pitch).}"
    ),
    "CW-P133.open": (
        "with a period that these targets cannot show ({probability:.0%}; most likely"
        " {periods:3sig} {unit})"
    ),
    "CW-P133.parameter": "{parameter} {value} (limit {limit:g})",
    "CW-P133.period": "every {period:.5g} {unit} ({probability:.0%})",
    "CW-P134": (
        "Circle {causes}, so the predicted band is too narrow to decide its limits: undecided."
        " Measure a full circle in both directions, or decide by the test after loading."
    ),
    "CW-P135": "Circles {circles} as one machine: {machine:if|{machine}|nothing that they show}.",
    "CW-P135.error": (
        "{kind:choose|squareness=squareness|scale=scale|lost motion=lost motion} of {of} {value}"
    ),
    "CW-P135.position_loop": "position loop of {axis} {value}",
    "CW-P136": (
        "{kind:choose|squareness=Squareness|scale=Scale|lost motion=Lost motion|servo"
        " mismatch=Servo mismatch}: the circles contradict each other: {values}. The machine"
        " changed between them, or its errors depend on place, feed or temperature. Repeat"
        " the circle that deviates."
    ),
    "CW-P136.circle": "{circle} {axes} {value}",
    "CW-P140": (
        "Axis {axis}: a new grid is chosen, {grid}, in place of the existing one, {existing}: {why}"
    ),
    "CW-P141": (
        "Axis {axis}: the existing grid {stays:if|stays|does not serve}, {existing},"
        " predicted {parameter} {same} ({new} at new targets); a new one, {grid}, would give"
        " {parameter} {better} ({better_new}): spacing: auto in the table of the axis takes"
        " it; what depends on the old one moves along, or is named where it cannot"
    ),
    "CW-P142.line": (
        "The slope of {slope} goes into a separate straight line. At the table points {left} rms"
        " are left without this line, and {with_line} with it"
    ),
    "CW-P142.table": (
        "The slope of {slope} stays in the table. At the table points {left} rms are left without"
        " a separate straight line, and {with_line} with it"
    ),
    "CW-P143.none": "No table of its own for {period}",
    "CW-P143.period": (
        "the period of {period:g} {unit}, too short for sections of {sections:g}: without a"
        " table of its own {left} rms are left, {with_it} with it"
    ),
    "CW-P143.second": "A second table for {period}",
    "CW-P144": (
        "Axis {axis}: the points are typed by hand, so few are taken: {few}, {mine}. The"
        " other choice is {many}, {other}: start: {start:.10g}, end: {end:.10g}, spacing:"
        " {spacing:.10g} in the table of the axis takes it"
    ),
    "CW-P150": (
        "Axis {axis}: a table will not help here. {parameter} is {now} at new"
        " targets{with_table:if| ({with_table} with it)}; the largest cause is {cause}"
        " ({value:.2f} {unit}, {share:.0%}): {advice}"
    ),
    "CW-P151.cause": (
        "Axis {axis}: of {parameter} {now} at new targets the table takes away {taken:.0%};"
        " most of what is left is {cause} ({value:.2f} of {left}): {advice}"
    ),
    "CW-P151.scatter": (
        "Axis {axis}: of {parameter} {now} at new targets the table takes away {taken:.0%};"
        " {scatter:.0%} is scatter, which no table takes away"
    ),
    "CW-P152": (
        "Axis {axis}: {tables:choose|left=the table of least expected square is taken, not"
        " one for the least {goal}|same=the table of least expected square is the one of"
        " least {goal} too|taken=made for the least {goal}|no_gain=a table made for the least"
        " {goal} shows no less of it in tests that it has not seen, so the table of least"
        " expected square is taken}; expected at new"
        " targets{tables:choose|left=|same=|taken=, in brackets with the table of least"
        " expected square|no_gain=, in brackets with the one made for {goal}}: {parameters}"
        " {unit}"
    ),
    "CW-P152.parameter": "{parameter} {value:.2f}{other:if| ({other:.2f})}",
    "CW-P153": (
        "Axis {axis}: the second table may hold the drift of this test. The reversal changes"
        " by {risen} along the travel. With a constant play, a drift as found, {drifted} from"
        " the first run to the last, would show {shown} of that: it goes on within every run, up"
        " and down. Warm the axis up and measure again before two tables are loaded, or"
        " take one (mode: single)"
    ),
    "CW-P154": (
        "Axis {axis}: the backlash value may hold the drift of this test. The mean reversal"
        " is {measured}; the drift found, {drifted} from the first run to the last, moves it"
        " by {shown} if it goes on within every run, up and down again. Warm the axis up and"
        " measure again before the backlash value is loaded"
    ),
    "CW-P155": (
        "Axis {axis}: stop here: what is left is {cause} ({value:.2f} {unit} of {parameter}"
        " {left:.2f} {unit} at new targets). A further table would change less than one test"
        " differs from the next."
    ),
    "CW-P156": (
        "Axis {axis}: the control never applies a step of the correction above {least:.2f}"
        " and up to {most:.2f} {unit}, and the reversal of the table is"
        " {reversal:.2f}{reversal_to:if| to {reversal_to:.2f}} {unit}. After a reversal the"
        " old correction stays until the table itself changes enough; the prediction counts"
        " with it. The control applies these steps with an acceleration limit of the axis"
        " below {low:3sig} times the present one, or of at least {high:3sig} times: change"
        " it, and run again"
    ),
    "CW-P160": (
        "The readings of test {test} do not look like what its file and state say: they are"
        " {ways:join|, or }. A table made from them would be wrong. {checks:join| }"
    ),
    "CW-P160.check": (
        "{way:choose|off=Was compensation switched on, and the axis referenced, while it was"
        " measured? If not, name that state under measured_in.|sign=Compare one reading with"
        " the instrument: too far in + is a positive deviation.|directions=Look into the"
        " instrument's file which way the axis went in the first run.|order=Compare the"
        " readings at the first and the last target with the instrument's file.|against=Move"
        " the axis in +: if the instrument counts down, the test needs position_map: {{sense:"
        " -1, offset: ..}}.}"
    ),
    "CW-P160.way": (
        "{odds:odds} times more likely {way:choose|off=if the"
        " table of the control was not active in it|sign=with the sign of the deviations"
        " turned (target minus measured)|directions=with + and - exchanged|order=with the"
        " readings in the opposite order of the targets|against=with an instrument that"
        " counts against the machine}"
    ),
    "CW-P161": (
        "The table in state {measured_in} is the mirror image of test {test} ({size:.1f}"
        " {unit}): the table was made from this test and was not active in it. A further"
        " table would correct the same error twice. Measure again with the table active, or"
        " name under measured_in the state in which the test was taken"
    ),
    "CW-P162.after": (
        "the file of the test after loading states compensation {both:if|both on and off|off}, but"
        " the plan loads tables for {names:and}. Check at the control that they are active,"
        " measure again, or correct the key compensation of the file."
    ),
    "CW-P162.both": (
        "the files state compensation both on and off. The new total is wrong if the job is"
        " wrong. Check at the control what was active, then correct the key compensation of"
        " the file, or measured_in and states of the job."
    ),
    "CW-P162.state": (
        "the file states compensation {on:if|on|off}, but the state {state} of the job"
        " {active:if|holds an active table or backlash|holds nothing active} for {names:and}."
        " The new total is wrong if the job is wrong. Check at the control what was active,"
        " then correct the key compensation of the file, or measured_in and states of the"
        " job."
    ),
    "CW-P163": "Axis {axis}, test {test}: its files differ in {keys:join|; }",
    "CW-P164": (
        "Axis {axis}: the error may repeat with a period that these targets cannot show"
        " ({probability:.0%}; most likely {periods:3sig} {unit}). Measure at {targets:.7g} {unit}"
        " in the same test too: all together show such an error from an amplitude of {amplitude}"
        " on."
    ),
    "CW-P165": (
        "Axis {axis}: the test drifts by {drift}, and the prediction assumes the same drift in the"
        " next one: {parameter} {low:.2f} to {high:.2f} {unit} at new targets. If each test has a"
        " drift of its own of that size, {parameter} is {least:.2f} to {most:.2f} {unit}. A second"
        " test in the same way decides: add its file to before of the axis"
    ),
    "grid.even": "{points} points from {start:.10g} to {end:.10g} {unit}, every {step:.6g} {unit}",
    "grid.few": "{points} points",
    "grid.predicted": "predicted {name} {value:.2f} {unit} ({elsewhere:.2f} at new targets)",
    "grid.uneven": (
        "{points} points from {start:.10g} to {end:.10g} {unit}, {least:.6g} to {most:.6g} {unit}"
        " apart"
    ),
    "run.no_state": (
        "no table is written: the job does not say what is active in the control; add states:"
        " {{as_found: none}} or states: {{as_found: [files of the control]}}"
    ),
    "table_advice": (
        "{cause:choose|noise=the axis does not repeat, which no table corrects: check first "
        "how the instrument is mounted (vibration, air, fixing), then call a mechanic (play, "
        "guides, bearings, coupling, scale)|single outliers=a few readings are outliers, "
        "which no table corrects: find what disturbs the measurement (interrupted beam, "
        "settling time, dirt), and measure again|shifts between traverses=whole traverses are"
        " shifted, which no table corrects: check whether instrument, spindle and clamping "
        "are firm, and look for play that differs from run to run|drift=the axis changes "
        "during the test, which no table corrects: warm it up as in work until it is stable, "
        "and measure again|one table for both directions=the reversal changes along the "
        "travel, and one table with one reversal value cannot hold that: call a mechanic "
        "(nut, screw, guides), or use a control with a table for each direction|spacing too "
        "wide for the period=the points are too far apart for so short a period; CW-F002 "
        "gives the interval that is needed. If the control cannot hold it, call a mechanic "
        "(screw, its bearings and coupling, gear, encoder)|error that the test leaves "
        "open=the test does not determine the error well enough: measure more targets or more"
        " runs}"
    ),
}
