"""Axes that move together by the control's own files: a table on one of them alone racks the
machine. The job has to name the other one, or the axis is refused with the parameter.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from compwright.cli import run as compwright
from compwright.controls.control import decode, open_control
from compwright.foundations.errors import InputError, UsageError
from compwright.foundations.session import Session
from compwright.records.axis import Axis, AxisKind
from compwright.records.correction import ControlFile, ControlState

pytestmark = pytest.mark.short_estimate

# --- FANUC
# --------------------------------------------------------------------------------------------------

#: By parameter: X, Y, Z, V; V carries the second column of X.
FANUC: Mapping[int, tuple[str, ...]] = {
    1006: ("00000000",) * 4,
    1013: ("00000000",) * 4,
    1020: ("88", "89", "90", "86"),
    1820: ("2",) * 4,
    1851: ("4", "2", "6", "4"),
    3620: ("40", "100", "300", "240"),
    3621: ("37", "100", "300", "237"),
    3622: ("44", "104", "310", "244"),
    3623: ("1", "2", "0", "1"),
    3624: ("50.0", "100.0", "50.0", "50.0"),
}
POINTS = {37: 1, 39: -2, 40: 1, 41: 2, 42: 1, 44: -1, 101: 3, 102: -1, 103: 2, 104: -2}
POINTS |= {number + 200: value for number, value in POINTS.items() if number < 100}


def fanuc(more: Mapping[int, str]) -> tuple[ControlFile, ...]:
    """Parameters and pitch data; ``more``: further lines by number, without it; empty: no line."""
    rows = {
        number: "".join(f"A{axis}P{value}" for axis, value in enumerate(values, start=1))
        for number, values in FANUC.items()
    }
    lines = sorted({**rows, **more}.items())
    text = "".join(f"N{number:05d}Q1{row}\n" for number, row in lines if row)
    points = "".join(f"N{10_000 + n}Q0P{POINTS.get(n, 0)}\n" for n in range(400))
    return (
        ControlFile("CNC-PARA.TXT", f"%\n{text}%".encode()),
        ControlFile("PITCH.TXT", f"%\n{points}%".encode()),
    )


def axis(address: str, gantry: str | None = None, *, alone: bool = False) -> Axis:
    return Axis(
        name={"1": "X", "2": "Y", "3": "Z", "4": "V"}[address],
        kind=AxisKind.LINEAR,
        travel=(-150.0, 200.0),
        address=address,
        gantry=gantry,
        moves_alone=alone,
    )


def read(
    more: Mapping[int, str], *axes: Axis, format_id: str = "fanuc-30i", **options: object
) -> ControlState:
    return decode(open_control(Session(), format_id, options), fanuc(more), axes).state


SYNCHRONOUS = {8311: "A1P0A2P0A3P0A4P1", 8312: "A1P0A2P0A3P0A4P0"}
TANDEM = {1817: "A1P01000000A2P00000000A3P00000000A4P01000000", 1023: "A1P1A2P3A3P4A4P2"}


@pytest.mark.parametrize("format_id", ["fanuc-30i", "fanuc-0i-d", "fanuc-0i-f"])
def test_a_slave_of_synchronous_control_is_asked_for(format_id: str) -> None:
    with pytest.raises(UsageError, match=r'8311 of axis 4 = 1.*gantry: "4"'):
        read(SYNCHRONOUS, axis("1"), format_id=format_id)
    assert set(read(SYNCHRONOUS, axis("1", "4"), format_id=format_id).axes) == {"1", "4"}
    assert set(read(SYNCHRONOUS, axis("2"), format_id=format_id).axes) == {"2"}


def test_work_on_the_slave_itself_is_refused() -> None:
    for asked in (axis("4"), axis("4", "1"), axis("2", "4")):
        with pytest.raises(InputError, match="8311 of axis 4 = 1"):
            read(SYNCHRONOUS, asked)


def test_a_coupling_that_a_program_switches_can_be_off() -> None:
    """The job says that the axis moves alone: both axes keep tables of their own, and that is
    said.
    """
    for asked in (axis("1", alone=True), axis("4", alone=True)):
        state = read(SYNCHRONOUS, asked)
        assert set(state.axes) == {asked.address}
        assert "CW-S035" in {finding.code for finding in state.findings}
    with pytest.raises(UsageError, match="1817"):
        read(TANDEM, axis("1", alone=True))
    for fixed in ({1817: "P01000000"}, {1817: "A1P64"}, {8200: "L1P1", 8211: "L1P1", 8212: "L1P2"}):
        with pytest.raises(InputError, match=str(min(fixed))):  # no program switches these
            read(fixed, axis("1", alone=True))


@pytest.mark.parametrize(
    ("more", "asked", "error", "says"),
    [
        (TANDEM, axis("1"), UsageError, "1817 of axis 4"),
        (TANDEM, axis("4"), InputError, "1817 of axis 4"),
        ({1817: TANDEM[1817]}, axis("1"), InputError, "1817 of axis 1"),
        ({**SYNCHRONOUS, 8312: "A4P100"}, axis("1", "4"), InputError, "8312 of axis 4 = 100"),
        ({8311: "A1P0A2P1A3P0A4P1"}, axis("1", "4"), InputError, "2, 4 follow axis 1"),
        ({8311: "A1P0A2P0A3P0A4P1"}, axis("1", "2"), InputError, 'gantry: "4"'),
        ({8180: "A1P0A2P0A3P0A4P1"}, axis("1"), UsageError, "8180 of axis 4"),
        ({8183: "A1P0A2P0A3P0A4P1"}, axis("1"), InputError, "8183 of axis 4"),
        ({8186: "A1P4A2P0A3P0A4P0"}, axis("1"), InputError, "8186 of axis 1"),
        ({5660: "L1P1L2P0", 5661: "L1P4L2P0"}, axis("1"), InputError, "5661 of path 1 = 4"),
        ({5660: "L1P1L2P0", 5661: "L1P4L2P0"}, axis("4"), InputError, "5661 of path 1 = 4"),
        ({8200: "L1P00000001", 8211: "L1P2", 8212: "L1P3"}, axis("3"), InputError, "8200"),
        ({8200: "L1P00000001", 8211: "L1P0", 8212: "L1P0"}, axis("1"), InputError, "8200"),
        ({981: "A1P1A2P1A3P2A4P2", 8180: "A3P101"}, axis("1"), UsageError, "8180 of axis 3"),
        ({8311: "A1P0A2P0A3P0A4P21"}, axis("1"), InputError, "8311 of axis 4 = 21"),
        ({8311: "A1P0A2P0A3P0A4P21"}, axis("2", "4"), InputError, "8311 of axis 4 = 21"),
        ({8311: "A1P0A2P-1A3P0A4P0"}, axis("1"), InputError, "8311 of axis 2 = -1"),
        ({8180: "A4P205"}, axis("1"), InputError, "8180 of axis 4 = 205"),
        ({1817: "A4P01000000", 1023: "A4P2"}, axis("1"), InputError, "1817 of axis 4"),
        ({5660: "L1P21", 5661: "L1P4"}, axis("1"), InputError, "5661 of path 1 = 4"),
        ({8200: "L1P00000001", 8211: "L1P2", 8212: "L1P21"}, axis("1"), InputError, "8200"),
        # without an axis, or in a form that no control gives out: what it couples is unknown
        ({8311: "P1"}, axis("1"), InputError, "8311 = 1"),
        ({8311: "L1P1"}, axis("1"), InputError, "8311 of path 1 = 1"),
        ({8311: "A1P0A2P0A3P0A4P+1"}, axis("1"), InputError, "8311 cannot be read"),
        ({8180: "A1P0A4P&1"}, axis("1"), InputError, "8180 cannot be read"),
        ({1817: "P01000000"}, axis("1"), InputError, "1817 = 01000000"),
        ({1817: "A1P64A4P64", 1023: "A1P1A4P2"}, axis("1"), InputError, "1817 of axis 1 = 64"),
        ({8200: "L1P1", 8211: "L1P1", 8212: "L1P2"}, axis("1"), InputError, "8200 of path 1 = 1"),
    ],
)
def test_each_coupling_of_a_fanuc_names_its_parameter(
    more: Mapping[int, str], asked: Axis, error: type[Exception], says: str
) -> None:
    with pytest.raises(error, match=says):
        read(more, asked)


@pytest.mark.parametrize(
    "more",
    [
        {8200: "L1P00000001", 8211: "L1P2", 8212: "L1P3"},
        {8200: "L1P00000000", 8211: "L1P1", 8212: "L1P3"},
        {8311: "A1P0A2P0A3P2A4P0"},
        {8311: "A1P1A2P0A3P4A4P0"},
        {1817: "A1P00000000A2P01000000A3P01000000A4P00000000", 1023: "A1P1A2P3A3P4A4P5"},
        {5660: "L1P0", 5661: "L1P4"},
        {1817: "A1P0A2P0A3P0A4P0", 8200: "L1P0"},
    ],
)
def test_what_couples_other_axes_stops_nothing(more: Mapping[int, str]) -> None:
    assert set(read(more, axis("1")).axes) == {"1"}


@pytest.mark.parametrize("second", [axis("1", "2"), axis("2")])
def test_one_detection_unit_is_not_that_of_two_multipliers(second: Axis) -> None:
    """Detection unit = least command increment / CMR; 1820 = 2 x CMR (B-63943EN-1/02 page 109): of
    one increment system 2 and 4 are units of 1 to 1/2.
    """
    axes = (axis("1"), second) if second.address == "2" else (second,)
    no_system = {1013: ""}
    read({**no_system, 1820: "A1P2A2P2A3P2A4P4"}, *axes, detection_unit=0.001)
    with pytest.raises(InputError, match=r"axis 2.*1820.*detection_unit"):
        read({**no_system, 1820: "A1P2A2P4A3P2A4P2"}, *axes, detection_unit=0.001)


def test_a_new_job_names_the_slave(tmp_path: Path) -> None:
    for file in fanuc(SYNCHRONOUS):
        (tmp_path / file.name).write_bytes(file.content)
    out = tmp_path / "job.yaml"
    files = [str(tmp_path / file.name) for file in fanuc({})]
    assert compwright(["new", "--from", *files, "--format", "fanuc-30i", "--out", str(out)]) == 0
    text = out.read_text(encoding="utf-8")
    assert 'gantry: "4"' in text
    assert "  V:" not in text


# --- the other controls
# --------------------------------------------------------------------------------------------------

EEC = (
    "$AA_ENC_COMP[0,0,{a}]=0\n$AA_ENC_COMP[0,1,{a}]=0.002\n$AA_ENC_COMP_STEP[0,{a}]=400\n"
    "$AA_ENC_COMP_MIN[0,{a}]=0\n$AA_ENC_COMP_MAX[0,{a}]=400\n$AA_ENC_COMP_IS_MODULO[0,{a}]=0\n"
    "$MA_BACKLASH[0,{a}]=0.001\n$MA_ENC_COMP_ENABLE[0,{a}]=1\n"
)
SINUMERIK = "CHANDATA(1)\n" + EEC.format(a="AX1") + EEC.format(a="AX5")
LINUXCNC = (
    "[KINS]\n{kins}JOINTS = 2\n[TRAJ]\nLINEAR_UNITS = mm\n"
    "[JOINT_0]\nTYPE = LINEAR\nBACKLASH = 0.01\nHOME_SEQUENCE = {one}\n"
    "[JOINT_1]\nTYPE = LINEAR\nBACKLASH = 0.01\nHOME_SEQUENCE = {two}\n"
)
PMAC = "&1\n#1->1000X\n#2->{second}\nI186=16\nI286=16\nI185=1\nI285=1\n{more}"
ISG_LIST = (
    "kopf.achs_nr {n}\nkw.ssfk.unit 1\nkw.ssfk.interval 20000\nkw.ssfk.kw_startpos 0\n"
    "kw.ssfk.kw_nr_max 3\nkw.ssfk.bilateral 0\nkw.ssfk.table[0].pos 0\nkw.ssfk.table[1].pos 10\n"
    "kw.ssfk.table[2].pos -30\n{more}"
)
MP = "MP710.0 : 0.002\nMP710.1 : 0.002\nMP850.0 : 0\nMP850.1 : {slave}\n"


def others(
    format_id: str,
    texts: Mapping[str, str],
    address: str,
    gantry: str | None = None,
    *,
    alone: bool = False,
    options: Mapping[str, object] = {},
) -> ControlState:
    asked = Axis(
        name="Q" if format_id == "linuxcnc" else "X",
        kind=AxisKind.LINEAR,
        travel=(0.0, 400.0),
        address=address,
        gantry=gantry,
        moves_alone=alone,
        axis_number=1 if "heidenhain" in format_id else None,
    )
    files = [ControlFile(name, text.encode()) for name, text in texts.items()]
    return decode(open_control(Session(), format_id, dict(options)), files, [asked]).state


def sinumerik(more: str, address: str, **words: Any) -> ControlState:
    return others("siemens-840d-sl", {"MD.INI": f"{SINUMERIK}{more}\nM17\n"}, address, **words)


def test_the_couplings_of_a_sinumerik_name_their_machine_data() -> None:
    master = "$MA_MS_ASSIGN_MASTER_SPEED_CMD[AX5]=1"
    state = sinumerik(master, "AX1")
    (found,) = [one for one in state.findings if one.code == "CW-S037"]
    assert "MD37250" in found.message
    with pytest.raises(InputError, match=r"MD37250.*gantry: none"):
        sinumerik(master, "AX5")
    with pytest.raises(InputError, match="MD37252"):
        sinumerik(
            "$MA_MS_ASSIGN_MASTER_TORQUE_CTR[AX5]=1\n$MA_MS_COUPLING_ALWAYS_ACTIVE[AX5]=1",
            "AX5",
            alone=True,
        )
    with pytest.raises(UsageError, match="MD63000"):
        sinumerik("$MA_CC_MASTER_AXIS[AX5]=1", "AX1")
    turned = "$MC_TRAFO_RESET_VALUE=2\n$MC_TRAFO_TYPE_2=1024"
    with pytest.raises(InputError, match=r"TRAANG.*MD20140"):
        sinumerik(turned, "AX1")
    sinumerik(turned, "AX1", alone=True)
    sinumerik(turned.replace("1024", "24"), "AX1")
    sinumerik(turned.replace("=2\n", "=1\n"), "AX1")


def test_joints_that_home_together_may_be_one_axis() -> None:
    def read_ini(kins: str, one: int, two: int, **words: Any) -> ControlState:
        text = LINUXCNC.format(kins=kins, one=one, two=two)
        return others("linuxcnc", {"m.ini": text}, "0", **words)

    with pytest.raises(UsageError, match="HOME_SEQUENCE = -1"):
        read_ini("", -1, -1)
    assert set(read_ini("", -1, -1, gantry="1").axes) == {"0", "1"}
    read_ini("", -1, -1, alone=True)
    read_ini("", 1, 1)
    read_ini("", -1, -2)
    read_ini("KINEMATICS = trivkins coordinates=XZ\n", -1, -1)


@pytest.mark.parametrize(
    ("second", "more", "error", "says"),
    [
        ("1000X", "", UsageError, "#2->1000X"),
        ("-1000X", "", InputError, "ratio"),
        ("500X+20Y", "", InputError, "2 axes at once"),
        ("1000Y", "I103=$3501\nI205=$3501\nI206=1\n", UsageError, "I206=1"),
        ("1000Y", "I205=$8B\nI206=1\n", UsageError, "I206=1, I205=$8B"),
        ("1000Y", "I205=$35C0\nI206=3\n", UsageError, "I206=3, I205=$35C0"),
        ("1000Y", "I206=1\n", UsageError, "I206=1"),
        ("1000Y", "I206=P12\n", UsageError, "I206=P12"),
        ("1000Y", "I205=$8B\nI206=1\nI207=-96\n", InputError, "ratio"),
        ("1000Y", "I106=1\n", InputError, "I106=1"),
        ("1000Y", "#define ON 1\nI106=ON\n", InputError, "I106=1"),
        # whether the block was sent decides whether the last statement counts
        ("1000X", "#ifdef SINGLE\n#2->0\n#endif\n", UsageError, "#2->1000X"),
        ("1000Y", "#ifdef PAIR\n#2->1000X\n#else\n#2->1000Y\n#endif\n", UsageError, "#2->1000X"),
        ("1000Y", "I205=$8B\nI206=1\n#ifdef SINGLE\nI206=0\n#endif\n", UsageError, "I206=1"),
        (
            "1000Y",
            "#ifdef PAIR\n#define MODE 1\n#else\n#define MODE 0\n#endif\nI206=MODE\n",
            UsageError,
            "I206=MODE",
        ),
    ],
)
def test_motors_of_one_axis_are_asked_for(
    second: str, more: str, error: type[Exception], says: str
) -> None:
    texts = {"a.pmc": PMAC.format(second=second, more=more)}
    options = {"counts_per_unit": 1000}
    address = "2" if "Y" in second and not more else "1"
    with pytest.raises(error, match=re.escape(says)):
        others("pmac", texts, address, options=options)


def test_motors_of_different_axes_are_not_coupled() -> None:
    options = {"counts_per_unit": 1000}
    for second, more in (
        ("1000Y", ""),
        ("1000Y", "I206=0\n"),
        ("0", "; I206=1\n"),
        ("1000Y", "#3->1000Z\nI305=$10B\nI306=1\n"),
    ):
        texts = {"a.pmc": PMAC.format(second=second, more=more)}
        assert set(others("pmac", texts, "1", options=options).axes) == {"1"}


def test_the_slave_of_an_isg_gantry_is_asked_for() -> None:
    def lists(more: str) -> dict[str, str]:
        return {"a.lis": ISG_LIST.format(n=1, more=""), "b.lis": ISG_LIST.format(n=2, more=more)}

    with pytest.raises(UsageError, match=r"kenngr\.gantry_ax_nr 1"):
        others("isg-kernel", lists("kenngr.gantry_ax_nr 1\n"), "1")
    assert set(others("isg-kernel", lists("kenngr.gantry_ax_nr 1\n"), "1", "2").axes) == {"1", "2"}
    with pytest.raises(InputError, match="multi_link"):
        others("isg-kernel", lists("kenngr.multi_link[0].lead_axis 1\n"), "1")
    others("isg-kernel", lists("kenngr.gantry_ax_nr 0\n"), "1")


def test_the_slave_of_an_itnc_is_asked_for() -> None:
    def read_mp(slave: int, address: str, gantry: str | None = None) -> ControlState:
        texts = {"MP.TXT": MP.format(slave=slave)}
        return others("heidenhain-itnc530", texts, address, gantry)

    with pytest.raises(UsageError, match=r"MP850\.1 : 1"):
        read_mp(1, "X")
    assert set(read_mp(1, "X", "Y").axes) == {"X", "Y"}
    read_mp(0, "X")


def test_a_slave_of_an_itnc_without_a_name_goes_by_its_number() -> None:
    """MP850.3: axis 4. By the letters X to C it would be A, which turns and can follow no X."""
    rows = "MP710.0 : 0.002\nMP710.3 : 0.004\nMP850.0 : 0\nMP850.3 : 1\n"

    def read_mp(address: str, gantry: str | None = None) -> ControlState:
        return others("heidenhain-itnc530", {"MP.TXT": rows}, address, gantry)

    with pytest.raises(UsageError, match='gantry: "AX4"'):
        read_mp("X")
    state = read_mp("X", "AX4")
    assert {one: axis.backlash for one, axis in state.axes.items()} == {"X": 0.002, "AX4": 0.004}
    assert set(read_mp("X", "A").axes) == {"X", "A"}  # the job names it so
    texts = {"MP.TXT": rows}
    turning = Axis(name="A", kind=AxisKind.ROTARY, travel=(0.0, 360.0), address="A")
    files = [ControlFile(name, text.encode()) for name, text in texts.items()]
    with pytest.raises(InputError, match="axis A follows axis X"):
        decode(open_control(Session(), "heidenhain-itnc530", {}), files, [turning])
