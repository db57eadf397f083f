"""Two threads of one process, each with commands of its own: each does what it does alone, byte for
byte.

One thread goes on at a time. After every call to the disk chance, by a seed, decides which: so each
seed is one interleaving, and always the same one.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from random import Random
from threading import Condition, Event, Thread, get_ident
from typing import Any

import pytest

from compwright.controls.control import open_control
from compwright.documents.json_text import to_json
from compwright.foundations import storage
from compwright.foundations.errors import StorageError
from compwright.foundations.session import Session
from compwright.reporting.panels import style
from compwright.workflow.commands.decode import decoded_files
from compwright.workflow.commands.evaluate import evaluate_files, write_evaluation
from compwright.workflow.commands.new import new_job
from compwright.workflow.commands.run import planned, write_planned
from compwright.workflow.inputs.job_inputs import read_job_inputs
from compwright.workflow.inputs.jobs import read_job_file
from dying import Process, running
from harm_fanuc import Backup, Pitch
from loop import Machine, csv_of

pytestmark = pytest.mark.short_estimate

#: Calls to the disk after which the other thread may go on.
CALLS = ("open", "lstat", "stat", "replace", "unlink", "mkdir")
SHORT, WHOLE = 20, 1
INI = """[KINS]
KINEMATICS = trivkins coordinates=X
[TRAJ]
LINEAR_UNITS = mm
[JOINT_0]
TYPE = LINEAR
BACKLASH = 0.002
COMP_FILE = joint_0.comp
COMP_FILE_TYPE = 0
"""
COMP = "".join(f"{node}.0 {node + 0.001 * bend} {node}.0\n" for node, bend in ((0, 0), (800, 3)))


@dataclass(frozen=True, slots=True)
class Task:
    """What one thread works on: a folder with a control's files, a test and a job."""

    folder: str
    format_id: str
    control: dict[str, str]
    machine: Machine
    address: str
    spacing: int

    def job(self, control: str) -> str:
        return (
            f"compwright: 1\ncontroller: {{format: {self.format_id}}}\n"
            f"states: {{as_found: [{control}]}}\n"
            f"axes:\n  X: {{travel: [0, {self.machine.high:g}], address: {self.address},"
            f" before: [x.csv], table: {{spacing: {self.spacing}}}}}\n"
        )

    @property
    def test(self) -> str:
        targets = self.machine.targets(11)
        return csv_of(targets, self.machine.measure(targets, seed=1))

    def put(self, top: Path) -> None:
        """Put the files there, and beside them what a stopped command left."""
        folder = top / self.folder
        (folder / "control").mkdir(parents=True)
        for name, text in self.control.items():
            (folder / "control" / name).write_text(text)
        (folder / "x.csv").write_text(self.test)
        (folder / "job.yaml").write_text(self.job("control"))
        files = {"notes.txt": b"half of them", "more.txt": b"half of them"}
        (folder / "notes.txt").write_text("all of them")
        (folder / "more.txt").write_text("all of them")
        shutil.copytree(folder, top / "tried")
        tried = Process()
        with running(tried):
            storage.write_files(Session(), top / "tried", files, force=True)
        shutil.rmtree(top / "tried")
        moved = max(at for at, name in enumerate(tried.made, 1) if name == "replace")
        with running(Process(moved)):
            storage.write_files(Session(), folder, files, force=True)


FANUC = Backup({1: Pitch(40, 30, 50.0, [1, 0, -2, 1, 2, 1, 0, -1, 1, 0, 1, 2, 0], 3)})
TASKS = (
    Task("first", "linuxcnc", {"a.ini": INI, "joint_0.comp": COMP}, Machine(), "0", 80),
    Task(
        "second",
        "fanuc-30i",
        {"CNC-PARA.TXT": FANUC.parameters(), "PITCH.TXT": FANUC.points()},
        Machine(high=600.0, lost=0.003),
        "1",
        50,
    ),
)


def short(task: Task) -> str:
    """Do two short commands: evaluate a test and try to overwrite it; read a control, and a job that
    is not on the disk yet, write both, and overwrite what only the first command has read.
    """
    folder, session = Path(task.folder), Session()
    evaluated = evaluate_files(session, [folder / "x.csv"])
    write_evaluation(session, evaluated.document, json_path=folder / "answer.json")
    try:
        storage.write_file(session, folder / "x.csv", b"other readings", force=True)
        refused = "not at all"
    except StorageError as error:
        refused = str(error)
    restored = session.restored

    session = Session()
    decoded = decoded_files(session, [folder / "control"], task.format_id, {})[2]
    below = {"job.yaml": task.job("../control").encode(), "x.csv": task.test.encode()}
    ahead = session.with_pending(folder / "next", below)
    job = read_job_file(ahead, folder / "next" / "job.yaml")
    control = open_control(ahead, job.format, job.options)
    read = read_job_inputs(ahead, job, control, folder / "next")
    new_job(session, [folder / "control"], task.format_id, {}, folder / "new.yaml")
    storage.write_files(session, folder / "next", below)
    storage.write_file(session, folder / "x.csv", b"other readings", force=True)
    readings = read.tests["X"][0].test.positive.tolist()
    return f"{to_json(decoded)} {refused} {readings} {restored}"


def whole(task: Task) -> str:
    """Do the whole job."""
    session, folder = Session(), Path(task.folder)
    job = read_job_file(session, folder / "job.yaml")
    out = folder / "out"
    outcome = write_planned(session, planned(session, job, folder, out), out)
    return f"{to_json(outcome.prediction)} {session.restored}"


class Turns:
    """Lets one thread go on at a time; after each call to the disk chance decides which."""

    def __init__(self, seed: int) -> None:
        self._chance = Random(seed)  # noqa: S311 - cases, no secrets
        self._staying = self._chance.choice((0.0, 0.8, 0.95))  # short turns, or long ones
        self._changed = Condition()
        self._threads: list[int] = []
        self._turn = 0
        self.switches = 0

    def enter(self, count: int) -> None:
        """Begin, as soon as all ``count`` threads have come."""
        with self._changed:
            self._threads.append(get_ident())
            self._changed.notify_all()
            self._changed.wait_for(lambda: len(self._threads) == count)
            self._turn = self._turn or self._threads[0]
        self.step()

    def step(self) -> None:
        """Let chance decide who goes on."""
        me = get_ident()
        with self._changed:
            if me in self._threads:
                self._pass_on(self._threads)
                self._changed.wait_for(lambda: self._turn == me)

    def leave(self) -> None:
        with self._changed:
            self._threads.remove(get_ident())
            self._pass_on(self._threads)

    def _pass_on(self, threads: list[int]) -> None:
        before = self._turn
        if self._turn not in threads or self._chance.random() >= self._staying:
            self._turn = self._chance.choice(threads) if threads else 0
        self.switches += before != self._turn
        self._changed.notify_all()

    def giving_way(self, real: Callable[..., Any]) -> Callable[..., Any]:
        def call(*arguments: Any, **words: Any) -> Any:
            try:
                return real(*arguments, **words)
            finally:
                self.step()

        return call


def together(work: Callable[[Task], str], seed: int) -> tuple[dict[str, str], int]:
    """Return what each task answers, and how often the turn went to the other thread."""
    turns, answers = Turns(seed), dict[str, str]()

    def worked(task: Task) -> None:
        turns.enter(len(TASKS))
        try:
            answers[task.folder] = work(task)
        except Exception as error:  # noqa: BLE001 - compared with what the task answers alone
            answers[task.folder] = repr(error)
        finally:
            turns.leave()

    threads = [Thread(target=worked, args=(task,)) for task in TASKS]
    with pytest.MonkeyPatch.context() as patch:
        for name in CALLS:
            patch.setattr(os, name, turns.giving_way(getattr(os, name)))
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    return answers, turns.switches


def left(top: Path) -> dict[str, bytes]:
    return {
        path.relative_to(top).as_posix(): path.read_bytes()
        for path in sorted(top.rglob("*"))
        if path.is_file()
    }


@contextmanager
def inside(folder: Path) -> Iterator[Path]:
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        yield folder


@pytest.fixture(scope="module")
def prepared(tmp_path_factory: pytest.TempPathFactory) -> Path:
    top = tmp_path_factory.mktemp("prepared") / "top"
    for task in TASKS:
        task.put(top)
    return top


@pytest.mark.parametrize(
    ("work", "count"), [(short, SHORT), (whole, WHOLE)], ids=["short", "whole"]
)
@pytest.mark.real_pages
def test_two_threads_do_what_each_does_alone(
    tmp_path: Path, prepared: Path, work: Callable[[Task], str], count: int
) -> None:
    with inside(shutil.copytree(prepared, tmp_path / "alone")) as top:
        alone = {task.folder: work(task) for task in TASKS}
        files = left(top)
    assert (
        all("is an input of this command" in answer for answer in alone.values()) or work is whole
    )
    for seed in range(count):
        with inside(shutil.copytree(prepared, tmp_path / str(seed))) as top:
            answers, switches = together(work, seed)
            assert switches > 5
            for name, answer in alone.items():
                assert answers[name] == answer.replace("/alone/", f"/{seed}/"), seed
            assert left(top) == files, seed
        shutil.rmtree(tmp_path / str(seed))


def test_one_thread_draws_at_a_time() -> None:
    """The plotting library keeps one style for the process; who leaves restores what he found."""
    matplotlib = pytest.importorskip("matplotlib")
    usual, entered, leave, seen = matplotlib.rcParams["font.size"], Event(), Event(), []

    def draw() -> None:
        with style():
            entered.set()
            leave.wait()
            seen.append(matplotlib.rcParams["font.size"])

    other = Thread(target=draw)
    with style():
        own = matplotlib.rcParams["font.size"]
        other.start()
        assert not entered.wait(0.1)
    leave.set()
    other.join()
    assert seen == [own] != [usual]
    assert matplotlib.rcParams["font.size"] == usual
