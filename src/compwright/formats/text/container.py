"""Open a commissioning archive, and return those of its texts that state active data of the
control.

The format of the container (``@@MMCIBN.``) is similar to tar. Each member is a header of 512 bytes,
the content, and zeros up to the next multiple of 512. The first member is a list of all others. All
headers of two real archives fit this description (versions 000 and 002). The texts in the archive
are those that the control exports, uncompressed.

Only the folder of active data is returned, because the control loads it. Programs, definitions and
drive data do not show the state: it is unknown whether a program was executed.

In version 002 no byte of a header depends on the contents, so changed contents are not noticed
here. A control may refuse a changed archive, so no archive is ever written.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache

from compwright.foundations.errors import Fault
from compwright.foundations.input_sizes import MOST_CONTROL_TEXT, MOST_CONTROL_TEXTS, in_words
from compwright.records.correction import ControlFile

MAGIC = b"@@MMCIBN."
#: Containers of other kinds, by their first bytes: what they are.
OTHERS = {
    b"@@MMC": "an archive of the operator panel in a container that is not known,",
    b"PK\x03\x04": "a ZIP archive,",
    b"\x1f\x8b": "a gzip archive,",
    b"7z\xbc\xaf\x27\x1c": "a 7z archive,",
    b"SQLite format 3\x00": "a data base,",
    b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1": "a compound document (OLE),",
}
_BLOCK = 512
_NAME, _SHOWN, _KIND, _SIZE, _DATE, _SUM, _FOLDER = (
    slice(0, 50),
    slice(50, 100),
    slice(108, 116),
    slice(124, 136),
    slice(136, 148),
    slice(148, 156),
    slice(384, 512),
)
_FILE, _MARK = b"7", b"0"
_ACTIVE = b"\\_NC_ACT.DIR\\"
_LISTED = re.compile(rb"^(\\[^\n]*\\)([^\\\n]+)$", re.MULTILINE)
_ZEROS = b"\x00"
#: What was read is kept by content, of as many containers as a job has states.
_KEPT = 8


@dataclass(frozen=True, slots=True)
class Member:
    """One member of an archive: folder, name, kind, date, and the bytes that it occupies.

    ``kind``: as written in the header. ``date``: in seconds, as written there. ``start``: the byte
    at which its contents of ``size`` bytes begin.
    """

    folder: str
    name: str
    kind: str
    date: str
    start: int
    size: int

    @property
    def path(self) -> str:
        """The folder and name of the member as one path."""
        return self.folder + self.name


@dataclass(frozen=True, slots=True)
class Container:
    """The members of an opened archive.

    ``state``: the texts that the control loads, in the order of the archive. The name of each
    begins with that of the archive. ``programs``: all other members that are texts.
    """

    state: tuple[ControlFile, ...]
    programs: tuple[ControlFile, ...]


def is_container(file: ControlFile) -> bool:
    """Return whether a file is an archive that can be opened."""
    return file.content.startswith(MAGIC)


def unpacked(files: Sequence[ControlFile], faults: list[Fault]) -> tuple[ControlFile, ...]:
    """Return the files, with archives replaced by their texts, which come before other files.

    The texts come first because the other files are loaded after the archive. If a container cannot
    be opened, a fault is added to ``faults``.
    """
    result: list[ControlFile] = []
    for file in sorted(files, key=is_container, reverse=True):
        if not is_container(file):
            result.append(file)
            continue
        container, found = opened(file)
        faults.extend(found)
        result.extend(container.state if container is not None else ())
    return tuple(result)


def unknown_container(content: bytes) -> str:
    """Return the type of an archive that is recognised but cannot be opened. Empty for other
    files.
    """
    return next((words for start, words in OTHERS.items() if content.startswith(start)), "")


@lru_cache(maxsize=_KEPT)
def programs_setting(file: ControlFile, words: tuple[str, ...]) -> tuple[str, ...]:
    """Return the archived programs that set a variable with one of ``words`` in its name."""
    container = opened(file)[0] if words else None
    named = "|".join(map(re.escape, words))
    sets = re.compile(rf"^[^;\n]*(?:{named})[^;=\n]*=(?!=)".encode(), re.IGNORECASE | re.MULTILINE)
    programs = () if container is None else container.programs
    return tuple(program.name for program in programs if sets.search(program.content))


@lru_cache(maxsize=_KEPT)
def opened(file: ControlFile) -> tuple[Container | None, tuple[Fault, ...]]:
    """Return the contents of an archive; None, with a fault, if it is damaged, incomplete or
    ambiguous.
    """
    faults: list[Fault] = []
    members = list(_members(file, faults))
    if not faults:
        faults.extend(_not_listed(file, members))
    state: dict[str, ControlFile] = {}
    programs = []
    for member in members[1:]:
        content = file.content[member.start : member.start + member.size]
        if member.kind != _FILE.decode() or not content:
            continue
        if member.folder.encode("latin-1").upper() != _ACTIVE:
            if _ZEROS not in content:
                programs.append(ControlFile(member.path, content))
            continue
        if member.size > MOST_CONTROL_TEXT:
            what = f"contains {member.name} with {member.size} bytes, more than any control's"
            expected = f"at most {in_words(MOST_CONTROL_TEXT)}"
            faults.append(_fault(file, member.start - _BLOCK, what, expected=expected))
            continue
        one = ControlFile(f"{file.name}: {member.name}", content)
        if state.setdefault(member.name.upper(), one).content != content:
            faults.append(
                _fault(
                    file,
                    member.start - _BLOCK,
                    (
                        f"contains {member.name} twice, and the two differ: which one is valid"
                        " is not known"
                    ),
                    expected="an archive made anew by the control",
                )
            )
    together = sum(len(one.content) for one in state.values())
    if together > MOST_CONTROL_TEXTS:
        what = (
            f"contains {len(state)} texts of {in_words(together)} together, more than any control's"
        )
        faults.append(_fault(file, 0, what, expected=f"at most {in_words(MOST_CONTROL_TEXTS)}"))
    if faults:
        return None, tuple(faults)
    return Container(tuple(state.values()), tuple(programs)), ()


def _members(file: ControlFile, faults: list[Fault]) -> Iterator[Member]:
    """Yield every archive member, the list of contents first. Stop at the first invalid header."""
    place, content, behind = 0, file.content, "at its beginning"
    while place < len(content):
        header = content[place : place + _BLOCK]
        size, total = _text(header, _SIZE), _text(header, _SUM)
        zeros = b"\x00" * (_SUM.stop - _SUM.start)
        if len(header) < _BLOCK:
            faults.append(_fault(file, place, "ends inside a header: it was cut short"))
            return
        if not (size.isdigit() and total.isdigit()) or int(total) != sum(
            header[: _SUM.start] + zeros + header[_SUM.stop :]
        ):
            message = f"contains no header {behind}: it is damaged, or was edited"
            faults.append(_fault(file, place, message))
            return
        shown = _text(header, _SHOWN) or _text(header, _NAME)
        member = Member(
            folder=_text(header, _FOLDER).decode("latin-1"),
            name=shown.decode("latin-1"),
            kind=_text(header, _KIND).decode("latin-1"),
            date=_text(header, _DATE).decode("latin-1"),
            start=place + _BLOCK,
            size=int(size),
        )
        if member.start + member.size > len(content):
            message = f"ends inside {member.path}: it was cut short"
            faults.append(_fault(file, place, message, expected=f"{member.size} bytes from there"))
            return
        if _text(header, _KIND) not in (_FILE, _MARK) or (place and not member.name):
            message = f"contains a member (file) of an unknown kind: {member.path or 'no name'}"
            found = f"kind {member.kind!r}"
            faults.append(_fault(file, place, message, expected="kind 7 or 0", found=found))
            return
        yield member
        behind = f"behind {member.path or 'its list of contents'}"
        place = member.start + -(-member.size // _BLOCK) * _BLOCK


def _not_listed(file: ControlFile, members: Sequence[Member]) -> Iterator[Fault]:
    """Yield a fault if members are missing that the archive's own list of contents names."""
    contents, *rest = members
    text = file.content[contents.start : contents.start + contents.size]
    listed = Counter(found[0].decode("latin-1") for found in _LISTED.finditer(text))
    missing = list(listed - Counter(member.path for member in rest))
    if missing or len(file.content) % _BLOCK:
        yield _fault(
            file,
            len(file.content),
            "ends before all members that its own list of contents names: it was cut short",
            expected=", ".join(missing[:3]) or f"a length that is a multiple of {_BLOCK}",
        )


def _text(header: bytes, field: slice) -> bytes:
    """Return a field of an archive header without its padding."""
    return header[field].partition(b"\x00")[0].strip(b" ")


def _fault(
    file: ControlFile, place: int, message: str, *, expected: str = "", found: str = ""
) -> Fault:
    return Fault(
        message=f"the archive {message}",
        file=file.name,
        place=f"byte {place}",
        expected=expected or "the archive as the control wrote it",
        found=found,
        hint="export the archive from the control again",
    )
