"""Tables of other programs, with the mapping profiles that say what their columns mean."""

from __future__ import annotations

LONG = """\
Protokoll;;;
Soll [mm];Richtung;Lauf;Abw. [µm]
0,000;vor;1;0,4
100,000;vor;1;2,1
100,000;zurück;1;-0,8
0,000;zurück;1;-2,9
Mittel;;;0,5
"""
LONG_PROFILE = """\
compwright_profile: 1
layout: long
delimiter: semicolon
decimal: comma
header_line: 2
axis: Y
target: "Soll [mm]"
target_unit: mm
value: "Abw. [µm]"
value_is: deviation
unit: um
sign: measured minus target
direction_from: column
direction: Richtung
directions: {vor: "+", "zurück": "-"}
run: Lauf
"""
WIDE = (
    "Pos\tL1 v\tL1 z\tT\n0\t0.4\t-2.9\t20\n100\t2.1\t\t20\n200\t3.0\t1.0\t20\n300\t3.0\t1.5\t20\n"
)
WIDE += "400\t3.0\t1.0\t20\n500\t3.5\t1.0\t20\n"
WIDE_PROFILE = """\
compwright_profile: 1
layout: wide
delimiter: tab
decimal: point
header_line: 1
target: Pos
target_unit: mm
value_is: deviation
unit: um
sign: measured minus target
traverses: {L1 v: "+1", L1 z: "-1"}
leave_out: [T]
"""
