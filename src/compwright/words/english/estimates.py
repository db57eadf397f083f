"""Sentences about the estimated error of an axis, and about the causes found in circular tests."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-D001": (
        "only one direction was measured. Causes of deviation that depend on the direction"
        " cannot be separated from the others."
        " {causes:if|Standard errors grow, most of all those of {causes:join|; }|No standard error"
        " grows much}"
    ),
    "CW-D001.cause": "{cause} ({factor:.0f} times, similar to {other})",
    "CW-D001.more": "and of {count} more {count:plural|cause|causes}",
    "CW-D002": (
        "an arc of {arc:g}° separates the causes of deviation less well than a full circle."
        " {causes:if|Standard errors grow, most of all those of {causes:join|; }|No standard error"
        " grows much}"
    ),
    "CW-D003": (
        "the length of the bar was not calibrated, so the scale of single axes is not given. Only"
        " the difference of their scales is given"
    ),
    "CW-D004": (
        "at {feed:g} mm/min a position loop with low gain (Kv) makes the circle up to"
        " {most:.1f} µm smaller. From this circle alone, the scale of single axes is therefore"
        " uncertain by {doubt:.0f} µm/m. Evaluate it together with a circle at a low feed:"
        " both show the scale (CW-P135)"
    ),
    "CW-D005.none": (
        "axis {name} does not reverse on this arc. Its lost motion, lateral play and reversal"
        " spike are therefore not determined"
    ),
    "CW-D005.one": (
        "axis {name} reverses only once on this arc. Its lost motion is known only at the"
        " {end:choose|positive=positive|negative=negative} end"
    ),
    "CW-D006": "a cyclic error of {axis} was found at a pitch of {pitch:.4g} mm",
    "CW-D007": (
        "no cyclic error of axis {name} was found at pitches of {least:2sig} to {most:g} mm. One"
        " below {hidden:2sig} µm, or of another pitch, may still be hidden"
    ),
    "CW-D008.gradual": (
        "axis {name} takes up its lost motion gradually: up to {inward:2sig} µm are missing after"
        " a reversal, and die out over about {travel:2sig} µm of travel. Check for elastic wind-up"
        " first: nut preload, support bearing, coupling or belt, friction of the guideway. Backlash"
        " compensation acts at once and cannot follow it"
    ),
    "CW-D008.inward": (
        "after the reversals of axis {name} the path lies up to {inward:2sig} µm inside the"
        " circle. Its friction compensation may be too strong. Backlash compensation does the"
        " same where the lost motion appears gradually"
    ),
    "CW-D009": (
        "the samples show only periods of {least:3sig} to {most:g} mm, so an error of period"
        " {period:g} mm along axis {axis} cannot be seen"
    ),
    "CW-D010": (
        "a part of the deviation, {rms:2sig} µm rms, has a shape that no known cause explains."
        " The standard errors allow for this"
    ),
    "CW-D011": (
        "the axes reverse {lag:.1f} ± {error:.1f} ms later than commanded; the angles were"
        " corrected for this delay"
    ),
    "CW-D012": (
        "What follows a reversal is in front of it in the file ({odds}). Either the two"
        " directions are exchanged, and lost motion and servo mismatch have the wrong sign, or the"
        " angles are too far ahead. Check which run was clockwise, and at which angle the first"
        " sample was taken. Correct the file, or acknowledge CW-D012 in the job."
    ),
    "CW-D013": (
        "The lost motion is {values:and}, but a circle with lost motion shows it above zero."
        " Unless the backlash compensation is too large, the sign of the deviations, the sense of"
        " the angles or the two directions are turned. With the first two, squareness has the"
        " wrong sign too. Check at the machine: move outwards by 10 µm, the reading must rise."
        " Correct the file or reduce the compensation, or acknowledge CW-D013 in the job."
    ),
    "CW-E001": (
        "Only one direction was measured. The error is assumed to be the same in the other"
        " direction, and lost motion is unknown."
    ),
    "CW-E002": (
        "There is only one approach per target and direction. The noise is therefore estimated"
        " from the scatter between neighbouring targets."
    ),
    "CW-E003": (
        "The spacing of the targets hides an error of period {period:g} {unit}, so this period is"
        " not part of the estimate. A test at other targets may show more error than is"
        " predicted; {better}"
    ),
    "CW-E004": (
        "The travel reaches up to {beyond:g} {unit} beyond the measured range ({first:g} to"
        " {last:g} {unit}). Beyond this range the error is extrapolated with the measured slope,"
        " and its uncertainty grows"
    ),
    "CW-E010": (
        "The targets are {interval:.4g} {unit} apart. At these targets an error of period"
        " {period:g} {unit} looks like {wave:if|a wave of {wave:.4g} {unit}|a constant}, and the"
        " two cannot be separated. The period is therefore not part of the estimate, and no limit"
        " can be reported as met; {better}"
    ),
    "CW-E011": (
        "The table is made from {number:plural|test {tests} alone, which covers|tests {tests:and},"
        " which cover} {low:g} to {high:g} {unit}. Test {other} measured {other_low:g} to"
        " {other_high:g} {unit}, but is not used: what was in the control during this test is not"
        " known. Beyond {low:g} to {high:g} {unit} the error is only extrapolated, and may be wrong"
        " by more than 100 %. Do one of three things: state under `measured_in` which entry of"
        " `states` was in the control during test {other}; list test {other} first under `before`;"
        " or let the table end at the measured range (`start` and `end` of `table`)"
    ),
    "CW-E012.found": (
        "The error repeats every {period:.5g} {unit} (probability {probability:.0f} %, {odds}):"
        " {meaning}.{nodes:if| The points of the existing table are also {nodes:.5g} {unit}"
        " apart. A table that was not active in the test leaves an error like this one: check"
        " first that the table was active.} Estimate and prediction weight the period by its"
        " probability"
    ),
    "CW-E012.period": "{period:.5g} {unit} ({percent:.0f} %)",
    "CW-E012.possible": (
        "The error may repeat every {periods:join| or }, but these targets do not show it clearly."
        " Estimate and prediction weight a possible period by its probability. Measure at more"
        " targets with random offsets to decide"
    ),
    "CW-E013": (
        "The error repeats, but at these targets several periods look the same:"
        " {periods:.4g}{more:if| and {more} others} {unit}. The readings do not show which of them"
        " is the true one, so the table may correct a wrong one, and a test at other targets may"
        " show the whole periodic error; {better}"
    ),
    "CW-E014.equal_spacing": (
        "No period was found, but targets at equal spacing ({interval:.4g} {unit}) hide every"
        " period that divides the spacing. The finding CW-T008 of this test proposes targets that"
        " would show these periods"
    ),
    "CW-E014.few_targets": (
        "{targets} targets are too few to look for a periodic error. Measure at eight targets or"
        " more, with random offsets"
    ),
    "CW-E014.hidden": (
        "The job gives no screw pitch or other period, and none is certain: with a probability of"
        " {probability:.0f} % the readings contain an error that repeats"
    ),
    "CW-E014.unlikely": (
        "The job gives no screw pitch or other period, and the readings show none"
    ),
    "CW-E015": (
        "The readings show {fitted} of the {known} known periods: {periods:g} {unit}. The other"
        " periods are not part of the estimate"
    ),
    "CW-E016": (
        "The job gives screw_pitch {stated:and} {unit}, but the readings show no error with this"
        " period. They show an error that repeats every {found:and} {unit}. Check the pitch: both"
        " periods stay in the estimate, where a wrong one does no harm, but the table points are"
        " chosen for the stated pitch"
    ),
    "CW-E020": (
        "The readings drift by {drift} from the first run to the last ({odds}){flattens:if|, and"
        " the drift flattens out}. {alone:if|The prediction knows only this one test. It assumes"
        " that a test repeated in the same way, from an equally cold axis, drifts by the same"
        " amount (to within about 10 %). If the next test drifts differently, or not at all because"
        " the axis is warm, its results can lie outside the predicted band. With a second test,"
        " measured in the same way, the predicted band allows for such a difference|The prediction"
        " allows for a drift that differs from test to test}. To see the axis without the drift,"
        " warm it up and measure again"
    ),
    "CW-E021": (
        "The readings drift along the travel as in thermal expansion: by {lower} at the lower end"
        " and {upper} at the upper end, from the first run to the last ({odds}){flattens:if|. The"
        " drift flattens out}. {alone:if|The prediction is valid for a test that is repeated in the"
        " same way from an equally cold axis, and drifts by the same amount (to within about 10 %)."
        " If the next test drifts differently, or not at all because the axis is warm, its results"
        " can lie outside the predicted band|The prediction allows for a drift that differs from"
        " test to test}. To see the axis without the drift, warm it up and measure again"
    ),
    "CW-E022.all": (
        "{pattern:choose|traverses=The single runs are shifted against each other|runs=The runs,"
        " out and back together, are shifted against each other|walk=The zero point wanders from"
        " run to run|wave=The readings rise and fall slowly in time} by {size}{pattern:choose|walk="
        " per run|=} (standard deviation; {odds}){where:if|, {where:and}}."
        " {pattern:choose|wave=Check the air around the machine: heating, cooling, drafts,"
        " sun|=Check warm-up, clamping, reference runs and the mounting of the instrument between"
        " runs}. The prediction assumes {pattern:choose|wave=waves|=shifts} of this size in the"
        " next test"
    ),
    "CW-E022.either": (
        "The runs are shifted against each other ({odds}). These readings do not show whether the"
        " axis drifts or jumps, and the prediction allows for both. Check warm-up, clamping,"
        " reference runs and the mounting of the instrument between runs"
    ),
    "CW-E022.seldom": (
        "{pattern:choose|traverses=Single runs deviate from the others|runs=Single runs, out and"
        " back together, deviate from the others|walk=Now and then the zero point jumps to a new"
        " place,} by {size} (standard deviation; {odds}){where:if|, {where:and}}. Check warm-up,"
        " clamping, reference runs and the mounting of the instrument between runs. The prediction"
        " assumes that such shifts are as rare in the next test"
    ),
    "CW-E023": (
        "The scale changes from run to run: the deviations at the ends of the travel shift by"
        " {tilt} relative to those in its middle (standard deviation; {odds}). Check how the"
        " instrument compensates air and temperature, and look for drafts"
    ),
    "CW-E024": (
        "{outliers} of {readings} {outliers:plural|readings is an outlier|readings are outliers}:"
        " {where}{more:if| and {more} more} ({odds}). Outliers count little in the estimate, and"
        " the prediction expects as many in a repeated test. Next: {cause}, then measure again"
    ),
    "CW-E024.reading": "find their cause (laser beam interrupted, chips, clamping)",
    "CW-E024.traverse": "all are in {traverse}, so find out what happened in this run",
    "CW-E025": (
        "Some readings lie further from the mean than normal scatter explains ({odds}). Such"
        " readings count less in the estimate, and the prediction expects them in a repeated test"
        " too"
    ),
    "CW-E026": (
        "The readings scatter by {positive} in + and by {negative} in − ({odds}): look for"
        " parts that have play in one direction only"
    ),
    "CW-E027": (
        "The scatter of the readings depends on the position ({odds}). It is smallest, {least},"
        " at {least_at} and largest, {most}, at {most_at}. Inspect screw, guides and covers"
        " where it is largest"
    ),
    "CW-E028": (
        "Test {test} has a different slope from test {other}: the difference is {difference:+.1f} ±"
        " {error:.1f} µm/m. Steel expands by as much when it becomes {kelvin:2sig} K warmer. This"
        " difference is therefore taken as an effect of temperature or set-up in one of the tests,"
        " not as an error of the axis. The tests do not show which slope is right: give the"
        " temperatures of both tests (`thermal` of the job), or measure again at an even"
        " temperature"
    ),
    "CW-E029": (
        "The instrument seems to resolve {step}: {repeated:if|all readings of a target are equal,"
        " and }all readings are multiples of this step. The true error may differ from each mean by"
        " half a step. If the instrument resolves more, export its readings with all digits and"
        " evaluate again"
    ),
    "CW-E030.jump": (
        "The error jumps by {size} ± {error} between {low:.10g} and {high:.10g} {unit}"
        " ({sure:if|more than 1000|{odds:2sig}} times as likely as not). Inspect the scale there"
        " (damage, dirt, a joint) and its reading head, and check the line count of the encoder."
        " Where exactly the error jumps is unknown: measure between these targets every few mm"
        " before you load a table"
    ),
    "CW-E030.jump_or_target": (
        "Either the error jumps by {size} ± {error} between {low:.10g} and {high:.10g} {unit},"
        " or only the target at {target:.10g} {unit} deviates by so much. Inspect the scale"
        " there (damage, dirt, a joint) and its reading head, and check the line count of the"
        " encoder. Where exactly the error jumps is unknown: measure between these targets every"
        " few mm before you load a table"
    ),
    "CW-E031": (
        "To save time, the noise is estimated from {used} of {runs} runs, evenly spaced over the"
        " test. The means use all runs"
    ),
    "CW-E032": (
        "{outliers} of {readings} readings are outliers, several at the same target: {where}"
        "{more:if| and {more} more} ({odds}). The true error of the axis there is uncertain. Next:"
        " {cause}, then measure again"
    ),
    "CW-E032.target": (
        "check the readings at {target:and} (unit, laser beam interrupted, chips) and inspect"
        " screw, guides and covers there"
    ),
    "period.cause": (
        "{cause:choose|lead=a screw lead of {number:g} mm|inch_lead=a screw lead of {number:g}"
        " inch|half_lead=half a screw lead of {number:g} mm|magnets=a pair of magnets of a linear"
        " motor|rack=a tooth of a helical rack|worm=one turn of a worm or motor ({number:g} turns"
        " for one turn of the table)|files=a period that the control's own files suggest}"
    ),
    "period.unusual_division": (
        "no usual part repeats {parts:.4g} times per turn. Compare this period with one turn of the"
        " worm, with one turn of the motor through its gear, and with the pitch of the scale"
    ),
    "period.unusual_lead": (
        "no usual screw has this lead. Compare this period with one turn of the motor through belt"
        " or gear, with half of such a turn, with the pitch of the scale or rack, and with a pair"
        " of magnets"
    ),
    "period.usual": (
        "{once:if|look for a part that turns or repeats once in {period:.5g} {unit}: {once:join|,"
        " or }|}{twice:if|{once:if|; or for|look for} a part that turns or repeats once in"
        " {double:.5g} {unit} and causes the error twice in it: {twice:join|, or }|}"
    ),
}
