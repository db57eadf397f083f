"""Which files were loaded is stated by their names, never by an empty one."""

from __future__ import annotations

from compwright.controls.partial_loads import PartialLoad, partial_load
from compwright.formats.text.file_values import FileValue


def entry(name: str, text: str, file: str) -> FileValue:
    return FileValue(name, name, text, file, 1)


def test_a_value_of_no_named_file_gives_no_list_of_files() -> None:
    """MP710 of an iTNC 530 may be in a list of any name: "only  was loaded" was printed."""

    def content(table: str, play: str, file: str) -> dict[str, FileValue]:
        return {"row": entry("row", table, "X.COM"), "play": entry("MP710.0", play, file)}

    def loaded(file: str) -> PartialLoad | None:
        before, planned = content("0", "0", file), content("1", "1", file)
        return partial_load(before, planned, content("0", "1", file))

    assert loaded("MP.TXT") == PartialLoad(("MP.TXT",), ("X.COM",))
    assert loaded("") is None
