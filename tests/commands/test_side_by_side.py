"""The same work on many items: in this process and in others beside it, with the results, the
errors and the bytes of working in turn.
"""

from __future__ import annotations

import io
import json
import os
import pickle
import platform
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import pytest

from compwright.cli import run
from compwright.foundations.errors import CapacityError, Fault
from compwright.foundations.processors import keep_free_memory
from compwright.foundations.session import Session
from compwright.workflow.commands.run import planned
from compwright.workflow.inputs.jobs import read_job_file

SOURCE = Path(__file__).resolve().parents[2] / "src"

#: A program as an engineer starts it: its functions are found again in the processes beside it.
PROGRAM = """
import json, os, sys, time
from multiprocessing import parent_process
sys.path.insert(0, {source!r})
from compwright.foundations import processes
from compwright.foundations.errors import CapacityError, Fault

def ready():
    pass

def square(number):
    time.sleep(0.02)
    return number * number, os.getpid()

def refused(number):
    if number in (5, 11):
        raise CapacityError(Fault(message=f"no room for {{number}}"))
    return number

def dies_elsewhere(number):
    if parent_process() is not None and number == 1:
        os._exit(9)
    return number + 0.5

def broken_elsewhere(number):
    if parent_process() is not None:
        raise RuntimeError("only there")
    return -number

def slow_elsewhere(number):
    time.sleep(0.01 if parent_process() is None else 0.5)
    return os.getpid()

if __name__ == "__main__":
    processes.processors = lambda: int(sys.argv[1])
    said = {{}}
    with processes.side_by_side(40, ready) as each:
        time.sleep(1.0 if sys.argv[1] != "1" else 0.0)  # the others are ready
        results = each(square, range(40))
        said["squares"] = [one for one, _ in results]
        said["processes"] = len({{pid for _, pid in results}})
        said["kept_back"] = sum(pid != os.getpid() for pid in each(slow_elsewhere, range(20)))
        try:
            each(refused, range(14))
        except CapacityError as error:
            said["refused"] = [fault.message for fault in error.faults]
        said["nothing"] = each(square, [])
        said["broken"] = each(broken_elsewhere, range(9))
        said["dies"] = each(dies_elsewhere, range(9))
        said["afterwards"] = each(refused, range(4))
    print(json.dumps(said))
"""


def said_by(tmp_path: Path, processors: int) -> dict[str, Any]:
    program = tmp_path / "program.py"
    program.write_text(PROGRAM.format(source=str(SOURCE)), encoding="utf-8")
    done = subprocess.run(
        [sys.executable, str(program), str(processors)], capture_output=True, text=True, check=True
    )
    assert done.stderr == ""
    said: dict[str, Any] = json.loads(done.stdout)
    return said


@pytest.mark.parametrize("processors", [1, 3])
def test_results_and_errors_are_those_of_working_in_turn(tmp_path: Path, processors: int) -> None:
    said = said_by(tmp_path, processors)
    assert said["squares"] == [number * number for number in range(40)]
    assert said["processes"] == processors
    assert said["kept_back"] <= 2 * (processors - 1)  # what they began with, no more
    assert said["refused"] == ["no room for 5"]  # the first in the order of the items
    assert said["nothing"] == []
    assert said["broken"] == [-number for number in range(9)]
    assert said["dies"] == [number + 0.5 for number in range(9)]
    assert said["afterwards"] == [0, 1, 2, 3]


def test_an_error_is_copied_with_its_faults() -> None:
    error = CapacityError(
        Fault(message="too many points", place="table", expected="at most 5", found="6"),
        Fault(message="another", file="job.yaml"),
    )
    copy = pickle.loads(pickle.dumps(error))  # noqa: S301 - our own
    assert type(copy) is CapacityError
    assert copy.faults == error.faults
    assert str(copy) == str(error)


LONG = """
import signal, sys, time
signal.signal(signal.SIGINT, signal.default_int_handler)  # also where a shell had it ignored
sys.path.insert(0, {source!r})
from compwright.foundations import processes

def ready():
    print("ready", flush=True)

def slow(number):
    time.sleep(20.0)

if __name__ == "__main__":
    processes.processors = lambda: 2
    with processes.side_by_side(4, ready) as each:
        each(slow, range(4))
"""


@pytest.mark.skipif(
    sys.platform == "win32", reason="a console's Ctrl-C cannot be sent to one group"
)
def test_ctrl_c_ends_all_of_them_at_once(tmp_path: Path) -> None:
    program = tmp_path / "long.py"
    program.write_text(LONG.format(source=str(SOURCE)), encoding="utf-8")
    running = subprocess.Popen(
        [sys.executable, str(program)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    assert running.stdout is not None
    assert running.stdout.readline() == "ready\n"
    time.sleep(0.3)
    started = time.perf_counter()
    os_group(running.pid)
    _, errors = running.communicate(timeout=10)
    assert time.perf_counter() - started < 5.0  # seconds; the work itself would take 40
    assert errors.count("Traceback") == 1  # that of this program, which catches nothing
    assert errors.rstrip().endswith("KeyboardInterrupt")


def os_group(pid: int) -> None:
    """What a terminal does at Ctrl-C: the signal goes to the whole group."""
    import os

    os.killpg(pid, signal.SIGINT)


#: Says the numbers of its processes when all have begun, then works without end.
ENDLESS = """
import os, sys, time
sys.path.insert(0, {source!r})
from compwright.foundations import processes

def ready():
    pass

def endless(number):
    with open({folder!r} + f"/{{os.getpid()}}", "w"):
        pass
    time.sleep(0.1)

if __name__ == "__main__":
    processes.processors = lambda: 3
    with processes.side_by_side(40, ready) as each:
        while True:
            each(endless, range(40))
"""


@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="no such signal on this system")
def test_a_first_process_that_is_killed_leaves_none_behind(tmp_path: Path) -> None:
    folder = tmp_path / "at_work"
    folder.mkdir()
    program = tmp_path / "program.py"
    program.write_text(ENDLESS.format(source=str(SOURCE), folder=str(folder)), encoding="utf-8")
    with subprocess.Popen([sys.executable, str(program)], stderr=subprocess.DEVNULL) as first:
        try:
            _wait_for(lambda: len(list(folder.iterdir())) == 3, seconds=60)
        finally:
            first.kill()
    others = [int(path.name) for path in folder.iterdir() if int(path.name) != first.pid]
    _wait_for(lambda: not any(_lives(process) for process in others), seconds=20)


def _wait_for(condition: Callable[[], bool], seconds: float) -> None:
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "waited in vain"
        time.sleep(0.05)


def _lives(process: int) -> bool:
    """Whether there is a process of this number that has not ended (one that nobody asked for
    its end yet stands in the list all the same).
    """
    try:
        os.kill(process, 0)
        state = Path(f"/proc/{process}/stat")
        return not state.exists() or state.read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except (ProcessLookupError, FileNotFoundError):
        return False


# --- what another process has to load
# --------------------------------------------------------------------------------------------------

MACHINE = """
virtual_machine: 1
controller: {format: siemens-840d-sl}
axes:
  X:
    travel: [0, 600]
    address: AX1
    error: {slope_um_per_m: 15, reversal: {mean_um: -3}, noise_um: 0.4}
    test: {targets: 7}
"""
JOB = """
compwright: 1
controller: {format: siemens-840d-sl}
states: {as_found: none}
axes: {X: {travel: [0, 600], address: AX1, before: [x.csv]}}
"""
#: Reading and writing for controls, jobs and commands: half of the time that all imports take.
NOT_NEEDED = ("formats", "jobs", "instruments", "documents", "workflow.commands", "cli")


class Named(pickle.Unpickler):
    """Reads a copy and notes the modules that it needs."""

    def __init__(self, copy: bytes) -> None:
        super().__init__(io.BytesIO(copy))
        self.modules: set[str] = set()

    def find_class(self, module_name: str, global_name: str) -> Any:
        self.modules.add(module_name)
        return super().find_class(module_name, global_name)


@pytest.mark.short_estimate
@pytest.mark.real_pages
def test_work_on_an_axis_loads_neither_formats_nor_commands(tmp_path: Path) -> None:
    (tmp_path / "machine.yaml").write_text(MACHINE)
    (tmp_path / "job.yaml").write_text(JOB)
    assert run(["simulate", str(tmp_path / "machine.yaml"), "--out", str(tmp_path)]) == 0
    named: set[str] = set()

    def copied(work: Callable[[Any], Any], items: Sequence[Any]) -> list[Any]:
        done = [work(item) for item in items]
        if items:
            reader = Named(pickle.dumps((work, list(items), done)))
            reader.load()
            named.update(reader.modules)
        return done

    planned(
        Session(),
        read_job_file(Session(), tmp_path / "job.yaml"),
        tmp_path,
        tmp_path / "out",
        each=copied,
    )
    own = {name for name in named if name.startswith("compwright.")}
    assert {"compwright.planning.axis_tasks", "compwright.reporting.axis_report"} <= own
    asked = (
        "import sys\n"
        "from compwright.workflow.preloading import ready_for_axes\n"
        "ready_for_axes()\n"
        f"from importlib import import_module; [import_module(name) for name in {sorted(own)}]\n"
        "print('\\n'.join(sys.modules))"
    )
    loaded = subprocess.run(
        [sys.executable, "-c", asked], capture_output=True, text=True, check=True
    ).stdout.split()
    assert "osqp" in loaded  # before there is work
    assert not [
        name
        for name in loaded
        if name.startswith(tuple(f"compwright.{room}" for room in NOT_NEEDED))
    ]
    assert not {"pydantic", "yaml", "click", "rich", "matplotlib", "jinja2.ext"} & set(loaded)


# --- memory that is free again
# --------------------------------------------------------------------------------------------------

FAULTS = """
import resource, sys
from compwright.foundations.processors import keep_free_memory
if sys.argv[1] == "kept":
    keep_free_memory()
blocks = lambda: [bytearray(5_000_000) for _ in range(4)]  # zeros: every page of them is written
blocks()
before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
for _ in range(20):
    blocks()
print(resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before)
"""


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="another C library")
def test_memory_that_is_free_again_is_not_got_from_the_system_anew() -> None:
    faults = {
        how: int(
            subprocess.run(
                [sys.executable, "-c", FAULTS, how],
                env={**os.environ, "PYTHONPATH": str(SOURCE)},
                capture_output=True,
                check=True,
            ).stdout
        )
        for how in ("kept", "given back")
    }
    assert faults["kept"] < 0.1 * faults["given back"]


@pytest.mark.parametrize("system", ["win32", "darwin", "linux"])
def test_where_the_c_library_cannot_be_told_nothing_happens(
    system: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def no_such_library(_name: object) -> object:
        assert system == "linux"
        return object()  # without mallopt, as musl

    monkeypatch.setattr(sys, "platform", system)
    monkeypatch.setattr("ctypes.CDLL", no_such_library)
    keep_free_memory()
