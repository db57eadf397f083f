"""Containers as a control writes them, made by hand: blocks of 512 bytes, header, content, zeros."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

BLOCK = 512


def header(
    name: str, shown: str, folder: str, size: int, *, kind: str = "7", date: int = 1476518605
) -> bytes:
    """A header with the sum of its bytes, those of the sum itself taken as zero."""
    block = bytearray(BLOCK)
    fields = {0: name, 50: shown, 108: kind, 116: "040703", 124: str(size), 136: str(date)}
    for place, text in {**fields, 384: folder}.items():
        block[place : place + len(text)] = text.encode("ascii")
    total = str(sum(block)).encode()
    block[148 : 148 + len(total)] = total
    return bytes(block)


def padded(content: bytes) -> bytes:
    return content + b"\x00" * (-len(content) % BLOCK)


def container(texts: Sequence[tuple[str, str, bytes]], version: str = "002") -> bytes:
    """The container of members (folder, name, content); its first one lists all of them."""
    listed = "".join(f"{folder}{name}\n" for folder, name, _ in texts)
    contents = f";---creation stamp---\n;1476518513\n;---components---\n;NCKComp\n{listed}".encode()
    parts = [header(f"@@MMCIBN.{version}", "", "", len(contents)) + padded(contents)]
    for folder, name, content in texts:
        inner = "_N_" + name.replace(".", "_")
        parts.append(header(inner, name, folder, len(content)) + padded(content))
    return b"".join(parts)


# -- variations of a container
# --------------------------------------------------------------------------------------------------

ACTIVE = "\\_NC_ACT.DIR\\"
MARK = header("@@_N_IBN_SS", "@@_N_IBN_SS", "", 0, kind="0")
_ORDER = ("AX_EEC.INI", "NC_CEC.INI", "INITIAL.INI")


@dataclass(frozen=True)
class Packing:
    """How texts of a control stand in a container: copies of members, marks between them, programs
    that load tables and are no state, a version, and the damage that is done to the whole.
    """

    version: str = "002"
    copies: tuple[str, ...] = ()
    marks: bool = False
    programs: tuple[tuple[str, str, bytes], ...] = ()
    damage: Callable[[bytes], bytes] | None = None

    def packed(self, texts: dict[str, str]) -> bytes:
        named = {
            {"MD.INI": "INITIAL.INI"}.get(name, name): text.encode("latin-1")
            for name, text in texts.items()
        }
        members = [(ACTIVE, name, named[name]) for name in _ORDER if name in named]
        members += [(ACTIVE, name, named[name]) for name in self.copies if name in named]
        whole = container([*members, *self.programs], self.version)
        if self.marks:
            at = whole.index(b"_N_INITIAL_INI")
            whole = whole[:at] + MARK + whole[at:]
        return self.damage(whole) if self.damage else whole
