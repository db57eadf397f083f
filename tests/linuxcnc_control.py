"""A real LinuxCNC, without a screen, as the judge of exported compensation files.

For tests. `applied_corrections` loads the files as they are into a running control, drives to stops
and returns what the control adds at each of them. `measure` puts a virtual machine with a known
error behind the control's motor positions and "measures" it like a laser would. Both take 1 to 2 s
to start and stop and about 0.06 s per stop; several joints are driven at the same time. Say
``pytestmark = REAL_LINUXCNC`` in the test module: where the control is not installed, or the kernel
does not allow separate namespaces, they are skipped with the reason.

A control that does not come up is started again, `ATTEMPTS` times in all, and has the more time the
busier the computer is; then `ControlNotUpError` says so with the control's own log. A session has
its own memory keys, network and processes (``session.sh``), and a lock lets only one run at a time
on a computer, whoever tests there: two would only take each other's time.

The files are used as a user would: ``joint_N.ini`` is included by the machine's INI (``#INCLUDE``),
so its keys (COMP_FILE, COMP_FILE_TYPE, BACKLASH) are what the control itself read.
"""

from __future__ import annotations

import fcntl
import functools
import json
import os
import shutil
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from compwright.records.axis import AxisKind, Direction, FloatArray

SCRIPTS = Path(__file__).resolve().parent / "real_linuxcnc"
SECONDS = 60.0  # a session takes 2 to 10 s on an idle computer
TIMED_OUT = 124  # exit status of `timeout`
ATTEMPTS = 3
LONGEST_WAIT = 900.0  # s, for the sessions of other test processes; each of them is bounded
PAUSE = 0.2  # s, between two looks at the lock

#: error(positions, direction) -> deviation of the machine, mm or deg, positions being those of the
#: motor.
Error = Callable[[FloatArray, Direction], FloatArray]


@functools.cache
def why_not() -> str:
    """Return why no session can run here, empty when one can."""
    if shutil.which("linuxcnc", path="/usr/bin:/bin") is None:
        return "LinuxCNC is not installed"
    rights = [] if os.geteuid() == 0 else ["--user", "--map-current-user", "--keep-caps"]
    command = ["unshare", *rights, "--pid", "--fork", "--mount-proc", "--ipc", "--net", "--mount"]
    try:
        tried = subprocess.run(
            [*command, "mount", "-t", "tmpfs", "tmpfs", "/tmp"],  # noqa: S108
            capture_output=True,
            timeout=120,
            check=False,
        )  # in its own namespace
    except (OSError, subprocess.TimeoutExpired) as error:
        return f"unshare cannot be used: {error}"
    return (
        ""
        if tried.returncode == 0
        else f"separate namespaces are not allowed: {tried.stderr.decode(errors='replace').strip()}"
    )


#: Where the real control is a must (continuous integration), its absence is a failure, not a skip.
REQUIRED = os.environ.get("COMPWRIGHT_REQUIRE_LINUXCNC") == "1"
REAL_LINUXCNC = [
    pytest.mark.real_linuxcnc,
    pytest.mark.skipif(bool(why_not()) and not REQUIRED, reason=why_not()),
]


@dataclass(frozen=True, slots=True)
class Stop:
    """One joint at one stop, all in machine units (mm or deg unless the machine is said to be an
    inch one).

    ``direction`` is that of the last motion that arrived here, None for a joint that has not moved
    yet. ``motor`` is the commanded motor position less the motor offset; ``correction`` what the
    control applies: motor - position. ``place``: the commanded motor position itself, which is 0
    where the control was started, whatever homing made of it.
    """

    number: int
    joint: str
    target: float
    direction: Direction | None
    position: float
    motor: float
    place: float

    @property
    def correction(self) -> float:
        """What the control adds to the command."""
        return self.motor - self.position


@dataclass(frozen=True, slots=True)
class Session:
    """What a run of the control gave. ``messages``: its own error messages."""

    stops: tuple[Stop, ...]
    messages: tuple[str, ...]

    def of(self, joint: str, direction: Direction | None = None) -> list[Stop]:
        """Return the stops of one joint, in one approach direction or all that were approached."""
        return [
            s
            for s in self.stops
            if s.joint == joint and s.direction is not None and direction in {None, s.direction}
        ]


class ControlNotUpError(AssertionError):
    """The control never came up: nothing was tested, nothing is said about the files."""


class ControlStoppedError(AssertionError):
    """The control came up and then did not arrive at a stop."""


def applied_corrections(
    files: Mapping[str, bytes],
    joints: Mapping[str, AxisKind],
    stops: Sequence[Sequence[float]],
    *,
    inch: bool = False,
) -> list[Stop]:
    """Return what the control applies at each of ``stops``, one `Stop` per stop and joint, in that
    order.

    ``files``: bare name -> bytes; ``joint_N.ini`` is included into the INI's section of that joint,
    other files lie beside it. ``joints``: number as text -> kind, numbered from "0" without gaps,
    at most six linear and three rotary. ``stops`` (n, joints), machine units. The control homes in
    place at 0. Raises AssertionError when it reports an error, and as `run_session`.
    """
    session = run_session(files, joints, stops, inch=inch)
    assert not session.messages, session.messages
    return list(session.stops)


def run_session(
    files: Mapping[str, bytes],
    joints: Mapping[str, AxisKind],
    stops: Sequence[Sequence[float]],
    *,
    inch: bool = False,
    hal: Sequence[str] = (),
) -> Session:
    """As `applied_corrections`, but error messages of the control are returned, not raised.

    ``hal``: further lines of its wiring, such as a home switch; `switch_at` gives them.

    Raises `ControlNotUpError` when it did not come up in any of `ATTEMPTS`, `ControlStoppedError`
    when it did not reach a stop.
    """
    failures = []
    with one_at_a_time():
        for attempt in range(1, ATTEMPTS + 1):
            wait = patience() * attempt
            ended = _session(files, joints, stops, inch=inch, hal=hal, patience=wait)
            if ended.came_up:
                break
            failures.append(
                f"--- attempt {attempt}: {ended.trouble}; its messages: {list(ended.messages)}; its"
                f" log:\n{ended.log}"
            )
        else:
            raise ControlNotUpError(
                f"LinuxCNC did not come up in {ATTEMPTS} attempts; nothing was tested.\n"
                + "\n".join(failures)
            )
    if ended.trouble:
        reached = (
            f"reached {len(ended.stops)} of {len(stops)} stops: {ended.trouble};"
            f" {list(ended.messages)}"
        )
        raise ControlStoppedError(f"LinuxCNC came up and {reached}\n{ended.log}")
    return Session(tuple(_stops(ended.stops, list(joints), stops)), ended.messages)


def patience() -> float:
    """Return by how much longer than on an idle computer to wait: the programs that want to run per
    processor, 1 to 4.
    """
    return min(max(os.getloadavg()[0] / (os.cpu_count() or 1), 1.0), 4.0)


@contextmanager
def one_at_a_time(path: Path | None = None, longest: float = LONGEST_WAIT) -> Iterator[None]:
    """Hold the computer's only place for a session. The system gives it free when its holder dies,
    however that happens.
    """
    path = path or Path(tempfile.gettempdir()) / f"compwright-linuxcnc-{os.getuid()}.lock"
    with path.open("a") as lock:
        end = time.monotonic() + longest
        while True:
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
                break
            except BlockingIOError:
                if time.monotonic() > end:
                    raise ControlNotUpError(
                        f"another test process has kept {path} for more than {longest:g} s"
                    ) from None
                time.sleep(PAUSE)
        yield


@dataclass(frozen=True, slots=True)
class _Ended:
    """One attempt: ``stops`` readings by stop and joint, ``trouble`` why it ended early, or
    empty.
    """

    came_up: bool
    stops: list[list[list[float]]]
    messages: tuple[str, ...]
    trouble: str
    log: str


def _session(
    files: Mapping[str, bytes],
    joints: Mapping[str, AxisKind],
    stops: Sequence[Sequence[float]],
    *,
    inch: bool,
    hal: Sequence[str],
    patience: float,
) -> _Ended:
    letters = _letters(joints)
    with tempfile.TemporaryDirectory(prefix="linuxcnc-") as name:
        folder = Path(name)
        folder.chmod(0o777)
        for file, content in files.items():
            (folder / file).write_bytes(content)
        (folder / "machine.ini").write_text(
            _machine_ini(files, joints, letters, inch=inch), encoding="utf-8"
        )
        wiring = _machine_hal(len(letters)) + "".join(f"{line}\n" for line in hal)
        (folder / "machine.hal").write_text(wiring, encoding="utf-8")
        wanted = {
            "letters": letters,
            "stops": [[float(x) for x in row] for row in stops],
            "patience": patience,
        }
        (folder / "stops.json").write_text(json.dumps(wanted))
        shutil.copy(SCRIPTS / "display.py", folder / "display.py")
        seconds = SECONDS * patience
        with (folder / "log").open("wb") as log_file:
            # session.sh ends itself after `seconds`; killed from here it would leave the control
            # behind, so this limit is far off
            code = subprocess.run(
                [str(SCRIPTS / "session.sh"), name, "machine.ini", f"{seconds:.0f}"],
                stdin=subprocess.DEVNULL,
                stdout=log_file,
                stderr=subprocess.STDOUT,
                timeout=2 * seconds + 60,
                check=False,
            ).returncode
        log = (folder / "log").read_text(errors="replace")
        result = folder / "result.json"
        if not result.exists():
            how = (
                f"no result within {seconds:.0f} s"
                if code == TIMED_OUT
                else f"it ended without a result (exit {code})"
            )
            return _Ended(came_up=False, stops=[], messages=(), trouble=how, log=log)
        found = json.loads(result.read_text())
    return _Ended(found["came_up"], found["stops"], tuple(found["messages"]), found["trouble"], log)


def _stops(
    readings: list[list[list[float]]], joints: list[str], stops: Sequence[Sequence[float]]
) -> list[Stop]:
    found = []
    before = [0.0] * len(joints)
    arriving: list[Direction | None] = [None] * len(joints)
    for number, (targets, row) in enumerate(zip(stops, readings, strict=True)):
        for j, (joint, (position, motor, _, raw)) in enumerate(zip(joints, row, strict=True)):
            if targets[j] != before[j]:
                arriving[j] = Direction.POSITIVE if targets[j] > before[j] else Direction.NEGATIVE
            found.append(Stop(number, joint, float(targets[j]), arriving[j], position, motor, raw))
        before = [float(x) for x in targets]
    return found


def _letters(joints: Mapping[str, AxisKind]) -> str:
    """Return the axis letter of each joint: XYZUVW for linear ones, ABC for rotary ones."""
    assert list(joints) == [str(n) for n in range(len(joints))], (
        "joints are numbered from 0 without gaps"
    )
    free = {AxisKind.LINEAR: iter("XYZUVW"), AxisKind.ROTARY: iter("ABC")}
    return "".join(next(free[kind]) for kind in joints.values())


def _machine_ini(
    files: Mapping[str, bytes], joints: Mapping[str, AxisKind], letters: str, *, inch: bool
) -> str:
    """Return the INI of a machine whose joints have the exported files.

    The axis limits plan the motion. The joint limits only shape the ramp of the correction: they
    are far above, so that every correction below 2.5 mm is applied within one servo tick and the
    control's dead zone for small steps is out of reach.
    """
    limits = "MIN_LIMIT = -99999\nMAX_LIMIT = 99999\n"
    head = f"""[EMC]
VERSION = 1.1
[DISPLAY]
DISPLAY = ./display.py stops.json result.json
[TASK]
TASK = milltask
CYCLE_TIME = 0.001
[EMCMOT]
EMCMOT = motmod
SERVO_PERIOD = 1000000
[EMCIO]
EMCIO = io
[HAL]
HALFILE = machine.hal
[KINS]
KINEMATICS = trivkins coordinates={letters}
JOINTS = {len(letters)}
[TRAJ]
COORDINATES = {letters}
LINEAR_UNITS = {"inch" if inch else "mm"}
ANGULAR_UNITS = degree
MAX_LINEAR_VELOCITY = 5000
MAX_ANGULAR_VELOCITY = 5000
"""
    axes = "".join(
        f"[AXIS_{letter}]\n{limits}MAX_VELOCITY = 5000\nMAX_ACCELERATION = 50000\n"
        for letter in letters
    )
    joint_limits = (
        "MAX_VELOCITY = 1e6\nMAX_ACCELERATION = 1e7\nFERROR = 1000\nMIN_FERROR ="
        " 1000\nHOME_SEQUENCE = 0\n"
    )
    parts = []
    for number, kind in joints.items():
        own = f"joint_{number}.ini"
        table = f"COMP_FILE = joint_{number}.comp\n" if f"joint_{number}.comp" in files else ""
        opening = f"#INCLUDE {own}\n" if own in files else f"[JOINT_{number}]\n{table}"
        angular = "ANGULAR" if kind is AxisKind.ROTARY else "LINEAR"
        parts.append(f"{opening}TYPE = {angular}\n{limits}{joint_limits}")
    return head + axes + "".join(parts)


def _machine_hal(joints: int) -> str:
    """Return the wiring: motor commands straight back as motor feedback, the emergency stop
    closed.
    """
    lines = [
        "loadrt [KINS]KINEMATICS",
        "loadrt [EMCMOT]EMCMOT servo_period_nsec=[EMCMOT]SERVO_PERIOD num_joints=[KINS]JOINTS",
        "addf motion-command-handler servo-thread",
        "addf motion-controller servo-thread",
        "net ready iocontrol.0.user-enable-out => iocontrol.0.emc-enable-in",
    ]
    lines += [
        f"net motor{j} joint.{j}.motor-pos-cmd => joint.{j}.motor-pos-fb" for j in range(joints)
    ]
    return "\n".join(lines) + "\n"


def switch_at(joint: int, place: float) -> list[str]:
    """Return the wiring of a home switch that is closed below ``place`` (machine units) of the
    motor, which starts at 0.
    """
    return [
        f"loadrt comp names=switch{joint}",
        f"addf switch{joint} servo-thread",
        f"setp switch{joint}.in1 {place}",
        f"net motor{joint} => switch{joint}.in0",
        f"net closed{joint} switch{joint}.out => joint.{joint}.home-sw-in",
    ]


def measure(
    files: Mapping[str, bytes],
    error: Error,
    targets: FloatArray,
    runs: int = 5,
    rng: np.random.Generator | None = None,
    *,
    noise: float = 0.0,
    kind: AxisKind = AxisKind.LINEAR,
    beyond: float = 5.0,
    control_runs: int = 1,
) -> tuple[FloatArray, FloatArray]:
    """Return deviations (m, runs) for approaches in + and -, mm or deg: joint 0 of a machine with
    ``error``, measured.

    As `measure_joints` for joint "0" alone.
    """
    found = measure_joints(
        files,
        {"0": kind},
        {"0": error},
        {"0": targets},
        runs,
        rng,
        noise=noise,
        beyond=beyond,
        control_runs=control_runs,
    )
    return found["0"]


def measure_joints(
    files: Mapping[str, bytes],
    joints: Mapping[str, AxisKind],
    errors: Mapping[str, Error],
    targets: Mapping[str, FloatArray],
    runs: int = 5,
    rng: np.random.Generator | None = None,
    *,
    noise: float = 0.0,
    beyond: float = 5.0,
    control_runs: int = 1,
) -> dict[str, tuple[FloatArray, FloatArray]]:
    """Return by joint the deviations (m, runs) for approaches in + and -, mm or deg (measured minus
    target).

    The control with ``files`` loaded drives each joint from ``beyond`` below its first target
    upward through all targets, beyond the last and back. A stop's measured position is the motor
    position plus ``errors[joint]`` there, plus normal noise of standard deviation ``noise`` from
    ``rng``. The control repeats exactly, so it drives the cycle ``control_runs`` times only and run
    i takes cycle i modulo that; the noise is fresh in every run. A joint with fewer targets than
    another waits by moving on beyond its end.
    """
    assert control_runs <= runs
    most = max(column.size for column in targets.values())
    ways = {
        joint: _way(np.asarray(targets[joint], dtype=np.float64), most, beyond) for joint in joints
    }
    cycle = np.column_stack([ways[joint] for joint in joints])
    stops = applied_corrections(files, joints, np.vstack([cycle] * control_runs).tolist())
    found: dict[str, tuple[FloatArray, FloatArray]] = {}
    for joint in joints:
        motor = np.array([s.motor for s in stops if s.joint == joint]).reshape(
            control_runs, cycle.shape[0]
        )
        wanted = np.asarray(targets[joint], dtype=np.float64)
        # a cycle is: one below, the targets upward (and waiting), one above, the targets downward
        # (and waiting)
        upward = motor[:, 1 : 1 + wanted.size]
        downward = motor[:, most + 2 : most + 2 + wanted.size][:, ::-1]
        sides = []
        for direction, positions in ((Direction.POSITIVE, upward), (Direction.NEGATIVE, downward)):
            once = positions + errors[joint](positions, direction) - wanted
            column = np.array([once[i % control_runs] for i in range(runs)]).T
            if noise:
                assert rng is not None, "noise needs a generator"
                column = column + rng.normal(0.0, noise, column.shape)
            sides.append(column)
        found[joint] = (sides[0], sides[1])
    return found


def _way(targets: FloatArray, most: int, beyond: float) -> FloatArray:
    """Return one cycle of positions (2 most + 2,): below, upward, waiting above, turn, downward,
    waiting below.
    """
    idle = np.arange(1, most - targets.size + 1) * beyond
    above = targets[-1] + idle
    turn = targets[-1] + (idle.size + 1) * beyond
    return np.concatenate(
        [[targets[0] - beyond], targets, above, [turn], targets[::-1], targets[0] - idle]
    )
