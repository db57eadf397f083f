"""Small sound sets of control files of every format, and random damage to them."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from compwright.controls.control import Control, decode, open_control
from compwright.controls.decoded_state import DecodedState
from compwright.foundations.errors import InputError, UsageError
from compwright.foundations.session import Session
from compwright.records.axis import Direction
from compwright.records.correction import ControlFile
from format_samples import DEFINITIONS

#: What stands in such files: damage made of these letters hits their grammar more often than any
#: byte would.
LETTERS = b"0123456789.-+%NQAPMILSR$_[]=,;#() \t\r\nENDBGKOx"
#: Largest difference that is no difference: 1 nm or 1e-6 deg.
SAME = 1e-6


@dataclass(frozen=True)
class Sample:
    """One set of files of a format, with the options that it is read with."""

    format_id: str
    name: str
    options: tuple[tuple[str, object], ...]
    files: tuple[ControlFile, ...]

    def __str__(self) -> str:
        return f"{self.format_id}, {self.name}"


def _samples() -> Iterator[Sample]:
    for format_id, definition in sorted(DEFINITIONS.items()):
        sets = [("sample", definition.sample_options, definition.sample_files)]
        sets += [(entry.name[:40], entry.options, entry.files) for entry in definition.expect]
        seen: set[tuple[str, ...]] = set()
        for name, options, texts in sets:
            files = tuple(ControlFile(file, text.encode("latin-1")) for file, text in texts.items())
            key = tuple(texts.values())
            if key not in seen:
                seen.add(key)
                yield Sample(format_id, name, tuple(sorted(options.items())), files)


SAMPLES = tuple(_samples())
#: What decides nothing that a control does.
WORDS = {"id", "title", "aliases", "sources", "evidence", "help", "expect", "look_at"}
#: What does not decide how files are read: words for people, and what is written at most.
_NOT_READ = WORDS | {"limits"}


def facts(value: Any, left_out: Collection[str] = WORDS) -> Any:
    """Return a definition's data without some of its keys."""
    if isinstance(value, dict):
        return {key: facts(one, left_out) for key, one in value.items() if key not in left_out}
    return [facts(one, left_out) for one in value] if isinstance(value, list) else value


def _read_differently() -> Iterator[Sample]:
    """Yield one of the samples with the same files that relatives read by the same facts."""
    seen: set[str] = set()
    for sample in SAMPLES:
        data = DEFINITIONS[sample.format_id].text.data
        key = repr((sample.files, sample.options, facts(data, _NOT_READ)))
        if key not in seen:
            seen.add(key)
            yield sample


READ_DIFFERENTLY = tuple(_read_differently())


@cache
def control_of(sample: Sample) -> Control:
    return open_control(Session(), sample.format_id, dict(sample.options))


def read(sample: Sample, files: Sequence[ControlFile]) -> DecodedState:
    """Read files as the commands do, for one axis where the sample is about one (a table that does
    not name its axis).
    """
    return decode(control_of(sample), files)


def damaged(sample: Sample, seed: int) -> tuple[ControlFile, ...]:
    """Return the files with one to three random changes in one of them."""
    rng = random.Random(f"{sample} {seed}")  # noqa: S311 - not for secrets
    which = rng.randrange(len(sample.files))
    content = sample.files[which].content
    for _ in range(rng.choice((1, 1, 1, 2, 3))):
        content = _change(content, rng)
    name = sample.files[which].name
    return (*sample.files[:which], ControlFile(name, content), *sample.files[which + 1 :])


def _change(content: bytes, rng: random.Random) -> bytes:
    place = rng.randrange(len(content) + 1)
    piece = bytes(rng.choices(LETTERS, k=rng.randint(1, 3)))
    what = rng.randrange(9)
    if what == 0:
        return content[:place] + content[place + rng.randint(1, 4) :]
    if what == 1:
        return content[:place] + piece + content[place:]
    if what == 2:
        return content[:place] + piece[:1] + content[place + 1 :]
    if what == 3:
        return content[:place]
    if what == 4:  # another digit somewhere: mostly still readable
        places = [index for index, byte in enumerate(content) if chr(byte).isdigit()]
        chosen = rng.choice(places) if places else 0
        return content[:chosen] + str(rng.randrange(10)).encode() + content[chosen + 1 :]
    lines = content.splitlines(keepends=True) or [b""]
    one, other = rng.randrange(len(lines)), rng.randrange(len(lines))
    if what == 5:
        lines[one], lines[other] = lines[other], lines[one]
    elif what == 6:
        lines.insert(other, lines[one])
    elif what == 7:
        del lines[one]
    else:
        lines[one] = lines[one].rstrip(b"\r\n") + rng.choice(
            (b"\r\n", b"\n\r\r", b"\r", b" \n", b"")
        )
    return b"".join(lines)


def trials(samples: Sequence[Sample], count: int, seed: int) -> Counter[str]:
    """Read ``count`` damaged sets; any error but a refusal comes through, with the seed in its
    notes.
    """
    counts: Counter[str] = Counter()
    for trial in range(count):
        sample = samples[trial % len(samples)]
        files = damaged(sample, seed * 10_000_000 + trial)
        try:
            read(sample, files)
        except (InputError, UsageError) as error:
            counts["ambiguous" if "read in two ways" in str(error) else "refused"] += 1
        except Exception as error:
            error.add_note(f"{sample}, seed {seed * 10_000_000 + trial}: {files}")
            raise
        else:
            counts["agreed"] += 1
    return counts


def cut_points(sample: Sample) -> Iterator[tuple[str, int]]:
    for file in sample.files:
        for end in range(len(file.content)):
            yield file.name, end


def said_incomplete(left: DecodedState, whole: DecodedState) -> bool:
    """Whether what is left of cut files means the same as the whole ones, or comes with a
    warning.
    """
    if any(
        finding.severity == "warning"
        for finding in left.state.findings
        if finding not in whole.state.findings
    ):
        return True
    return _same(left, whole)


def _same(left: DecodedState, whole: DecodedState) -> bool:
    if set(left.state.axes) != set(whole.state.axes):
        return False
    where = np.linspace(-700, 700, 281) + 0.01
    return all(
        bool(np.all(np.abs(left.state.axes[name].at(where, side) - axis.at(where, side)) <= SAME))
        for name, axis in whole.state.axes.items()
        for side in Direction
    )
