"""Variations of a backup that hang on what stays in place beside a new table: functions whose
amount no page tells, other units, wishes for the grid, other series. Marks: see
``backup_variations_fanuc``.
"""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np

from backup_files_fanuc import Rng, Table, wavy
from backup_jobs_fanuc import AxisJob, Job, axis_job, family, job_on, reopen
from backup_oddities_fanuc import cyclic, inclination, straightness
from backup_variations_fanuc import as_it_is, filled, filled_backup, incline, older_style, spread

_BESIDE = (r"58[67]\d", r"57[1-9]\d", r"1498\d", r"133[89]\d", r"108\d\d")

# what stays, cancels
# --------------------------------------------------------------------------------------------------


@family
def several_beside(rng: Rng, whole: bool) -> Job:
    """Inclination, straightness and a second table on one axis at once."""
    address = int(rng.integers(1, 4))
    backup = filled_backup(rng, whole, address)
    incline(rng, backup, address)
    backup.set(5711, "L1", address).set(5721, "L1", address % 3 + 1)
    for place, number in enumerate(spread(backup, address)):
        backup.set(5731 + place, "L1", number).set(5761 + place, "L1", int(rng.integers(-99, 99)))
    low = int(rng.integers(500, 1400))
    points = [0, *wavy(rng, 10, 0.1, closed=True, height=2)]
    backup.points(dict(zip(range(low, low + 11), points, strict=True)))
    group = f"A{address}"
    backup.set(14985, group, low).set(14986, group, low + 10).set(14987, group, "8.0")
    return job_on("plain", axis_job(rng, address), backup, *_BESIDE)


@family
def in_space(rng: Rng, whole: bool) -> Job:
    """Three-dimensional error compensation, or interpolated straightness, is set."""
    address = int(rng.integers(1, 4))
    backup = filled_backup(rng, whole, address)
    if rng.random() < 0.5:
        for place in range(3):
            backup.set(10800 + place, "L1", place + 1).set(10803 + place, "L1", 5)
            backup.set(10812 + place, "L1", "100.0")
    else:
        backup.set(13381, "L1", address).set(13383, "L1", int(rng.integers(1, 30)))
    return job_on("plain", axis_job(rng, address), backup)


@family
def smooth_backlash(rng: Rng, whole: bool) -> Job:
    """1846 to 1848: the way behind a reversal on which backlash comes."""
    address = int(rng.integers(1, 5))
    backup = filled_backup(rng, whole, address)
    for number in (1846, 1847, 1848):
        backup.set(number, f"A{address}", int(rng.integers(1, 400)))
    return job_on("plain", axis_job(rng, address), backup, r"184\d", "smooth backlash")


@family
def beside_on_a_moved_grid(rng: Rng, whole: bool) -> Job:
    """The job names another distance while a function hangs on the numbers that are there."""
    job = (inclination, straightness, cyclic)[int(rng.integers(0, 3))](rng, whole)
    spacing = ("auto", "12.5", "35", "60")[int(rng.integers(0, 4))]
    axis = job.axes[0]
    if axis.rotary:
        spacing = "auto" if spacing == "auto" else "10"
    words = {**axis.words, "table": f"{{spacing: {spacing}}}"}
    return replace(
        job, mark="answerable", axes=(replace(axis, words=words),), names=(*_BESIDE, "362")
    )


@family
def asleep_with_inclination(rng: Rng, whole: bool) -> Job:
    """3623 = 0 beside amounts of inclination: whether these act, no page tells; a table that wakes
    3623 could wake them.
    """
    job = inclination(rng, whole)
    backup = reopen(job)
    backup.set(3623, f"A{job.axes[0].address}", 0)
    return replace(job, mark="refuse", files=backup.files(), names=(r"58[67]\d", "3623"))


@family
def neighbour_shares_and_inclines(rng: Rng, whole: bool) -> Job:
    """Two axes on the same numbers, of which the other one has an inclination by them."""
    address = int(rng.integers(1, 4))
    backup = filled_backup(rng, whole, address)
    other = address % 3 + 1
    for number in (3620, 3621, 3622):
        backup.set(number, f"A{other}", backup.get(number, f"A{address}"))
    incline(rng, backup, other)
    return job_on("answerable", axis_job(rng, address), backup, r"362\d", "number", *_BESIDE)


# options of the control
# --------------------------------------------------------------------------------------------------


@family
def options_available(rng: Rng, whole: bool) -> Job:
    """The control has inclination and a second table, both at rest: compwright may write them."""
    address = int(rng.integers(1, 5))
    options = {name: "available" for name in ("inclination", "cyclic") if rng.random() < 0.7} or {
        "straightness": "available"
    }
    if address != 4:
        options.pop("cyclic", None)
    axis = axis_job(rng, address)
    if address == 4:
        worm = float(rng.choice([2.0, 4.0, 5.0]))
        waves = (*axis.physics.waves, (rng.uniform(2, 6), worm, rng.uniform(0, 6)))
        axis = replace(
            axis,
            physics=replace(axis.physics, waves=waves),
            words={**axis.words, "screw_pitch": f"{worm:g}"},
        )
    else:
        axis = replace(axis, physics=replace(axis.physics, slope=rng.uniform(-0.15, 0.15)))
    return job_on("plain", axis, filled_backup(rng, whole, address), options=options)


@family
def options_in_use(rng: Rng, whole: bool) -> Job:
    """As the pages describe it (detection units, no 3623) the function acts, and the job says that
    it may be counted.
    """
    kind = int(rng.integers(0, 3))
    job = (inclination, straightness, cyclic)[kind](rng, whole)
    name = ("inclination", "straightness", "cyclic")[kind]
    return replace(job, mark="answerable", options={name: "available"}, names=_BESIDE)


# units and motion
# --------------------------------------------------------------------------------------------------


@family
def units_of_both_codings(rng: Rng, whole: bool) -> Job:
    """IS-A to IS-C, 1820 = 2 CMR or 100 + 1/CMR: the files say the detection unit. Which bit of
    1013 is IS-D no page tells.
    """
    address = int(rng.integers(1, 5))
    backup = filled_backup(rng, whole, address)
    group = f"A{address}"
    codes = {1: 2.0, 101: 1.0, 102: 2.0, 105: 5.0, 3: 2 / 3, 4: 0.5, 20: 0.1, 40: 0.05, 96: 1 / 48}
    systems = {"00000001": 10.0, "00000000": 1.0, "00000010": 0.1, "00000100": 0.01}
    pairs = [(s, c) for s, least in systems.items() for c, k in codes.items()
             if 0.02 <= least * k <= 5.0]  # fmt: skip
    system, code = pairs[int(rng.integers(0, len(pairs)))]
    backup.set(1013, group, system).set(1820, group, code)
    pulse = systems[system] * codes[code] * (3.6 if address == 4 else 1.0)
    for number in (1851, 1852):
        backup.set(number, group, round(rng.uniform(-3, 5) / pulse))
    if address == 4:
        Table(4, 900, 901, 912, 30.0).put(backup)
        values = wavy(rng, 12, pulse, closed=True, height=max(12.0, 2 * pulse))
        backup.points(dict(zip(range(901, 913), values, strict=True)))
    else:
        Table(address, 939, 900, 939, 30.0).put(backup, wavy(rng, 40, pulse))
    axis = axis_job(rng, address, quantum=2.5 * max(pulse, 0.1))
    if system == "00000100":
        return job_on("answerable", axis, backup, "1013")
    return job_on("plain", axis, backup)


@family
def inch_and_systems(rng: Rng, whole: bool) -> Job:
    """An inch machine; the interval in inches (P, I) or millimetres (M), IS-B or IS-C."""
    address = int(rng.integers(1, 4))
    backup = filled_backup(rng, whole, address).bit(1001, "L1", 0)
    letter = "PIM"[int(rng.integers(0, 3))]
    system = ("00000000", "00000010")[int(rng.integers(0, 2))]
    code = int(rng.choice([2, 4, 20]))
    inches = float(rng.choice([1.0, 1.1, 1.5]))
    pulse = (2.54 if system == "00000000" else 0.254) / (code / 2)
    count = int(np.ceil(1200 / (inches * 25.4)))
    for axis in (1, 2, 3):
        first = 300 * axis + 1
        Table(axis, first + count - 1, first, first + count - 1, inches).put(
            backup, wavy(rng, count, pulse)
        )
        if letter != "P":
            text = f"{inches * (25.4 if letter == 'M' else 1.0):.3f}".rstrip("0")
            backup.set(3624, f"A{axis}", text + ("0" if text.endswith(".") else ""), letter)
        backup.set(1013, f"A{axis}", system).set(1820, f"A{axis}", code)
        for number, limit in ((1320, "0.1"), (1321, "-47.0"), (1420, "945.0")):
            backup.set(number, f"A{axis}", limit)
        for number in (1851, 1852):
            backup.set(number, f"A{axis}", round(4 / pulse))
    return job_on("plain", axis_job(rng, address, quantum=2.5 * max(pulse, 0.1)), backup)


@family
def motion_not_said(rng: Rng, whole: bool) -> Job:
    """The test was taken in rapid traverse and the job does not say so: 1851 and 1852 move
    together.
    """
    job = as_it_is(rng, whole)
    axes = tuple(replace(axis, rapid=True, says_motion=False) for axis in job.axes)
    return replace(job, axes=axes)


@family
def paths_unknown(rng: Rng, whole: bool) -> Job:
    """Without 981 nobody knows whose 1800#4 counts."""
    address = int(rng.integers(1, 4))
    backup = filled_backup(rng, whole, address)
    group = f"A{address}"
    backup.set(1851, group, 50).set(1852, group, -20)
    backup.bit(1800, "L1", 4, True).bit(1800, "L2", 4, False)
    really = backup.files()
    axis = axis_job(rng, address, rapid=bool(rng.random() < 0.5))
    return job_on("answerable", axis, backup.drop([981]), "1800", "981", "1852", really=really)


@family
def lead_by_file(rng: Rng, whole: bool) -> Job:
    """1821 suggests a lead that is not the real one, or nothing: a word, no more."""
    address = int(rng.integers(1, 4))
    backup = filled_backup(rng, whole, address)
    group = f"A{address}"
    backup.set(1821, group, int(rng.choice([0, 50000, 120000, 200000, 7])))
    if rng.random() < 0.4:
        backup.bit(1815, group, 1)
    return job_on("plain", axis_job(rng, address), backup)


# the grid
# --------------------------------------------------------------------------------------------------


def _with_table(axis: AxisJob, text: str) -> AxisJob:
    return replace(axis, words={**axis.words, "table": text})


@family
def another_grid(rng: Rng, whole: bool) -> Job:
    """``spacing``: auto, or a number."""
    job = filled(rng, whole)
    spacing = ("auto", "auto", "24", "45")[int(rng.integers(0, 4))]
    return replace(
        job, axes=tuple(_with_table(axis, f"{{spacing: {spacing}}}") for axis in job.axes)
    )


@family
def modes_on_the_old_grid(rng: Rng, whole: bool) -> Job:
    job = filled(rng, whole)
    mode = ("single", "bidirectional", "auto")[int(rng.integers(0, 3))]
    goal = ("expected", "A", "E", "M")[int(rng.integers(0, 4))]
    text = f"{{mode: {mode}, goal: {goal}}}"
    job = replace(job, axes=tuple(_with_table(axis, text) for axis in job.axes))
    if mode == "bidirectional" and any(axis.home < 0 for axis in job.axes):
        # 1006#5 says +: what 3627 means is contradicted (docs/controllers/fanuc.md, 1006#5)
        return replace(job, mark="answerable", names=("3627", "reference return"))
    return job


@family
def all_axes_at_once(rng: Rng, whole: bool) -> Job:
    axes = tuple(axis_job(rng, n) for n in (1, 2, 3, 4))
    backup = filled_backup(rng, whole, 1)
    for address in (2, 3, 4):
        backup.set(1852, f"A{address}", backup.get(1851, f"A{address}"))
    return job_on("plain", axes, backup)


# other series
# --------------------------------------------------------------------------------------------------


@family
def zero_i(rng: Rng, whole: bool) -> Job:
    """0i-D and 0i-F: the files of a 30i, their own limits; 8135#0 = 0."""
    address = int(rng.integers(1, 4))
    backup = filled_backup(rng, whole, address)
    series = ("fanuc-0i-d", "fanuc-0i-f")[int(rng.integers(0, 2))]
    for axis in (1, 2, 3, 4):
        group = f"A{axis}"
        backup.set(1820, group, 2).set(1821, group, 10000).set(1851, group, 4).set(1852, group, 4)
        first, last = int(backup.get(3621, group)), int(backup.get(3622, group))
        count = last - first + 1
        values = wavy(rng, count, 1.0, most=6) if axis < 4 else [0] * count
        backup.points(dict(zip(range(first, last + 1), values, strict=True)))
        backup.points({int(backup.get(3620, "A4")): 0})
        if axis < 4:
            backup.set(3623, group, 1)
    if series == "fanuc-0i-d":
        backup.pitch = [line for line in backup.pitch if line[:1] != b"N" or int(line[1:6]) < 11024]
    return job_on("plain", axis_job(rng, address), backup, format=series)


@family
def zero_i_switched_off(rng: Rng, whole: bool) -> Job:
    """8135#0 = 1: stored pitch error compensation is off, whatever stands in the table."""
    job = zero_i(rng, whole)
    backup = reopen(job)
    return replace(
        job, mark="refuse", names=("8135",), files=backup.set(8135, "", "00000001").files()
    )


@family
def older_units(rng: Rng, whole: bool) -> Job:
    """Older style, the detection unit from 1820 and 1004 of the files alone."""
    return replace(older_style(rng, whole), options={})


@family
def fifteen_i(rng: Rng, whole: bool) -> Job:
    """The parameters of a 15i have other numbers, known from memory alone: nothing is written on
    the files of another series.
    """
    axis = axis_job(rng)
    backup = filled_backup(rng, whole, axis.address)
    backup.pitch = [line for line in backup.pitch if line[:1] != b"N" or int(line[1:6]) < 11024]
    for lines in (backup.parameters, backup.pitch):
        lines[:] = [re.sub(rb"(?<=^N\d{5})Q[01]", b"", line) for line in lines]
    options = {"detection_unit": "0.0001"}
    names = (r"54\d\d", "fanuc-15i", "pitch", "parameter")
    return job_on("refuse", axis, backup, *names, format="fanuc-15i", options=options)
