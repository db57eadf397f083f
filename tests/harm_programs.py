"""Programs around compensation values, and what a control that carries them out may end with.

A ``World`` is what no file says: R parameters, block skip, what a called program does, what was in
the control before. Where the worlds end differently, the program does not say what was loaded.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from harm_sinumerik import Control, grid_of, table_text

AXIS, LOW, STEP = "AX1", 0.0, 100.0
OLD = (0.0, -0.004, -0.009, -0.012, -0.018, -0.020, -0.026)
OTHER = (0.0, 0.011, 0.017, 0.028, 0.033, 0.041, 0.052)
NODES = tuple(LOW + i * STEP for i in range(len(OLD)))

VALUES = [f"$AA_ENC_COMP[0,{i},{AXIS}]={value:.4f}" for i, value in enumerate(OLD)]
OTHERS = [f"$AA_ENC_COMP[0,{i},{AXIS}]={value:.4f}" for i, value in enumerate(OTHER)]
GRID = grid_of(AXIS, len(OLD), LOW, STEP)
OFF = [f"$MA_ENC_COMP_ENABLE[0,{AXIS}]=0", "NEWCONF"]
ON = [f"$MA_ENC_COMP_ENABLE[0,{AXIS}]=1", "NEWCONF"]
LOST = [f"$MA_BACKLASH[0,{AXIS}]=0.002"]
ALL = [*OFF, *VALUES, *GRID, *LOST, *ON]


def program(*parts: str | Sequence[str], end: str = "M17") -> str:
    rows = [row for part in parts for row in ([part] if isinstance(part, str) else part)]
    return "\n".join([*rows, *([end] if end else [])]) + "\n"


@dataclass(frozen=True)
class World:
    """What the program meets in the control."""

    parameters: Mapping[str, float] = field(default_factory=dict)
    block_skip: bool = False
    called: Sequence[str] = ()
    before: Sequence[float] = ()

    def control(self) -> Control:
        control = Control(memory=dict(self.parameters), block_skip=self.block_skip)
        if self.before:
            control.load(table_text(AXIS, self.before, LOW, STEP))
            control.memory[f"$MA_ENC_COMP_ENABLE[0,{AXIS}]"] = 1.0
            control.reset()
        control.programs = dict.fromkeys(NAMED, "\n".join(self.called))
        return control


#: Programs that are called in the cases, whatever the file says of them.
NAMED = ("L100", "L101", "SETZEN", "KOMP_X", "/_N_SPF_DIR/_N_KOMP_X_SPF", "KOMP_X.SPF")


def worlds() -> Iterator[World]:
    for before in ((), OTHER):
        yield World(before=before)
        yield World(before=before, block_skip=True)
        for value in (1.0, 2.0, 3.0, 90.0, -1.0):
            yield World({f"R{n}": value for n in range(100)} | _FLAGS, before=before)
    for called in (OTHERS, [f"$MA_ENC_COMP_ENABLE[0,{AXIS}]=0", "NEWCONF"]):
        yield World(called=called)


_FLAGS = {"_FLAG": 1.0, "$A_IN[1]": 1.0, "$P_SIM": 1.0, "$MN_USER_DATA_INT[0]": 1.0}


def ends(text: str) -> list[tuple[float, ...]]:
    """Give what acts at the nodes, both directions, in each world; an alarm leaves what was done."""
    found: list[tuple[float, ...]] = []
    for world in worlds():
        control = world.control()
        control.load(text)
        control.reset()
        found.append(
            tuple(round(control.correction(AXIS, x, d), 7) for d in (1, -1) for x in NODES)
        )
    return found


def is_certain(text: str) -> bool:
    """Whether the program ends the same, whatever the control holds."""
    return len(set(ends(text))) == 1


HALF = len(VALUES) // 2
#: What may not be carried out, or not as it stands: nothing may be counted from it unasked.
DOUBTFUL: dict[str, str] = {
    "if around the table": program(OFF, "IF R50==1", VALUES, GRID, "ENDIF", LOST, ON),
    "if, block numbers and small letters": program(
        OFF, "N100 if r50 == 1", VALUES, GRID, "N200 endif", LOST, ON
    ),
    "if around some points": program(
        OFF, VALUES[:HALF], "IF R50==1", VALUES[HALF:], "ENDIF", GRID, LOST, ON
    ),
    "if around one point": program(
        OFF, VALUES[:3], "IF R1", VALUES[3:4], "ENDIF", VALUES[4:], GRID, LOST, ON
    ),
    "if around the grid": program(OFF, VALUES, "IF R50<>0", GRID, "ENDIF", LOST, ON),
    "if around the switch": program(OFF, VALUES, GRID, LOST, "IF R50>0", ON, "ENDIF"),
    "if around the backlash": program(OFF, VALUES, GRID, "IF R50==1", LOST, "ENDIF", ON),
    "else holds the table": program(
        OFF, "IF R50==1", "R60=1", "ELSE", VALUES, GRID, "ENDIF", LOST, ON
    ),
    "two tables in two branches": program(
        OFF, "IF R50==1", VALUES, "ELSE", OTHERS, "ENDIF", GRID, LOST, ON
    ),
    "two tables, two ifs": program(
        OFF, "IF R50==1", VALUES, "ENDIF", "IF R50<>1", OTHERS, "ENDIF", GRID, LOST, ON
    ),
    "nested ifs": program(OFF, "IF R50==1", "IF R51==1", VALUES, GRID, "ENDIF", "ENDIF", LOST, ON),
    "if with machine code in the condition": program(
        OFF, "IF ($MN_USER_DATA_INT[0]==1) OR (R3==7)", VALUES, GRID, "ENDIF", LOST, ON
    ),
    "jump over the table": program(OFF, "IF R50==0 GOTOF _ENDE", VALUES, GRID, LOST, ON, "_ENDE:"),
    "jump over some points": program(
        OFF, VALUES[:2], "IF R50==1 GOTOF WEITER", VALUES[2:], "WEITER:", GRID, LOST, ON
    ),
    "jump over the switch": program(OFF, VALUES, GRID, LOST, "IF NOT R50 GOTOF ENDE", ON, "ENDE:"),
    "jump without condition": program(OFF, "GOTOF ENDE", VALUES, GRID, "ENDE: R1=1", LOST, ON),
    "jump to a block number": program(
        OFF, "IF R5==2 GOTOF N900", VALUES, GRID, LOST, ON, "N900 R1=1"
    ),
    "jump with GOTO": program(OFF, "IF R5==2 GOTO ENDE", VALUES, GRID, LOST, ON, "ENDE:"),
    "jump with GOTOC": program(OFF, "IF R5==2 GOTOC ENDE", VALUES, GRID, LOST, ON, "ENDE:"),
    "jump behind a label": program(
        OFF, "ANFANG: IF R5==2 GOTOF ENDE", VALUES, GRID, LOST, ON, "ENDE:"
    ),
    "jump back": program(
        OFF, "GOTOF HINTEN", "VORN:", VALUES, GRID, LOST, ON, "M17", "HINTEN: IF R50==1 GOTOB VORN"
    ),
    "case before the table": program(
        OFF,
        "CASE(R50) OF 1 GOTOF T1 2 GOTOF T2 DEFAULT GOTOF ENDE",
        *("T1:", VALUES, GRID, "GOTOF ENDE", "T2:", OTHERS, GRID, "ENDE:"),
        LOST,
        ON,
    ),
    "case without brackets": program(
        OFF, "CASE R50 OF 1 GOTOF ENDE", VALUES, GRID, LOST, ON, "ENDE:"
    ),
    "return before the table": program("RET", OFF, VALUES, GRID, LOST, ON),
    "end of program before the table": program("M30", OFF, VALUES, GRID, LOST, ON),
    "M17 in a branch before": program("IF R50==0", "M17", "ENDIF", OFF, VALUES, GRID, LOST, ON),
    "M2 in a branch before": program("IF R50==0", "M02", "ENDIF", OFF, VALUES, GRID, LOST, ON),
    "return in the middle": program(OFF, VALUES[:4], "RET", VALUES[4:], GRID, LOST, ON),
    "return before the switch": program(OFF, VALUES, GRID, LOST, "IF R50==0", "RET", "ENDIF", ON),
    "while around the table": program(
        OFF, "WHILE R50==1", VALUES, GRID, "R50=0", "ENDWHILE", LOST, ON
    ),
    "for with an unknown end": program(OFF, "FOR R1=1 TO R50", VALUES, GRID, "ENDFOR", LOST, ON),
    "for counts the points up": program(
        OFF, VALUES, "FOR R1=1 TO R50", "$AA_ENC_COMP[0,3,AX1]=0.010*R1", "ENDFOR", GRID, LOST, ON
    ),
    "loop left by a jump": program(
        OFF,
        "LOOP",
        "IF R50<>1 GOTOF RAUS",
        VALUES,
        GRID,
        "GOTOF RAUS",
        "ENDLOOP",
        "RAUS:",
        LOST,
        ON,
    ),
    "repeat until, jumped over": program(
        OFF, "IF R50==0 GOTOF RAUS", "REPEAT", VALUES, GRID, "UNTIL TRUE", "RAUS:", LOST, ON
    ),
    "repeat of a label": program(
        OFF,
        VALUES,
        "DAZU: $AA_ENC_COMP[0,3,AX1]=$AA_ENC_COMP[0,3,AX1]+0.005",
        "REPEATB DAZU P=2",
        GRID,
        LOST,
        ON,
    ),
    "called number before": program("L100", OFF, VALUES[:5], GRID, LOST, ON),
    "called number between": program(OFF, VALUES, "L100", GRID, LOST, ON),
    "called with CALL": program(OFF, VALUES, GRID, LOST, 'CALL "KOMP_X"', ON),
    "called with PCALL": program(OFF, VALUES, "PCALL /_N_SPF_DIR/_N_KOMP_X_SPF", GRID, LOST, ON),
    "called with EXTCALL": program(OFF, VALUES, GRID, LOST, 'EXTCALL "KOMP_X.SPF"', ON),
    "called by its name": program(OFF, VALUES, GRID, LOST, "KOMP_X", ON),
    "called before, by its name": program("SETZEN", OFF, VALUES[:5], GRID, LOST, ON),
    "block skip on the values": program(OFF, ["/" + row for row in VALUES], GRID, LOST, ON),
    "block skip on one value": program(
        OFF, VALUES[:3], "/ " + VALUES[3], VALUES[4:], GRID, LOST, ON
    ),
    "block skip on the switch": program(OFF, VALUES, GRID, LOST, "/" + ON[0], ON[1]),
    "block skip level": program(OFF, VALUES, GRID, "/3 " + LOST[0], ON),
    "block skip of a jump": program(OFF, "/ GOTOF ENDE", VALUES, GRID, LOST, ON, "ENDE:"),
    "block skip of the end": program("/ M30", OFF, VALUES, GRID, LOST, ON),
    "value from a parameter": program(
        OFF, VALUES[:3], "$AA_ENC_COMP[0,3,AX1]=-0.010-R9", VALUES[4:], GRID, LOST, ON
    ),
    "weight added at the end": program(
        OFF, VALUES, GRID, LOST, ON, OFF, "$AA_ENC_COMP[0,6,AX1]=$AA_ENC_COMP[0,6,AX1]+R5/1000", ON
    ),
    "switch from a parameter": program(
        OFF, VALUES, GRID, LOST, "$MA_ENC_COMP_ENABLE[0,AX1]=R50", "NEWCONF"
    ),
    "condition over two statements": program(
        OFF,
        "R50=R50*2 R51=1",
        "IF (R50==2) AND NOT (R51==0) GOTOF ENDE",
        VALUES,
        GRID,
        LOST,
        ON,
        "ENDE: M17",
    ),
}

#: The program ends the same whatever the control holds, and a reader can see that without carrying it out.
PLAIN: dict[str, str] = {
    "the maker's form": program(
        ";Geberkompensation -- IF R50==1 GOTOF",
        OFF,
        "STOPRE",
        [row + "   ;  50" for row in VALUES],
        GRID,
        LOST,
        "STOPRE",
        "NEWCONF",
        ON,
        'MSG("Geberkompensation eingestellt, NCK-RESET !")',
        "G4F4",
    ),
    "flow after the last value": program(
        ALL, "IF R50==1", 'MSG("NCK-RESET")', "ELSE", "GOTOF ENDE", "ENDIF", "ENDE:"
    ),
    "jump after the last value": program(
        ALL,
        "STOPRE",
        "IF NOT (ABS(R719)<(0.031))",
        "_FEHLER1:",
        'MSG("zu gross")',
        "G4 F10",
        "GOTOB _FEHLER1",
        "ENDIF",
    ),
    "return after the last value": program(ALL, "IF R1==0", "RET", "ENDIF", "R2=1", end="M30"),
    "loop after the last value": program(ALL, "FOR R1=0 TO 5", "R2=R2+R1", "ENDFOR"),
    "comments that look like flow": program(
        "; IF R50==1 THEN",
        OFF,
        ";GOTOF ENDE",
        [row + " ; IF 1" for row in VALUES],
        "; ENDIF",
        GRID,
        LOST,
        ";RET",
        ";M30",
        ON,
    ),
    "texts that look like flow": program(
        'MSG("IF R1==1 GOTOF ENDE")',
        OFF,
        VALUES,
        'MSG("RET")',
        GRID,
        LOST,
        ON,
        'MSG("CALL L100 ; M30")',
    ),
    "labels without jumps": program(
        "ANFANG:", OFF, VALUES, "MITTE: STOPRE", GRID, LOST, ON, "ENDE:"
    ),
    "block numbers": program([f"N{10 * i} {row}" for i, row in enumerate(ALL)], end="N9990 M17"),
    "harmless statements": program(
        "%_N_KOMP_MPF\n;$PATH=/_N_WKS_DIR/_N_KOMP_WPD",
        "STOPRE",
        OFF,
        "G4 F1",
        VALUES,
        "STOPRE",
        GRID,
        LOST,
        ON,
        "G4 F1",
        end="M30",
    ),
    "two ends": program(ALL, "M0", end="M17"),
    "a definition before": program("DEF INT ZAEHLER", "DEF REAL _MAX=0.5", ALL),
    "a parameter before": program("R50=1", ALL),
    "a comment at the end": program(ALL, "; ENDIF CASE RET"),
    "no end": program(ALL, end=""),
}
