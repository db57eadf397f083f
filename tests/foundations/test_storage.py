"""Files appear whole or not at all; what cannot be written is said with file and reason (exit
5).
"""

from __future__ import annotations

import errno
import os
from collections.abc import Callable
from pathlib import Path

import pytest

from compwright.foundations import storage
from compwright.foundations.errors import InputError, StorageError
from compwright.foundations.input_sizes import ANY, CONTROL, JSON, MEASUREMENT, PROFILE, InputKind
from compwright.foundations.session import Session
from next_steps import without_hint


def tree(folder: Path) -> dict[str, bytes | None]:
    """Return everything below ``folder``, hidden files included: name -> bytes, None for a
    folder.
    """
    return {
        path.relative_to(folder).as_posix(): path.read_bytes() if path.is_file() else None
        for path in sorted(folder.rglob("*"))
    }


def faults_of(action: Callable[[], object]) -> list[str]:
    with pytest.raises(StorageError) as caught:
        action()
    assert caught.value.exit_code == 5
    return [str(fault) for fault in caught.value.faults]


def test_files_are_written_below_the_folder_in_the_order_given(tmp_path: Path) -> None:
    paths = storage.write_files(
        Session(), tmp_path / "a" / "b", {"t/two.txt": b"2", "one.txt": b"1\r\n\0"}
    )
    assert paths == [tmp_path / "a" / "b" / "t" / "two.txt", tmp_path / "a" / "b" / "one.txt"]
    assert tree(tmp_path) == {
        "a": None,
        "a/b": None,
        "a/b/one.txt": b"1\r\n\0",
        "a/b/t": None,
        "a/b/t/two.txt": b"2",
    }


def test_no_files_make_no_folder(tmp_path: Path) -> None:
    assert storage.write_files(Session(), tmp_path / "new", {}) == []
    assert tree(tmp_path) == {}


def test_every_existing_file_is_named_and_nothing_is_touched(tmp_path: Path) -> None:
    storage.write_files(Session(), tmp_path, {"x": b"old x", "y": b"old y"})
    before = tree(tmp_path)
    (fault,) = faults_of(
        lambda: storage.write_files(Session(), tmp_path, {"x": b"n", "new": b"n", "y": b"n"})
    )
    assert (
        without_hint(fault)
        == f"{tmp_path}: 2 of the files to write exist already in this folder; found x, y"
    )
    assert tree(tmp_path) == before


def test_force_replaces_and_keeps_the_rights_of_the_file(tmp_path: Path) -> None:
    target = storage.write_file(Session(), tmp_path / "x", b"old")
    target.chmod(0o640)
    assert storage.write_file(Session(), target, b"new", force=True) == target
    assert tree(tmp_path) == {"x": b"new"}
    assert target.stat().st_mode & 0o777 == 0o640


def test_new_files_have_the_rights_that_the_user_asked_for(tmp_path: Path) -> None:
    """As any program's file under that mask: 0666 without the bits of the mask, not the 0600 of a
    temporary file.
    """
    previous = os.umask(0o027)
    try:
        assert storage.write_file(Session(), tmp_path / "x", b"").stat().st_mode & 0o777 == 0o640
    finally:
        os.umask(previous)


@pytest.mark.parametrize("force", [False, True])
def test_folder_in_the_place_of_a_file(tmp_path: Path, force: bool) -> None:
    (tmp_path / "x").mkdir()
    (fault,) = faults_of(
        lambda: storage.write_files(Session(), tmp_path, {"y": b"", "x": b""}, force=force)
    )
    assert fault.startswith(f"{tmp_path / 'x'}: this is a folder")
    assert tree(tmp_path) == {"x": None}


def test_file_in_the_place_of_a_folder(tmp_path: Path) -> None:
    storage.write_file(Session(), tmp_path / "x", b"file")
    (fault,) = faults_of(lambda: storage.write_files(Session(), tmp_path, {"ok": b"", "x/y": b""}))
    assert fault.startswith(f"{tmp_path / 'x'}: this is not a folder")
    assert tree(tmp_path) == {"x": b"file"}


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes in the file system here")
def test_pipes_and_devices_are_never_replaced(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    (fault,) = faults_of(lambda: storage.write_file(Session(), tmp_path / "pipe", b"x", force=True))
    assert "not an ordinary file" in fault
    assert (tmp_path / "pipe").is_fifo()


def test_link_to_nowhere_counts_as_existing(tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to(tmp_path / "nowhere")
    (fault,) = faults_of(lambda: storage.write_file(Session(), tmp_path / "link", b"x"))
    assert "exists already" in fault


@pytest.mark.parametrize("name", ["../x", "a/../../x", "/x", "", "."])
def test_names_cannot_lead_out_of_the_folder(tmp_path: Path, name: str) -> None:
    inner = tmp_path / "inner"
    (fault,) = faults_of(
        lambda: storage.write_files(Session(), inner, {"ok": b"", name: b"x"}, force=True)
    )
    assert "is outside of the folder" in fault
    assert tree(tmp_path) == {}


def test_names_that_no_file_can_have(tmp_path: Path) -> None:
    (fault,) = faults_of(lambda: storage.write_files(Session(), tmp_path, {"a\0b": b"x"}))
    assert "cannot be written" in fault
    (fault,) = faults_of(
        lambda: storage.write_files(Session(), tmp_path / "new", {"n" * 300: b"x"})
    )
    assert os.strerror(errno.ENAMETOOLONG) in fault
    assert tree(tmp_path) == {}


def test_longest_name_of_the_file_system_can_be_written(tmp_path: Path) -> None:
    longest = (
        "n" * 255
    )  # NAME_MAX of ext4, NTFS and APFS; the staged file beside it must not be longer
    storage.write_file(Session(), tmp_path / longest, b"x")
    assert tree(tmp_path) == {longest: b"x"}


def failing(after: int, number: int, real: Callable[..., object]) -> Callable[..., object]:
    """Return ``real`` that raises OSError ``number`` from its call ``after`` on."""
    calls = 0

    def function(*arguments: object, **words: object) -> object:
        nonlocal calls
        calls += 1
        if calls > after:
            raise OSError(number, os.strerror(number))
        return real(*arguments, **words)

    return function


@pytest.mark.parametrize("after", [0, 1, 2])
def test_full_disk_leaves_nothing_behind(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, after: int
) -> None:
    monkeypatch.setattr(os, "fsync", failing(after, errno.ENOSPC, os.fsync))
    files = {"a/b/one": b"1", "a/c/two": b"2", "three": b"3"}
    (fault,) = faults_of(lambda: storage.write_files(Session(), tmp_path / "new" / "out", files))
    assert fault.startswith(str(tmp_path / "new" / "out" / list(files)[after]))
    assert os.strerror(errno.ENOSPC) in fault
    assert tree(tmp_path) == {}


@pytest.mark.parametrize("after", [0, 1, 2])
def test_full_disk_for_folders_leaves_nothing_behind(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, after: int
) -> None:
    monkeypatch.setattr(Path, "mkdir", failing(after, errno.ENOSPC, Path.mkdir))
    faults_of(lambda: storage.write_files(Session(), tmp_path, {"a/b/c/one": b"1"}))
    assert tree(tmp_path) == {}


@pytest.mark.parametrize("after", [0, 1, 2])
def test_failure_while_putting_in_place_restores_what_was_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, after: int
) -> None:
    """As on Windows, where a file that another program holds open cannot be replaced."""
    storage.write_files(Session(), tmp_path, {"x": b"old x", "z": b"old z"})
    before = tree(tmp_path)
    real = Path.replace
    calls = 0

    def replace(self: Path, target: Path) -> Path:
        nonlocal calls
        calls += 1
        if calls == after + 1:
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
        return real(self, target)

    monkeypatch.setattr(Path, "replace", replace)
    (fault,) = faults_of(
        lambda: storage.write_files(
            Session(), tmp_path, {"x": b"new", "sub/y": b"new", "z": b"new"}, force=True
        )
    )
    assert os.strerror(errno.EACCES) in fault
    assert calls > after
    assert tree(tmp_path) == before


def test_interruption_leaves_nothing_behind(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(_handle: int) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "fsync", interrupted)
    with pytest.raises(KeyboardInterrupt):
        storage.write_files(Session(), tmp_path, {"a/x": b"1"})
    assert tree(tmp_path) == {}


def test_target_never_holds_a_part_of_the_content(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Until the new content is safe on disk, the name holds the whole old content."""
    target = storage.write_file(Session(), tmp_path / "x", b"old")
    seen: list[bytes] = []
    real = os.fsync

    def watching(handle: int) -> None:
        seen.append(target.read_bytes())
        real(handle)

    monkeypatch.setattr(os, "fsync", watching)
    storage.write_file(Session(), target, b"new", force=True)
    assert seen == [b"old", b"new"]  # once for the content, once for the name
    assert target.read_bytes() == b"new"


@pytest.mark.skipif(
    not Path("/proc/self").is_dir(),
    reason="needs a file system that refuses new files, such as /proc",
)
def test_no_permission() -> None:
    """/proc refuses new files even to root."""
    (fault,) = faults_of(lambda: storage.write_file(Session(), Path("/proc/compwright.txt"), b"x"))
    assert fault.startswith("/proc/compwright.txt: the file cannot be written; found ")


def test_reading_says_why_not(tmp_path: Path) -> None:
    for path, reason in (
        (tmp_path / "missing", "does not exist"),
        (tmp_path, "a folder"),
        (tmp_path / "a\0b", "null byte"),
    ):
        with pytest.raises(InputError) as caught:
            storage.read_bytes(Session(), path)
        assert caught.value.exit_code == 3
        assert reason in str(caught.value)
        assert caught.value.faults[0].file == str(path)


@pytest.mark.skipif(not Path("/dev/zero").exists(), reason="no endless device here")
def test_endless_file_is_refused() -> None:
    with pytest.raises(InputError, match="expected a file, found a device"):
        storage.read_bytes(Session(), Path("/dev/zero"))


@pytest.mark.parametrize(
    "kind", [MEASUREMENT, CONTROL, PROFILE, JSON, ANY], ids=lambda one: one.name
)
def test_a_file_larger_than_its_kind_is_refused_before_it_is_read(
    kind: InputKind, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Sizes are told in words, and nothing is opened."""
    large = tmp_path / "large"
    with large.open("wb") as stream:
        stream.truncate(kind.most_bytes + 100_000_000)  # a hole: takes no room on the disk
    monkeypatch.setattr(os, "open", None)
    with pytest.raises(InputError) as caught:
        storage.read_bytes(Session(), large, kind)
    assert without_hint(str(caught.value)) == (
        f"{large}: the file is too large; expected {kind.name} of at most {kind.most_bytes // 1_000_000} MB,"
        f" found {kind.most_bytes // 1_000_000 + 100} MB"
    )


@pytest.mark.skipif(not Path("/proc/self/maps").exists(), reason="no file without a size here")
def test_a_file_that_does_not_tell_its_size_is_read_so_far_and_refused() -> None:
    assert Path("/proc/self/maps").stat().st_size == 0
    with pytest.raises(InputError, match="a map of at most 10 bytes, found more than 10 bytes"):
        storage.read_bytes(Session(), Path("/proc/self/maps"), InputKind("a map", 10))


def test_folder_lists_its_files_by_name_without_hidden_ones(tmp_path: Path) -> None:
    storage.write_files(
        Session(),
        tmp_path,
        {"b.csv": b"", "a.csv": b"", ".hidden": b"", "sub/c.csv": b"", "[x]*.csv": b""},
    )
    assert storage.list_files(Session(), tmp_path) == [
        tmp_path / name for name in ("[x]*.csv", "a.csv", "b.csv")
    ]
    assert storage.list_files(Session(), tmp_path / "a.csv") == [tmp_path / "a.csv"]
    assert storage.list_files(Session(), tmp_path / "missing") == [tmp_path / "missing"]


def test_definitions_come_in_the_order_of_their_names() -> None:
    names = [name for name, _ in storage.definition_files(Session())]
    assert names == sorted(names)
    assert all(name.endswith(".yaml") for name in names)


def test_looking_never_fails(tmp_path: Path) -> None:
    storage.write_file(Session(), tmp_path / "x", b"")
    (tmp_path / "link").symlink_to(tmp_path / "nowhere")
    there = {
        name: storage.is_there(Session(), tmp_path / name)
        for name in (".", "x", "link", "y", "n" * 300, "a\0b", "x/y")
    }
    assert there == {
        ".": True,
        "x": True,
        "link": True,
        "y": False,
        "n" * 300: False,
        "a\0b": False,
        "x/y": False,
    }
    assert [name for name in there if storage.is_folder(tmp_path / name)] == ["."]


def test_a_whole_folder_holds_what_was_written_and_nothing_else(tmp_path: Path) -> None:
    storage.write_files(
        Session(),
        tmp_path,
        {"set/a": b"old", "set/b": b"of an earlier run", "set/deep/c": b"kept", "other/d": b"kept"},
    )
    before = tree(tmp_path)
    (fault,) = faults_of(
        lambda: storage.write_files(Session(), tmp_path, {"set/e": b"new"}, whole=["set"]) and None
    )[:1]
    assert "this file is not one of them" in fault
    assert tree(tmp_path) == before
    storage.write_files(Session(), tmp_path, {"set/a": b"new"}, force=True, whole=["set", "none"])
    after = tree(tmp_path)
    assert after == {
        name: content for name, content in {**before, "set/a": b"new"}.items() if name != "set/b"
    }


def test_what_was_removed_comes_back_when_the_rest_cannot_be_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    storage.write_files(
        Session(), tmp_path, {"set/a": b"old", "set/b": b"earlier", "set/c": b"earlier too"}
    )
    before = tree(tmp_path)
    replace, calls = Path.replace, []

    def fails_late(self: Path, target: Path) -> Path:
        calls.append(target)
        if len(calls) == 3:  # the new file is in its place and the first stranger is gone
            raise OSError(28, "No space left on device")
        return replace(self, target)

    monkeypatch.setattr(Path, "replace", fails_late)
    assert faults_of(
        lambda: storage.write_files(
            Session(), tmp_path, {"set/a": b"new"}, force=True, whole=["set"]
        )
    )
    monkeypatch.undo()
    assert tree(tmp_path) == before


def test_what_was_read_is_not_removed_either(tmp_path: Path) -> None:
    """Though an earlier run wrote it and it holds no longer with what is written now."""
    storage.write_files(Session(), tmp_path, {"old": b"1", "older": b"1", "cards/old": b"1"})
    session = Session()
    storage.read_bytes(session, tmp_path / "old")
    storage.read_bytes(session, tmp_path / "cards" / "old")
    storage.write_files(
        session, tmp_path, {"new": b"2"}, force=True, outdated=["old", "older"], renewed=["cards"]
    )
    assert tree(tmp_path) == {"cards": None, "cards/old": b"1", "new": b"2", "old": b"1"}
