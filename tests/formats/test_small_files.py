"""Small files out of a real archive in its container: what they enter, what they leave as it is,
and the way back, held against a virtual control that shares nothing with the package.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from compwright.formats.families.activity import Activity
from compwright.formats.families.family import Family
from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import InputError, UsageError
from compwright.records.axis import Axis, AxisKind, Encoder
from compwright.records.correction import AxisCompensation, ControlFile
from compwright.records.delivery import Delivery
from format_samples import SIEMENS
from sinumerik_archive import (
    ARCHIVE,
    cec_lines,
    cec_text,
    eec_text,
    machine_data,
    needs_archive,
    put,
    replace_cec,
)
from sinumerik_archive import (
    LISTING as COLUMNS,
)
from sinumerik_container import container
from virtual_sinumerik import VirtualSinumerik

pytestmark = needs_archive

ACTIVE = "\\_NC_ACT.DIR\\"
TABLED = ["AX1", "AX2", "AX3", "AX4", "AX5"]
REAL_ARCHIVE = ControlFile("backup.arc", ARCHIVE.read_bytes() if ARCHIVE.is_file() else b"")
MACHINE = {"AX1": "X1", "AX2": "Y1", "AX3": "Z1", "AX4": "C1", "AX5": "A1"}


def archive(**texts: str) -> ControlFile:
    """The archive with the machine data that count; ``texts`` in place of its tables (``eec``,
    ``cec``).
    """
    members = [
        (ACTIVE, "AX_EEC.INI", texts.get("eec", eec_text()).encode("latin-1")),
        (ACTIVE, "NC_CEC.INI", texts.get("cec", cec_text()).encode("latin-1")),
        (ACTIVE, "INITIAL.INI", machine_data().encode("latin-1")),
    ]
    return ControlFile("backup.arc", container(members))


def axis_of(control: Family, file: ControlFile, address: str) -> tuple[Axis, AxisCompensation]:
    """The axis of a job as the archive says it, and what acts on it."""
    state = control.read([file], address=address)
    found, facts = state.axes[address], state.facts_of(address)
    travel = (float(found.positions[0]), float(found.positions[-1]))
    system = facts.encoder_system
    assert system is not None
    axis = Axis(
        name=str(facts.name),
        kind=found.kind,
        address=address,
        travel=travel,
        encoder=Encoder(system=system, stated=True),
        modulo=found.period,
    )
    return axis, found


def bent(table: AxisCompensation, step: float = 1e-3) -> AxisCompensation:
    """The table with 1 to 3 steps (mm or deg) more inside, and a backlash of 2."""
    inside = np.arange(table.positions.size) % 3 + 1.0
    inside[[0, -1]] = 0.0
    more = step * inside
    return replace(
        table, positive=table.positive + more, negative=table.negative + more, backlash=2 * step
    )


def delivered(
    file: ControlFile, address: str, step: float = 1e-3
) -> tuple[Delivery, AxisCompensation, Axis]:
    control = control_format(SIEMENS, {})
    axis, old = axis_of(control, file, address)
    bound = control.in_state(control.read([file], [axis]))
    new = bent(old, step)
    written = bound.write([new], [axis], [file])
    return bound.delivered(written, [file], [axis]), new, axis


def loaded(cec: str | None = None) -> VirtualSinumerik:
    """The control as the archive left it."""
    control = VirtualSinumerik()
    for text in (machine_data(), eec_text(), cec or cec_text()):
        control.load(text, protected=False)
    return control


def switched_off_and(
    control: VirtualSinumerik, address: str, files: tuple[ControlFile, ...]
) -> None:
    """MD32700 = 0, then the files in the order in which they are delivered."""
    control.load(f"$MA_ENC_COMP_ENABLE[1,{address}]=0")
    for file in files:
        control.load(file.content.decode("ascii"))
    assert not [one for one in control.refused if one.mattered]


@pytest.mark.parametrize("address", TABLED)
def test_small_files_do_what_was_planned_and_bring_the_old_state_back(address: str) -> None:
    """Every register of the control is as before, to the last digit."""
    delivery, new, _ = delivered(REAL_ARCHIVE, address)
    name = MACHINE[address]
    assert [file.name for file in delivery.files] == [f"{name}_EEC.INI", f"{name}_MD.INI"]
    assert [file.name for file in delivery.back] == [f"BACK_{name}_EEC.INI", f"BACK_{name}_MD.INI"]
    control = loaded()
    before = {key: value.text for key, value in control.registers.items()}
    where = np.linspace(new.positions[0], new.positions[-1], 101)
    held = {d: control.correction(address, where, d) for d in (1, -1)}

    switched_off_and(control, address, delivery.files)
    for d in (1, -1):
        direction = "+" if d > 0 else "-"
        planned = new.at(
            where, next(one for one in type(new.reference_return) if one.value == direction)
        )
        others = loaded_without(address).correction(address, where, d)
        assert control.correction(address, where, d) - others == pytest.approx(planned, abs=1e-9)

    switched_off_and(control, address, delivery.back)
    assert {key: value.text for key, value in control.registers.items()} == before
    for d in (1, -1):
        assert control.correction(address, where, d) == pytest.approx(held[d], abs=1e-12)


def loaded_without(address: str) -> VirtualSinumerik:
    """The control with the leadscrew table of one axis off and no backlash on it."""
    control = loaded()
    control.load(f"$MA_ENC_COMP_ENABLE[1,{address}]=0\n$MA_BACKLASH[1,{address}]=0")
    return control


@pytest.mark.parametrize("address", ["AX1", "AX4"])
def test_small_files_alone_say_everything_of_their_axis(address: str) -> None:
    """Kind, turn, limits, measuring system, and what else acts on it."""
    control = control_format(SIEMENS, {})
    delivery, new, axis = delivered(archive(), address)
    whole = control.read([archive()], [axis])
    alone = control.read(delivery.files, [axis])
    without_job = control.read(delivery.files)
    assert without_job.axes[address].kind is new.kind
    assert without_job.axes[address].period == new.period
    for one in (alone, without_job):
        assert one.axes[address].positive == pytest.approx(new.positive, abs=1e-9)
        assert one.axes[address].backlash == pytest.approx(new.backlash, abs=1e-9)
    facts = whole.facts_of(address)
    of_files = ("archive", "others_protected")  # what is said of the archive itself
    left_open = {name: fact for name, fact in facts.stated.items() if name not in of_files}
    assert replace(alone.facts_of(address), name=None, pairs=facts.pairs) == (
        replace(facts, name=None, stated=left_open)
    )


@pytest.mark.parametrize("turned", [False, True], ids=["archive first", "archive last"])
def test_small_files_beside_the_archive_were_loaded_over_it(turned: bool) -> None:
    control = control_format(SIEMENS, {})
    delivery, new, axis = delivered(archive(), "AX2")
    files = [archive(), *delivery.files]
    state = control.read(files[::-1] if turned else files, [axis])
    assert state.axes["AX2"].positive == pytest.approx(new.positive, abs=1e-9)
    assert state.axes["AX2"].backlash == pytest.approx(new.backlash, abs=1e-9)
    back = control.read([archive(), *delivery.back], [axis])
    before = control.read([archive()], [axis])
    assert np.array_equal(back.axes["AX2"].positive, before.axes["AX2"].positive)


def test_a_shorter_table_beside_the_archive_leaves_nothing_behind_its_end() -> None:
    """The archive's values behind the new end are the old table's: the new one ends the table."""
    control = control_format(SIEMENS, {})
    _, axis_old = axis_of(control, archive(), "AX4")
    rows = "".join(f"$AA_ENC_COMP[1,{n},AX4]=0.00{n % 3}\n" for n in range(4)).replace(
        "[1,3,AX4]=0.000", "[1,3,AX4]=0.000"
    )
    text = (
        f"CHANDATA(1)\n{rows}$AA_ENC_COMP_STEP[1,AX4]=120\n$AA_ENC_COMP_MIN[1,AX4]=0\n"
        "$AA_ENC_COMP_MAX[1,AX4]=360\nM17\n"
    )
    state = control.read([archive(), ControlFile("C.INI", text.encode())], address="AX4")
    assert state.axes["AX4"].positions.size == 4 < axis_old.positions.size


def test_a_member_that_contradicts_another_is_refused_by_name() -> None:
    other = (
        machine_data().encode().replace(b"$MA_BACKLASH[1,AX1]=0", b"$MA_BACKLASH[1,AX1]=0.01", 1)
    )
    texts = [
        (ACTIVE, "CFG.INI", b"CHANDATA(1)\n$MA_BACKLASH[1,AX1]=0\nM17\n"),
        (ACTIVE, "AX_EEC.INI", eec_text().encode()),
        (ACTIVE, "INITIAL.INI", other),
    ]
    control = control_format(SIEMENS, {})
    with pytest.raises(InputError, match=r"MA_BACKLASH contradicts backup.arc: CFG.INI, line 2"):
        control.read([ControlFile("backup.arc", container(texts))], address="AX1")


def test_programs_in_the_archive_are_named_and_count_as_nothing() -> None:
    program = (
        "\\WKS.DIR\\K.WPD\\",
        "LOAD.MPF",
        b"$AA_ENC_COMP[1,0,AX1]=0.5\nM30\n",
    )
    reader = ("\\CMA.DIR\\", "LOOK.SPF", b"IF $MA_ENC_COMP_ENABLE[1,AX1]==0 GOTOF A\nM17\n")
    texts = [
        (ACTIVE, "AX_EEC.INI", eec_text().encode()),
        (ACTIVE, "INITIAL.INI", machine_data().encode()),
    ]
    control = control_format(SIEMENS, {})
    plain = control.read([ControlFile("a.arc", container(texts))], address="AX1")
    state = control.read(
        [ControlFile("a.arc", container([*texts, program, reader]))], address="AX1"
    )
    (told,) = [one.message for one in state.findings if one.code == "CW-S070"]
    assert "LOAD.MPF" in told
    assert "LOOK.SPF" not in told
    assert np.array_equal(state.axes["AX1"].positive, plain.axes["AX1"].positive)


def test_an_archive_is_never_patched() -> None:
    control = control_format(SIEMENS, {"files": "patched"})
    axis, old = axis_of(control, archive(), "AX1")
    bound = control.in_state(control.read([archive()], [axis]))
    with pytest.raises(UsageError, match=r"backup.arc is an archive in a container") as refused:
        bound.write([bent(old)], [axis], [archive()])
    assert refused.value.faults[0].place == "files"


def test_small_files_of_an_inch_archive_say_so() -> None:
    """The line INCH stands where the archive has METRIC, before the channel."""
    eec = eec_text().replace("METRIC\n", "INCH\n")
    data = machine_data().replace("METRIC\n", "INCH\n").replace("_IS_METRIC=1", "_IS_METRIC=0")
    texts = [(ACTIVE, "AX_EEC.INI", eec.encode()), (ACTIVE, "INITIAL.INI", data.encode())]
    file = ControlFile("backup.arc", container(texts))
    delivery, new, axis = delivered(file, "AX3", step=0.00254)
    assert all(one.content.split(b"\n").index(b"INCH") < 2 for one in delivery.files)
    state = control_format(SIEMENS, {}).read(delivery.files, [axis])
    assert state.axes["AX3"].positive == pytest.approx(new.positive, abs=1e-9)


def test_other_containers_are_refused_with_what_to_export() -> None:
    control = control_format(SIEMENS, {})
    with pytest.raises(InputError, match=r"ZIP archive.*AX_EEC.INI, NC_CEC.INI, INITIAL.INI"):
        control.read([ControlFile("backup.dsf", b"PK\x03\x04" + b"\x00" * 100)])


def test_a_pair_between_directions_goes_back_to_what_its_tables_held() -> None:
    """Tables 9 and 10 held something of another axis' past, and were off."""
    held = replace_cec(
        replace_cec(cec_text(), 9, cec_lines(9, "AX1", "AX1", 0, 100, [0.0] * 10, direction=1)),
        10,
        cec_lines(10, "AX1", "AX1", 0, 100, [0.0] * 10, direction=-1),
    )
    file = archive(cec=held)
    options: dict[str, object] = {"cec": "available", "cec_tables": [9, 10], "cec_sign": "error"}
    control = control_format(SIEMENS, options)
    axis, old = axis_of(control, file, "AX1")
    bound = control.in_state(control.read([file], [axis]))
    more = np.where(np.arange(old.positions.size) % 2, 0.001, 0.0)
    new = replace(bent(old), negative=old.negative + more, backlash=0.0)
    delivery = bound.delivered(bound.write([new], [axis], [file]), [file], [axis])
    assert [one.name for one in delivery.files] == ["X1_CEC.INI", "X1_MD.INI"]
    before = loaded(held)
    # room, and both switches off, as the card has it
    before.load("$MN_MM_CEC_MAX_POINTS[9]=25\n$MN_MM_CEC_MAX_POINTS[10]=25", protected=False)
    registers = {key: value.text for key, value in before.registers.items()}
    before.load("$MA_CEC_ENABLE[AX1]=0")
    for files in (delivery.files, delivery.back):
        before.load(
            "$MA_ENC_COMP_ENABLE[1,AX1]=0\n$SN_CEC_TABLE_ENABLE[9]=0\n$SN_CEC_TABLE_ENABLE[10]=0"
        )
        for one in files:
            before.load(one.content.decode("ascii"))
        assert not [one for one in before.refused if one.mattered]
    before.load("$MA_CEC_ENABLE[AX1]=1")
    after = {key: value.text for key, value in before.registers.items()}
    assert {key: text for key, text in after.items() if registers.get(key, "0") != text} == {}


# -- listings
# --------------------------------------------------------------------------------------------------

LISTING = """CHANDATA(1)
$AA_ENC_COMP[0,0,AX1]=0,0000
$AA_ENC_COMP[0,1,AX1]=0,0012 ; measured
$AA_ENC_COMP[0,2,AX1]=-0,0030
$AA_ENC_COMP_STEP[0,AX1]=19,7436
$AA_ENC_COMP_MIN[0,AX1]=-215,0
$AA_ENC_COMP_MAX[0,AX1]=-175,5128
$MA_BACKLASH[0,AX1]=n/a
$MA_ENC_COMP_ENABLE[0,AX1]=1
M17
"""
DATA = "CHANDATA(1)\n$MA_BACKLASH[0,AX1]=0.001\nM17\n"


def listing(text: str, *others: str) -> list[ControlFile]:
    texts = {"list.txt": text} | {f"other{n}.ini": one for n, one in enumerate(others)}
    return [ControlFile(name, one.encode()) for name, one in texts.items()]


def test_decimal_commas_are_read_where_all_values_have_them() -> None:
    state = control_format(SIEMENS, {}).read(listing(LISTING, DATA), address="AX1")
    axis = state.axes["AX1"]
    assert axis.positions == pytest.approx([-215.0, -195.2564, -175.5128], abs=1e-9)
    assert axis.positive == pytest.approx([0.0, -0.0012, 0.003], abs=1e-12)
    assert axis.backlash == pytest.approx(0.001, abs=1e-12)
    assert any(one.code == "CW-S071" for one in state.findings)


def test_a_value_that_the_listing_does_not_know_is_asked_for_by_name() -> None:
    with pytest.raises(
        InputError, match=r"line 8 cannot be read: the listing does not know it; .*MA_BACKLASH"
    ):
        control_format(SIEMENS, {}).read(listing(LISTING), address="AX1")


@pytest.mark.parametrize("value", ["0.0012", ".5", "-1.0"])
def test_commas_beside_points_are_refused(value: str) -> None:
    with pytest.raises(InputError, match=r"decimal comma\?"):
        control_format(SIEMENS, {}).read(
            listing(LISTING.replace("0,0012 ; measured", value), DATA), address="AX1"
        )


def test_a_listing_is_not_patched() -> None:
    """Small files go into the control; what was listed is brought back by others."""
    control = control_format(SIEMENS, {})
    files = listing(LISTING, DATA)
    axis = Axis(
        name="X", kind=AxisKind.LINEAR, address="AX1", travel=(-215.0, -175.0), reference=-215.0
    )
    state = control.read(files, [axis])
    bound = control.in_state(state)
    new = replace(bent(state.axes["AX1"]), positions=np.array([-215.0, -195.0, -175.0]))
    delivery = bound.delivered(bound.write([new], [axis], files), files, [axis])
    assert [file.name for file in delivery.files] == ["AX1_EEC.INI", "AX1_MD.INI"]
    assert not any(
        b"," in line.split(b"=")[-1] for one in delivery.files for line in one.content.split(b"\n")
    )
    assert b"$AA_ENC_COMP[0,2,AX1]=-0.0030" in delivery.back[0].content
    patched = control_format(SIEMENS, {"files": "patched"})
    with pytest.raises(UsageError, match=r"list.txt is a listing with decimal commas"):
        patched.in_state(patched.read(files, [axis])).write([new], [axis], files)


@pytest.mark.skipif(not COLUMNS.is_file(), reason=f"the real listing is not there ({COLUMNS})")
def test_a_listing_in_columns_is_refused_with_what_to_export() -> None:
    file = ControlFile(COLUMNS.name, COLUMNS.read_bytes())
    with pytest.raises(InputError, match=r"in columns.*AX_EEC.INI") as refused:
        control_format(SIEMENS, {}).read([file])
    assert len(refused.value.faults) == 1


def test_a_switch_goes_back_to_what_the_job_says_of_it() -> None:
    """MD32700 ends as 0 in the archive, and the job answers that the table acted."""
    data = machine_data().replace("$MA_ENC_COMP_ENABLE[1,AX4]=1", "$MA_ENC_COMP_ENABLE[1,AX4]=0")
    members = [(ACTIVE, "AX_EEC.INI", eec_text()), (ACTIVE, "INITIAL.INI", data)]
    texts = [(folder, name, text.encode()) for folder, name, text in members]
    file = ControlFile("backup.arc", container(texts))
    control = control_format(SIEMENS, {})
    axis, _ = axis_of(control, archive(), "AX4")
    for said in (True, False):
        state = control.read([file], [axis], activity=Activity(stated=said, asking=True))
        new = bent(control.read([archive()], [axis]).axes["AX4"])
        bound = control.in_state(state)
        delivery = bound.delivered(bound.write([new], [axis], [file]), [file], [axis])
        assert f"$MA_ENC_COMP_ENABLE[1,AX4]={int(said)}".encode() in delivery.back[-1].content
        assert b"$MA_ENC_COMP_ENABLE[1,AX4]=1" in delivery.files[-1].content


@pytest.mark.parametrize("sign", ["correction", "error"])
def test_a_table_that_is_no_curve_hides_none_of_its_pair(sign: str) -> None:
    """Table 2 of the archive (X1 on Y1, 9.5 steps) stays as it is; another one of the pair is
    counted.
    """
    control = control_format(SIEMENS, {"cec": "available", "cec_sign": sign})
    ours = cec_lines(20, "AX1", "AX2", 0, 950, [0.0, 0.009])
    data = put(
        put(machine_data(), "$MN_MM_CEC_MAX_POINTS[20]", "2"), "$SN_CEC_TABLE_ENABLE[20]", "1"
    )
    held = replace_cec(cec_text(), 20, ours)
    members = {"AX_EEC.INI": eec_text(), "NC_CEC.INI": held, "INITIAL.INI": data}
    texts = [(ACTIVE, name, text.encode()) for name, text in members.items()]
    state = control.read([ControlFile("backup.arc", container(texts))])
    (entry,) = [one for one in state.cross if (one.input, one.output) == ("AX1", "AX2")]
    turned = 1 if sign == "correction" else -1
    assert entry.positive == pytest.approx([0.0, 0.009 * turned], abs=1e-12)
    assert any("CEC table 2" in one.message for one in state.findings if one.code == "CW-S050")
