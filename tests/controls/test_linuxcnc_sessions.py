"""How the real control is started for the tests: again when it does not come up, one at a time, and
never failing in silence.

The control is played by a script here, so that these run everywhere.
"""

from __future__ import annotations

import json
import subprocess
import sys
import time
from pathlib import Path

import pytest

import linuxcnc_control
from compwright.records.axis import AxisKind
from linuxcnc_control import (
    ControlNotUpError,
    ControlStoppedError,
    Session,
    one_at_a_time,
    patience,
    run_session,
)

pytestmark = pytest.mark.short_estimate

UP = {"came_up": True, "trouble": "", "messages": [], "stops": [[[1.0, 1.25, 0.0, 0.25]]]}
DOWN = {"came_up": False, "trouble": "the control did not come up", "messages": [], "stops": []}
STUCK = {
    "came_up": True,
    "trouble": "no standstill at [1.0]",
    "messages": ["joint 0 following error"],
    "stops": [],
}


@pytest.fixture
def scripts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = tmp_path / "scripts"
    folder.mkdir()
    (folder / "display.py").write_text("")
    monkeypatch.setattr(linuxcnc_control, "SCRIPTS", folder)
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    return folder


def play(folder: Path, *attempts: dict[str, object] | None) -> None:
    """The n-th start gives the n-th of these results; None: it ends without one."""
    for number, result in enumerate(attempts, start=1):
        if result is not None:
            (folder / f"{number}.json").write_text(json.dumps(result))
    script = folder / "session.sh"
    script.write_text(
        f"#!/bin/bash\ncd {folder}\necho x >>starts; n=$(wc -l <starts)\necho the log of start $n,"
        ' limit $3\ncp "$1/stops.json" "asked$n.json"\nif [ -f $n.json ]; then cp $n.json'
        ' "$1/result.json"; else exit 1; fi\n'
    )
    script.chmod(0o755)


def starts(folder: Path) -> int:
    return len((folder / "starts").read_text().splitlines())


def ran() -> Session:
    return run_session({}, {"0": AxisKind.LINEAR}, [[1.0]])


def test_a_control_that_comes_up_is_started_once(scripts: Path) -> None:
    play(scripts, UP)
    assert [stop.correction for stop in ran().stops] == [0.25]
    assert starts(scripts) == 1


@pytest.mark.parametrize("first", [DOWN, None], ids=["it says so", "no result at all"])
def test_a_control_that_does_not_come_up_is_started_again_with_more_time(
    scripts: Path, first: dict[str, object] | None
) -> None:
    play(scripts, first, first, UP)
    assert [stop.correction for stop in ran().stops] == [0.25]
    limits = [json.loads((scripts / f"asked{n}.json").read_text())["patience"] for n in (1, 2, 3)]
    assert limits == sorted(set(limits))
    assert limits[0] >= 1


def test_one_that_never_comes_up_is_said_with_its_own_log(scripts: Path) -> None:
    play(scripts, DOWN, None, DOWN, UP)
    with pytest.raises(ControlNotUpError) as raised:
        ran()
    said = str(raised.value)
    assert said.startswith("LinuxCNC did not come up in 3 attempts; nothing was tested.")
    assert "attempt 2: it ended without a result (exit 1)" in said
    assert [f"the log of start {n}" in said for n in (1, 2, 3, 4)] == [True, True, True, False]
    assert starts(scripts) == 3


def test_one_that_comes_up_and_does_not_arrive_is_not_tried_again(scripts: Path) -> None:
    """That may be what the files do to it."""
    play(scripts, STUCK, UP)
    with pytest.raises(
        ControlStoppedError,
        match=r"reached 0 of 1 stops: no standstill at \[1.0\]; \['joint 0 following error'\]",
    ):
        ran()
    assert starts(scripts) == 1


@pytest.mark.parametrize(("load", "expected"), [(0.0, 1.0), (2.0, 1.0), (5.0, 2.5), (400.0, 4.0)])
def test_time_limits_grow_with_the_load(
    monkeypatch: pytest.MonkeyPatch, load: float, expected: float
) -> None:
    monkeypatch.setattr("os.getloadavg", lambda: (load, 0.0, 0.0))
    monkeypatch.setattr("os.cpu_count", lambda: 2)
    assert patience() == expected


def test_another_process_waits_and_a_dead_one_does_not_hold_the_place(tmp_path: Path) -> None:
    lock = tmp_path / "place.lock"
    hold = (
        "import fcntl,sys,time; f=open(sys.argv[1],'a'); fcntl.flock(f,fcntl.LOCK_EX);"
        " print('held',flush=True); time.sleep(60)"
    )
    with subprocess.Popen([sys.executable, "-c", hold, str(lock)], stdout=subprocess.PIPE) as other:
        assert other.stdout is not None
        assert other.stdout.readline() == b"held\n"
        with (
            pytest.raises(ControlNotUpError, match="another test process"),
            one_at_a_time(lock, longest=0.05),
        ):
            pass
        other.kill()
    start = time.monotonic()
    with one_at_a_time(lock):
        assert time.monotonic() - start < 30  # s; it does not wait for the 60 of the other
