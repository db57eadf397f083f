"""Sentences about a control's files: their contents, and differences between two sets of files."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-S001": (
        "{file}: the last line does not end with a line break. The file may be cut off: check"
        " that it is complete"
    ),
    "CW-S002": (
        "{file}: the end mark {mark} is missing. The file may be cut off: check that it is complete"
    ),
    "CW-S003": (
        "{label}: the files give {quantity} several times. The {rule} value is used: {value}"
        " ({where})"
    ),
    "CW-S004.not_zero": (
        "{label}: the file contains {values} {values:plural|value|values} after the end of the"
        " table ({first} to {last}), {not_zero} of them not zero. The control does not use them."
        " They belong to an older, longer table, or the end or the spacing of this table is"
        " wrong: check both"
    ),
    "CW-S004.zero": (
        "{label}: the file contains {values} {values:plural|value|values} after the end of the"
        " table, all zero. The control does not use them"
    ),
    "CW-S005": (
        "{label}: {quantity} is not in the files; {value} is assumed. If the control contains"
        " another value, the tables and corrections are wrong by the difference. Look the value"
        " up at the control, or add the file that contains it"
    ),
    "CW-S006": (
        "axis {axis}: several measuring systems have a compensation table. Only the table of"
        " system {system} is shown"
    ),
    "CW-S007": "{label}: the table has no effect ({switch})",
    "CW-S008": (
        "{label}: no file contains a compensation table. It is assumed that the control has none"
        " for it"
    ),
    "CW-S009": (
        "{label}: the control ignores {what}, because the axis {why:choose|table=has a"
        " table|rotary=is a rotary axis}"
    ),
    "CW-S010": (
        "axis {axis} of the job is assumed to be axis {address} of the control. Check this at the"
        " control, and give the axis its `address` in the job"
    ),
    "CW-S011": (
        "{label} corrects {output} over {input}. It is left as it is: {why}. {active:if|It is"
        " active, the same before and after loading|It is switched off}"
    ),
    "CW-S012.assignments": (
        "{file} is not active: the active line that assigns tables to axes does not name it"
    ),
    "CW-S012.no_axis": "The control does not load {file}: no axis names this file",
    "CW-S012.no_table": (
        "The control loads no table from {files}{more:if| and {more} more}: no axis names such a"
        " file, and none of them contains a table"
    ),
    "CW-S012.not_given": (
        "{file} is active when {axis} moves, but this file was not given. Its effect on other"
        " axes is unknown: add the file"
    ),
    "CW-S012.start_up_list": (
        "The control does not load {file}: the start-up list does not name this file"
    ),
    "CW-S013": (
        "{file}, line {line}: no manual shows a line of this form. It was read nevertheless. Check"
        " whether it is read correctly. {lines} {lines:plural|line|lines} of the file"
        " {lines:plural|has|have} this form"
    ),
    "CW-S014": (
        "axes {addresses:and} share the compensation point numbers {first} to {last}. A change"
        " for one axis would change the other too, so a new table gets numbers of its own"
    ),
    "CW-S015": (
        "{label}: cutting feed and rapid traverse have different backlash compensation ({feed}"
        " and {rapid}; {why}). Shown here is that of {rapid_shown:if|rapid traverse"
        " (1852)|cutting feed (1851)}. A new table changes both values by the same amount, so"
        " their difference stays"
    ),
    "CW-S016": (
        "{label}: on a full turn the compensation points {first} and {last} are the same"
        " position. Point {first} should have the value of point {last} ({value:g})"
    ),
    "CW-S017": (
        "axis {axis}: the table in {file} covers a full turn, but its last value differs from its"
        " first value"
    ),
    "CW-S018": (
        "{label}: the reference position is not machine zero (1240). It is assumed that the"
        " control counts the compensation points from {reference:g} (option reference); this is"
        " unconfirmed. Check the correction at two positions"
    ),
    "CW-S019": (
        "{label}: the axis is programmed in diameter (1006#3). Positions, interval and"
        " corrections are taken as radius values; this is unconfirmed. A usual error here is a"
        " factor of 2, so check the correction at one position after loading"
    ),
    "CW-S030": "axes {leading} and {partner} form a gantry, but their corrections differ",
    "CW-S031.gantry": (
        "axes {axis} and {other} have the same table. If they form a gantry, give axis {axis}"
        " the key `gantry: {other}` in the job, so that both get the new table. A new table on"
        " one of them alone twists the gantry"
    ),
    "CW-S031.single": (
        "axes {axis} and {other} have the same table. According to the control's files axis"
        " {axis} belongs to no gantry"
    ),
    "CW-S032": "{label}: all values and the grid are zero. This means that there is no table",
    "CW-S033.ends": (
        "{label} is an endless axis, but its table does not repeat: the table has two ends"
    ),
    "CW-S033.repeats": (
        "{label}: the existing table repeats every {period:g}, but the job gives no `modulo` for"
        " this axis. A new table will not repeat: it will have two ends"
    ),
    "CW-S034": "{label} is switched off in the files ({switches}), so it corrects nothing",
    "CW-S035": (
        "axis {axis}: the job says that this axis moves alone, but {parameter} can couple it with"
        " another axis. Keep the coupling off in every test. Load the tables of both axes before"
        " the coupling is used again"
    ),
    "CW-S036": (
        "As the job says, axis {gantry} gets {table:choose|same=the same table as axis"
        " {axis}|change=its own existing table plus the same change as axis {axis}}. Afterwards"
        " the corrections of the two axes differ by up to {after:.2f} {unit}, before by up to"
        " {before:.2f} {unit}. At no position does the difference change by more than {moved:.2f}"
        " {unit}"
    ),
    "CW-S037": (
        "axis {axis}: axis {follows} is a second drive that follows it and has no position of its"
        " own ({parameter}). The table of axis {axis} corrects both"
    ),
    "CW-S038": (
        "Axes {axis} and {gantry} of the gantry move apart by up to {moved:.2f} {unit} (limit"
        " {limit:.2f} {unit}), while axis {axis} improves by {gain:.2f} {unit}. The cause: the"
        " points of their tables lie at different positions. Give both axes the same points in the"
        " control, or give `table: same` in the job"
    ),
    "CW-S040": (
        "{label}: {bits} = 1 ({value}). Real machines use this setting, but its meaning is not"
        " confirmed; it stays as it is. It may mean interpolated compensation: in that case give"
        " the option output: ramp"
    ),
    "CW-S041": (
        "{label}: on a full turn the manual gives {own} the same number as {zero}, but in the"
        " files {own} is {first}, one more than {zero}. The points {first} to {last} are read as"
        " the sections of the turn; point {reference} stays reserved for the axis"
    ),
    "CW-S042": (
        "axis {axis} has unusual settings and is not changed; neither are its compensation"
        " points: {reasons:join|; }"
    ),
    "CW-S043": (
        "{label}: {systems}. The detection unit, in which corrections are counted, depends on it."
        " Check 1013 on the control's display before you load"
    ),
    "CW-S044": (
        "{label}: the axis returns to its reference position in the direction {files} according to"
        " 1006#5, but {job} according to the job. The job is used. If it is wrong, only the zero"
        " point is shifted, by the backlash, because there is one table for both directions. With"
        " two tables such a contradiction is refused"
    ),
    "CW-S045": (
        "{label}: the travel of the job goes {outside:g} {unit} beyond the axis limits of the"
        " control, {low:g} to {high:g} ({parameters}). Check that travel and targets are machine"
        " coordinates"
    ),
    "CW-S046": (
        "{file}: the table points are not equally spaced ({least:.10g} to {most:.10g} apart),"
        " though the control requires equal spacing. They are read as they are; a new table gets"
        " equal spacing"
    ),
    "CW-S047": (
        "{label}: smooth backlash compensation applies the backlash value 1851 in stages"
        " ({parameters}). It is left as it is. The last stage is applied at most {reach:g} {unit}"
        " after a reversal (unconfirmed). Before that, in tests and in machining, the backlash"
        " compensation differs from 1851"
    ),
    "CW-S048": "{label}: {function}",
    "CW-S049.none": (
        "{suggested}. The job gives no screw pitch. The search for periodic errors therefore takes"
        " this period as the most probable one. If it is the screw pitch, add `screw_pitch:"
        " {lead:key}` to the axis"
    ),
    "CW-S049.other": (
        "{suggested}. The job gives {periods:g} instead, and the job is used: check the pitch at"
        " the screw"
    ),
    "CW-S049.suggested": (
        "{label}: according to the control's files one turn of the motor moves the axis by"
        " {lead:g} {unit} ({evidence}). Errors may repeat with this period"
    ),
    "CW-S050.cec": (
        "{label} corrects {output} over {input}. It is left as it is: {why}. {active:if|It is"
        " active, the same before and after loading|It is switched off}"
    ),
    "CW-S050.list": "{label} is left as it is, and its corrections are not shown: {why}",
    "CW-S050.sum": (
        "CEC tables {tables} correct axis {output}. Their sum reaches {low:g} to {high:g}, but"
        " MD32720 $MA_CEC_MAX_SUM limits the sum to {limit:g}. The tables are left as they are:"
        " they are active, the same before and after loading"
    ),
    "CW-S051": (
        "The tables that correct one axis over another ({pairs}) are left as they are and not"
        " shown, because the sign of CEC values on this control is unknown. Check the sign as the"
        " commissioning card describes, then give the option cec_sign"
    ),
    "CW-S052": (
        "axis {axis}: the job names measuring system {number}, but in the files compensation is"
        " on for system {other} (MD32700). Make sure that the axis uses system {number}"
    ),
    "CW-S053": (
        "axis {axis}: apart from its table, this compensation is active too: {functions:join|; }."
        " It is left as it is. It is assumed to have the same effect during the test and after"
        " loading"
    ),
    "CW-S054": (
        "CEC tables {tables} are left as they are. All their values are 0, so they correct nothing"
    ),
    "CW-S055": (
        "The values of CEC tables are shown as if a positive value moved the axis in +. According"
        " to Siemens' manual (Extended Functions 03/2009, page 372) a positive value moves the"
        " axis in −, the opposite. Check the sign as the commissioning card describes, then give"
        " the option cec_sign"
    ),
    "CW-S056": (
        "axis {axis}: {period:if|the existing table repeats every {period:g}, but the job gives no"
        " `modulo` for this axis. A new table will not repeat: it will have two ends|this is an"
        " endless axis, but its table does not repeat: the table has two ends}"
    ),
    "CW-S057": (
        "{format}: the meaning of the parameters {parameters} on this series is unknown ({place});"
        " on other series they are units, paths or further compensation. They stay unchanged, and"
        " are not compared with the job. Look them up in the control's own manual. If one of them"
        " is a compensation, keep the points of the existing table: a new table with other points"
        " does not take this compensation into account"
    ),
    "CW-F011.feed": (
        "at {feed:g} {unit}/min ({of:choose|option=option max_feed|rapid=rapid traverse,"
        " parameter 1420}) the table points must be at least {least:g} {unit} apart. The"
        " control's rule: feed divided by {rule} ({evidence})"
    ),
    "CW-S060": (
        "The table was read back from its files, but not independently checked: only your own"
        " definition of {definition} says what these files do. A wrong sign or unit in the"
        " definition makes every result here wrong. Check the correction on the machine, at one"
        " position and from both sides, before the whole table is active{expectation:if|. A"
        " definition is checked with corrections that were calculated by hand. {definition} has"
        " none of its own, so those of {expectation} were used}"
    ),
    "CW-S061": (
        "{what}. The definition of {carried} in the plan is used instead. To use another"
        " definition, run the job again"
    ),
    "CW-S062": "the control format {name} means {definition}: {title}",
    "CW-S070": (
        "{file}: it contains programs that load compensation or switch it on and off: {programs}."
        " These programs were not run here. The result is that of the archive's own data; if such"
        " a program was run since, the control differs from it"
    ),
    "CW-S071": (
        "{file}: the control does not load a file with decimal commas, so this is a listing. Its"
        " commas are read as decimal points. The control may hold other values: compare some of"
        " them"
    ),
    "CW-S072": (
        "{file}: nothing in this archive shows whether a value was changed after the export. The"
        " commissioning card of the run lists up to three values per axis. Before you load,"
        " compare them with the control's display"
    ),
    "CW-S073": (
        "{file}: according to the job the control never ran this file (active: no). Its tables"
        " and backlash values count as not loaded"
    ),
    "CW-S080": (
        "{files}: for {axis:if|axis {axis}|these files}, the correction that the control applies"
        " cannot be calculated from the files ({faults:join|; }{more:if|; and {more} more|}). Only"
        " the entries of the files are compared, one by one"
    ),
    "CW-S081": (
        "{files}: compwright reads such files with two independent readers. Only one of them"
        " could read these corrections; the other one reports: {why}"
    ),
    "CW-S082": (
        "{files}: some of these files contain no data of the control and are not compared: {idle}"
    ),
    "CW-S083.new": (
        "What was read back contains {new} {new:plural|compensation value|compensation values}"
        " that no file of the plan contains. {new:plural|It was|They were} not compared"
    ),
    "CW-S083.not_read": (
        "{missing} {missing:plural|compensation value|compensation values} of the plan's files"
        " {missing:plural|was|were} not read back, and so not compared"
    ),
    "CW-S084": (
        "{files}: left out, because these files of the folder contain no line in the format"
        " {format}"
    ),
    "CW-S085": (
        "{path} was written by compwright run; it was not read back from the control. It does not"
        " show what the control holds. Save the data from the control, and give that file"
    ),
    "CW-S086": (
        "No file says whether {number:plural|axis {names} is|axes {names} are} linear or"
        " rotary. The unit of the corrections is unknown: thousandths of a mm (µm) or of a"
        " degree (3.6 arcsec). Give --option kind=linear or --option kind=rotary."
    ),
    "CW-S087": (
        "The table of axis {output} over axis {input} was not read back completely: {value}"
        "{more:if| and {more} more} missing. It is unknown whether this table is loaded and active."
        " Read these values of the control back too, and give their files with `--loaded`."
    ),
    "CW-S087.assumed": (
        "{fact}: counted as {value} ({evidence}). The plan's files state it, those read back do"
        " not, so the comparison depends on this assumption. Read this value of the control back"
        " too, and give its file with `--loaded`."
    ),
    "CW-S087.typed": (
        "The files read back hold no table of axis {output} over axis {input}. It is unknown"
        " whether the values of the entry sheet were typed in. Read this table of the control back"
        " too, and give its file with `--loaded`."
    ),
    "CW-S088.coupled": (
        "The files read back couple axis {axis} with another axis ({parameter}), those of the plan"
        " do not. A table on one of two coupled axes racks the machine. Check this parameter on the"
        " control. If it is right, state it in the job (`gantry`), and run it again with these"
        " files."
    ),
    "CW-S088.changed": (
        "A parameter that couples axis {axis} with another axis is {parameter} in the files read"
        " back, and {was} in those of the plan. A table on one of two coupled axes racks the"
        " machine. Check this parameter on the control. If it is right, state the coupling in the"
        " job (`gantry`), and run it again with these files."
    ),
}
