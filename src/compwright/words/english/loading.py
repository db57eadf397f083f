"""Sentences about a test after loading."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-V001": "{verdict}",
    "CW-V010": (
        "Axis {axis}: the table that was read back from the control agrees with the table of the"
        " plan."
    ),
    "CW-V011": (
        "Axis {axis}: the table that was read back from the control differs from the plan by up"
        " to {difference:.2f} {unit}. Run compwright compare to see where."
    ),
    "CW-V011.others": (
        "What was read back from the control differs from the plan outside of its axis tables:"
        " {entries}{more:if| and {more} more|}. Run compwright compare to see where."
    ),
    "CW-V012": (
        "Axis {axis}: this test would not show whether its table was exchanged with that of"
        " {others:join| or }. To exclude this, read the control's files back and give them with"
        " `--loaded`."
    ),
    "CW-V020": (
        "The test after loading covers less than the first test: {gaps:join|; }. Measure"
        " {targets} targets from {range}, as before."
    ),
    "CW-V020.approaches": (
        "it has {runs} {runs:plural|approach|approaches} in {direction} (the first test: {first})"
    ),
    "CW-V020.fewer": "it has {targets} {targets:plural|target|targets}",
    "CW-V020.fewest": (
        "it has {targets} {targets:plural|target|targets}, and the standard asks for {fewest}"
        " at least"
    ),
    "CW-V020.gap": "over {gap} of the travel there is no target",
    "CW-V020.range": "it covers {range}",
    "CW-V021": (
        "{circle:if|The readings of the circle|Repeated readings} scatter by {scatter},"
        " {beyond:if|more than |}{ratio:3sig} times {less:if|less|more} than in the first test"
        " ({first}). By chance this happens in less than one of 1000 tests, even if the noise of"
        " the two tests differs by a factor of up to {factor:g}. Check unit and readings. Measure"
        " again with the instrument set as for the first test."
    ),
    "CW-V022": (
        "The job was edited after the run: {what:choose|standard=the standard|rule=the decision"
        " rule|axis_limits=the limits of axis {of}|circle_limits=the limits of circle"
        " {of}|uncertainty=the declared uncertainty of {of} axes|circle_uncertainty=the declared"
        " uncertainty of circular tests} {several:if|were|was} {was:if|{was}|none}, now"
        " {several:if|they are|it is} {now:if|{now}|none}. Run the job again, so that prediction"
        " and verdict use the same values."
    ),
    "CW-V023.axis": (
        "Axis {axis} was not measured after loading, so the result is not proven for it."
        " Measure it as for the test {test}."
    ),
    "CW-V023.circle": (
        "Circle {circle} has limits and was not measured after loading, so the result is not"
        " proven for it. Measure it again and give it as --after {circle}=FILE."
    ),
    "CW-V023.scale": (
        "The scale error of axis {axis} was corrected from circular tests, and no circle"
        " after loading shows clearly enough whether this is active, so"
        " the result is not proven for it. Measure the circle {circles:if|{circles:join| or }|of"
        " this plane} again."
    ),
    "CW-V023.squareness": (
        "The squareness of {plane} was corrected and not measured after loading, so the result"
        " is not proven for it. Measure the circle {circles:if|{circles:join| or }|of this"
        " plane} again."
    ),
    "CW-V023.test": (
        "The limits of axis {axis} are for the test {meant}, but after loading {measured} was"
        " measured. Whether the limits are met is therefore not proven. Measure as for {meant} and"
        " give it as --after {meant}=FILE."
    ),
    "CW-V024": (
        "With this warning about the test after loading the verdict cannot be good ({code}):"
        " {finding} Remove its cause, then measure again."
    ),
    "CW-V025": (
        "The file given with --after for circle {circle} was measured before loading. Measure the"
        " circle again."
    ),
    "CW-V026.certain": (
        "The readings cannot be right: {why}. Export the test in the unit that its file states."
    ),
    "CW-V026.copied": (
        "This file contains the readings of the test {test} from before"
        " loading{way:choose|same=|sign=, with the sign reversed|direction=, with the directions"
        " exchanged}. Measure the axis anew."
    ),
    "CW-V026.file_twice": (
        "The test of axis {axis} contains one file twice. Give each measurement once."
    ),
    "CW-V026.one_run": (
        "All runs contain the same readings: one run was copied. Measure the axis anew."
    ),
    "CW-V026.scatter": (
        "Run by run, the readings scatter exactly as in the test {test} (correlation"
        " {correlation:.2f}). So this test was calculated from that one. Measure the axis anew."
    ),
    "CW-V026.targets": "The targets of the test are in {unit}, not in mm. Export it in mm.",
    "CW-V026.thousand": (
        "The readings scatter by {scatter}, those of the first test by {first}. They are 1000"
        " times too {small:if|small (mm read as µm)|large (µm read as mm)}. Export the test in"
        " the unit that its file states."
    ),
    "CW-V026.turned": (
        "Lost motion or servo mismatch has the opposite sign of the first test: {what:join|; }. The"
        " sign of the deviations is turned in this file, or ccw and cw are exchanged. Check both,"
        " and export the test again."
    ),
    "CW-V026.two_axes": (
        "Axis {axis} and axis {other} were given the same measurement. Give each axis its own file."
    ),
    "CW-V026.zeros": (
        "Every reading of the test is the same, so nothing was measured. Measure the axis."
    ),
    "CW-V027": "{verdict}",
    "CW-V028": "{verdict}",
    "CW-V029": (
        "The test{circle:if| of circle {circle}|} after loading is dated {date}, and the first test"
        " {first}. An older test does not show what was loaded. Check the file and its date, or"
        " measure again."
    ),
    "CW-V030": (
        "The tests {off} (without the table) and {on} (with it) show that the existing table"
        " (states.{state} in the job) was active as its files say ({percent:.1f} % sure)."
    ),
    "CW-V031": (
        "The tests {off} (without the table) and {on} (with it) do not show whether the existing"
        " table (states.{state} in the job) was active as its files say: {likely:if|{likely}|no"
        " known cause fits}. The two tests are used only as far as they agree."
    ),
    "CW-V032": (
        "The test{circle:if| of circle {circle}|} after loading is of the machine with the serial"
        " number {found}, but this machine has {known:join| or }. A test of another machine does"
        " not show what was loaded. Give the file of this machine, or correct the number in the"
        " job or the file."
    ),
    "CW-V033": (
        "What was read back from the control leaves a doubt: {doubts:join|; }. Read back all files"
        " of the control again, and give all of them with --loaded."
    ),
    "CW-V034": (
        "Circle {circle} after loading is not the circle of the first test: {what:join|; }."
        " Deviations depend on radius, feed and arc, so they cannot be compared with the"
        " prediction{limits:if|, and the limits stay undecided|}. The squareness is compared all"
        " the same. Measure the circle as the first time."
    ),
    "CW-V034.arc": (
        "it runs from {start:.0f}° to {end:.0f}° (the first one from {was_start:.0f}° to"
        " {was_end:.0f}°)"
    ),
    "CW-V034.feed": "its feed is {now:g} mm/min (of the first one {was:g} mm/min)",
    "CW-V034.radius": "its radius is {now:g} mm (of the first one {was:g} mm)",
    "CW-V035": (
        "{axis:if|The scale error of axis {axis}|The squareness} after loading is {value:.1f}"
        " µm/m. {expected:.1f} µm/m was predicted, ± {U:.1f} µm/m from the noise of the two tests"
        " (k = 2). {verdict:choose|loaded=The correction is active; a new set-up of the"
        " instrument or a change of the machine can leave this rest.|not_active={loading} Check"
        " that it is loaded and switched on.|inverted={loading} Check the sign of the table, and"
        " load it again.|increment={loading} The existing correction is missing."
        " {step}|read_back=The table that was read back differs from the plan"
        " (CW-V011).|uncertain=The tests are too uncertain to name the fault. Measure the full"
        " circle again in both directions.|={loading} {step}}{negligible:if| Below"
        " {negligible:.0f} µm/m it is accepted.|}"
    ),
    "CW-V035.open": (
        "The circle after loading does not determine the squareness well enough to show that its"
        " correction is active. Measure the full circle again in both directions."
    ),
    "CW-V035.step": (
        "{as_planned:if|What was read back is as planned: check that all tables are switched on,"
        " and measure the circle again.|Compare what is loaded with the plan.}"
    ),
    "CW-V036": (
        "The circle after loading is not as predicted: {what:join|; }. Compare what is loaded with"
        " the plan. Feed, noise, the set-up of the instrument, a warmer machine, friction or servo"
        " parameters can also be the reason. Check them, and measure again as for the first test."
        " If this stays, the machine has changed: start a new job from this circle and the present"
        " files of the control."
    ),
    "CW-V036.value": "{name} {value} (predicted {low} to {high})",
    "headline.active": "Table{tables:plural||s} active. No limits given.",
    "headline.bad": "Bad: see the {circles:if|circles|axes} below",
    "headline.good": (
        "Good: the tables are active and the limits are met"
        "{without:if| (no limits given for {without})|}"
    ),
    "headline.undecided": (
        "Undecided: the tests do not show whether the table is active or the limits are met"
    ),
    "loading.likely": "{verdict} {percent:.0f} %",
    "loading.as_before": (
        "The test differs by {left} from what it would show if the control were still as before"
        " loading."
    ),
    "loading.as_predicted": "The test differs by {left} from the prediction.",
    "loading.backlash": (
        "{kind:choose|missing=missing|twice=twice|sign=with the wrong sign|old=the old value"
        " instead of the new one|added=the old value added to the new one}"
    ),
    "loading.candidate": "{name} ({sure:if|more than 99|{percent:2sig}} %)",
    "loading.circle": (
        "{candidates:if|The test after loading shows {effect}. These causes are possible:"
        " {candidates}.|No known loading fault explains this{effect:if|: the test after loading"
        " shows {effect}}. Measure the circle again.}"
    ),
    "loading.declared_slope": (
        "Over the travel the deviations of this test rise by {slope:+.2f} ± {error:.2f} µm/m more"
        " than expected. Steel shows such a slope when its temperature changes by {kelvin:+2sig} K,"
        " which is {within:if|within|beyond} what the job declares for two tests (± {declared:.1f}"
        " µm/m, k = 2). The table is not at fault, but the readings that decide whether the limits"
        " are met contain this slope."
    ),
    "loading.effect": "{part:.2f} ± {error:.2f} of the planned effect",
    "loading.equivalent": (
        "These faults would give the same readings: {names}. No measurement of this axis can tell"
        " them apart. {read_back:if|The values that were read back from the control decide this:"
        " they equal the planned values (--loaded)|Read the values back from the control and give"
        " them with --loaded}."
    ),
    "loading.evidence": (
        "The measured deviations differ from the predicted ones by {off}, at worst by {worst}."
        " They differ by {left} from those that the fault named in the verdict would give; the"
        " noise of a reading is {noise}.{effect:if| Measured: {effect}.}"
    ),
    "loading.factor": (
        "{factor:choose|2=twice: radius and diameter mixed up, loaded on top of itself, or twice"
        " the magnification|0.5=half: radius and diameter mixed up|10=ten times: another"
        " detection unit or increment system|0.1=a tenth: another detection unit or increment"
        " system|16=16 times: multiplied by 16 twice|0.0625=1/16: counts entered in place of"
        " 1/16 counts|25.4=25.4 times: values in mm entered as inch|0.03937=1/25.4: values in"
        " inch entered as mm|1000=a thousand times: values in µm entered as mm|0.001=a"
        " thousandth: values in mm entered as µm}"
    ),
    "loading.in_order": (
        "entered in the order of the positions, the {end:choose|low=lowest|high=highest} one"
        " first; the control counts the entries from its zero point"
    ),
    "loading.instead": (
        "{active:choose|still=what was in the control before is still active|before=what was in the"
        " control before is active|nothing=nothing at all is active|backlash=only the new backlash"
        " is active}"
    ),
    "loading.measurement": (
        "The test after loading itself seems wrong. It agrees with the first test and the plan only"
        " if {fault:choose|sign=the sign of its deviations is reversed|direction=its directions +"
        " and − are exchanged|unit=its readings are multiplied by {factor:4sig}|wrong_axis=it is a"
        " test {axis}}. {fault:choose|sign=Check sign and directions of the instrument and"
        " export the test again.|direction=Check sign and directions of the instrument and export"
        " the test again.|unit=Export the test in the unit that its file states.|wrong_axis=Measure"
        " this axis, or give the file to the axis that it belongs to.}"
    ),
    "loading.name": (
        "{name:choose|loaded=loaded|not_active=not active|inverted=opposite sign|scaled=wrong"
        " factor|shifted=shifted along the axis|mirrored=back to front|wrong_axis=table of another"
        " axis|one_direction=active in one direction only|backlash=wrong backlash"
        " value|partial=only a part is active|increment=only the change loaded|on_top=added to the"
        " existing table|state=existing table not active in the first test|thermal=another"
        " temperature|measurement=wrong measurement|undecided=undecided}{detail:if|: {detail}}"
    ),
    "loading.neither": (
        "The test after loading fits neither the loaded table, nor the control as it was before,"
        " nor a known fault of loading.{loaded:if| It differs from the prediction by {loaded}, at"
        " worst by {loaded_worst}.}{inactive:if| It differs by {inactive}, at worst by"
        " {inactive_worst}, from what it would show with the control as it was before.}{offset:if|"
        " Compared with the prediction, the approaches in + lie on average {offset}"
        " {above:if|above|below} those in −.}{effect:if| Measured: {effect}.}"
    ),
    "loading.no_table": "The plan contains no table for this axis: nothing was to be loaded.",
    "loading.of_axis": "of axis {axis}",
    "loading.one_direction": (
        "approaches{axis:if| of {axis}|} in {direction} only; in the other direction"
        " {other:choose|before=the correction is as before|nothing=no correction is"
        " active|backlash=only the new backlash is active}"
    ),
    "loading.open": (
        "This test cannot show what was loaded. The new table changes the deviations by {size} rms,"
        " and the noise of a reading is {noise}{needed:if|. This correction is smaller than the"
        " {needed} rms that the test can prove}{effect:if|. Measured: {effect}}. These causes are"
        " possible: {candidates}.{off:if| But the measured deviations differ by {off}, at worst by"
        " {worst}, from those that the first of these causes would give. That is more than noise:"
        " something else changed, or the test is at fault.}"
    ),
    "loading.other_axis": (
        "that of axis {axis}, at the same {by:choose|position=positions|number=point numbers}"
    ),
    "loading.part": (
        "{first:if|up to|from} point {number} ({position:g}){first:if|| on},"
        " {beyond:choose|nothing=no correction elsewhere|last=the last value elsewhere|old=the old"
        " values elsewhere|old_steps=the old increments elsewhere|no_backlash=no correction and no"
        " backlash elsewhere|before=all as before elsewhere}"
    ),
    "loading.rms": "{rms} rms",
    "loading.slope": (
        "Over the travel the deviations of this test rise by {slope:+.2f} ± {error:.2f} µm/m more"
        " than expected. Steel shows such a slope when its temperature changes by {kelvin:+2sig}"
        " K{declared:if| (declared for two tests: ± {declared:.1f} µm/m, k = 2)}. Give the"
        " temperature of the scale in the files of both tests (T_m) and its coefficient in the job"
        " (thermal). Or let machine and instrument settle, check the instrument's temperature"
        " sensor, and measure again."
    ),
    "loading.steps": "increments in reverse order",
    "loading.straight_line": (
        "The test after loading shows the loaded table and an additional slope. {slope} The"
        " correction itself is a straight line, so a table that is active with factor {factor:.2f}"
        " would show the same. {read_back:if|The values that were read back from the control equal"
        " the planned values (--loaded)|To decide, read the values back from the control and give"
        " them with --loaded}."
    ),
    "loading.table": "the table is {active:if|active|not active}",
    "loading.thermal": (
        "The table is active. Apart from a slope, the test after loading differs by {left} from"
        " the prediction. {slope}"
    ),
    "loading.too_few": (
        "The test after loading has fewer than 3 measured means, which is too few to show what"
        " was loaded. Measure more targets."
    ),
    "loading.variant": (
        "{detail:if|{detail}, }{backlash:choose|old=with the old backlash|apart=apart from the"
        " backlash|table=only in the table of the backlash}"
    ),
    "loading.verdict": (
        "{verdict:choose|loaded=The table is active as planned{effect:if|: the test after loading"
        " shows {effect}}|not_active=The table is not active{detail:if| ({detail})}{effect:if|: the"
        " test after loading shows {effect}}|inverted=The table is active with the opposite"
        " sign{detail:if| ({detail})} and makes the error larger|scaled=The table is active with"
        " factor {factor:3sig}{detail:if| ({detail})}|shifted=The table is shifted by {nodes} table"
        " {nodes:plural|point|points} in direction {direction}{detail:if| ({detail})}|mirrored=The"
        " table is loaded back to front, its last value first{detail:if| ({detail})}|wrong_axis=The"
        " active table is {detail}|one_direction=The table is active in one direction only:"
        " {detail}|backlash=The table is active, but the backlash value is wrong:"
        " {detail}|partial=Only a part of the table is active: {detail}|increment=Only the change"
        " to the existing table is active{detail:if| ({detail})}{open:if||. Load the total, which"
        " is in the written files}|on_top=The control added the new total to the existing"
        " table{detail:if| ({detail})}{open:if||. Clear the table and load the written files"
        " again}|state=The existing table was not active during the first test, although the job"
        " says so{open:if||. Run the job again with `active: no` in the entry of `states` that was"
        " in the control during the first test (measured_in)}}."
    ),
    "loading.worst": "{value} ({position} approached in {direction})",
    "next.between_again": (
        "the correction of {output} over {input} was estimated again from the circles after loading"
    ),
    "next.between_kept": "the correction of {output} over {input} stays as it is in the control",
    "next.cannot_be_made": "the tables of the next correction round cannot be made: {reason}",
    "next.circles_only": (
        "the table of this axis was calculated from circular tests only, and a next round corrects"
        " only axes that have a positioning test. The axis keeps what is in the control"
    ),
    "next.differs": "what was read back differs from the plan: {why}{quantity:if| ({quantity})}",
    "next.doubted": (
        "a finding about the test of this axis after loading is not resolved ({code}: {message})"
    ),
    "next.gained": (
        "a new table is written. It is expected to change {parameter} at new targets"
        " from {now:.2f} to {then:.2f} {unit}"
    ),
    "next.kept": ("{why}. The axis keeps what is in the control, and gets no new table"),
    "next.load": (
        "a new table was written for {axes}{between:if|{axes:if|, and for the }squareness}. Load"
        " all files of next/tables, measure again, and run compwright verify with next/job.yaml"
    ),
    "next.no_axis": "no axis gets a new table",
    "next.no_table": (
        "the plan contains no table for this axis, so none was loaded. The axis keeps what is in"
        " the control"
    ),
    "next.not_compared": "what was read back cannot be compared with the plan: {why}",
    "next.not_measured": (
        "this axis was not measured after loading. The axis keeps what is in the control"
    ),
    "next.read_back_differs": (
        "what was read back differs from the plan: {axes:join|; } ({quantity}{more:if| and {more}"
        " more}; compwright compare lists all). Load what is missing, read the control's contents"
        " back again, and verify again"
    ),
    "next.something_else": (
        "other values in the control were changed since the run: {quantity}{axis:if| of axis"
        " {axis}}{more:if| and {more} more} (compwright compare lists all). Check these changes"
        " first, then run a new job"
    ),
    "next.squareness_alone": (
        "no axis gets a new table, and therefore the squareness is not corrected further either."
        " {measured:if|To correct it further, measure at least one axis that has a table after"
        " loading, and give its test with --after together with the circles|To correct it further,"
        " make a new job: give the files that were read back as as_found, and the circles that"
        " were measured after loading}"
    ),
    "next.squareness_not_active": (
        "no new table: the circles do not show that the correction of the squareness of {planes}"
        " is active as planned, and a further one could be added to a fault. Correct this first,"
        " and measure the circle again"
    ),
    "next.stop": (
        "stop here: the gain of another correction round for {axes} would be too small to show"
        " in a test"
    ),
    "next.stop_axis": "{stop:if|stop here|no new table}: {why}",
    "next.stop_squareness": (
        "{stop:if|stop here: the squareness of {planes} needs no further correction|no new table:"
        " the squareness of {planes} after loading is too uncertain for a further correction."
        " Measure the circle again}"
    ),
    "next.verdict": (
        'the verdict is "{verdict:choose|not_active=not active|inverted=inverted|scaled=scaled|'
        "shifted=shifted|mirrored=mirrored|wrong_axis=wrong axis|increment=only the change loaded|"
        "on_top=added to the existing table|state=existing table not active in the first test|"
        "one_direction=one direction|partial=partial|thermal=thermal|undecided=undecided|"
        '={name}}{of:if| ({of})}", not "loaded"'
    ),
    "next.written": "a new table is written",
    "read_back.backlash": (
        "all values for the approach in {direction} differ by the same amount: the backlash value"
        " is not the planned one"
    ),
    "read_back.cause": (
        "{cause:choose|loaded=the table in the control is the planned table|before=what was in"
        " the control before is still there|nothing=no table is active: it is off or"
        " empty|increment=only the change to the existing table was loaded: load the"
        " total|on_top=the new total was added to the existing table: clear the table and load"
        " it again|inverted=every value has the opposite sign}{apart:if| (apart from the"
        " backlash)|}"
    ),
    "read_back.one_side": (
        "only the values for the approach in {direction} equal the planned values"
    ),
    "read_back.other": (
        "the values differ at {off} of {number} positions (each direction counted); no known"
        " mistake explains all of these differences"
    ),
    "read_back.own": (
        "the files that compwright run wrote contain the planned table. They do not show what is in"
        " the control"
    ),
    "read_back.partly": (
        "only {loaded:and} was loaded: load {missing:and} too, before the axis moves; {why}"
    ),
    "read_back.scaled": (
        "every value differs from the planned one by a factor ({factor}){apart:if| (apart from"
        " the backlash)|}"
    ),
    "read_back.shifted": (
        "the table is {points} {points:plural|point|points} too far to {towards}{apart:if|, and"
        " the values of each direction also differ from the plan by a constant: the reference"
        " point has a different number or position|}"
    ),
}
