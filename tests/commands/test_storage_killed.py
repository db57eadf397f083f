"""A set of files goes from old to new as one: a process killed at any of its calls to the disk, or
a disk that refuses any of them, leaves one whole set to whoever reads next.
"""

from __future__ import annotations

import errno
import json
import os
import shutil
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from random import Random

import pytest

from compwright.cli import run as compwright
from compwright.foundations import storage
from compwright.foundations.errors import InputError, StorageError
from compwright.foundations.session import Session
from compwright.foundations.storage import disk, locking, recovery
from compwright.foundations.storage.locking import Lock, take
from dying import Disk, Process, running
from killing import calls_of, killed_at, needs_strace

UNFINISHED = ".compwright-unfinished"
OLD = {"set/x": b"old x", "set/y": b"old y", "record": b"old record", "set/gone": b"old gone"}
NEW = {"set/x": b"new x", "set/y": b"new y", "record": b"new record", "deep/er/z": b"new z"}
JSON = "beside/answer.json"
ANOTHER_FILE_SYSTEM = Path("/dev/shm")  # noqa: S108 - memory, on Linux


@pytest.fixture
def quick_path(tmp_path: Path) -> Iterator[Path]:
    """A folder for hundreds of small trees, in memory where there is such a thing."""
    if not ANOTHER_FILE_SYSTEM.is_dir():
        yield tmp_path
        return
    with tempfile.TemporaryDirectory(dir=ANOTHER_FILE_SYSTEM) as made:
        yield Path(made)


def make(top: Path) -> Path:
    """Make a result folder, a file beside it that belongs to it, and the notes of the user."""
    for name, content in {
        **{f"out/{name}": content for name, content in OLD.items()},
        JSON: b"old answer",
        "out/notes.txt": b"mine",
        "beside/notes.txt": b"mine too",
    }.items():
        (top / name).parent.mkdir(parents=True, exist_ok=True)
        (top / name).write_bytes(content)
    return top


def write(top: Path, session: Session | None = None) -> None:
    beside = {top / JSON: b"new answer"}
    storage.write_files(
        session or Session(), top / "out", NEW, force=True, elsewhere=beside, whole=["set"]
    )


def files(top: Path) -> dict[str, bytes]:
    """Return all files, hidden ones too."""
    return {
        path.relative_to(top).as_posix(): path.read_bytes()
        for path in sorted(top.rglob("*"))
        if path.is_file()
    }


def named(top: Path) -> dict[str, bytes]:
    """Return what somebody sees who knows nothing of compwright."""
    return {name: content for name, content in files(top).items() if UNFINISHED not in name}


def is_begun(top: Path) -> bool:
    return any(name.endswith("out/.compwright-unfinished/journal.json") for name in files(top))


def stopped(top: Path, at: int) -> Path:
    make(top)
    with running(Process(at)):
        write(top)
    return top


class Course:
    """How a whole write goes: what is there before and after, and its calls to the disk."""

    def __init__(self, top: Path) -> None:
        self.old = files(make(top))
        process = Process()
        with running(process):
            write(top)
        self.new = files(top)
        self.calls = process.made
        shutil.rmtree(top)
        #: the call with which the first file is moved, of those after the journals are there
        moves = [at for at, name in enumerate(self.calls, 1) if name == "replace"]
        self.first_move, self.last_move = moves[2], moves[-1]

    def is_unmixed(self, top: Path) -> bool:
        """Whether no new file lies beside an earlier one that it replaces."""
        seen = named(top).items()
        return seen <= self.old.items() or seen <= self.new.items()


@pytest.fixture(scope="module")
def course(tmp_path_factory: pytest.TempPathFactory) -> Course:
    return Course(tmp_path_factory.mktemp("course") / "top")


def test_the_course_is_what_was_asked_for(course: Course) -> None:
    assert {name.removeprefix("out/"): text for name, text in course.new.items()} == {
        **NEW,
        JSON: b"new answer",
        "notes.txt": b"mine",
        "beside/notes.txt": b"mine too",
    }
    assert len(course.calls) > 50
    assert {"write", "fsync", "replace", "unlink", "mkdir", "rmdir"} <= set(course.calls)


def test_killed_at_any_call_one_whole_set_is_left(quick_path: Path, course: Course) -> None:
    found = []
    for at in range(1, len(course.calls) + 1):
        top = stopped(quick_path / str(at), at)
        assert course.is_unmixed(top), at
        begun = is_begun(top)
        # whoever reads either folder
        session = Session()
        storage.read_bytes(session, top / (JSON if at % 2 else "out/notes.txt"))
        storage.read_bytes(session, top / ("out/notes.txt" if at % 2 else JSON))
        assert bool(session.restored) == begun
        assert files(top) in (course.old, course.new), (at, course.calls[at - 1])
        found.append(files(top) == course.new)
    assert found == sorted(found)  # old up to one moment, new from then on
    assert {True, False} == set(found)


def test_putting_right_may_be_killed_at_any_call(quick_path: Path, course: Course) -> None:
    whole = stopped(quick_path / "whole", course.last_move)
    for then in range(1, 99):
        top = quick_path / str(then)
        shutil.copytree(whole, top)
        process = Process(then)
        with running(process):
            storage.read_bytes(Session(), top / JSON)
        assert course.is_unmixed(top), then
        storage.read_bytes(Session(), top / JSON)
        storage.read_bytes(Session(), top / "out" / "notes.txt")
        assert files(top) == course.old, then
        if not process.dead:
            break
    assert then > 10


@pytest.mark.parametrize("work", ["writing", "putting right"])
def test_when_the_power_fails_one_whole_set_is_left(
    quick_path: Path, course: Course, work: str
) -> None:
    """Of what was not synced anything may have reached the disk, in any order."""
    begun = quick_path / "begun"
    if work == "writing":
        make(begun)
    else:
        stopped(begun, course.last_move + 1)
    shutil.copytree(begun, quick_path / "whole")
    drive, chance = Disk(quick_path / "whole"), Random(1)  # noqa: S311 - cases, no secrets
    with drive.watched():
        if work == "writing":
            write(quick_path / "whole")
        else:
            storage.read_bytes(Session(), quick_path / "whole" / JSON)
    for at in range(len(drive.steps) + 1):
        top = quick_path / str(at)
        shutil.copytree(begun, top)
        drive.fail(top, at, chance)
        storage.read_bytes(Session(), top / "out" / "notes.txt")
        storage.read_bytes(Session(), top / "beside" / "notes.txt")
        whole = (course.old, course.new) if work == "writing" else (course.old,)
        assert files(top) in whole, (at, drive.steps[at - 1])
    assert files(top) == whole[-1]


def refusal() -> OSError:
    return OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


@pytest.mark.parametrize(
    ("kind", "every"), [(refusal, 2), (KeyboardInterrupt, 3)], ids=["full disk", "Ctrl-C"]
)
def test_an_error_at_any_call_leaves_one_whole_set(
    quick_path: Path, course: Course, kind: Callable[[], BaseException], every: int
) -> None:
    """As before, until the journal is gone; what is left to be cleared away then fails nothing."""
    raised = 0
    for at in range(1, len(course.calls) + 1, every):
        top, error = make(quick_path / str(at)), kind()
        try:
            with running(Process(at, refused=error)):
                write(top)
        except (StorageError, KeyboardInterrupt) as stopped_by:
            raised += 1
            if isinstance(error, OSError):
                assert os.strerror(errno.ENOSPC) in str(stopped_by)  # noqa: PT017 - not all raise
                assert named(top) == course.old, at
            assert named(top) in (course.old, course.new), at
        else:
            assert named(top) == course.new, at
        storage.read_bytes(Session(), top / "out" / "notes.txt")
        storage.read_bytes(Session(), top / JSON)
        assert files(top) in (course.old, course.new), at
    assert raised > 15


READERS: dict[str, Callable[[Session, Path], object]] = {
    "read_bytes": lambda session, out: storage.read_bytes(session, out / "set" / "x"),
    "earlier_bytes": lambda session, out: storage.earlier_bytes(session, out / "record"),
    "list_files": lambda session, out: storage.list_files(session, out / "set"),
    "in_folders_of": lambda session, out: storage.in_folders_of(session, out.parent, "record"),
    "folders_holding": lambda session, out: storage.folders_holding(
        session, out.parent, ["record"]
    ),
    "is_there": lambda session, out: storage.is_there(session, out / "set" / "x"),
    "state_of": lambda session, out: storage.state_of(session, [out / "record"]),
    "matching": lambda session, out: storage.matching(session, str(out / "set" / "*")),
    "write_files": lambda session, out: storage.write_files(session, out, {"other": b"new"}),
}


@pytest.mark.parametrize("reader", READERS)
def test_whoever_reads_next_finds_the_earlier_files(
    tmp_path: Path, course: Course, reader: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    top = stopped(tmp_path / "top", course.last_move)
    assert named(top) != course.old
    monkeypatch.chdir(tmp_path)  # by a name that is not from the root
    session = Session()
    told = READERS[reader](session, Path("top/out"))
    (top / "out" / "other").unlink(missing_ok=True)
    assert files(top) == course.old
    assert told == READERS[reader](session, Path("top/out"))
    assert session.restored == [str(top / "out")]


def test_the_command_says_so_once(
    tmp_path: Path, course: Course, capsys: pytest.CaptureFixture[str]
) -> None:
    top = stopped(tmp_path / "top", course.last_move)
    compwright(["evaluate", str(top / "out" / "set")])
    compwright(["evaluate", str(top / "out" / "set")])
    said = [line for line in capsys.readouterr().err.splitlines() if "was stopped" in line]
    (line,) = said
    assert line.startswith(f"{top / 'out'}: a command that was stopped had begun to write here;")


def test_through_a_link_too(tmp_path: Path, course: Course) -> None:
    top = stopped(tmp_path / "top", course.last_move)
    (tmp_path / "link").symlink_to(top / "out" / "set")
    assert storage.read_bytes(Session(), tmp_path / "link" / "x") == b"old x"
    assert files(top) == course.old


def test_a_folder_that_was_moved_is_put_right_where_it_is(tmp_path: Path, course: Course) -> None:
    top = stopped(tmp_path / "top", course.last_move)
    top.rename(tmp_path / "elsewhere")
    assert storage.read_bytes(Session(), tmp_path / "elsewhere" / JSON) == b"old answer"
    assert files(tmp_path / "elsewhere") == course.old


def test_a_copy_of_the_folder_alone_is_put_right_and_the_rest_stays(
    tmp_path: Path, course: Course
) -> None:
    top = stopped(tmp_path / "top", course.last_move)
    shutil.copytree(top / "out", top / "copy")
    beside = named(top / "beside")
    assert storage.read_bytes(Session(), top / "copy" / "set" / "x") == b"old x"
    assert named(top / "beside") == beside
    shutil.rmtree(top / "copy")
    assert storage.read_bytes(Session(), top / JSON) == b"old answer"
    assert files(top) == course.old


COPIED_IN_PART = {
    "one file less": lambda kept: kept.unlink(),
    "half of one": lambda kept: kept.write_bytes(kept.read_bytes()[:-3]),
}


@pytest.mark.parametrize("damage", COPIED_IN_PART)
@pytest.mark.parametrize("when", ["before the new files stand there", "after"])
def test_a_folder_that_was_copied_in_part_is_not_said_to_be_as_before(
    tmp_path: Path, course: Course, when: str, damage: str
) -> None:
    """As a program leaves it that synchronises folders file by file, or a stick pulled too early:
    of the files that were moved away not all have come whole.
    """
    top = stopped(
        tmp_path / "top", course.last_move + 1 if when == "after" else course.first_move + 5
    )
    kept = next(
        path
        for path in sorted((top / "out" / UNFINISHED).glob("*.old"))
        if path.read_bytes() == b"old y"
    )
    whole = kept.read_bytes()
    COPIED_IN_PART[damage](kept)
    before = files(top)
    for _ in range(2):  # nothing is forgotten
        session = Session()
        with pytest.raises(InputError, match=r"set/y: .* the moved file is (missing|damaged)"):
            storage.read_bytes(session, top / "out" / "record")
        with pytest.raises(StorageError, match=r"set/y: .* the moved file is"):
            write(top, session)
        assert session.restored == []
        assert files(top) == before
    kept.write_bytes(whole)  # the rest has come
    assert storage.read_bytes(Session(), top / "out" / "record") == b"old record"
    assert files(top) == course.old


def test_a_folder_whose_journal_has_not_come_yet_keeps_its_files(
    tmp_path: Path, course: Course
) -> None:
    """Programs that synchronise go by the name: ``0.old`` comes before ``journal.json``."""
    top = stopped(tmp_path / "top", course.last_move - 1)
    journal = top / "out" / UNFINISHED / "journal.json"
    journal.rename(tmp_path / "not yet")
    before = files(top)
    with pytest.raises(InputError, match="its journal is missing"):
        storage.read_bytes(Session(), top / "out" / "record")
    with pytest.raises(StorageError, match="its journal is missing"):
        write(top)
    assert files(top) == before
    (tmp_path / "not yet").rename(journal)
    assert storage.read_bytes(Session(), top / "out" / "record") == b"old record"
    assert files(top) == course.old


def test_a_copy_of_the_folder_beside_alone_is_put_right_by_itself(
    tmp_path: Path, course: Course
) -> None:
    top = stopped(tmp_path / "top", course.last_move + 1)
    shutil.copytree(top / "beside", top / "copy")
    assert storage.read_bytes(Session(), top / "copy" / "answer.json") == b"old answer"
    shutil.rmtree(top / "copy")
    assert files(top) == course.old


@pytest.mark.parametrize("reader", ["out/notes.txt", JSON])
def test_what_another_write_left_is_not_taken_back_with_it(
    tmp_path: Path, course: Course, reader: str
) -> None:
    """As folders that come from backups of two days: beside, a write is done and only not cleared
    away; the folder that decided over it holds what a later one had begun, with the same names.
    """
    begun = stopped(tmp_path / "begun", course.last_move)
    for at in range(course.last_move + 1, len(course.calls) + 1):
        top = stopped(tmp_path / str(at), at)
        if not is_begun(top):
            break
    left = {path.name for path in (top / "beside" / UNFINISHED).iterdir()}
    assert {"journal.json", "0.old"} <= left
    shutil.rmtree(top / "out")
    shutil.copytree(begun / "out", top / "out")
    session = Session()
    storage.read_bytes(session, top / reader)
    assert session.restored == ([str(top / "out")] if reader.startswith("out") else [])
    assert storage.read_bytes(Session(), top / JSON) == b"new answer"
    assert storage.read_bytes(Session(), top / "out" / "set" / "x") == b"old x"
    assert files(top) == {**course.old, JSON: b"new answer"}


def test_a_process_that_is_stopped_while_one_waits_for_it(
    tmp_path: Path, course: Course, monkeypatch: pytest.MonkeyPatch
) -> None:
    """When it was looked at it had not begun to move files; then it had, and was stopped."""
    top = stopped(tmp_path / "top", course.last_move)
    journal = top / "out" / UNFINISHED / "journal.json"
    journal.rename(journal.with_name("later"))

    def later(staging: Path, *, patience: float) -> Lock:
        if not journal.exists():
            journal.with_name("later").rename(journal)
        return take(staging, patience=patience)

    monkeypatch.setattr(recovery, "take", later)
    assert storage.read_bytes(Session(), top / JSON) == b"old answer"
    assert files(top) == course.old


def test_where_the_folder_that_decides_is_gone_its_file_is_refused_and_others_are_read(
    tmp_path: Path, course: Course
) -> None:
    top = stopped(tmp_path / "top", course.last_move + 1)
    shutil.rmtree(top / "out")
    assert storage.read_bytes(Session(), top / "beside" / "notes.txt") == b"mine too"
    with pytest.raises(InputError, match="list of its files is missing"):
        storage.read_bytes(Session(), top / JSON)
    with pytest.raises(StorageError, match="a stopped command left"):
        storage.write_file(Session(), top / JSON, b"", force=True)
    shutil.rmtree(top / "beside" / UNFINISHED)  # as the message says
    assert storage.read_bytes(Session(), top / JSON) == b"new answer"


def test_what_the_user_changed_meanwhile_is_refused_by_name_and_stays(
    tmp_path: Path, course: Course
) -> None:
    top = stopped(tmp_path / "top", course.last_move + 1)
    (top / "out" / "set" / "x").write_bytes(b"mine")
    before = files(top)
    with pytest.raises(InputError) as caught:
        storage.read_bytes(Session(), top / "out" / "record")
    assert f"{top / 'out' / 'set' / 'x'}: the file was changed after" in str(caught.value)
    assert storage.read_bytes(Session(), top / "out" / "notes.txt") == b"mine"
    assert files(top) == before
    (top / "out" / "set" / "x").rename(top / "out" / "my-x")
    assert storage.read_bytes(Session(), top / "out" / "set" / "x") == b"old x"
    assert files(top) == {**course.old, "out/my-x": b"mine"}


def test_what_cannot_be_put_right_is_refused_by_name(
    tmp_path: Path, course: Course, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As on a medium that is read-only: nobody can write there, neither lock nor file."""
    top = stopped(tmp_path / "top", course.last_move)
    real = os.open

    def read_only(path: str, flags: int, mode: int = 0o777) -> int:
        if flags & (os.O_CREAT | os.O_WRONLY | os.O_RDWR):
            raise OSError(errno.EROFS, os.strerror(errno.EROFS))
        return real(path, flags, mode)

    with monkeypatch.context() as patch:
        patch.setattr(os, "open", read_only)
        session = Session()
        for name in ("out/set/x", "out/deep/er/z", JSON):
            with pytest.raises(InputError) as caught:
                storage.read_bytes(session, top / name)
            assert str(top / name) in str(caught.value)
            assert os.strerror(errno.EROFS) in str(caught.value)
        with pytest.raises(InputError):
            storage.list_files(session, top / "out" / "set")
        assert storage.folders_holding(session, top, ["notes.txt"])[1]
        assert storage.read_bytes(session, top / "out" / "notes.txt") == b"mine"
    assert storage.read_bytes(Session(), top / "out" / "set" / "x") == b"old x"


def test_what_was_only_prepared_is_in_nobody_s_way_on_a_read_only_medium(
    tmp_path: Path, course: Course, monkeypatch: pytest.MonkeyPatch
) -> None:
    top = stopped(tmp_path / "top", 20)
    monkeypatch.setattr(os, "unlink", Process(1, refused=refusal()).standing_for("unlink"))
    assert storage.read_bytes(Session(), top / "out" / "set" / "x") == b"old x"
    assert named(top) == course.old


DAMAGE: dict[str, Callable[[dict[str, object]], object]] = {
    "no JSON": lambda _data: "cut",
    "no journal": lambda _data: [],
    "another version": lambda data: {**data, "form": "compwright/unfinished/2"},
    "a bit": lambda data: {**data, "key": "0"},
    "another file": lambda data: {**data, "files": [["record", False, "0", ""]]},
}


@pytest.mark.parametrize("damage", DAMAGE)
def test_a_damaged_journal_is_not_followed(tmp_path: Path, course: Course, damage: str) -> None:
    top = stopped(tmp_path / "top", course.last_move)
    journal = top / "out" / UNFINISHED / "journal.json"
    journal.write_text(json.dumps(DAMAGE[damage](json.loads(journal.read_text()))))
    before = files(top)
    with pytest.raises(InputError, match="journal"):
        storage.read_bytes(Session(), top / "out" / "record")
    with pytest.raises(StorageError, match="journal"):
        write(top)
    assert files(top) == before


OUTSIDE = ["../victim", "set/../../victim", "/etc/victim", "link/victim", f"{UNFINISHED}/0.old", ""]


@pytest.mark.parametrize("name", OUTSIDE)
def test_a_journal_that_names_files_outside_of_its_folder_is_not_followed(
    tmp_path: Path, name: str
) -> None:
    """As one that somebody made and sent."""
    from compwright.foundations.storage.journal import Journal, JournalEntry, digest_of, put_journal

    folder, victim = tmp_path / "sent", tmp_path / "victim"
    (folder / UNFINISHED).mkdir(parents=True)
    (folder / "link").symlink_to(tmp_path)
    victim.write_bytes(b"mine")
    entry = JournalEntry(name=name, there=False, digest=digest_of(b"mine"))
    put_journal(folder, Journal(key="1", entries=(entry,), parts=("..",)))
    (folder / "plan").write_bytes(b"plan")
    with pytest.raises(InputError, match="names a file outside"):
        storage.read_bytes(Session(), folder / "plan")
    assert victim.read_bytes() == b"mine"
    assert storage.read_bytes(Session(), victim) == b"mine"


def test_a_link_in_place_of_the_folder_is_not_followed(tmp_path: Path, course: Course) -> None:
    top = stopped(tmp_path / "top", course.last_move)
    (top / "other").mkdir()
    (top / "other" / UNFINISHED).symlink_to(top / "out" / UNFINISHED)
    (top / "other" / "x").write_bytes(b"x")
    before = files(top)
    with pytest.raises(InputError, match="is not a folder"):
        storage.read_bytes(Session(), top / "other" / "x")
    assert files(top) == before


def test_a_living_process_is_waited_for(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "x").write_bytes(b"old")
    lock = take(tmp_path / UNFINISHED, make=True)
    monkeypatch.setattr(locking, "sleep", lambda _seconds: lock.remove())  # it finishes meanwhile
    storage.write_file(Session(), tmp_path / "x", b"new", force=True)
    assert files(tmp_path) == {"x": b"new"}


def test_a_lock_that_its_owner_has_just_removed_is_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It was opened before, and would keep nobody out who comes later."""
    owner = take(tmp_path / UNFINISHED, make=True)
    real = locking._is_locked

    def later(handle: int) -> bool:
        owner.release() if os.name == "nt" else owner.remove()
        monkeypatch.setattr(locking, "_is_locked", real)
        return real(handle)

    monkeypatch.setattr(locking, "_is_locked", later)
    lock = take(tmp_path / UNFINISHED, make=True)
    assert os.path.samestat(os.fstat(lock.handle), (tmp_path / UNFINISHED / "lock").stat())
    lock.remove()


def test_a_living_process_that_does_not_end_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    lock = take(tmp_path / UNFINISHED, make=True)
    clock = iter(range(0, 1000, 6))
    monkeypatch.setattr(locking, "monotonic", lambda: next(clock))
    monkeypatch.setattr(locking, "sleep", lambda _seconds: None)
    with pytest.raises(StorageError, match="another command is writing there"):
        storage.write_file(Session(), tmp_path / "x", b"new")
    assert storage.list_files(Session(), tmp_path) == []  # what it only prepares hinders no reader
    lock.remove()
    storage.write_file(Session(), tmp_path / "x", b"new")


def test_two_commands_may_put_right_at_once(
    tmp_path: Path, course: Course, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The one that comes second finds it done."""
    top = stopped(tmp_path / "top", course.last_move)

    def second(staging: Path, *, patience: float) -> Lock:
        monkeypatch.setattr(recovery, "take", take)
        storage.read_bytes(Session(), top / "out" / "notes.txt")  # by the first one
        return take(staging, patience=patience)

    monkeypatch.setattr(recovery, "take", second)
    assert storage.read_bytes(Session(), top / "out" / "set" / "x") == b"old x"
    assert files(top) == course.old


def test_a_file_that_appears_in_the_last_moment_is_not_overwritten(tmp_path: Path) -> None:
    (tmp_path / "x").write_bytes(b"old")

    def changing(_name: str, _content: bytes) -> bool:
        (tmp_path / "x").write_bytes(b"of another program")
        return True

    with pytest.raises(StorageError, match="changed the file at this moment"):
        storage.write_files(
            Session(), tmp_path, {"x": b"new", "y": b"new"}, force=True, known=changing
        )
    assert files(tmp_path) == {"x": b"of another program"}


def test_links_stay_links(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A link that is replaced is put back as one; a folder that is a link is written through."""
    (tmp_path / "far").mkdir()
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "set").symlink_to("../far")
    (tmp_path / "far" / "x").write_bytes(b"old")
    (tmp_path / "far" / "w").write_bytes(b"old")
    (tmp_path / "out" / "y").symlink_to("set/w")
    new = {"set/x": b"new", "y": b"new too", "z": b"new"}
    with monkeypatch.context() as patch:
        patch.setattr(os, "replace", Process(7, refused=refusal()).standing_for("replace"))
        with pytest.raises(StorageError):
            storage.write_files(Session(), tmp_path / "out", new, force=True)
    assert (tmp_path / "out" / "y").readlink() == Path("set/w")
    assert files(tmp_path) == {"far/w": b"old", "far/x": b"old", "out/y": b"old"}
    storage.write_files(Session(), tmp_path / "out", new, force=True)
    assert (tmp_path / "out" / "set").is_symlink()
    assert files(tmp_path) == {
        "far/w": b"old",
        "far/x": b"new",
        "out/y": b"new too",
        "out/z": b"new",
    }


@pytest.mark.skipif(not ANOTHER_FILE_SYSTEM.is_dir(), reason="no other file system here")
def test_folders_on_another_file_system(tmp_path: Path, course: Course) -> None:
    """Nothing can be renamed from one to the other: what goes there waits there."""
    if ANOTHER_FILE_SYSTEM.stat().st_dev == tmp_path.stat().st_dev:
        pytest.skip("the same file system")
    with tempfile.TemporaryDirectory(dir=ANOTHER_FILE_SYSTEM) as far:
        for at in (0, course.first_move + 1, course.last_move - 1, course.last_move + 2):
            top = make(tmp_path / str(at))
            shutil.rmtree(far)
            (top / "out" / "set" / "gone").unlink()  # nothing is removed behind a link
            (top / "out" / "set").rename(top / "set")
            shutil.copytree(top / "set", far)
            (top / "out" / "set").symlink_to(far)
            with running(Process(at)):
                write(top)
            assert storage.read_bytes(Session(), top / "out" / "set" / "x") == (
                b"old x" if at else b"new x"
            )
            assert storage.read_bytes(Session(), top / JSON) == (
                b"old answer" if at else b"new answer"
            )
            assert {path.name for path in Path(far).iterdir()} == {"x", "y"}
            assert (top / "out" / "record").read_bytes() == (b"old record" if at else b"new record")
            assert not list(top.rglob(UNFINISHED))


def test_as_on_windows(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, course: Course) -> None:
    """No folder can be opened, no open file removed, and a scanner holds each new file for a
    moment.
    """
    opened: dict[int, str] = {}
    real = {name: getattr(os, name) for name in ("open", "close", "unlink", "replace")}
    scanned: set[str] = set()

    def open_(path: str, flags: int, mode: int = 0o777) -> int:
        handle: int = real["open"](path, flags, mode)
        opened[handle] = str(path)
        return handle

    def close(handle: int) -> None:
        opened.pop(handle, None)
        real["close"](handle)

    def unlink(path: str) -> None:
        if str(path) in opened.values():
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
        real["unlink"](path)

    def replace(source: str, target: str) -> None:
        if str(source) not in scanned:
            scanned.add(str(source))
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
        real["replace"](source, target)

    top = make(tmp_path)
    monkeypatch.delattr(os, "O_DIRECTORY")
    monkeypatch.setattr(disk, "_WINDOWS", True)
    monkeypatch.setattr(disk, "sleep", lambda _seconds: None)
    for name, double in (("open", open_), ("close", close), ("unlink", unlink)):
        monkeypatch.setattr(os, name, double)
    monkeypatch.setattr(os, "replace", replace)
    write(top)
    assert files(top) == course.new
    assert opened == {}


def test_where_the_file_system_has_no_locks(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, course: Course
) -> None:
    fcntl = pytest.importorskip("fcntl")

    def without(_handle: int, _what: int) -> None:
        raise OSError(errno.ENOLCK, os.strerror(errno.ENOLCK))

    monkeypatch.setattr(fcntl, "flock", without)
    write(make(tmp_path))
    assert files(tmp_path) == course.new


def test_a_single_file_is_one_rename(tmp_path: Path) -> None:
    storage.write_file(Session(), tmp_path / "x", b"old")
    process = Process()
    with running(process):
        storage.write_file(Session(), tmp_path / "x", b"new", force=True)
    assert process.made.count("replace") == 1
    for at in range(1, len(process.made) + 1):
        folder = tmp_path / str(at)
        folder.mkdir()
        (folder / "x").write_bytes(b"old")
        with running(Process(at)):
            storage.write_file(Session(), folder / "x", b"new", force=True)
        assert storage.read_bytes(Session(), folder / "x") in (b"old", b"new")
        assert list(files(folder)) == ["x"]
        assert [path.name for path in folder.iterdir()] == ["x"]


def test_looking_costs_a_folder_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    storage.write_files(Session(), tmp_path, {f"{number}.csv": b"" for number in range(50)})
    calls: list[Path] = []
    session = Session()

    def looked(path: Path) -> bool:
        calls.append(path)
        return False

    monkeypatch.setattr(os.path, "lexists", looked)
    for path in storage.list_files(session, tmp_path):
        storage.read_bytes(session, path)
    assert len(calls) == len(set(calls)) == len(tmp_path.parents) + 1


PROGRAM = """
import sys
from pathlib import Path
from compwright.foundations import storage
from compwright.foundations.session import Session
top = Path(sys.argv[1])
new = {"x": b"new x", "set/y": b"new y"}
storage.write_files(Session(), top / "out", new, force=True, elsewhere={top / "answer": b"new"})
"""


@needs_strace
def test_killed_by_the_kernel(tmp_path: Path) -> None:
    """Nothing of Python is left to undo anything. All calls: ``benchmarks/kill_run.py``."""
    old = {"out/x": b"old x", "out/set/y": b"old y", "answer": b"old", "out/notes": b"mine"}
    new = {"out/x": b"new x", "out/set/y": b"new y", "answer": b"new", "out/notes": b"mine"}

    def make_old(name: str) -> Path:
        for file, content in old.items():
            (tmp_path / name / file).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / name / file).write_bytes(content)
        return tmp_path / name

    command = (sys.executable, "-c", PROGRAM)
    log = tmp_path / "log"
    calls = calls_of([*command, str(make_old("whole"))], log)
    assert files(tmp_path / "whole") == new
    renames = [call for call in calls if call.name.startswith("rename")]
    removal = next(call for call in calls if call.name.startswith("unlink"))  # of the journal
    for number, call in enumerate((*renames[1:8:3], removal)):
        top = make_old(str(number))
        killed_at(call, [*command, str(top)], log)
        assert is_begun(top) == (number > 0)
        storage.read_bytes(Session(), top / "out" / "notes")
        storage.read_bytes(Session(), top / "answer")
        assert files(top) == old
