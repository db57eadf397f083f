"""Check a FANUC axis for settings that prevent reading it: unclear paths, a table that is not used,
functions of unknown effect.
"""

from __future__ import annotations

from collections.abc import Iterator

from compwright.controllers.fanuc.additional_functions import inclined, refusing
from compwright.controllers.fanuc.memory import Memory
from compwright.foundations.errors import Fault

#: May say that the data are totals (practice).
_TOTALS = 3602


def stopping(memory: Memory, axis: int, *, rotary: bool) -> Iterator[Fault]:
    """Yield a fault for each parameter that makes the compensation of an axis uncertain."""
    yield from memory.machine.contradicting(axis)
    yield from refusing(memory.machine, axis)
    yield from _deciding_bits(memory, axis, rotary=rotary)


def inclined_without_grid(memory: Memory, axis: int) -> Iterator[Fault]:
    """Yield a fault for inclination on an axis without active pitch points: its effect is
    unknown.
    """
    entry = inclined(memory.machine, axis)
    if entry is not None:
        off = memory.whole_if_sound(3623, axis) == 0
        yield entry.fault(
            f"inclination of axis {axis} {'with 3623 = 0' if off else 'without a grid'}: "
            "it is unknown"
            " whether it is active",
            "3620 to 3624 of an active grid, or 5871 to 5874 = 0",
        )


def not_used(memory: Memory, axis: int) -> Iterator[Fault]:
    """Yield a fault if the control does not use the table in the files, or if the files leave it
    uncertain.
    """
    series, machine = memory.series, memory.machine
    totals, apart = machine.entry(_TOTALS, axis), machine.either(_TOTALS, axis)
    if apart is not None:
        yield apart
    elif totals is not None and not totals.zero:
        yield totals.fault(f"the pitch data of axis {axis} may be totals", "3602 = 0: increments")
    if series.switched_by is not None:
        switch = machine.entry(series.switched_by, axis)
        apart = machine.either(series.switched_by, axis, 0)
        if apart is not None:
            yield apart
        elif switch is not None and switch.bit(0):
            yield switch.fault(
                f"the table of axis {axis} is not active: {switch.number}#0 = 1 switches stored"
                " pitch error compensation off",
                f"{switch.number}#0 = 0",
            )
    for number in (3626, 3627) if series.own else ():
        value = memory.whole(number, axis)
        if value is not None and value != 0:
            yield memory.setting(number, axis).fault(
                f"what {number} does to axis {axis} is not known (two sets?)", expected="0"
            )


def _deciding_bits(memory: Memory, axis: int, *, rotary: bool) -> Iterator[Fault]:
    """Yield a fault for each bit on which the correction of an axis depends (such as 1006#0), if
    its value is not written as eight bits, or if the paths differ in it and the axis' path is
    unknown.
    """
    machine = memory.machine
    moves = memory.moves(axis)
    bits: list[tuple[int, int]] = [(1006, 0)] if moves else []
    bits += [(1001, 0)] if moves and not rotary else []
    system = machine.system(axis)
    if moves and system is not None:
        bits += [(system.number, 0), (system.number, 1)]
    feed, rapid = (memory.whole_if_sound(number, axis) for number in (1851, 1852))
    if rapid is not None and rapid != (feed or 0):
        bits.append((1800, 4))
    for number, bit in bits:
        entry = machine.entry(number, axis)
        if entry is not None and not entry.zero and not entry.is_bits:
            yield entry.fault(f"{number}#{bit} of axis {axis} cannot be read", "eight bits")
        apart = machine.either(number, axis, bit)
        if apart is not None:
            yield apart
