"""Large inputs: right to the last digit, work that grows with the size and not with its square,
and refused with what is expected and what was found where they are larger than anything real.
"""

from __future__ import annotations

import time
import tracemalloc
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest

from compwright.controls import control_files
from compwright.controls.control_files import read_files
from compwright.estimation.circle import _average_neighbours
from compwright.evaluation.copied_runs import copied_run_findings, copied_runs
from compwright.evaluation.reading_checks import drift_findings, suspect_traverse_findings
from compwright.evaluation.standards import evaluate
from compwright.formats.families.control_texts import _UNKNOWN, _assigned_names, texts_of
from compwright.foundations import yaml_reader
from compwright.foundations.errors import InputError
from compwright.foundations.session import Session
from compwright.instruments import assembling
from compwright.instruments.header_words import difference_of, stated_unit, unit_of, without_unit
from compwright.instruments.profile_of_file import proposed_profile
from compwright.instruments.sections import FileSections, header_of
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.circular import CircularRun
from compwright.records.correction import ControlFile
from compwright.records.positioning import PositioningTest
from format_samples import DEFINITIONS
from next_steps import without_hint
from one_test import read_positioning


def readings(targets: int, runs: int, seed: int = 1) -> tuple[FloatArray, FloatArray]:
    """Return deviations (targets, runs) in um of + and of -, three decimals each."""
    rng = np.random.default_rng(seed)
    shape = 5.0 * np.sin(np.arange(targets) / 3.0)[:, None]
    up, down = (shape + lag + rng.normal(0.0, 0.6, (targets, runs)) for lag in (0.0, -2.0))
    return np.round(up, 3), np.round(down, 3)


def rows(up: FloatArray, down: FloatArray) -> Iterator[str]:
    for sign, block in (("+", up), ("-", down)):
        for run, column in enumerate(block.T, start=1):
            for target, value in enumerate(column.tolist()):
                yield f"{target * 12.5},{sign},{run},{value}"


def test_of(up: FloatArray, down: FloatArray) -> PositioningTest:
    return PositioningTest(
        name="x",
        axis="X",
        kind=AxisKind.LINEAR,
        targets=np.arange(len(up), dtype=np.float64) * 12.5,
        positive=up / 1000.0,
        negative=down / 1000.0,
    )


test_of.__test__ = False  # type: ignore[attr-defined]


def test_many_readings_are_evaluated_right() -> None:
    """Mean and s at every target against numpy of the numbers that were written."""
    up, down = readings(40, 250)
    text = "# axis: X\ntarget_mm,direction,run,deviation_um\n" + "\n".join(rows(up, down)) + "\n"
    test = read_positioning(text.encode(), "x.csv")
    assert test.positive.shape == test.negative.shape == up.shape
    columns = evaluate(test).targets
    for block, mean, s in (
        (up, columns.mean_positive, columns.s_positive),
        (down, columns.mean_negative, columns.s_negative),
    ):
        np.testing.assert_allclose(mean * 1000.0, block.mean(axis=1), rtol=1e-12)
        np.testing.assert_allclose(s * 1000.0, block.std(axis=1, ddof=1), rtol=1e-11)


def test_checks_of_many_runs_need_memory_in_proportion_to_them() -> None:
    """Nine thousand runs of eleven targets: held all against all, they would take gigabytes."""
    test = test_of(*readings(11, 4_500))
    tracemalloc.start()
    assert copied_run_findings(test) == []
    assert drift_findings(test) == []
    assert suspect_traverse_findings(test, lambda _: None) == []
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 30 * (test.positive.nbytes + test.negative.nbytes)


def test_copies_and_drift_are_found_among_many_runs() -> None:
    up, down = readings(11, 300)
    up[:, 250] = up[:, 17]
    test = test_of(up, down)
    assert [group for group in copied_runs(test).values() if group] == [[[17, 250]]]
    assert "runs 18 and 251 in +" in copied_run_findings(test)[0].message
    drifting = test_of(up + np.linspace(0.0, 3.0, 300), down)
    assert [finding.code for finding in drift_findings(drifting)] == ["CW-T012"]


def test_the_chance_of_an_order_is_the_same_by_orders_and_by_the_normal_limit(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    from compwright.evaluation import reading_checks as module

    table = np.random.default_rng(3).normal(size=(4, 90))
    centred = np.arange(90.0) - 44.5
    table += 0.006 * centred
    by_orders = module._chance(table, centred)
    monkeypatch.setattr(module, "_MOST_ORDERED", 10)
    assert 0.001 < by_orders < 0.5
    assert module._chance(table, centred) == pytest.approx(by_orders, abs=0.01)


def test_many_suspect_traverses_are_counted_and_the_farthest_told() -> None:
    up, down = readings(11, 120)
    up[:, ::3] += 40.0
    findings = suspect_traverse_findings(test_of(up, down), lambda _: None)
    assert len(findings) == 21
    assert findings[-1].values == {"more": 20}


@pytest.mark.parametrize(
    ("limit", "words"),
    [
        (
            "MOST_READINGS",
            ("contains too many readings; expected at most 100 in one test, found 220"),
        ),
        ("MOST_TARGETS", "contains too many targets; expected at most 100 in one test, found 110"),
    ],
)
def test_more_than_anything_real_is_refused(
    limit: str, words: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(assembling, limit, 100)
    text = "target_mm,direction,run,deviation_um\n" + "\n".join(rows(*readings(110, 1)))
    with pytest.raises(InputError) as caught:
        read_positioning(text.encode(), "x.csv")
    assert without_hint(str(caught.value)) == f"x.csv: {words}"


def linear(work: Callable[[str], object], unit: str, before: str = "", after: str = "") -> bool:
    """Whether four times the length takes no more than about four times the time: the shortest of
    three, judged only where it can be seen at all.
    """

    def seconds(count: int) -> float:
        text = before + unit * count + after
        taken = []
        for _ in range(3):
            start = time.process_time()
            with suppress(InputError):
                work(text)
            taken.append(time.process_time() - start)
        return min(taken)

    return seconds(12_000) < 0.02 + 9.0 * seconds(3_000)


@pytest.mark.parametrize("unit", ["[", "(", "[ ", " ", "a-", "- "])
def test_long_headers_take_time_in_proportion_to_their_length(unit: str) -> None:
    def look(text: str) -> object:
        return unit_of(text), without_unit(text), difference_of(text), stated_unit(text)

    assert linear(look, unit, "Einheit ", "!")


@pytest.mark.parametrize("unit", ["\t", " ", "= ", "a\t", "n/a "])
def test_long_lines_of_control_files_take_time_in_proportion_to_their_length(unit: str) -> None:
    assert linear(lambda text: _UNKNOWN.sub(b"", text.encode()), unit, "$MA_X", "!")


def test_a_text_longer_than_any_of_a_control_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "m.cfg"
    file.write_bytes(b"0 0 0\n" * 1_400_000)
    with pytest.raises(InputError) as caught:
        read_files(Session(), [file])
    assert without_hint(str(caught.value)) == (
        "m.cfg: the file is too large; expected a file of at most 8 MB, found 8.4 MB"
    )
    file.write_bytes(b"@@MMCIBN." + b"0 0 0\n" * 1_400_000)
    assert (
        len(read_files(Session(), [file])) == 1
    )  # an archive; what is in it is told where it is opened


def test_texts_longer_together_than_those_of_a_control_are_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(control_files, "MOST_CONTROL_TEXTS", 1000)
    for number in range(3):
        (tmp_path / f"{number}.cfg").write_bytes(b"0 0 0\n" * 60)
    with pytest.raises(
        InputError, match=r"too large; .* in all files together, found 3 files of 1\.1 kB"
    ):
        read_files(Session(), [tmp_path])
    assert len(read_files(Session(), [tmp_path / "0.cfg", tmp_path / "1.cfg"])) == 2


def test_a_job_full_of_keys_is_refused_before_it_is_understood(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(yaml_reader, "MOST_YAML_WORDS", 20)
    assert len(yaml_reader.read_yaml(b"a: [" + b"1," * 19 + b"]", "j.yaml").data["a"]) == 19
    with pytest.raises(InputError) as caught:
        yaml_reader.read_yaml(b"".join(b"k%d: 1\n" % key for key in range(11)), "j.yaml")
    assert without_hint(str(caught.value)) == (
        "j.yaml: line 11 is too long; expected at most 20 keys and values"
    )


def listings(entries: int) -> tuple[ControlFile, ...]:
    """A listing that knows no value, and beside it a file that knows all but the last."""
    names = [f"$MA_ENC_COMP[0,{index},AX1]" for index in range(entries)]
    unknown = "".join(f"MD {name} = n/a\n" for name in names)
    known = "".join(f"N{at} {name.lower()}=1.5\n" for at, name in enumerate(names[:-1]))
    return (
        ControlFile("a.ini", f"{unknown}$MA_X=1\n".encode()),
        ControlFile("b.ini", f"{known}; {names[-1]}=2\n{names[-1]}= n/a\n$MA_X=n/a\n".encode()),
    )


def test_what_a_listing_does_not_know_is_looked_for_once() -> None:
    definition = DEFINITIONS["siemens-840d-sl"]
    listing, beside = texts_of(definition, listings(5), [])
    lines = listing.content.decode().split("\n")
    assert [line.strip() for line in lines[:5]] == [""] * 4 + ["MD $MA_ENC_COMP[0,4,AX1] = n/a"]
    assert beside.content.split(b"\n")[-2].strip() == b""
    assert linear(
        lambda text: texts_of(definition, listings(len(text) // 4), []), " ", before="    "
    )


@pytest.mark.parametrize("unit", ["a", "a ", "=", " ", "a=n/a "])
def test_words_of_long_lines_are_found_in_time_in_proportion(unit: str) -> None:
    assert linear(
        lambda text: _assigned_names([ControlFile("a", text.encode())]), unit, "$MA_X=", "!"
    )


def test_header_lines_are_joined_in_time_in_proportion() -> None:
    def header(text: str) -> object:
        return header_of(FileSections({"A": [(1, "b" * 50)] * (4 * len(text))}), ["A"])

    assert header_of(FileSections({"A": [(1, "x: 1"), (2, "x: 2")]}), ["A"]) == {"x": "1\n2"}
    assert linear(header, " ")


def test_a_number_of_a_million_digits_in_a_control_file_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "m.cfg"
    file.write_bytes(b"DEFINE COMP 4,100\n" + b"9" * 1_000_000)
    with pytest.raises(InputError) as caught:
        read_files(Session(), [file])
    assert without_hint(str(caught.value)) == (
        "m.cfg: line 2: this line contains a number with too many digits; expected at most 1000 digits, found"
        " more than 1000"
    )


def test_a_table_with_thousands_of_columns_is_refused() -> None:
    head = ";".join(f"c{index}" for index in range(5_000))
    row = ";".join("1" * 5_000)
    with pytest.raises(InputError, match="more columns than any table of readings; expected at"):
        proposed_profile(f"{head}\n{row}\n{row}\n".encode(), "x.csv")


def test_means_of_neighbours_stand_for_the_samples_of_a_very_fine_circle() -> None:
    angles = (np.arange(50_000) + 0.5) * 360.0 / 50_000
    run = CircularRun(sense="ccw", angles=angles, deviations=np.cos(np.radians(2.0 * angles)))
    thinned = _average_neighbours(run, 13)
    assert thinned.angles.size == 3_846
    np.testing.assert_allclose(
        thinned.deviations, np.cos(np.radians(2.0 * thinned.angles)), atol=1e-6
    )
