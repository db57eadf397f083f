"""Commissioning archives in one container: members by their headers, what counts, what is refused."""

from __future__ import annotations

import time

import pytest

from compwright.formats.families.shapes import control_format
from compwright.formats.text import container as text_container
from compwright.formats.text.container import opened, unknown_container
from compwright.foundations.errors import InputError
from compwright.foundations.input_sizes import MOST_CONTROL_TEXT
from compwright.records.correction import ControlFile
from format_samples import DEFINITIONS
from sinumerik_archive import ARCHIVE, cec_text, eec_text, member, needs_archive
from sinumerik_container import container, header

ACTIVE = "\\_NC_ACT.DIR\\"


def members(content: bytes) -> dict[str, bytes]:
    found, faults = opened(ControlFile("a.arc", content))
    assert not faults, faults
    assert found is not None
    return {file.name.removeprefix("a.arc: "): file.content for file in found.state}


def refused(content: bytes) -> str:
    found, faults = opened(ControlFile("a.arc", content))
    assert found is None
    (fault, *_) = faults
    assert fault.file == "a.arc"
    assert fault.place.startswith("byte ")
    return str(fault)


TEXTS = [
    (ACTIVE, "AX_EEC.INI", b"\nMETRIC\n\nCHANDATA(1)\nM17\n"),
    ("\\WKS.DIR\\K.WPD\\", "LOAD.MPF", b"$MA_ENC_COMP_ENABLE[0,AX1]=0\nM30\n"),
    (ACTIVE, "INITIAL.INI", b"\nCHANDATA(1)\nM17\n" * 100),
]


def test_only_the_active_data_are_state() -> None:
    found, _ = opened(ControlFile("a.arc", container(TEXTS)))
    assert found is not None
    assert [file.name for file in found.state] == ["a.arc: AX_EEC.INI", "a.arc: INITIAL.INI"]
    assert [file.name for file in found.programs] == ["\\WKS.DIR\\K.WPD\\LOAD.MPF"]
    assert found.state[1].content == TEXTS[2][2]


def test_a_member_twice_counts_once_where_both_are_alike() -> None:
    assert members(container([*TEXTS, TEXTS[0]])) == members(container(TEXTS))


def test_a_member_twice_that_differs_is_refused_by_name() -> None:
    other = (ACTIVE, "ax_eec.ini", b"\nINCH\n\nCHANDATA(1)\nM17\n")
    assert "ax_eec.ini twice" in refused(container([*TEXTS, other]))


def test_a_container_cut_anywhere_is_refused() -> None:
    """At the end of a member too: its own list of contents tells it."""
    whole = container(TEXTS)
    for end in (*range(1, len(whole), 97), *range(512, len(whole), 512)):
        if whole[:end].startswith(b"@@MMCIBN."):
            assert "cut short" in refused(whole[:end]), end


@pytest.mark.parametrize("place", [0, 51, 124, 130, 150, 390])
def test_a_damaged_header_is_refused_at_its_place(place: int) -> None:
    whole = bytearray(container(TEXTS))
    start = whole.index(b"_N_AX_EEC_INI")
    whole[start + place] ^= 1
    assert f"byte {start}:" in refused(bytes(whole)).replace(", byte", " byte")


def test_a_container_edited_with_a_text_editor_is_refused() -> None:
    """A digit more in a value moves every header behind it."""
    whole = container(TEXTS).replace(b"CHANDATA(1)", b"CHANDATA(10)", 1)
    assert "was edited" in refused(whole)


def test_a_member_of_an_unknown_kind_is_refused() -> None:
    odd = header("_N_AX_EEC_INI", "AX_EEC.INI", ACTIVE, 0, kind="9")
    assert "of an unknown kind" in refused(container(TEXTS) + odd)


def test_a_hostile_container_takes_no_time() -> None:
    """100 MB of headers without content; sizes far beyond the end of the file."""
    marks = header("@@_N_IBN_SS", "@@_N_IBN_SS", ACTIVE, 0, kind="0") * 20_000
    begin = time.perf_counter()
    assert members(container(TEXTS) + marks)
    large = header("_N_X", "X.INI", ACTIVE, 10**11)
    assert "cut short" in refused(container(TEXTS) + large)
    rubbish = bytes(range(256)) * 4096
    assert refused(container(TEXTS) + rubbish)
    assert time.perf_counter() - begin < 2.0


def test_a_member_larger_than_any_control_has_is_refused() -> None:
    """Not read line by line for minutes; a program of that size concerns nobody."""
    content = b"$MA_BACKLASH[0,AX1]=0\n" * (MOST_CONTROL_TEXT // 22 + 1)
    assert "INITIAL.INI" in refused(container([(ACTIVE, "INITIAL.INI", content)]))
    assert not members(container([("\\MPF.DIR\\", "LONG.MPF", content)]))


def test_texts_that_are_more_than_any_control_has_together_are_refused(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    opened.cache_clear()
    monkeypatch.setattr(text_container, "MOST_CONTROL_TEXTS", 1000)
    texts = [(ACTIVE, f"A{number}.INI", b"$MA_X=0\n" * 50) for number in range(3)]
    assert "contains 3 texts of 1.2 kB together" in refused(container(texts))
    assert len(members(container(texts[:2]))) == 2
    opened.cache_clear()


@pytest.mark.parametrize(
    ("start", "words"),
    [(b"PK\x03\x04", "ZIP"), (b"\x1f\x8b\x08", "gzip"), (b"@@MMCARC.001", "not known")],
)
def test_other_containers_are_named(start: bytes, words: str) -> None:
    assert words in unknown_container(start + b"\x00" * 600)


@needs_archive
def test_every_member_of_the_real_archive_is_told() -> None:
    """Held against texts that are cut out of it by their own end marks, without any header."""
    content = ARCHIVE.read_bytes()
    found = members(content)
    assert found["AX_EEC.INI"].decode().lstrip("\n") == eec_text().lstrip("\n")
    assert found["NC_CEC.INI"].decode().lstrip("\n") == cec_text().lstrip("\n")
    assert found["INITIAL.INI"].lstrip(b"\n") == member("INITIAL.INI").lstrip(b"\n")
    assert set(found) == {
        *("CFG_RESET.INI", "NC.OPT", "CFG_GLOBAL.INI", "CFG_CHAN.INI", "CFG_SCALING.INI"),
        *("AX_QEC.INI", "AX_EEC.INI", "NC_CEC.INI", "INITIAL.INI"),
    }
    assert "cut short" in refused(content[:-512])


def test_a_container_says_nothing_to_a_control_of_another_kind() -> None:
    """One line, not one for each line of its members."""
    with pytest.raises(InputError, match="not a text file") as refused_:
        control_format(DEFINITIONS["linuxcnc"], {}).read([ControlFile("a.arc", container(TEXTS))])
    assert len(refused_.value.faults) == 1
