"""What the estimate of an error and the diagnosis of circles say."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-D001": (
        "one direction only: what depends on the direction cannot be separated from what does"
        " not; standard errors that this multiplies: {causes:if|{causes}|none}"
    ),
    "CW-D001.cause": "{cause} (x {factor:.0f}, with {other})",
    "CW-D002": (
        "an arc of {arc:g}° tells the causes apart less well than a circle; standard errors"
        " that this multiplies: {causes:if|{causes}|none}"
    ),
    "CW-D003": (
        "the length of the bar was not calibrated: the scale of single axes is not given,"
        " only their mismatch"
    ),
    "CW-D004": (
        "at {feed:g} mm/min a soft position loop makes the circle up to {most:.1f} µm"
        " smaller: the scale of single axes is uncertain by {doubt:.0f} µm/m for that; a"
        " second test at a low feed decides it"
    ),
    "CW-D005.none": (
        "the arc holds no reversal point of {name}: its lost motion, lateral play and"
        " reversal spike are not determined"
    ),
    "CW-D005.one": (
        "the arc holds one reversal point of {name} only: its lost motion is that at the"
        " {end:choose|positive=positive|negative=negative} end"
    ),
    "CW-D006": "a cyclic error of {axis} was found at a pitch of {pitch:.4g} mm",
    "CW-D007": (
        "no cyclic error of {name} was found; one of less than {hidden:2sig} µm may be hidden"
    ),
    "CW-D008": (
        "{name} is up to {inward:2sig} µm inside after its reversals: its backlash"
        " compensation may be too strong"
    ),
    "CW-D009": (
        "a period of {period:g} mm along {axis} cannot be seen: the samples show periods of"
        " {least:3sig} to {most:g} mm"
    ),
    "CW-D010": (
        "{rms:2sig} µm of deviation has a shape that no cause explains; the standard errors"
        " allow for it"
    ),
    "CW-D011": (
        "the axes reverse {lag:.1f} ± {error:.1f} ms after their commands; the angles were"
        " corrected for this delay"
    ),
    "CW-E001": (
        "Measured in one direction only: the same error is assumed in both, lost motion is"
        " not known."
    ),
    "CW-E002": (
        "One approach per target and direction: the noise is inferred from the scatter"
        " between neighbouring targets."
    ),
    "CW-E003": (
        "The targets cannot show an error of period {period:g} {unit} (their spacing hides"
        " it): it is left out, and a test at other targets may show more than is predicted;"
        " {better}"
    ),
    "CW-E004": (
        "The travel reaches up to {beyond:g} {unit} beyond the measured range ({first:g} to"
        " {last:g} {unit}): there the error is continued with the measured slope, and its"
        " uncertainty grows"
    ),
    "CW-E010": (
        "At these targets, {interval:.4g} {unit} apart, an error of period {period:g} {unit}"
        " looks like {wave:if|a wave of {wave:.4g} {unit}|a constant}: the two cannot be"
        " separated, the period is not fitted, and no limit is accepted; {better}"
    ),
    "CW-E011": (
        "The table is made from the {number:plural|test {tests} alone, which covers|tests"
        " {tests:and}, over} {low:g} to {high:g} {unit}; the test {other} measured"
        " {other_low:g} to {other_high:g} {unit} and is not fitted. Beyond {low:g} to"
        " {high:g} {unit} the error is only continued and may be wrong by more than it is:"
        " name the state that was active in the control while it was measured (measured_in),"
        " list the test {other} first, or let the table end at the measured range (table:"
        " start, end)"
    ),
    "CW-E012.found": (
        "The error repeats every {period:.5g} {unit} (probability {probability:.0f} %,"
        " {odds}): {meaning}.{nodes:if| The nodes of the table in the control are also"
        " {nodes:.5g} {unit} apart: a table that was not active as its files say leaves an"
        " error that looks like this; check first that it was.} It counts in the estimate and"
        " the prediction with that probability"
    ),
    "CW-E012.period": "{period:.5g} {unit} ({percent:.0f} %)",
    "CW-E012.possible": (
        "The error may repeat every {periods}: these targets do not decide it. Each of"
        " these periods counts with its probability. More targets at random offsets would show it"
    ),
    "CW-E013": (
        "The error repeats, but these targets do not show with which period:"
        " {periods:.4g}{more:if| and {more} others} {unit} look the same there. None is"
        " certainly taken out, and a test at other targets may show all of it; {better}"
    ),
    "CW-E014.equal_spacing": (
        "No period was found, but equal spacing hides those that divide it ({interval:.4g}"
        " {unit}); the targets that CW-T008 proposes would show them"
    ),
    "CW-E014.few_targets": (
        "Too few targets ({targets}) to look for a periodic error: eight at random offsets"
        " show some, more are better"
    ),
    "CW-E014.hidden": (
        "No screw pitch or other period is given, and none was found: there is a chance of"
        " {probability:.0f} % that the error repeats with a period that these targets hardly"
        " show"
    ),
    "CW-E014.unlikely": (
        "No screw pitch or other period is given, and none was found: there is a chance of"
        " less than 1 % that the error repeats with a period that these targets hardly show"
    ),
    "CW-E015": (
        "Of {known} known periods the readings show {fitted}: {periods:g} {unit}; the others"
        " are not fitted"
    ),
    "CW-E016": (
        "The readings show no error that repeats every {stated:and} {unit}, as the job says"
        " (screw_pitch), but one that repeats every {found:and} {unit}: is the pitch right?"
        " Both stay in the estimate; a wrong one does no harm there, but the grid is chosen"
        " for it"
    ),
    "CW-E020": (
        "The readings drift by {drift} from the first run to the last ({odds}){flattens:if|,"
        " and it flattens out}. With one test the prediction assumes the same drift in a test that"
        " is repeated in the same way, from as cold an axis, to about a tenth: another drift, or"
        " none because the axis is warm by then, is outside of the band. A second test in the same"
        " way puts it into the band. Warm the axis up and measure again to see it without"
    ),
    "CW-E021": (
        "The readings drift apart along the travel, as in thermal expansion: by {lower} at"
        " its lower end and {upper} at its upper end from the first run to the last"
        " ({odds}){flattens:if|, and it flattens out}. The prediction assumes the same drift"
        " in a test that is repeated in the same way, from as cold an axis, to about a tenth."
        " One test does not tell more: another drift, or none because the axis is warm by"
        " then, is outside of the band. Warm the axis up and measure again to see it without"
    ),
    "CW-E022.all": (
        "{pattern:choose|traverses=Traverses are shifted against each other|runs=Runs are"
        " shifted against each other as a whole|walk=The zero point wanders from traverse to"
        " traverse|wave=The readings rise and fall slowly in time} by"
        " {size}{pattern:choose|traverses=|runs=|wave=|walk= a step} (one standard deviation;"
        " {odds}){where:if|, {where:and}}: {pattern:choose|traverses=look at warm-up,"
        " clamping, reference runs and the mounting of the instrument between"
        " traverses|runs=look at warm-up, clamping, reference runs and the mounting of the"
        " instrument between traverses|walk=look at warm-up, clamping, reference runs and the"
        " mounting of the instrument between traverses|wave=look at the air of the hall"
        " (heating, cooling, drafts, sun)}. The prediction draws such"
        " {pattern:choose|traverses=shifts|runs=shifts|walk=shifts|wave=waves} anew"
    ),
    "CW-E022.either": (
        "The traverses are shifted against each other ({odds}). These readings do not show"
        " whether the axis drifts or jumps; the prediction counts with both. Look at warm-up,"
        " clamping, reference runs and the mounting of the instrument between traverses"
    ),
    "CW-E022.seldom": (
        "{pattern:choose|traverses=Single traverses are off the others|runs=Single runs are"
        " off the others as a whole|walk=The zero point jumps now and then, and stays there,}"
        " by {size} (one standard deviation; {odds}){where:if|, {where:and}}: look at"
        " warm-up, clamping, reference runs and the mounting of the instrument between"
        " traverses. The prediction draws such shifts anew, as seldom"
    ),
    "CW-E023": (
        "The scale changes from traverse to traverse: the ends of the travel move by {tilt}"
        " against its middle (one standard deviation; {odds}): look at the compensation of"
        " air and temperature of the instrument and at drafts"
    ),
    "CW-E024": (
        "{outliers} of {readings} {outliers:plural|readings is an outlier|readings are"
        " outliers}: {where}{more:if| and {more} more} ({odds}). They count little in the"
        " estimate, and a repeated test is predicted to have as many: {cause}, then measure"
        " again"
    ),
    "CW-E024.reading": "find their cause (beam, chips, clamping)",
    "CW-E024.target": "all at {target}, look at screw, guides and covers there",
    "CW-E024.traverse": "all in {traverse}, find out what happened in that traverse",
    "CW-E025": (
        "Single readings lie further out than normal scatter explains ({odds}): far readings"
        " count less in the estimate, and a repeated test is predicted to have such readings"
    ),
    "CW-E026": (
        "The readings scatter by {positive} in + and by {negative} in − ({odds}): look for"
        " what moves freely in one direction only"
    ),
    "CW-E027": (
        "The scatter of the readings depends on the position: least, by {least}, at"
        " {least_at} and most, by {most}, at {most_at} ({odds}): look at screw, guides and"
        " covers where it is largest"
    ),
    "CW-E028": (
        "Test {test} has another slope than test {other}: {difference:+.1f} ± {error:.1f}"
        " µm/m from it, as much as {kelvin:2sig} K make of steel. It counts as the"
        " temperature or the set-up of one of the tests, not as an error of the axis; they do"
        " not show which slope is right: give the temperatures of the tests (thermal), or"
        " measure again at an even temperature"
    ),
    "CW-E029": (
        "Assumed resolution of the instrument: {step} ({repeated:if|every target repeats one"
        " reading, and }all readings lie on this step). The true error may differ from each"
        " mean by half a step. If the instrument resolves more, export its readings with all"
        " digits and evaluate again"
    ),
    "CW-E030.jump": (
        "The error jumps by {size} ± {error} between {low:.10g} and {high:.10g} {unit} (odds"
        " {sure:if|over 1000|{odds:2sig}} to 1): look at the scale there (damage, dirt, a"
        " joint), at its reading head, and at the line count of the encoder. Between these"
        " targets the place of the jump is unknown: measure there at targets a few mm apart"
        " before a table is loaded"
    ),
    "CW-E030.jump_or_target": (
        "The error jumps by {size} ± {error} between {low:.10g} and {high:.10g} {unit}, or"
        " the target at {target:.10g} {unit} alone is off by so much: look at the scale there"
        " (damage, dirt, a joint), at its reading head, and at the line count of the encoder."
        " Between these targets the place of the jump is unknown: measure there at targets a"
        " few mm apart before a table is loaded"
    ),
    "CW-E031": (
        "The noise is estimated from {used} of {runs} runs, evenly spaced over the test; the"
        " means use all runs"
    ),
    "period.cause": (
        "{cause:choose|lead=a screw lead of {number:g} mm|inch_lead=a screw lead of {number:g}"
        " inch|half_lead=half a screw lead of {number:g} mm|magnets=a pair of magnets of a linear"
        " motor|rack=a tooth of a helical rack|worm=a turn of a worm or motor, 1/{number:g} of the"
        " table's|files=what the control's own files suggest}"
    ),
    "period.unusual_division": (
        "no usual division ({parts:.4g} in a turn): look for the turn of the worm or of the motor"
        " through its gear, and the pitch of the scale"
    ),
    "period.unusual_lead": (
        "no usual lead: look for the turn of the motor through a belt or gear, half of it, the"
        " pitch of the scale or rack, a pair of magnets"
    ),
    "period.usual": (
        "{once:if|look for what turns or repeats once in {period:.5g} {unit}: {once:join|, or"
        " }|}{twice:if|{once:if|; or for|look for} what does so twice in {double:.5g} {unit}:"
        " {twice:join|, or }|}"
    ),
}
