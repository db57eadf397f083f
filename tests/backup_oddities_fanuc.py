"""Variations of a backup in which something else acts, or which contradict the job; marks: see
``backup_variations_fanuc``.
"""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np

from backup_files_fanuc import PARAMETERS, PITCH, Backup, Rng, Table, wavy
from backup_jobs_fanuc import Job, alike, axis_job, both_files, family, job_on, linear_physics
from backup_variations_fanuc import as_it_is, filled_backup, incline, spread, state_none, straighten

# answerable: right, or refused by name
# ------------------------------------------------------------------------------------------

_INCLINATION = (r"58[67]\d", "inclination")


@family
def inclination(rng: Rng, whole: bool) -> Job:
    axis = axis_job(rng)
    backup = filled_backup(rng, whole, axis.address)
    incline(rng, backup, axis.address)
    return job_on("plain", axis, backup, *_INCLINATION)


@family
def inclination_at_rest(rng: Rng, whole: bool) -> Job:
    """Point numbers without amounts."""
    axis = axis_job(rng)
    backup = filled_backup(rng, whole, axis.address)
    for place, number in enumerate(spread(backup, axis.address)):
        backup.set(5861 + place, f"A{axis.address}", number)
    return job_on("plain", axis, backup)


@family
def inclination_points_here(rng: Rng, whole: bool) -> Job:
    """The inclination of another axis is given by numbers of this one, or by free ones that an
    automatic grid likes to take.
    """
    backup = filled_backup(rng, whole, 1)
    numbers = spread(backup, 1) if rng.random() < 0.5 else [1200, 1300, 1400, 1500]
    for place, number in enumerate(numbers):
        backup.set(5861 + place, "A3", number).set(5871 + place, "A3", 40)
    return job_on("plain", axis_job(rng, 1), backup)


@family
def straightness(rng: Rng, whole: bool) -> Job:
    """The axis moves another one by its point numbers, or is moved."""
    axis = axis_job(rng)
    backup = filled_backup(rng, whole, axis.address)
    other = axis.address % 3 + 1
    pair = (axis.address, other) if rng.random() < 0.7 else (other, axis.address)
    straighten(rng, backup, *pair)
    return job_on("plain", axis, backup, r"57[1-9]\d", "straightness")


@family
def straightness_further(rng: Rng, whole: bool) -> Job:
    """Pairs whose numbers are from memory, or those of the second path."""
    axis = axis_job(rng)
    backup = filled_backup(rng, whole, axis.address)
    if rng.random() < 0.5:
        backup.set(5714, "L1", axis.address).set(5724, "L1", axis.address % 3 + 1)
    else:
        backup.set(981, f"A{axis.address}", 2).set(5711, "L2", 1).set(5721, "L2", 1)
        for place, number in enumerate(spread(backup, axis.address)):
            backup.set(5731 + place, "L2", number).set(5761 + place, "L2", 40)
    return job_on("plain", axis, backup)


@family
def cyclic(rng: Rng, whole: bool) -> Job:
    """The second table of the axis itself: on numbers of its own, or inside those of its main
    table.
    """
    address = int(rng.integers(1, 5))
    backup = filled_backup(rng, whole, address)
    inside = bool(rng.random() < 0.3)
    low = int(backup.get(3621, f"A{address}")) if inside else int(rng.integers(400, 1500))
    if not inside:
        backup.points(
            dict(
                zip(
                    range(low, low + 11),
                    [0, *wavy(rng, 10, 0.1, closed=True, height=2)],
                    strict=True,
                )
            )
        )
    interval = "2.0" if address == 4 else "8.0"
    backup.set(14985, f"A{address}", low).set(14986, f"A{address}", low + 10).set(
        14987, f"A{address}", interval
    )
    backup.set(14988, f"A{address}", 1)
    mark = "answerable" if inside else "plain"
    return job_on(mark, axis_job(rng, address), backup, r"1498\d")


@family
def neighbour_cyclic_here(rng: Rng, whole: bool) -> Job:
    """The second table of another axis lies inside the numbers of this one."""
    backup = filled_backup(rng, whole, 1)
    low = int(backup.get(3621, "A1")) + int(rng.integers(0, 20))
    backup.set(14985, "A4", low).set(14986, "A4", low + 10).set(14987, "A4", "2.0").set(
        14988, "A4", 1
    )
    return job_on("answerable", axis_job(rng, 1), backup, r"1498\d", r"362\d")


@family
def pitch_in_part(rng: Rng, whole: bool) -> Job:
    """A pitch file that ends at number 399: what lies above the files do not say, and it is not
    nothing.
    """
    axis = axis_job(rng)
    backup = filled_backup(rng, whole, axis.address)
    really = Backup(*both_files(backup)).points(dict.fromkeys(range(420, 1500, 7), 5)).files()
    backup.pitch = [line for line in backup.pitch if line[:1] != b"N" or int(line[1:6]) < 10400]
    return job_on("answerable", axis, backup, "first_point", "number", "point", really=really)


@family
def other_increment_system(rng: Rng, whole: bool) -> Job:
    """Two systems at once in 1013; 1004#1 was that of older series, beside 1013 = 0 it is a
    riddle.
    """
    axis = axis_job(rng)
    backup = filled_backup(rng, whole, axis.address)
    if rng.random() < 0.5:
        return job_on("refuse", axis, backup.set(1013, f"A{axis.address}", "00000011"), "1013")
    return job_on("warn", axis, backup.bit(1004, "L1", 1), "1004")


@family
def letter_of_another(rng: Rng, whole: bool) -> Job:
    """The job calls X what the control calls Y or Z (1020): a word, or a refusal."""
    axis = axis_job(rng, int(rng.integers(2, 4)), name="X")
    return job_on("warn", axis, filled_backup(rng, whole, axis.address), "1020", "address")


@family
def address_by_letter(rng: Rng, whole: bool) -> Job:
    """The job names no address, or the letter: it is in 1020."""
    axis = replace(axis_job(rng), by_name=True)
    if rng.random() < 0.5:
        axis = replace(axis, words={**axis.words, "address": f'"{axis.name}"'})
    return job_on("answerable", axis, filled_backup(rng, whole, axis.address), "address", "1020")


@family
def other_3605(rng: Rng, whole: bool) -> Job:
    """Bits of 3605 whose meaning no page tells."""
    axis = axis_job(rng)
    backup = filled_backup(rng, whole, axis.address).bit(
        3605, f"A{axis.address}", int(rng.integers(2, 8))
    )
    return job_on("plain", axis, backup, "3605")


@family
def other_3602(rng: Rng, whole: bool) -> Job:
    axis = axis_job(rng)
    bits = "".join("1" if place == int(rng.integers(1, 8)) else "0" for place in range(7, -1, -1))
    backup = filled_backup(rng, whole, axis.address).set(3602, "", bits[:7] + "0")
    return job_on("answerable", axis, backup, "3602")


@family
def inch(rng: Rng, whole: bool) -> Job:
    """An inch machine: what stands with P is inches."""
    address = int(rng.integers(1, 4))
    backup = filled_backup(rng, whole, address).bit(1001, "L1", 0)
    for axis in (1, 2, 3):
        backup.set(3624, f"A{axis}", "1.1")
        count = int(np.ceil(1200 / (1.1 * 25.4)))
        Table(axis, 300 * axis + count, 300 * axis + 1, 300 * axis + count, 1.1).put(
            backup, wavy(rng, count, 0.254)
        )
        for number, limit in ((1320, "0.1"), (1321, "-47.0"), (1420, "945.0")):
            backup.set(number, f"A{axis}", limit)
    return job_on("plain", axis_job(rng, address), backup)


@family
def inch_letter(rng: Rng, whole: bool) -> Job:
    """3624 with I on a metric machine."""
    address = int(rng.integers(1, 4))
    backup = filled_backup(rng, whole, address)
    count = int(np.ceil(1200 / 25.4))
    Table(address, 900 + count, 901, 900 + count, 1.0).put(backup, wavy(rng, count, 0.1))
    backup.set(3624, f"A{address}", "1.0", "I")
    return job_on("plain", axis_job(rng, address), backup)


@family
def wraps_by_file_only(rng: Rng, whole: bool) -> Job:
    """1006#0 = 1, 1006#1 = 0: the table repeats; the job does not say so."""
    travel = [(-360.0, 360.0), (0.0, 360.0), (-180.0, 180.0)][int(rng.integers(0, 3))]
    axis = axis_job(rng, 4, words={}, travel=travel)
    return job_on("answerable", axis, filled_backup(rng, whole, 4), "1006", "modulo")


@family
def wraps_by_job_only(rng: Rng, whole: bool) -> Job:
    """1006 = 3: a rotary axis whose coordinate does not begin again; the job says modulo."""
    backup = filled_backup(rng, whole, 4).set(1006, "A4", "00000011")
    return job_on("answerable", axis_job(rng, 4), backup, "1006", "modulo")


@family
def rotary_without_wrap(rng: Rng, whole: bool) -> Job:
    """1006 = 3 and no modulo: both say the same."""
    backup = filled_backup(rng, whole, 4).set(1006, "A4", "00000011")
    return job_on("answerable", axis_job(rng, 4, words={}), backup, "1006")


@family
def endless_two_turns(rng: Rng, whole: bool) -> Job:
    """A test over one turn in a job whose travel has two."""
    axis = axis_job(rng, 4)
    return job_on(
        "answerable",
        replace(axis, travel=(-360.0, 360.0), true_travel=(0.0, 360.0)),
        filled_backup(rng, whole, 4),
        "travel",
        "turn",
        "1260",
    )


@family
def other_turn(rng: Rng, whole: bool) -> Job:
    backup = filled_backup(rng, whole, 4).set(
        3625, "A4", ("360.0", "180.0")[int(rng.integers(0, 2))]
    )
    return job_on("answerable", axis_job(rng, 4), backup, "3625", "1260")


@family
def diameter_by_file(rng: Rng, whole: bool) -> Job:
    axis = axis_job(rng)
    backup = filled_backup(rng, whole, axis.address).set(1006, f"A{axis.address}", "00001000")
    return job_on("answerable", axis, backup, "1006", "diameter")


@family
def reference_elsewhere(rng: Rng, whole: bool) -> Job:
    """1240 is not 0: whether the grid hangs on machine zero or on the reference position is not
    told.
    """
    axis = axis_job(rng)
    backup = filled_backup(rng, whole, axis.address).set(1240, f"A{axis.address}", "-100.0")
    axis = replace(axis, words={**axis.words, "reference": "-100"})
    return job_on("answerable", axis, backup, "1240", "points_from")


@family
def shared_numbers(rng: Rng, whole: bool) -> Job:
    """Another axis claims the same numbers."""
    address = int(rng.integers(1, 4))
    backup = filled_backup(rng, whole, address)
    other = address % 3 + 1
    shift = int(rng.integers(-3, 4))
    for number in (3620, 3621, 3622):
        backup.set(number, f"A{other}", max(0, int(backup.get(number, f"A{address}")) + shift))
    return job_on("plain", axis_job(rng, address), backup, "3620", "3621", "3622", "number")


@family
def scarce(rng: Rng, whole: bool) -> Job:
    """Every number that no axis owns holds something."""
    address = int(rng.integers(1, 4))
    backup = filled_backup(rng, whole, address)
    owned: set[int] = set()
    for axis in (1, 2, 3, 4):
        owned |= set(
            range(int(backup.get(3621, f"A{axis}")), int(backup.get(3622, f"A{axis}")) + 1)
        ) | {int(backup.get(3620, f"A{axis}"))}
    spare = int(rng.integers(0, 60))
    backup.points({n: 3 for n in range(1536 - spare) if n not in owned})
    return job_on("plain", axis_job(rng, address), backup)


@family
def odd_own_grid(rng: Rng, whole: bool) -> Job:
    axis = axis_job(rng)
    backup = filled_backup(rng, whole, axis.address)
    group = f"A{axis.address}"
    odd = {
        0: lambda: backup.set(3620, group, int(backup.get(3621, group)) - 2),
        1: lambda: backup.set(3623, group, 101),
        2: lambda: backup.set(3622, group, int(backup.get(3621, group)) - 1),
        3: lambda: backup.set(3624, group, "0.0"),
        4: lambda: backup.set(1820, group, int(rng.choice([0, 97, 100, 128]))),
        5: lambda: backup.set(3622, group, 1600),
    }
    odd[int(rng.integers(0, len(odd)))]()
    return job_on("answerable", axis, backup, r"362\d", "1820", "detection_unit")


@family
def parameters_alone_asleep(rng: Rng, whole: bool) -> Job:
    """No pitch file; all tables off. What the numbers hold nobody knows, the job says from where on
    they are free.
    """
    address = int(rng.integers(1, 4))
    backup = alike(Backup.real(whole).points(dict.fromkeys(range(1536), 0)), address)
    for axis in (1, 2, 3, 4):
        for number in (3620, 3621, 3622, 3623):
            backup.set(number, f"A{axis}", 0)
    files = backup.files()
    options = {"first_point": str(int(rng.integers(0, 100)))} if rng.random() < 0.7 else {}
    names = ("first_point", "pitch", "point", "PITCH")
    return job_on(
        "answerable",
        axis_job(rng, address),
        backup,
        *names,
        files={PARAMETERS: files[PARAMETERS]},
        really=files,
        options=options,
    )


@family
def older_parameters_alone(rng: Rng, whole: bool) -> Job:
    """Older style without Q: N1nnnnP in a parameter file are parameters too."""
    job = parameters_alone_asleep(rng, whole)
    assert job.files is not None
    old = {PARAMETERS: re.sub(rb"(?<=\nN\d{5})Q1", b"", job.files[PARAMETERS])}
    really = {**old, PITCH: re.sub(rb"(?<=\nN1\d{4})Q0", b"", (job.really or {})[PITCH])}
    return replace(job, files=old, really=really, names=(*job.names, "Q0", "Q1"))


# refuse: the pages do not tell enough, or the files contradict the job
# ----------------------------------------------------------


@family
def detection_unit_contradicts(rng: Rng, whole: bool) -> Job:
    job = as_it_is(rng, whole)
    unit = str(rng.choice(["0.001", "0.0005", "0.00001", "0.01"]))
    return replace(job, mark="refuse", names=("1820", "1013"), options={"detection_unit": unit})


@family
def totals(rng: Rng, whole: bool) -> Job:
    axis = axis_job(rng, int(rng.integers(1, 5)))
    return job_on(
        "refuse", axis, filled_backup(rng, whole, axis.address).set(3602, "", "00000001"), "3602"
    )


@family
def kind_contradicts(rng: Rng, whole: bool) -> Job:
    if rng.random() < 0.5:
        backup = filled_backup(rng, whole, 1).set(1006, "A1", "00000001")
        return job_on("refuse", axis_job(rng, 1), backup, "1006")
    axis = axis_job(rng, 4)
    return job_on(
        "refuse",
        replace(axis, rotary=False, words={}, physics=linear_physics(rng, axis.travel)),
        filled_backup(rng, whole, 4),
        "1006",
    )


@family
def diameter_by_job(rng: Rng, whole: bool) -> Job:
    axis = axis_job(rng)
    return job_on(
        "refuse",
        replace(axis, words={**axis.words, "programmed": "diameter"}),
        filled_backup(rng, whole, axis.address),
        "diameter",
        "1006",
    )


@family
def parameters_alone(rng: Rng, whole: bool) -> Job:
    """The table acts and its increments were not given: missing is not zero."""
    axis = axis_job(rng, int(rng.integers(1, 5)))
    backup = filled_backup(rng, whole, axis.address)
    files = backup.files()
    return job_on(
        "refuse",
        axis,
        backup,
        "point",
        "pitch",
        "PITCH",
        files={PARAMETERS: files[PARAMETERS]},
        really=files,
    )


@family
def pitch_alone(rng: Rng, whole: bool) -> Job:
    axis = axis_job(rng)
    backup = filled_backup(rng, whole, axis.address)
    files = backup.files()
    options = {"detection_unit": "0.0001"}
    return job_on(
        "refuse",
        axis,
        backup,
        r"362\d",
        "parameter",
        files={PITCH: files[PITCH]},
        really=files,
        options=options,
    )


@family
def state_none_without_first_point(rng: Rng, whole: bool) -> Job:
    job = state_none(rng, whole)
    return replace(job, mark="refuse", names=("first_point",), options={"detection_unit": "0.0001"})


@family
def no_unit_anywhere(rng: Rng, whole: bool) -> Job:
    """The files do not hold 1820, and the job does not say the detection unit."""
    axis = axis_job(rng)
    backup = filled_backup(rng, whole, axis.address).drop([1820])
    return job_on("refuse", axis, backup, "detection_unit", "1820")
