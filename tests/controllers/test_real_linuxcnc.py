"""The virtual LinuxCNC against a real one, and what the real one makes of broken files.

The real control is the outside reference: its applied corrections are read from its motion
controller while it runs.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import ClassVar

import numpy as np
import pytest

from compwright.controllers.virtual_control import VirtualControl, virtual_control
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.correction import ControlFile
from linuxcnc_control import (
    REAL_LINUXCNC,
    Session,
    applied_corrections,
    measure,
    measure_joints,
    run_session,
)

pytestmark = REAL_LINUXCNC

UP, DOWN = Direction.POSITIVE, Direction.NEGATIVE

# mm or deg. The control freezes the correction one servo tick before standstill, up to a T²/24 =
# 2.1e-3 mm short of the target (a = 50000 mm/s², T = 1 ms), times the table's slope, here at most
# 4e-4.
SAME = 1e-6


def ini(number: int, comp_type: int | None = 0, backlash: float = 0.0, table: bool = True) -> bytes:
    lines = [f"[JOINT_{number}]"]
    lines += [f"COMP_FILE = joint_{number}.comp"] if table else []
    lines += [f"COMP_FILE_TYPE = {comp_type}"] if table and comp_type is not None else []
    return "\n".join([*lines, f"BACKLASH = {backlash}", ""]).encode()


def rows(nominal: FloatArray, forward: FloatArray, reverse: FloatArray, comp_type: int) -> str:
    """A table with these corrections, in either type."""
    columns = (nominal - forward, nominal - reverse) if comp_type == 0 else (forward, reverse)
    return "".join(f"{x:.7f} {a:.7f} {b:.7f}\n" for x, a, b in zip(nominal, *columns, strict=True))


def random_table(rng: np.random.Generator, count: int, comp_type: int) -> tuple[FloatArray, str]:
    gaps = rng.uniform(5.0, 15.0, count)
    nominal = np.round(np.cumsum(gaps) - gaps.sum() / 2, 4)
    forward = np.cumsum(rng.uniform(-2e-4, 2e-4, count) * gaps)
    reverse = forward + rng.uniform(-0.01, 0.01) + rng.uniform(-1e-4, 1e-4, count) * 5.0
    return nominal, rows(nominal, forward, reverse, comp_type)


def virtual(
    files: Mapping[str, bytes], kinds: Mapping[str, AxisKind] | None = None
) -> VirtualControl:
    return virtual_control(
        "linuxcnc", [ControlFile(name, content) for name, content in files.items()], kinds=kinds
    )


def differences(session: Session, control: VirtualControl, joint: str) -> list[float]:
    found = []
    for stop in session.of(joint):
        assert stop.direction is not None
        expected = control.correction(joint, np.array([stop.target]), stop.direction)[0]
        found.append(abs(stop.correction - expected))
    return found


class TestVirtualAgreesWithReal:
    KINDS: ClassVar[dict[str, AxisKind]] = {
        "0": AxisKind.LINEAR,
        "1": AxisKind.LINEAR,
        "2": AxisKind.LINEAR,
        "3": AxisKind.LINEAR,
        "4": AxisKind.LINEAR,
        "5": AxisKind.ROTARY,
        "6": AxisKind.ROTARY,
    }

    @pytest.fixture(scope="class")
    @classmethod
    def ran(cls) -> tuple[Session, VirtualControl]:
        rng = np.random.default_rng(20230208)
        nodes: dict[str, FloatArray] = {}
        texts: dict[str, str] = {}
        for joint, count, comp_type in (("0", 12, 0), ("1", 9, 1), ("5", 10, 0), ("6", 10, 1)):
            nodes[joint], texts[joint] = random_table(rng, count, comp_type)
        nodes["3"] = np.arange(-102.0, 102.1, 0.8)
        walk = np.cumsum(rng.uniform(-2e-4, 2e-4, (2, 256)), axis=1)
        texts["3"] = rows(nodes["3"], walk[0], walk[1], 0)
        texts["1"] = texts["1"].replace("\n", " 9 text behind\r\n")  # the control takes these
        lines = texts["0"].split("\n")
        texts["0"] = "\n".join(
            [*lines[:5], lines[5].ljust(253), *lines[6:]]
        )  # the longest line that is taken whole
        lines = texts["6"].split("\n")
        texts["6"] = "\n".join(
            [*lines[:7], lines[7].ljust(254), *lines[8:]]
        )  # one byte more: the table ends there
        files = {f"joint_{joint}.comp": text.encode() for joint, text in texts.items()}
        files |= {
            f"joint_{joint}.ini": ini(int(joint), {"1": 1, "6": 1}.get(joint, 0)) for joint in texts
        }
        files["joint_5.ini"] = ini(5, None)  # type left out: 0
        files["joint_0.ini"] = ini(0, 0, backlash=0.5)  # ignored beside a table
        files["joint_2.ini"] = ini(2, table=False, backlash=0.020)
        files["joint_4.ini"] = ini(4, table=False)
        stops: list[list[float]] = []
        for i in range(60):
            fresh = [rng.uniform(-120.0, 120.0) for _ in cls.KINDS]
            at_node = [
                float(rng.choice(nodes[joint])) if joint in nodes else x
                for joint, x in zip(cls.KINDS, fresh, strict=True)
            ]
            small = [x + rng.uniform(-0.5, 0.5) for x in stops[-1]] if stops else fresh
            stops.append([[*fresh], at_node, small][i % 3])
        return run_session(files, cls.KINDS, stops), virtual(files, cls.KINDS)

    @pytest.mark.parametrize("joint", list(KINDS))
    def test_at_points_between_outside_and_after_reversals(
        self, ran: tuple[Session, VirtualControl], joint: str
    ) -> None:
        session, control = ran
        assert session.messages == ()
        for direction in (UP, DOWN):
            assert len(session.of(joint, direction)) >= 15
        assert max(differences(session, control, joint)) < SAME

    def test_the_comparison_could_fail(self, ran: tuple[Session, VirtualControl]) -> None:
        session, control = ran
        assert control.points("0").size == 12
        assert control.points("6").size == 8
        for joint in ("0", "1", "3", "5", "6", "2"):
            applied = [stop.correction for stop in session.of(joint)]
            assert max(applied) - min(applied) > 1e-3
        one = session.of("2")[0]
        assert one.direction is not None
        assert (
            abs(
                one.correction - control.correction("2", np.array([0.0]), one.direction.opposite)[0]
            )
            > 0.01
        )


class TestBrokenFiles:
    """One good joint and eight broken copies of its files, in one session."""

    NOMINAL = np.arange(-100.0, 101.0, 20.0)
    FORWARD = 0.004 * np.sin(NOMINAL / 40.0) - 0.002
    REVERSE = FORWARD + 0.006
    NAMES = (
        "good",
        "header",
        "blank line",
        "swapped columns",
        "wrong type",
        "lost row",
        "260 rows",
        "descending",
        "sign",
    )
    SAID = (
        "header",
        "blank line",
        "260 rows",
        "descending",
    )  # what the virtual control must say by itself
    REPORTED = ("260 rows", "descending")  # what the real control reports as an error

    @classmethod
    def texts(cls) -> dict[str, str]:
        good = rows(cls.NOMINAL, cls.FORWARD, cls.REVERSE, 0)
        lines = good.splitlines(keepends=True)
        many = np.linspace(
            -129.5, 129.5, 260
        )  # four above 256: the control keeps only its first 32 messages
        wave = 0.004 * np.sin(many / 40.0) - 0.002
        return {
            "good": good,
            "header": "nominal forward reverse\n" + good,
            "blank line": "".join([*lines[:5], "\n", *lines[5:]]),
            "swapped columns": rows(cls.NOMINAL, cls.REVERSE, cls.FORWARD, 0),
            "wrong type": good,
            "lost row": "".join(lines[:-1]),
            "260 rows": rows(many, wave, wave + 0.006, 0),
            "descending": "".join(reversed(lines)),
            "sign": rows(cls.NOMINAL, -cls.FORWARD, -cls.REVERSE, 0),
        }

    @pytest.fixture(scope="class")
    @classmethod
    def ran(cls) -> tuple[Session, VirtualControl]:
        files: dict[str, bytes] = {}
        for number, (name, text) in enumerate(cls.texts().items()):
            files[f"joint_{number}.comp"] = text.encode()
            files[f"joint_{number}.ini"] = ini(
                number, 1 if name == "wrong type" else 0, backlash=0.03 if name == "header" else 0.0
            )
        kinds = {str(n): AxisKind.LINEAR if n < 6 else AxisKind.ROTARY for n in range(9)}
        way = [-110.0, *np.linspace(-105.0, 145.0, 16), 150.0, *np.linspace(145.0, -105.0, 16)]
        return run_session(files, kinds, [[x] * 9 for x in way]), virtual(files, kinds)

    @pytest.mark.parametrize("number", range(9), ids=NAMES)
    def test_virtual_control_shows_the_same_wrong_behaviour(
        self, ran: tuple[Session, VirtualControl], number: int
    ) -> None:
        session, control = ran
        # with the type confused the table's slope is 1: the residual before standstill is the whole
        # 2.1e-3 mm
        assert max(differences(session, control, str(number))) < (
            3e-3 if self.NAMES[number] == "wrong type" else SAME
        )

    @pytest.mark.parametrize("number", range(9), ids=NAMES)
    def test_fault_is_caught_by_the_plan_or_by_the_control(
        self, ran: tuple[Session, VirtualControl], number: int
    ) -> None:
        session, control = ran
        name = self.NAMES[number]
        off = [
            abs(
                stop.correction
                - np.interp(
                    stop.target,
                    self.NOMINAL,
                    self.FORWARD if stop.direction is UP else self.REVERSE,
                )
            )
            for stop in session.of(str(number))
        ]
        reported = [message for message in session.messages if f"joint {number}:" in message]
        assert bool(reported) == (name in self.REPORTED), session.messages
        if name == "good":
            assert max(off) < SAME
        else:
            assert max(off) > 5e-4 or reported  # mm, half a micrometre and above
        said = [note for note in control.notes if f"joint_{number}.comp" in note]
        assert bool(said) == (name in self.SAID), control.notes


def test_inch_machine() -> None:
    """Files and motion in inches: the virtual control answers in millimetres."""
    files = {
        "joint_0.comp": b"0 0 0.0002\n4 4.0004 3.9999\n10 9.9990 10.0003\n",
        "joint_0.ini": ini(0),
    }
    stops = [[-1.0], [0.0], [2.5], [4.0], [11.0], [7.0], [1.0]]
    judge = virtual_control(
        "linuxcnc", [ControlFile(n, c) for n, c in files.items()], options={"units": "inch"}
    )
    for stop in applied_corrections(files, {"0": AxisKind.LINEAR}, stops, inch=True):
        assert stop.direction is not None
        expected = judge.correction("0", np.array([stop.target * 25.4]), stop.direction)[0]
        assert stop.correction * 25.4 == pytest.approx(expected, abs=25.4 * SAME)


def bent(
    knots: Sequence[float], values: Sequence[float], lost_motion: float
) -> Callable[[FloatArray, Direction], FloatArray]:
    """A machine's error: straight between knots; with lost motion the axis stands too high when it
    arrives downward.
    """

    def error(positions: FloatArray, direction: Direction) -> FloatArray:
        return np.asarray(
            np.interp(positions, knots, values) + (lost_motion if direction is DOWN else 0.0)
        )

    return error


class TestMeasuring:
    KNOTS = (0.0, 100.0, 200.0, 300.0, 400.0)
    VALUES = (0.0, 0.008, 0.003, -0.006, -0.011)
    LOST = 0.012
    TARGETS = np.array([10.0, 100.0, 200.0, 250.0, 300.0, 390.0])

    def test_without_a_table_the_error_itself_is_measured(self) -> None:
        error = bent(self.KNOTS, self.VALUES, self.LOST)
        positive, negative = measure({}, error, self.TARGETS, runs=3)
        assert positive.shape == negative.shape == (6, 3)
        by_hand = np.array([0.0008, 0.008, 0.003, -0.0015, -0.006, -0.0105])
        assert (
            np.max(np.abs(positive - by_hand[:, None])) < 1e-9
        )  # mm; the planner's own end position
        assert np.max(np.abs(negative - by_hand[:, None] - 0.012)) < 1e-9

    def test_table_that_knows_the_error_removes_it(self) -> None:
        error = bent(self.KNOTS, self.VALUES, self.LOST)
        x = np.array(self.KNOTS)
        files = {
            "joint_0.comp": rows(x, -error(x, UP), -error(x, DOWN), 0).encode(),
            "joint_0.ini": ini(0),
        }
        positive, negative = measure(files, error, self.TARGETS, runs=2, control_runs=2)
        # the error is met at the corrected position: second order, slope 9e-5 times 0.023 mm, and
        # the file's 1e-7 mm
        assert np.max(np.abs(np.hstack([positive, negative]))) < 2.5e-6

    def test_swapped_columns_double_the_reversal(self) -> None:
        error = bent(self.KNOTS, self.VALUES, self.LOST)
        x = np.array(self.KNOTS)
        files = {
            "joint_0.comp": rows(x, -error(x, DOWN), -error(x, UP), 0).encode(),
            "joint_0.ini": ini(0),
        }
        positive, negative = measure(files, error, self.TARGETS, runs=1)
        assert np.mean(positive - negative) == pytest.approx(-2 * self.LOST, abs=3e-6)

    def test_noise_and_joints_of_different_length(self) -> None:
        errors = {"0": bent((0, 400), (0, 0.01), 0.0), "1": bent((0, 360), (0.02, 0.02), 0.005)}
        targets = {"0": np.linspace(20.0, 380.0, 7), "1": np.array([0.0, 120.0, 240.0])}
        kinds = {"0": AxisKind.LINEAR, "1": AxisKind.ROTARY}
        rng = np.random.default_rng(3)
        found = measure_joints({}, kinds, errors, targets, 40, rng, noise=0.001)
        assert found["0"][0].shape == (7, 40)
        assert found["1"][1].shape == (3, 40)
        # standard errors: 0.001/sqrt(40) for a mean (5 of them), 0.001/sqrt(2*39*20) for s over 20
        # columns (4 of them)
        assert np.max(
            np.abs(found["0"][0].mean(axis=1) - targets["0"] * 0.01 / 400)
        ) < 5 * 0.001 / np.sqrt(40)
        assert np.max(np.abs(found["1"][1].mean(axis=1) - 0.025)) < 5 * 0.001 / np.sqrt(40)
        columns = np.vstack([side for sides in found.values() for side in sides])
        assert np.sqrt(np.mean(columns.var(axis=1, ddof=1))) == pytest.approx(
            0.001, abs=4 * 0.001 / np.sqrt(2 * 39 * 20)
        )
