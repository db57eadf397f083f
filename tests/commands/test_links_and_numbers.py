"""Links among results, and words in the place of numbers in a record."""

from __future__ import annotations

from pathlib import Path

import pytest

from compwright.cli import run as compwright
from compwright.foundations import storage
from compwright.foundations.errors import StorageError
from compwright.foundations.session import Session
from compwright.workflow.history.result_folders import result_folders

pytestmark = pytest.mark.short_estimate


def test_a_link_to_a_folder_among_what_is_handed_on_is_named(tmp_path: Path) -> None:
    """Nothing is written, nothing is removed, and the link is named."""
    storage.write_files(Session(), tmp_path, {"card/card.md": b"one"}, whole=["card"])
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "card" / "link").symlink_to(tmp_path / "elsewhere")
    with pytest.raises(StorageError, match="link"):
        storage.write_files(
            Session(), tmp_path, {"card/card.md": b"two"}, whole=["card"], force=True
        )
    assert (tmp_path / "card" / "card.md").read_bytes() == b"one"
    assert (tmp_path / "card" / "link").is_dir()


@pytest.mark.parametrize("word", ["NaN", "Infinity", "-Infinity"])
def test_a_word_is_no_number_of_a_record(
    tmp_path: Path, word: str, capsys: pytest.CaptureFixture[str]
) -> None:
    text = f'{{"schema": "compwright/record/1", "tests": [{{"parameters": {{"A": {word}}}}}]}}'
    (tmp_path / "record.json").write_text(text)
    assert compwright(["history", str(tmp_path)]) == 3
    assert word in capsys.readouterr().err


def test_copies_below_a_result_folder_are_none(tmp_path: Path) -> None:
    """A copied record in ``inputs`` is no result of its own; one in another folder below is."""
    for name in ("a", "a/inputs", "a/inputs/deeper", "a/next", "b/card"):
        (tmp_path / name).mkdir(parents=True)
        (tmp_path / name / "record.json").write_text("{}")
    found, faults = result_folders(Session(), [tmp_path])
    assert faults == []
    names = sorted(path.relative_to(tmp_path).as_posix() for path in found)
    assert names == ["a", "a/next", "b/card"]
