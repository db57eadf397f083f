"""The text members of a real commissioning archive, cut out of its container, and small edits of
such texts.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path

import pytest

from places import REAL
from sinumerik_container import BLOCK, padded

ARCHIVE = REAL / "siemens" / "dmu_840d_sl.arc"
LISTING = REAL / "siemens" / "compmaster_840d_axis_data.tsv"

needs_archive = pytest.mark.skipif(
    not ARCHIVE.is_file(),
    reason=f"the real SINUMERIK archive is not beside the project ({ARCHIVE})",
)

# What decides about compensation, and what stands around it: units, names, points, encoders, kinds,
# ratios, limits, gantry.
_KEPT = re.compile(
    rb"N(10000|10220|1024\d|10250|18342|30200|3024\d|3030\d|3031\d|3032\d|3033\d|3034\d|31000|31030|31040|3245\d|327\d\d|3410\d|361[0-3]0|371\d\d"
    rb"|38000|41300|41310|4132\d|439\d\d) "
)


@cache
def member(name: str) -> bytes:
    """The text behind the last header with this file name, up to M17 and its line end."""
    container = ARCHIVE.read_bytes()
    header = re.compile(
        rb"[ \x00]"
        + re.escape(name.encode())
        + rb"[ \x00]{2,}\d[^\n]{0,400}?\\[\w.\\]+\\[ \x00]*(?:\n|(?=;))"
    )
    *_, last = header.finditer(container)
    end = re.compile(rb"^M17\r?\n", re.MULTILINE).search(container, last.end())
    assert end is not None, f"{name}: no M17"
    return container[last.end() : end.end()]


@cache
def machine_data() -> str:
    """The lines of INITIAL.INI that compensation depends on, in their order; temperature
    compensation switched off.
    """
    lines = [
        line for line in member("INITIAL.INI").split(b"\n") if _KEPT.match(line) or line == b"M17"
    ]
    text = "METRIC\n\nCHANDATA(1)\n" + "\n".join(line.decode("latin-1") for line in lines) + "\n"
    return text.replace("]='H1'", "]='H0'")


def eec_text() -> str:
    return member("AX_EEC.INI").decode("latin-1")


def cec_text() -> str:
    return member("NC_CEC.INI").decode("latin-1")


def put(text: str, register: str, value: str) -> str:
    """The text with ``register = value``: in its own place, or on a line of its own before the
    end.
    """
    pattern = re.compile(
        r"(^[ \t]*(?:N\d+ )?" + re.escape(register) + r"[ \t]*=[ \t]*)[^\s;]+", re.MULTILINE
    )
    changed, times = pattern.subn(lambda found: found[1] + value, text)
    if times:
        return changed
    at = text.rfind("M17")
    at = len(text) if at < 0 else at
    return text[:at] + f"{register}={value}\n" + text[at:]


def without(text: str, part: str | re.Pattern[str]) -> str:
    """The text without the lines that hold ``part``."""
    keep: Callable[[str], object] = (
        (lambda line: part not in line)
        if isinstance(part, str)
        else (lambda line: not part.search(line))
    )
    return "".join(line for line in text.splitlines(keepends=True) if keep(line))


def number(value: float) -> str:
    text = f"{value:.6f}".rstrip("0").rstrip(".")
    return "0" if text in {"-0", ""} else text


def eec_lines(
    axis: str,
    e: int,
    low: float,
    step: float,
    values: Sequence[float],
    *,
    modulo: bool,
    spare: int = 0,
) -> str:
    """A table as the control exports it; ``spare`` zero values stand behind the last one that
    counts.
    """
    shown = [*values, *([0.0] * spare)]
    lines = [f"$AA_ENC_COMP[{e},{n},{axis}]={number(value)}" for n, value in enumerate(shown)]
    lines += [
        f"$AA_ENC_COMP_STEP[{e},{axis}]={number(step)}",
        f"$AA_ENC_COMP_MIN[{e},{axis}]={number(low)}",
        f"$AA_ENC_COMP_MAX[{e},{axis}]={number(low + step * (len(values) - 1))}",
        f"$AA_ENC_COMP_IS_MODULO[{e},{axis}]={int(modulo)}",
    ]
    return "\n".join(lines) + "\n"


def replace_eec(text: str, axis: str, lines: str) -> str:
    """The text with another table of ``axis`` in the place of the old one."""
    kept = text.splitlines(keepends=True)
    own = [
        n for n, line in enumerate(kept) if re.search(rf"\$AA_ENC_COMP\w*\[[^\]]*\b{axis}\]", line)
    ]
    at = own[0] if own else next(n for n, line in enumerate(kept) if line.startswith("M17"))
    rest = [line for n, line in enumerate(kept) if n not in set(own)]
    return "".join(rest[:at]) + lines + "".join(rest[at:])


def cec_lines(
    t: int,
    inputs: str,
    outputs: str,
    low: float,
    step: float,
    values: Sequence[float],
    *,
    direction: int = 0,
    product: int = 0,
    modulo: int = 0,
) -> str:
    lines = [f"$AN_CEC[{t},{n}]={number(value)}" for n, value in enumerate(values)]
    lines += [
        f"$AN_CEC_INPUT_NCU[{t}]=1",
        f"$AN_CEC_INPUT_AXIS[{t}]=({inputs})",
        f"$AN_CEC_OUTPUT_NCU[{t}]=1",
        f"$AN_CEC_OUTPUT_AXIS[{t}]=({outputs})",
        f"$AN_CEC_STEP[{t}]={number(step)}",
        f"$AN_CEC_MIN[{t}]={number(low)}",
        f"$AN_CEC_MAX[{t}]={number(low + step * (len(values) - 1))}",
        f"$AN_CEC_DIRECTION[{t}]={direction}",
        f"$AN_CEC_MULT_BY_TABLE[{t}]={product}",
        f"$AN_CEC_IS_MODULO[{t}]={modulo}",
        f"$AN_CEC_TYPE[{t}]=0",
    ]
    return "\n".join(lines) + "\n"


def replace_cec(text: str, t: int, lines: str) -> str:
    """The text with another table ``t``, where the old one stood or before the end."""
    kept = text.splitlines(keepends=True)
    own = [n for n, line in enumerate(kept) if re.match(rf"\$AN_CEC\w*\[{t}[,\]]", line)]
    at = own[0] if own else next(n for n, line in enumerate(kept) if line.startswith("M17"))
    rest = [line for n, line in enumerate(kept) if n not in set(own)]
    return "".join(rest[:at]) + lines + "".join(rest[at:])


def in_inch(text: str, rotary: set[str]) -> str:
    """The same state in the texts of an inch control: lengths of linear axes in inch, the line INCH
    in place of METRIC.
    """
    lengths = re.compile(
        r"(?P<head>\$(?:AA_ENC_COMP(?:_STEP|_MIN|_MAX)?|MA_BACKLASH|MA_BACKLASH_DYN|MA_POS_LIMIT_\w+|MA_REFP_SET_POS|MA_CEC_MAX_SUM"
        r"|SA_TEMP_COMP_ABS_VALUE|SA_TEMP_COMP_REF_POSITION|MA_LEADSCREW_PITCH)\[(?:[^\],]*,)*(?P<axis>\w+)\]\s*=\s*)(?P<value>[-+\d.]+)"
    )

    def turn(found: re.Match[str]) -> str:
        value = float(found["value"])
        return found["head"] + (
            found["value"] if found["axis"] in rotary else number_long(value / 25.4)
        )

    return re.sub(r"^METRIC$", "INCH", lengths.sub(turn, text), flags=re.MULTILINE)


def number_long(value: float) -> str:
    text = f"{value:.10f}".rstrip("0").rstrip(".")
    return "0" if text in {"-0", ""} else text


def listing() -> dict[str, list[str]]:
    """The machine data of another real control, as a compensation program lists them: name to one
    text per axis.
    """
    rows: dict[str, list[str]] = {}
    for line in Path(LISTING).read_text(encoding="utf-8").splitlines()[1:]:
        cells = line.split("\t")
        if cells[0].startswith("$MC_CHAN_NAME"):
            break
        if len(cells) > 1:
            rows[cells[0]] = cells[1:]
    return rows


# -- the whole container, with other texts in it
# --------------------------------------------------------------------------------------------------


@cache
def _members() -> tuple[tuple[bytes, bytes], ...]:
    """Header and content of every member of the real container, by the sizes in the headers."""
    whole = ARCHIVE.read_bytes()
    found, at = [], 0
    while at < len(whole):
        head = whole[at : at + BLOCK]
        size = int(head[124:136].rstrip(b"\x00 "))
        found.append((head, whole[at + BLOCK : at + BLOCK + size]))
        at += BLOCK + -(-size // BLOCK) * BLOCK
    return tuple(found)


def whole_container(texts: dict[str, str]) -> bytes:
    """The real container, all 325 members, with these tables in it, and every machine datum that
    the text ``MD.INI`` says otherwise put into the members that hold it.
    """
    wanted = {
        _register(line): line.split("=", 1)[1].strip()
        for line in texts["MD.INI"].splitlines()
        if "=" in line and "$" in line
    }
    parts, missing = [], dict(wanted)
    for head, content in _members():
        name = head[50:100].rstrip(b"\x00").decode("latin-1")
        new = content
        if head[384:].rstrip(b"\x00") == b"\\_NC_ACT.DIR\\":
            if name in texts:
                new = texts[name].encode("latin-1")
            elif name.startswith(("CFG_", "INITIAL")):
                last = name.startswith("INITIAL")
                new = _with(content, wanted, missing, last=last)
        parts.append(_headed(head, new))
    return b"".join(parts)


def _register(line: str) -> str:
    return line[line.index("$") :].split("=", 1)[0].strip()


def _with(content: bytes, wanted: dict[str, str], missing: dict[str, str], *, last: bool) -> bytes:
    lines = content.decode("latin-1").split("\n")
    for n, line in enumerate(lines):
        if not line.startswith("N") or "$" not in line or "=" not in line:
            continue
        register = _register(line)
        value = wanted.get(register)
        missing.pop(register, None)
        if value is not None and value != line.split("=", 1)[1].split(" '")[0].strip():
            lines[n] = f"{line.split('=', 1)[0]}={value}"
    if last and missing:
        at = max(n for n, line in enumerate(lines) if line.startswith("M17"))
        lines[at:at] = [f"{register}={value}" for register, value in missing.items()]
    return "\n".join(lines).encode("latin-1")


def _headed(head: bytes, content: bytes) -> bytes:
    """The member with its size and the sum of its header."""
    block = bytearray(head)
    block[124:136] = str(len(content)).encode().ljust(12, b"\x00")
    block[148:156] = bytes(8)
    block[148:156] = str(sum(block)).encode().ljust(8, b"\x00")
    return bytes(block) + padded(content)
