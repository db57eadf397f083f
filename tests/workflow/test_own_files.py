"""The hidden list of a folder without a record: what a command wrote there is its own as long as
nobody changes it; all else is the user's.
"""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import pytest
from test_inputs_stay import tree

from compwright.documents.file_list import LIST
from compwright.foundations.errors import StorageError
from compwright.foundations.session import Session
from compwright.workflow.results.own_files import write_listed

pytestmark = pytest.mark.short_estimate

SET = {"a.ini": b"one", "sub/b.ini": b"two"}


def written(out: Path, files: dict[str, bytes], *, by: str = "export", force: bool = True) -> None:
    paths = write_listed(Session(), out, files, command=by, force=force, as_set=by == "export")
    assert paths == [out / name for name in files]


def refused(out: Path, files: dict[str, bytes], *, force: bool = True) -> str:
    before = tree(out)
    with pytest.raises(StorageError) as caught:
        written(out, files, force=force)
    assert tree(out) == before
    return str(caught.value)


def test_the_list_says_what_was_written(tmp_path: Path) -> None:
    written(tmp_path / "one", SET, force=False)
    written(tmp_path / "two", SET, force=True)
    assert tree(tmp_path / "one") == tree(tmp_path / "two")
    listed = json.loads((tmp_path / "one" / LIST).read_bytes())
    assert listed["schema"] == "compwright/files/1"
    assert [(each["file"], each["size"], each["by"]) for each in listed["files"]] == [
        ("a.ini", 3, "export"),
        ("sub/b.ini", 3, "export"),
    ]
    assert listed["files"][0]["sha256"] == hashlib.sha256(b"one").hexdigest()


def test_with_force_one_set_takes_the_place_of_the_other(tmp_path: Path) -> None:
    written(tmp_path, SET)
    (tmp_path / "notes.txt").write_bytes(b"mine")
    assert "exists already" in refused(tmp_path, {"a.ini": b"new"}, force=False)
    written(tmp_path, {"a.ini": b"new"})
    left = tree(tmp_path)
    assert set(left) == {"a.ini", "notes.txt", LIST}
    assert (left["a.ini"], left["notes.txt"]) == (b"new", b"mine")


@pytest.mark.parametrize("name", SET)
def test_what_was_changed_is_not_replaced(name: str, tmp_path: Path) -> None:
    written(tmp_path, SET)
    (tmp_path / name).write_bytes(b"mine")
    new = dict.fromkeys(SET, b"new")
    assert "was changed since" in refused(tmp_path, new)
    # nor removed with the set that it was of; and it is no more of it
    other = "a.ini" if name != "a.ini" else "sub/b.ini"
    written(tmp_path, {other: b"new"})
    assert (tmp_path / name).read_bytes() == b"mine"
    assert name.encode() not in (tmp_path / LIST).read_bytes()


@pytest.mark.parametrize("content", [None, b"mine", b'{"schema": "compwright/plan/1"}'])
def test_without_its_list_nothing_is_its_own(content: bytes | None, tmp_path: Path) -> None:
    written(tmp_path, SET)
    (tmp_path / LIST).unlink()
    if content is not None:
        (tmp_path / LIST).write_bytes(content)
    assert "a.ini: the file was not written by an earlier run" in refused(
        tmp_path, {"a.ini": b"new"}
    )


def test_commands_in_one_folder_leave_each_other_s_files(tmp_path: Path) -> None:
    written(tmp_path, SET)
    written(tmp_path, {"x.csv": b"three"}, by="redact", force=False)
    written(tmp_path, {"y.csv": b"four"}, by="redact")
    written(tmp_path, {"c.ini": b"new"})
    assert set(tree(tmp_path)) == {"c.ini", "x.csv", "y.csv", LIST}
    listed = json.loads((tmp_path / LIST).read_bytes())["files"]
    assert {each["file"]: each["by"] for each in listed} == {
        "c.ini": "export",
        "x.csv": "redact",
        "y.csv": "redact",
    }


def test_a_file_that_lay_there_just_so_stays_the_user_s(tmp_path: Path) -> None:
    (tmp_path / "a.ini").write_bytes(b"one")
    written(tmp_path, SET)
    assert "a.ini" not in (tmp_path / LIST).read_text()
    assert "a.ini: the file was not written by an earlier run" in refused(
        tmp_path, {"a.ini": b"new"}
    )
    written(tmp_path, {"c.ini": b"new"})
    assert set(tree(tmp_path)) == {"a.ini", "c.ini", LIST}


def test_a_list_that_leads_out_of_its_folder_removes_nothing(tmp_path: Path) -> None:
    (tmp_path / "mine.txt").write_bytes(b"mine")
    out = tmp_path / "out"
    written(out, SET)
    data = json.loads((out / LIST).read_bytes())
    digest = hashlib.sha256(b"mine").hexdigest()
    data["files"].append({"file": "../mine.txt", "sha256": digest, "size": 4, "by": "export"})
    (out / LIST).write_text(json.dumps(data))
    assert "is outside of the folder" in refused(out, {"a.ini": b"new"})
    assert (tmp_path / "mine.txt").read_bytes() == b"mine"
