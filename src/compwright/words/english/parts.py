"""Sentences and parts of sentences that several findings use."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "as_written": "{text}",
    "backlash_compensation_larger": (
        "{finding} The control's files explain it: their backlash compensation is larger than the"
        " lost motion of the axis."
    ),
    "better_targets": "targets that would show this error: {targets:g} {unit}",
    "between.axes": "{output} over {input}",
    "between.deviation": "the measured deviation of {output} over {input} ({slope})",
    "between.fault": (
        "{where:if|{where}: |}{message}{expected:if|; expected {expected}|}"
        "{found:if|, found {found}|}{hint:if|. Next: {hint}|}"
    ),
    "between.faults": "{faults:join|; }",
    "between.racked": (
        "{output} is a gantry axis, and a table on {output} without {partner} racks the machine."
        " Next: {squareness:if|correct the squareness by the reference offset of the"
        " gantry{instead:if|, or move axis {input} instead (`{instead}`)|}|have the guideway of"
        " {input} aligned, and remove this entry from the job: no other table corrects a"
        " straightness}"
    ),
    "between.squareness": "squareness of {output} over {input} ({slope:+.1f} µm/m)",
    "circle.mean": "mean of {axes:and}",
    "circle.part": "{start:.5g}° to {end:.5g}°",
    "compared_not_removed": "{parameters:join|; }. The result contains all readings.",
    "direct_squareness": (
        "{input} and {output}: squareness {squareness:+.1f} µm/m according to the"
        " {measurements:plural|direct measurement|sum of the direct measurements of both axes}"
    ),
    "doubts.acknowledged": "Acknowledged in the job: {reason}. {message}",
    "doubts.compare": (
        "What is in the control may differ from the files that were compared. Read its files back"
        " again, completely, and repeat compwright compare"
    ),
    "doubts.first": "Check first: the result depends on these findings",
    "doubts.step": (
        "Nothing is decided until these findings are cleared up. Correct the test or the job and"
        " run again. If the measurement is right as it is, write in the job why: `acknowledged:"
        " {{{codes:join|: reason, }: reason}}`"
    ),
    "in_direction": "{value} in {direction}",
    "increments": "{symmetric:if|±{largest}|{least} to {largest}}",
    "listed": "{items:join|; }{more:if|; and {more} more}",
    "listed_places": "{items}{more:if| and {more} more}",
    "odds.1_to": "odds {odds:2sig} to 1 against it",
    "odds.above_1000": "more than 1000 times as likely as not",
    "odds.over_1000": "more than 1000 times as likely as not",
    "odds.to_1": "{odds:2sig} times as likely as not",
    "of_axis": "Axis {axis}: {finding}",
    "of_axis_small": "axis {axis}: {finding}",
    "of_circle": "Circle {circle}: {finding}",
    "of_test": "Axis {axis}, test {test}: {finding}",
    "paragraph": "{sentences:join| }",
    "parameter": "{parameter} {value}",
    "range": "{low} to {high}",
    "read_back": (
        "Tables of {definition} are read back from their files, but not independently checked:"
        " only your own definition says what these files do"
    ),
    "reading_off": "{traverse} at {target} (deviates by {off})",
    "scale_by": "{axis}: scale error {scale} according to {tests:join|; }",
    "table_advice": (
        "{cause:choose|noise=the axis does not repeat, which no table corrects: check first how"
        " the instrument is mounted (vibration, air, fixing), then call a mechanic (play, guides,"
        " bearings, coupling, scale)|single outliers=a few readings are outliers, which no table"
        " corrects: find what disturbs the measurement (laser beam interrupted, settling time,"
        " dirt), and measure again|shifts between traverses=whole traverses are shifted, which no"
        " table corrects: check whether instrument, spindle and clamping are firm, and look for"
        " play that differs from run to run|drift=the axis changes during the test, which no"
        " table corrects: warm it up as in work until it is stable, and measure again|one table"
        " for both directions=the reversal changes along the travel, and one table with one"
        " reversal value cannot correct that: call a mechanic (nut, screw, guides), or use a"
        " control with a table for each direction|spacing too wide for the period=the points are"
        " too far apart for so short a period; CW-F002 gives the interval that is needed. If the"
        " control cannot store such a table, call a mechanic (screw, its bearings and coupling,"
        " gear, encoder)|error that the test leaves open=the test does not determine the error"
        " well enough: measure more targets or more runs}"
    ),
    "traverse": "run {run} in {direction}",
    "undetermined.bar": (
        "the length of the bar was not calibrated: give a calibrated length, or measure the"
        " axis with a laser"
    ),
    "undetermined.both_directions": (
        "the value compares both directions: measure a full circle in both directions"
    ),
    "undetermined.causes": (
        "{circle}: the causes of its deviation cannot be determined from {samples} samples over"
        " {arc:g}° in {directions:plural|one direction|both directions}"
    ),
    "undetermined.few_at_reversal": "the arc has too few samples where the {axis} axis reverses",
    "undetermined.few_in_time": (
        "the run takes {time:3sig} s and has too few samples to show a vibration"
    ),
    "undetermined.few_near_reversals": (
        "too few samples near the reversals of the {axis} axis: measure at a lower feed"
    ),
    "undetermined.full_circle": "{reasons:join|; }: measure a full circle in both directions",
    "undetermined.lobes": "only a full circle shows lobes",
    "undetermined.no_end": "this reversal point of {axis} is not in the arc",
    "undetermined.no_reversal": "{axis} does not reverse inside the arc",
    "undetermined.of_circle": "{circle}: {reason}",
    "undetermined.one_direction": (
        "one direction alone cannot separate this cause from lag and lost motion"
    ),
    "undetermined.one_reversal": "the arc contains only one reversal point of the axis",
    "undetermined.pitch": (
        "the samples are too far apart to show a pitch: sample faster or lower the feed"
    ),
    "undetermined.prior": (
        "{value:+3sig} ± {error:2sig} {unit} is too uncertain: even without a test, values within"
        " ±{width:g} (standard deviation) are expected on machines, and the samples hardly narrow"
        " this range"
    ),
    "undetermined.spike": (
        "the samples after the reversal are too few to tell a spike from lost motion: sample faster"
        " or lower the feed"
    ),
    "undetermined.square": "an arc does not show all errors that count in the positional tolerance",
    "undetermined.value": (
        "{value:+.1f} ± {error:.1f} µm/m is too uncertain: the uncertainty (k = 2) must be"
        " below half of the value and below {most:g} µm/m{squareness:if|. Measure full circles in"
        " both directions, and give all of them. The squareness of bent guideways needs a square|}"
    ),
    "value_with_error": (
        "{decimals:choose|1={value:+.1f} ± {error:.1f}|2={value:+.2f} ± {error:.2f}"
        "|3={value:+.3f} ± {error:.3f}} {unit}"
    ),
    "with_and_without": "{parameter}: {value} with these readings, {without} without them",
}
