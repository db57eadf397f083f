"""Random jobs on variations of a real FANUC backup: the files, the axis behind them, and what must
come of it.

Each variation is marked beforehand, from the facts pages alone. ``plain``: nothing but what the
pages describe fully acts, a table must be written (and, with ``names``, a word be said on it).
``answerable``: it may be written, and then it must be right, or it is refused with one of ``names``
(patterns). ``refuse``: the pages do not tell enough, or the files contradict the job: refused, with
one of ``names`` in the message. ``warn``: a table may come, with a word on it. Nothing here is
taken from the package.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from backup_files_fanuc import PARAMETERS, PITCH, Backup, Rng, Table, wavy
from backup_jobs_fanuc import Job, alike, axis_job, family, job_on, linear_physics, reopen

# plain: nothing but described things act
# ----------------------------------------------------------------------------------------


#: 1851 and 1852 differ and 1800#4 = 1: the test was taken with one of both. What is written must be
#: right in the motion of the test, and a word be said.
_SEPARATE = ("1852", r"1800")


@family
def as_it_is(rng: Rng, whole: bool) -> Job:
    """The backup as the control punched it; on X and Z 1852 differs from 1851, and 1800#4 = 1."""
    address = int(rng.integers(1, 5))
    axis = axis_job(rng, address, rapid=bool(rng.random() < 0.5))
    return job_on("plain", axis, Backup.real(whole), *(_SEPARATE if address in (1, 3) else ()))


def filled_backup(rng: Rng, whole: bool, address: int) -> Backup:
    backup = Backup.real(whole)
    alike(backup, address)
    backup.points(dict.fromkeys(range(1536), 0))
    start = int(rng.integers(0, 40))
    for axis in (1, 2, 3):
        interval = float(rng.choice([20.0, 25.0, 27.5, 40.0, 50.0]))
        magnification = int(rng.choice([1, 2, 5, 10]))
        below = int(np.ceil((1200 if axis < 3 else 900) / interval))
        above = int(rng.integers(0, 3))
        first = start + int(rng.integers(0, 12))
        reference = first + below - 1
        count = below + above
        Table(axis, reference, first, reference + above, interval, magnification).put(
            backup, wavy(rng, count, 0.1 * magnification)
        )
        start = reference + above + 1
    interval = float(rng.choice([15.0, 30.0, 45.0]))
    count = round(360 / interval)
    points = wavy(rng, count, 0.36, closed=True)
    first_too = bool(rng.random() < 0.5)
    reference = start + 5
    Table(4, reference, reference + (0 if first_too else 1), reference + count, interval).put(
        backup
    )
    backup.points(dict(zip(range(reference + 1, reference + count + 1), points, strict=True)))
    if first_too:
        backup.points({reference: points[-1]})
    return backup


@family
def filled(rng: Rng, whole: bool) -> Job:
    """Old tables of all axes acting, on other numbers, intervals and magnifications."""
    address = int(rng.integers(1, 5))
    home = 1 if rng.random() < 0.7 else -1
    return job_on("plain", axis_job(rng, address, home=home), filled_backup(rng, whole, address))


@family
def filled_two_axes(rng: Rng, whole: bool) -> Job:
    backup = filled_backup(rng, whole, 1)
    alike(backup, 3)
    return job_on("plain", (axis_job(rng, 1), axis_job(rng, 3)), backup)


@family
def asleep(rng: Rng, whole: bool) -> Job:
    """3623 = 0 on the axis or on all: the increments stand there and do not act."""
    address = int(rng.integers(1, 5))
    backup = filled_backup(rng, whole, address)
    for axis in (address,) if rng.random() < 0.5 else (1, 2, 3, 4):
        backup.set(3623, f"A{axis}", 0)
    return job_on("plain", axis_job(rng, address), backup)


@family
def never_compensated(rng: Rng, whole: bool) -> Job:
    """No grid on the axis, and non-zero numbers that no axis owns, which stay as they are."""
    address = int(rng.integers(1, 4))
    backup = filled_backup(rng, whole, address)
    for number in (3620, 3621, 3622, 3623):
        backup.set(number, f"A{address}", 0)
    backup.set(3624, f"A{address}", "0.0")
    stray = int(rng.integers(700, 1100))
    backup.points({n: int(rng.integers(1, 9)) for n in range(stray, stray + 40)})
    return job_on("plain", axis_job(rng, address), backup)


@family
def fixed_grid(rng: Rng, whole: bool) -> Job:
    axis = axis_job(rng)
    spacing = float(rng.choice([20, 25, 50]))
    table = {
        "table": f"{{start: {axis.travel[0] // spacing * spacing:g}, end: 0, spacing: {spacing:g}}}"
    }
    return job_on(
        "plain",
        replace(axis, words={**axis.words, **table}),
        filled_backup(rng, whole, axis.address),
    )


@family
def two_sets(rng: Rng, whole: bool) -> Job:
    """Bidirectional compensation acts: 3605#0, 3626, 3627."""
    address = int(rng.integers(1, 4))
    backup = filled_backup(rng, whole, address)
    count, reference = 45, 900
    Table(address, reference, reference - 43, reference + 1, 27.5).put(
        backup, wavy(rng, count, 0.1, height=4)
    )
    second = 1000
    backup.points(
        dict(zip(range(second, second + count), wavy(rng, count, 0.1, height=4), strict=True))
    )
    group = f"A{address}"
    backup.bit(3605, group, 0).set(3626, group, second).set(3627, group, int(rng.integers(-40, 40)))
    if rng.random() < 0.5:
        backup.set(1851, group, 0).set(1852, group, 0)
    return job_on("plain", axis_job(rng, address), backup)


@family
def two_sets_magnified(rng: Rng, whole: bool) -> Job:
    """As two_sets with 3623 above 1: whether it multiplies 3627 is not told, the option says it."""
    job = two_sets(rng, whole)
    backup = reopen(job)
    backup.set(3623, f"A{job.axes[0].address}", 2)
    return replace(
        job,
        mark="answerable",
        names=("3627", "offset_magnified"),
        files=backup.files(),
        options={"offset_magnified": "no"},
    )


@family
def two_sets_home_minus(rng: Rng, whole: bool) -> Job:
    job = two_sets(rng, whole)
    return replace(
        job,
        mark="answerable",
        names=("3627", "3605", "reference_return"),
        axes=(replace(job.axes[0], home=-1),),
    )


@family
def backlash(rng: Rng, whole: bool) -> Job:
    """1851 and 1852 of either sign; where 1800#4 = 0, 1852 stands there and does not act, whatever
    the motion.
    """
    address = int(rng.integers(1, 5))
    backup = filled_backup(rng, whole, address)
    group = f"A{address}"
    backup.set(1851, group, int(rng.integers(-60, 80))).set(1852, group, int(rng.integers(-60, 80)))
    separate = bool(rng.random() < 0.5)
    backup.bit(1800, "L1", 4, separate)
    axis = axis_job(
        rng, address, rapid=bool(rng.random() < 0.5), home=1 if rng.random() < 0.7 else -1
    )
    return job_on("plain", axis, backup, *(_SEPARATE if separate else ()))


@family
def second_path(rng: Rng, whole: bool) -> Job:
    """The axis belongs to path 2, whose 1800#4 differs from that of path 1."""
    address = int(rng.integers(1, 4))
    backup = filled_backup(rng, whole, address)
    group = f"A{address}"
    backup.set(981, group, 2).set(1851, group, int(rng.integers(20, 70))).set(
        1852, group, int(rng.integers(-60, 0))
    )
    separate = bool(rng.random() < 0.5)
    backup.bit(1800, "L1", 4, not separate).bit(1800, "L2", 4, separate)
    if separate:
        return job_on(
            "plain", axis_job(rng, address, rapid=bool(rng.random() < 0.5)), backup, *_SEPARATE
        )
    return job_on("plain", axis_job(rng, address, rapid=True), backup)


@family
def detection_units(rng: Rng, whole: bool) -> Job:
    """Other CMR and increment system: the unit is in the files, and the job does not say it."""
    address = int(rng.integers(1, 5))
    backup = filled_backup(rng, whole, address)
    group = f"A{address}"
    if rng.random() < 0.4:
        backup.set(1013, group, "00000010")
        least = 0.1
    else:
        least = 1.0
    cmr = int(rng.choice([1, 2, 5, 10, 20]))
    backup.set(1820, group, 2 * cmr)
    pulse = least / cmr * (3.6 if address == 4 else 1.0)
    table = {1: 40, 2: 40, 3: 40, 4: 12}[address]
    if address == 4:
        Table(4, 900, 901, 912, 30.0).put(backup)
        backup.points(dict(zip(range(901, 913), wavy(rng, 12, pulse, closed=True), strict=True)))
    else:
        Table(address, 939, 900, 939, 30.0).put(backup, wavy(rng, table, pulse))
    return job_on("plain", axis_job(rng, address, quantum=2.5 * pulse), backup)


@family
def detection_unit_agrees(rng: Rng, whole: bool) -> Job:
    job = as_it_is(rng, whole)
    return replace(job, options={"detection_unit": "0.0001"})


@family
def other_letter(rng: Rng, whole: bool) -> Job:
    """3624 with M on a metric machine: kept."""
    address = int(rng.integers(1, 4))
    backup = filled_backup(rng, whole, address)
    backup.set(3624, f"A{address}", backup.get(3624, f"A{address}"), "M")
    return job_on("plain", axis_job(rng, address), backup)


@family
def other_newline(rng: Rng, whole: bool) -> Job:
    job = as_it_is(rng, whole)
    newline = b"\r\n" if rng.random() < 0.5 else b"\n\r\r"
    return replace(job, files=reopen(job).files(newline))


@family
def files_in_another_form(rng: Rng, whole: bool) -> Job:
    """Pitch data first, both in one file, or with an identifier in the first line."""
    job = as_it_is(rng, whole)
    backup = reopen(job)
    parameters, pitch = backup.files()[PARAMETERS], backup.files()[PITCH]
    first, one, headed = (int(rng.integers(0, 3)) == n for n in range(3))
    files = {PITCH: pitch, PARAMETERS: parameters}
    if one and not first:
        files = {"ALL-DATA.TXT": parameters.rstrip(b"%\n ") + b"\n" + pitch.split(b"\n", 1)[1]}
    elif headed:
        files = {PARAMETERS: b"%(CNCID=12345678,9ABCDEF0)" + parameters[1:], PITCH: pitch}
    return replace(job, files=files)


@family
def either_side(rng: Rng, whole: bool) -> Job:
    """A travel on both sides of the reference, or wholly above it."""
    address = int(rng.integers(1, 4))
    backup = filled_backup(rng, whole, address)
    travel = ((-400.0, 400.0), (0.0, 800.0))[int(rng.integers(0, 2))]
    interval = float(rng.choice([20.0, 40.0]))
    below, above = round(-travel[0] / interval) + 1, round(travel[1] / interval)
    Table(address, 1000 + below - 1, 1000, 1000 + below - 1 + above, interval, 2).put(
        backup, wavy(rng, below + above, 0.2)
    )
    backup.set(1320, f"A{address}", f"{travel[1] + 5:.1f}").set(
        1321, f"A{address}", f"{travel[0] - 5:.1f}"
    )
    return job_on(
        "plain", axis_job(rng, address, travel=travel, physics=linear_physics(rng, travel)), backup
    )


@family
def two_sets_wanted(rng: Rng, whole: bool) -> Job:
    axis = axis_job(rng)
    words = {**axis.words, "table": "{mode: bidirectional}"}
    return job_on("plain", replace(axis, words=words), filled_backup(rng, whole, axis.address))


@family
def neighbour_two_sets(rng: Rng, whole: bool) -> Job:
    """The second set of another axis lies on numbers that no first set names."""
    backup = filled_backup(rng, whole, 1)
    low = int(rng.integers(400, 1300))
    count = int(backup.get(3622, "A3")) - int(backup.get(3621, "A3")) + 1
    backup.bit(3605, "A3", 0).set(3626, "A3", low)
    if rng.random() < 0.5:
        backup.points(dict(zip(range(low, low + count), wavy(rng, count, 1.0), strict=True)))
    return job_on("plain", axis_job(rng, 1), backup)


@family
def interpolation_bit_off(rng: Rng, whole: bool) -> Job:
    axis = axis_job(rng)
    backup = filled_backup(rng, whole, axis.address)
    return job_on("plain", axis, backup.set(3605, f"A{axis.address}", "00000000"))


@family
def odd_neighbour(rng: Rng, whole: bool) -> Job:
    """What is strange about another axis is no business of this one."""
    address = int(rng.integers(1, 3))
    backup = filled_backup(rng, whole, address)
    odd = {
        0: lambda: backup.set(3621, "A3", 1400).set(3622, "A3", 1390),
        1: lambda: backup.set(3622, "A3", 2000),
        2: lambda: backup.set(3624, "A3", "0.0"),
        3: lambda: backup.set(3623, "A3", 200),
        4: lambda: (
            backup.set(3620, "A5", backup.get(3620, "A3"))
            .set(3621, "A5", backup.get(3621, "A3"))
            .set(3622, "A5", backup.get(3622, "A3"))
        ),
        5: lambda: backup.set(1820, "A3", 0),
        6: lambda: backup.set(3620, "A3", 1380).set(3621, "A3", 1390).set(3622, "A3", 1400),
        7: lambda: backup.set(3625, "A4", "77.0"),
        8: lambda: backup.set(1240, "A3", "12.5"),
        9: lambda: backup.set(1006, "A3", "00001000"),
    }
    odd[int(rng.integers(0, len(odd)))]()
    return job_on("plain", axis_job(rng, address), backup)


@family
def neighbour_inclination(rng: Rng, whole: bool) -> Job:
    """5861 to 5874 of another axis on its own numbers; straightness between others; a cyclic table
    of B on free numbers.
    """
    address = 1
    backup = filled_backup(rng, whole, address)
    kind = int(rng.integers(0, 3))
    if kind == 0:
        incline(rng, backup, 3)
    elif kind == 1:
        straighten(rng, backup, 3, 2)
    else:
        low = int(rng.integers(300, 900))
        backup.points(
            dict(
                zip(
                    range(low, low + 11),
                    [0, *wavy(rng, 10, 0.36, closed=True, height=4)],
                    strict=True,
                )
            )
        )
        backup.set(14985, "A4", low).set(14986, "A4", low + 10).set(14987, "A4", "2.0").set(
            14988, "A4", 1
        )
    return job_on("plain", axis_job(rng, address), backup)


def spread(backup: Backup, axis: int) -> list[int]:
    first, last = int(backup.get(3621, f"A{axis}")), int(backup.get(3622, f"A{axis}"))
    return [round(first + share * (last - first)) for share in (0.0, 0.3, 0.7, 1.0)]


def incline(rng: Rng, backup: Backup, axis: int) -> None:
    for place, number in enumerate(spread(backup, axis)):
        backup.set(5861 + place, f"A{axis}", number).set(
            5871 + place, f"A{axis}", int(rng.integers(-150, 150))
        )


def straighten(rng: Rng, backup: Backup, moving: int, bent: int) -> None:
    backup.set(5711, "L1", moving).set(5721, "L1", bent)
    for place, number in enumerate(spread(backup, moving)):
        backup.set(5731 + place, "L1", number).set(5761 + place, "L1", int(rng.integers(-150, 150)))


@family
def state_none(rng: Rng, whole: bool) -> Job:
    """Nothing is in the control, and the job says from which number on it is free."""
    axis = axis_job(rng, int(rng.integers(1, 5)))
    options = {"detection_unit": "0.0001", "first_point": str(int(rng.integers(0, 200)))}
    return job_on("plain", axis, None, options=options, really=empty_control(axis.address))


def empty_control(address: int) -> dict[str, bytes]:
    backup = Backup.real().points(dict.fromkeys(range(1536), 0))
    for number in (3620, 3621, 3622, 3623, 3626, 3627, 1851, 1852):
        for axis in range(1, 5):
            backup.set(number, f"A{axis}", 0)
    backup.bit(1800, "L1", 4, False)
    return backup.set(3605, f"A{address}", "00000000").files()


@family
def older_style(rng: Rng, whole: bool) -> Job:
    """No Q in the files; increments to 7 only, intervals as whole numbers of 0.001 mm."""
    address = int(rng.integers(1, 4))
    backup = filled_backup(rng, whole, address)
    for axis in (1, 2, 3, 4):
        backup.set(1820, f"A{axis}", 2)
        count = int(backup.get(3622, f"A{axis}")) - int(backup.get(3621, f"A{axis}")) + 1
        first = int(backup.get(3621, f"A{axis}"))
        backup.points(
            dict(
                zip(
                    range(first, first + count),
                    wavy(rng, count, 1.0, most=6) if axis < 4 else [0] * count,
                    strict=True,
                )
            )
        )
        if axis < 4:
            backup.set(3623, f"A{axis}", 1)
        backup.set(1851, f"A{axis}", 4).set(1852, f"A{axis}", 4)
    backup.points(dict.fromkeys(range(1024, 1536), 0))
    old = backup.older()
    old.pitch = [line for line in old.pitch if not (line[:1] == b"N" and int(line[1:6]) > 11023)]
    return job_on(
        "plain",
        axis_job(rng, address, quantum=1.0),
        old,
        format="fanuc-0i-16i",
        options={"detection_unit": "0.001"},
    )
