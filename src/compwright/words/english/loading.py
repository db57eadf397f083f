"""What a test after loading shows."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-V001": "{verdict}",
    "CW-V010": "Axis {axis}: what was read back from the control is the plan's table.",
    "CW-V011": (
        "Axis {axis}: what was read back from the control differs from the plan by up to"
        " {difference:.2f} {unit}."
    ),
    "CW-V020": (
        "The test after loading does not cover what the first one did: {gaps:join|; }."
        " Measure {targets} targets from {range}, as before."
    ),
    "CW-V020.approaches": (
        "it has {runs} {runs:plural|approach|approaches} in {direction} (the first test: {first})"
    ),
    "CW-V020.fewer": "it has {targets} {targets:plural|target|targets}",
    "CW-V020.fewest": (
        "it has {targets} {targets:plural|target|targets}, and the standard asks for {fewest}"
        " at least"
    ),
    "CW-V020.gap": "{gap} of the travel are without a target",
    "CW-V020.range": "it covers {range}",
    "CW-V021": (
        "Repeated readings scatter by {scatter}, {ratio:3sig} times {less:if|less|more} than"
        " in the first test ({first}). Where the noise of two tests differs by up to {factor:g}"
        " times, chance alone does this less than once in 1000 tests. Are unit and readings"
        " right? Measure again with the instrument set as for the first test."
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
        "Axis {axis} was not measured after loading, so nothing is proven for it. Measure it as"
        " for the test {test}."
    ),
    "CW-V023.circle": (
        "Circle {circle} has limits and was not measured after loading, so nothing is proven for"
        " it. Measure it again and give it as --after {circle}=FILE."
    ),
    "CW-V023.scale": (
        "The scale of axis {axis} came from circles, and none was measured after loading, so"
        " nothing is proven for it. Measure the circle {circles:if|{circles:join| or }|of this"
        " plane} again."
    ),
    "CW-V023.squareness": (
        "The squareness of {plane} was corrected and not measured after loading, so nothing is"
        " proven for it. Measure the circle {circles:if|{circles:join| or }|of this plane} again."
    ),
    "CW-V023.test": (
        "The limits of axis {axis} are for the test {meant}, and {measured} was measured, so"
        " nothing is proven for them. Measure as for {meant} and give it as --after {meant}=FILE."
    ),
    "CW-V024": "The test after loading, {code}: {finding} Clear this up, or measure again.",
    "CW-V025": (
        "The file given with --after for circle {circle} is one from before loading. Measure the"
        " circle again."
    ),
    "CW-V026.certain": (
        "This cannot be right: {why}. Export the test in the unit that its file states."
    ),
    "CW-V026.copied": (
        "The readings are those of the test {test} from before"
        " loading{way:choose|same=|sign=, with the sign turned|direction=, with the"
        " directions exchanged}. Measure the axis anew."
    ),
    "CW-V026.file_twice": (
        "The test of axis {axis} holds one file twice. Give each measurement once."
    ),
    "CW-V026.one_run": (
        "All runs hold the same readings: one run was copied. Measure the axis anew."
    ),
    "CW-V026.scatter": (
        "The scatter of the readings is that of the test {test} run by run (correlation"
        " {correlation:.2f}): the test was made from it. Measure the axis anew."
    ),
    "CW-V026.targets": "The targets of the test are in {unit}, not in mm. Export it in mm.",
    "CW-V026.thousand": (
        "The readings scatter by {scatter}, those of the first test by {first}: 1000 times"
        " too {small:if|small (mm read as µm)|large (µm read as mm)}. Export the test in the"
        " unit that its file states."
    ),
    "CW-V026.two_axes": (
        "Axis {axis} and axis {other} were given the same measurement. Give each axis its own."
    ),
    "CW-V026.zeros": (
        "Every reading of the test is the same: nothing was measured. Measure the axis."
    ),
    "CW-V027": "{verdict}",
    "CW-V028": "{verdict}",
    "CW-V030": (
        "Tests {off} (without it) and {on} (with it): the table of state {state} was active as its"
        " files say, {percent:.1f} % sure."
    ),
    "CW-V031": (
        "Tests {off} (without it) and {on} (with it) do not show whether the table of state {state}"
        " was active as its files say: {likely:if|{likely}|no known cause fits}. They count"
        " as far as they agree."
    ),
    "headline.active": "Table{tables:plural||s} active. No limits given.",
    "headline.bad": "Bad: see the {circles:if|circles|axes} below",
    "headline.good": (
        "Good: the tables are active and the limits are met"
        "{without:if| (no limits given for {without})|}"
    ),
    "headline.undecided": "Undecided: the tests do not tell",
    "loading.likely": "{verdict} {percent:.0f} %",
    "loading.as_before": "The test lies within {left} of what the control did before.",
    "loading.as_predicted": "The test lies within {left} of the prediction.",
    "loading.candidate": "{name} ({sure:if|more than 99|{percent:2sig}} %)",
    "loading.declared_slope": (
        "Over the travel its deviations rise by {slope:+.2f} ± {error:.2f} µm/m more than"
        " expected: steel does that over {kelvin:+2sig} K, {within:if|within|beyond} what the"
        " job declares for two tests (± {declared:.1f} µm/m, k = 2). The table is not at"
        " fault, but the limits are decided with the slope in the readings."
    ),
    "loading.effect": "{part:.2f} ± {error:.2f} of the planned effect",
    "loading.equivalent": (
        "The same test would come from: {names}. No measurement of this axis tells them"
        " apart; {read_back:if|the values that were read back from the control are the plan's"
        " (--loaded)|the values that are read back from the control do (--loaded)}."
    ),
    "loading.evidence": (
        "Against the prediction the test is off by {off} and at worst by {worst}; with this"
        " explanation {left} are left, and the noise of a reading is {noise}.{effect:if|"
        " Measured: {effect}.}"
    ),
    "loading.measurement": (
        "The after test is explained when {fault:choose|sign=the sign of its deviations is"
        " turned|direction=its directions + and − are exchanged|unit=its readings are"
        " multiplied by {factor:4sig}|wrong_axis=it is one of {axis}}. As it is, nothing"
        " explains it. {fault:choose|sign=Check sign and directions of the instrument and"
        " export the test again.|direction=Check sign and directions of the instrument and"
        " export the test again.|unit=Export it in the unit that its file"
        " states.|wrong_axis=Measure this axis, or give the file to its own axis.}"
    ),
    "loading.name": "{name}{detail:if|: {detail}}",
    "loading.neither": (
        "The after test fits neither the loaded table nor the control as it was before, nor"
        " any known fault of loading.{loaded:if| Against the prediction it is off by {loaded}"
        " and at worst by {loaded_worst}.}{inactive:if| Against no change it is off by"
        " {inactive} and at worst by {inactive_worst}.}{offset:if| Against the prediction the"
        " + approaches lie {offset} {above:if|above|below} the - approaches on"
        " average.}{effect:if| Measured: {effect}.}"
    ),
    "loading.no_table": "The plan holds no table for this axis: nothing was to be loaded.",
    "loading.open": (
        "Cannot tell what was loaded: the new table changes the deviations by {size} rms, and the"
        " noise of a reading is {noise}{needed:if|; the correction is smaller than the {needed}"
        " rms that this test can prove}{effect:if|. Measured: {effect}}. Possible:"
        " {candidates}.{off:if| But the test deviates from the first of these by {off}, at worst"
        " by {worst}. That is more than noise: something else changed, or the test is at fault.}"
    ),
    "loading.rms": "{rms} rms",
    "loading.slope": (
        "Over the travel its deviations rise by {slope:+.2f} ± {error:.2f} µm/m more than"
        " expected: steel does that over {kelvin:+2sig} K{declared:if| (declared for two"
        " tests: ± {declared:.1f} µm/m, k = 2)}. State the temperature of the scale in the"
        " files of both tests (T_m) and its coefficient in the job (thermal), or measure"
        " again once machine and instrument have settled; look at the instrument's"
        " temperature sensor."
    ),
    "loading.straight_line": (
        "The after test is that of the loaded table and a slope. {slope} The correction is a"
        " straight line itself: a table that is active with factor {factor:.2f} would show"
        " the same; {read_back:if|the values that were read back from the control are the"
        " plan's (--loaded)|read the values back from the control (--loaded)}."
    ),
    "loading.thermal": (
        "The table is active: apart from a slope the after test is within {left} of the"
        " prediction. {slope}"
    ),
    "loading.too_few": "Cannot tell: the after test has fewer than 3 measured means.",
    "loading.verdict": (
        "{verdict:choose|loaded=The table is active as planned{effect:if|: the after test"
        " shows {effect}}|not_active=The table is not active{detail:if|"
        " ({detail})}{effect:if|: the after test shows {effect}}|inverted=The table is active"
        " with the opposite sign{detail:if| ({detail})}: it adds to the error|scaled=The"
        " table is active with factor {factor:3sig}{detail:if| ({detail})}|shifted=The table"
        " is {nodes} {nodes:plural|node|nodes} too far to {direction}{detail:if|"
        " ({detail})}|mirrored=The table is loaded back to front, its last value"
        " first{detail:if| ({detail})}|wrong_axis=The table that is active is that of axis"
        " {axis}{detail:if| ({detail})}|one_direction=The table is active in one direction"
        " only: {detail}|backlash=The table is active, and its backlash is wrong:"
        " {detail}|partial=A part of the table is active: {detail}|increment=Only the change"
        " to the existing table is active{detail:if| ({detail})}: load the total, which is in"
        " the written files|on_top=The new total was added to the existing table{detail:if|"
        " ({detail})}: clear the table and load the written files again|state=The existing"
        " table was not active while the test before was taken, although the job says that it"
        " was. Run the job again with `active: no` for this state}."
    ),
    "loading.worst": "{value} ({position} approached in {direction})",
    "next.between_again": "{output} over {input}: looked at again, from the circles after loading",
    "next.between_kept": "{output} over {input}: it keeps what is in the control",
    "next.cannot_be_made": "the next round cannot be made: {reason}",
    "next.circles_only": (
        "its table came from circles, which do not show its effect: it keeps what is in the control"
    ),
    "next.differs": "what was read back differs from the plan: {why}{quantity:if| ({quantity})}",
    "next.doubted": "its test after loading is in doubt ({code}: {message})",
    "next.gained": (
        "a further table is written: {parameter} from {now:.2f} to {then:.2f} {unit} at new targets"
    ),
    "next.kept": "{why}: it keeps what is in the control, and gets no further table",
    "next.load": (
        "a further table for {axes}{between:if|{axes:if|, }squareness}: load all of next/tables,"
        " measure again, and verify that round"
    ),
    "next.no_axis": "no axis may be corrected further",
    "next.no_table": (
        "the plan holds no table for it, none was loaded: it keeps what is in the control"
    ),
    "next.not_compared": "what was read back cannot be compared with the plan: {why}",
    "next.not_measured": "it was not measured after loading: it keeps what is in the control",
    "next.read_back_differs": (
        "what was read back differs from the plan: {axes:join|; } ({quantity}{more:if| and {more}"
        " more}; compwright compare lists all). Read back what is in the control now, load what is"
        " missing, and verify again"
    ),
    "next.something_else": (
        "something else was changed in the control since the run: {quantity}{axis:if| of axis"
        " {axis}}{more:if| and {more} more} (compwright compare lists all); check that first, then"
        " run a new job"
    ),
    "next.squareness_alone": (
        "no axis may be corrected further, and squareness alone gets no next round:"
        " {measured:if|measure an axis that has a table after loading too, and give it with"
        " --after in addition to the circles|for what is left of it run a new job, with what was"
        " read back as as_found and with the circles after loading}"
    ),
    "next.stop": "stop here: no further table for {axes} would gain what a test can show",
    "next.stop_axis": "{stop:if|stop here|no further table}: {why}",
    "next.verdict": (
        "the verdict is {verdict:choose|not_active=not"
        " active|inverted=inverted|scaled=scaled|shifted=shifted|mirrored=mirrored|wrong_axis=wrong"
        " axis|on_top=on top|one_direction=one"
        " direction|partial=partial|thermal=thermal|undecided=undecided|={name}}{of:if| ({of})},"
        " not loaded"
    ),
    "next.written": "a further table is written",
}
