"""Files of every kind with a secret at every place where a text can stand.

The secret is a company with a number; ``{S}`` stands for it in free text, ``{W}`` for one word of
it where blanks or umlauts cannot stand.
"""

from __future__ import annotations

from collections.abc import Mapping

from laser_files import compensation_file, laser_file, mean_file

#: What must not be found in a copy, in small letters.
SECRETS = ("mühlbauer", "muehlbauer", "zerspan", "48151623")
FREE, WORD = "Zerspanwerk Mühlbauer GmbH 48151623", "Muehlbauer48151623"

_LASER = laser_file(
    ["0.0", "100.0", "200.0"],
    {(run, n): f"{0.1 * n + run / 10:.1f}" for run in (1, 2, 3, 4) for n in (1, 2, 3)},
    machine="{S}",
)
_ROWS = "0.5,+,1,0.4\n100.2,+,1,2.1\n100.2,-,1,-1.6\n0.5,-,1,-2.9\n"
_CIRCLE = "".join(f"ccw,{angle},{angle % 7 / 10:.1f}\n" for angle in range(0, 361, 2))
_BAR = "".join(f" {0.001 * (n % 5):.4f}" for n in range(400))

PLAIN = {
    "long": "# axis: X\n# {S}\n# machine: {S}\n# serial: {S}\n# operator: {S}\n# {S}: 5\n"
    "# date: {S}\n# instrument: {S}\n# compensated_for: {S}\n# T_m: 21,5 {S}\n#   {W}\n"
    "target_mm,direction,run,deviation_um,{W},note\n"
    + _ROWS.replace("\n", ",48151623,{S}\n")
    + "# {S}\n",
    "quoted": '"# machine: {S};""{W}""";;\ntarget_mm;direction;run;deviation_um;"{S} ""a"""\n'
    + _ROWS.replace(",", ";").replace("\n", ';"{S}"\n'),
    "wide": "# axis: {W}\n# unit: um\ntarget_mm,+1,-1,+2,-2,{S}\n0.5,0.4,-2.9,0.5,-3.1,{W}\n"
    "100.2,2.1,-1.6,2.4,-1.2,\n",
    "circle": "# compwright: circular 1\n# plane: XY\n# nominal_radius_mm: 150\n# feed_mm_min: 1000\n"
    "# calibrated: yes\n# {W}: 7\n# centre: 1, 2, 3\n# ballbar: {S}\n"
    "direction,angle_deg,deviation_um\n" + _CIRCLE,
    "still": "# machine: {S}\ntime_min,deviation_um,{W}\n0,0.0,48151623\n0.5,0.1,a\n1,0.3,{S}\n",
    "tgt": "# {S}\nTEST_DATA=# from /home/{W}/x.log\nREF_PV={W}:Enc\nTGT_SET_PV={S}\nUNIT=mm\n"
    "CYCLES=1\nPOSITIONS=2\nTGT_DATA[1]=0\nTGT_DATA[2]=10\nREF_DATA_FWD[1,1]=0.001\n"
    "REF_DATA_FWD[2,1]=10.002\nREF_DATA_BWD[1,1]=-0.001\nREF_DATA_BWD[2,1]=10.001\n",
    "rtl": _LASER.replace("4711", "{W}")
    .replace("N N", "{S}")
    .replace("hall 3", "{S}")
    .replace("TITLE: before", "TITLE: {S}\r\n{S}\r\n48151623\r\nKunde: {W}")
    .replace("EQUIPMENT::", "EQUIPMENT::\r\nLaser no: {W}\r\n{W}::\r\n{S}")
    .replace("Air temp   : 20.1", "Air temp   : 20.1\r\nSensor: {S}"),
    "pos": mean_file(
        {
            "Forward Directional": [("0.0", "0.0010"), ("100.0", "0.0020")],
            "Reverse Directional": [("0.0", "-0.0010"), ("100.0", "0.0010")],
        }
    )
    .replace("Axis: Y", "Axis: Y\r\nMachine: {S}\r\n{S}")
    .replace("ENVIRONMENT::", "{S}\r\nENVIRONMENT::\r\nOperator {S}"),
    "ren": compensation_file(
        [("1", "-250.0", "0.0", "0.001"), ("2", "-225.0", "0.002", "0.001"),
         ("3", "-200.0", "0.003", "0.002")],
    ).replace("X-Axis Position Accuracy", "{S}\r\n{S}\r\nMachine {W}"),
}  # fmt: skip
FOREIGN = (
    "Protokoll {S};;;;\nAchse: Y, Maschine {W};;;;\n"
    "Soll [mm];Richtung;Lauf;Abweichung (Ist - Soll) [µm];{S}\n"
    "0,000;auf;1;0,4;{W}\n100,000;auf;1;2,1;x\n100,000;ab;1;-0,8;\n0,000;ab;1;-2,9;{S}\n"
    "Mittel Mühlbauer;;;0,5;\n"
)
#: With a profile: words of directions and names of columns are somebody's too.
NAMED = FOREIGN.replace(";auf;", ";{W};").replace(";1;", ";{T} Nr 1;")
NAMED = NAMED.replace("Lauf", "Lauf {W}")
NAMED_PROFILE = """\
compwright_profile: 1   # {S}
layout: long
delimiter: semicolon
decimal: comma
header_line: 3
target: "Soll [mm]"
target_unit: mm
value: "Abweichung (Ist - Soll) [µm]"
value_is: deviation
unit: um
sign: measured minus target
direction_from: column
direction: Richtung
directions: {"{W}": "+", ab: "-"}
run: "Lauf {W}"
leave_out: ["{S}"]
"""
BALLBAR = f"""\
<?xml version="1.0" encoding="utf-8"?>
<!-- {{S}} -->
<?software {{W}}?>
<TEST_DOCUMENT owner="{{S}}">
  <TEST_SPEC NAME="{{S}}" version="2.0">
    <INSTRUMENT MANUFACTURER="{{W}}" MODEL="QC20-W">
      <DYNAMIC_BALLBAR CALIBRATION_REQUIRED="true" {{W}}="{{W}}">
        <NOMINAL_LENGTH>100</NOMINAL_LENGTH><PROGRAMMED_FEEDRATE>1000</PROGRAMMED_FEEDRATE>
        <START_ANGLE>0</START_ANGLE><END_ANGLE>360</END_ANGLE>
        <OVERSHOOT_ANGLE>10</OVERSHOOT_ANGLE><TEST_RADIUS>100</TEST_RADIUS>
        <PLANE VIEW="+A+B" TEST_PLANE="XY"><A_AXIS_NAME>X</A_AXIS_NAME>
          <B_AXIS_NAME>Y</B_AXIS_NAME></PLANE>
        <RUN_SPEC><RUN_DIRECTION>CCW</RUN_DIRECTION></RUN_SPEC>
        <NC_PROGRAM_ID>{{W}}</NC_PROGRAM_ID><{{W}}><DEEP a="{{S}}">{{S}}</DEEP></{{W}}>
      </DYNAMIC_BALLBAR>
    </INSTRUMENT>
  </TEST_SPEC>
  <OPERATOR>M&#252;hlbauer</OPERATOR><COMMENT NAME="{{S}}"><![CDATA[{{S}}]]></COMMENT>
  <DATE_STARTED>20260302-101500 {{W}}</DATE_STARTED>
  <MACHINE_TESTED NAME="{{S}}" SERIAL="{{W}}"/>
  <EQUIPMENT><BALLBAR><SERIAL_NUMBER>{{W}}</SERIAL_NUMBER><MODEL>{{S}}</MODEL></BALLBAR></EQUIPMENT>
  <RUN_RESULTS><BALLBAR_RUN><RUN_DIRECTION>CCW</RUN_DIRECTION><START_INDEX>20</START_INDEX>
    <END_INDEX>379</END_INDEX><READINGS>{_BAR}</READINGS>
    <FEATURE NAME="AF_{{W}}" DT="UT_LENGTH_UM">1.5</FEATURE>
  </BALLBAR_RUN></RUN_RESULTS>
</TEST_DOCUMENT>
<!-- {{S}} -->
"""

FANUC = {
    "CNC-PARA.TXT": "%\n({S})\nN01851Q1A1P4A2P0({W})\nN03605Q1A1P00000000A2P00000000\n"
    "N03620Q1A1P40A2P0\nN03621Q1A1P37A2P0\nN03622Q1A1P44A2P0\nN03623Q1A1P1A2P0\n"
    "N03624Q1A1M50.0A2M0.0\nN06711Q1P12\n%\nO0001({W})\nG01X100.Y48151623.(TEIL {W})\n"
    "#500=48151623({W})\nM30\n%\n",
    "PITCH.TXT": "%\nN10037Q0P1\nN10038Q0P0({W})\nN10039Q0P-2\nN10040Q0P1\nN10041Q0P2\nN10042Q0P1\n"
    "N10043Q0P0\nN10044Q0P-1\n%\n({W})\n",
}
SINUMERIK = {
    "AX_EEC.INI": "%_N_AX_EEC_INI\n;$PATH=/_N_WKS_DIR/_N_{W}_WPD\nCHANDATA(1)\n"
    "$AA_ENC_COMP[0,0,AX1]=0.003 ; {S}\n$AA_ENC_COMP[0,1,AX1]=0.001\n"
    "$AA_ENC_COMP[0,2,AX1]=0.0\n$AA_ENC_COMP_STEP[0,AX1]=50.0\n$AA_ENC_COMP_MIN[0,AX1]=-50.0\n"
    "$AA_ENC_COMP_MAX[0,AX1]=50.0\n$AA_ENC_COMP_IS_MODULO[0,AX1]=0\nM17\n; {S}\n",
    "AX1_MD.INI": 'CHANDATA(1)\n; {S}\nN20000 $MC_CHAN_NAME="{W}"\n'
    'N10000 $MN_AXCONF_MACHAX_NAME_TAB[0]="X1"\nN32450 $MA_BACKLASH[0,AX1]=0.0005\n'
    'N38000 $MA_MM_ENC_COMP_MAX_POINTS[0,AX1]=26 ;{W}\nMSG("{W} 1")\nDEF STRING[20] {W}\n'
    "G1 X48151623 Y2\nM17\n",
}
LINUXCNC = {
    "x.comp": "-200 -200.0080 -199.9960 {W}\n0 0.0000 0.0120\n200 200.0100 200.0230\n",
    "machine.ini": "# {S}\n[EMC]\nMACHINE = {S}\nSERIAL = 48151623\n[{W}]\nKEY = 48151623\n"
    "[TRAJ]\nLINEAR_UNITS = mm\nCOORDINATES = X Y\n[KINS]\nKINEMATICS = trivkins\n"
    "[JOINT_0]\nCOMP_FILE = /home/{W}/x.comp\nCOMP_FILE_TYPE = 0\nBACKLASH = 0\nMIN_LIMIT = -200\n"
    "; {S}\n[DISPLAY]\nINTRO_GRAPHIC = /srv/{W}.gif\nPROGRAM_PREFIX = ~/{W}\n",
}
HEIDENHAIN = {
    "X.COM": "BEGIN X .COM MM DATUM:-400 DIST:200\n#STRUCTBEGIN\n   NAME = 1=F()\n     TYPE = N\n"
    "     WIDTH = 9\n     DEC = 3\n*  // {S}\n     DIA-ENGLISH = {W}\n   NAME = 2=F()\n"
    "     TYPE = N\n     WIDTH = 9\n     DEC = 4\n#STRUCTEND\nNR      1=F()     2=F()\n"
    "0       +0.000    +0.0000\n1       -0.002    +0.0001\n2                 +0.0002\n"
    "3       +0.001    +0.0003\nEND X .COM\n",
    "MP.TXT": "; {S}\nMP710.1 : 0.0010 ; {W}\nMP730 : %00011\nMP7230 : {W}\n{W}\n",
}
PMAC = {
    "comp.pmc": "; {S}\nI51=0\n#1 DEFINE COMP 4,#1D,400000\n-32 -48 16 0\n"
    "#1 DEFINE BLCOMP 4,400000 ; {W}\n8 12 -4 0\nI185=32 I186=96\nI51=1\n;{S}\n",
}
ISG = {
    "achskw1.lis": "# {S}\nkopf.achs_nr                      1\nkopf.log_achs_name  X # {W}\n"
    "antr.{W} 5\nkw.ssfk.unit 1\nkw.ssfk.interval 0\nkw.ssfk.kw_startpos -2000000\n"
    "kw.ssfk.kw_nr_max 2\nkw.ssfk.bilateral 1\nkw.ssfk.modulo 0\n"
    "kw.ssfk.table[0].setpoint -2000000\nkw.ssfk.table[0].pos -40\nkw.ssfk.table[0].neg -25\n"
    "kw.ssfk.table[1].setpoint 0\nkw.ssfk.table[1].pos 0\nkw.ssfk.table[1].neg 18 # {S}\n",
}
SHEET = {
    "entry_X.csv": "# axis: X\n# address: X\n# value: error\n# {S}\n# machine: {S}\n"
    "point,position,value,unit\n0,-400.0000,0.0000,mm\n1,-200.0000,0.0040,mm\nMP710,,0.0040,mm\n",
}
CONTROLS: Mapping[str, Mapping[str, str]] = {
    "fanuc": FANUC, "sinumerik": SINUMERIK, "linuxcnc": LINUXCNC, "heidenhain": HEIDENHAIN,
    "pmac": PMAC, "isg": ISG, "sheet": SHEET,
}  # fmt: skip


def filled(text: str, encoding: str = "utf-8") -> bytes:
    """Return a sample with the secret at its places."""
    told = text.replace("{S}", FREE).replace("{W}", WORD).replace("{T}", "Muehlbauer")
    return told.encode(encoding)
