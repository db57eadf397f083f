#!/usr/bin/python3
"""The display program of a LinuxCNC without a screen: drives to stops and writes down what the
control applies.

Started by LinuxCNC itself as ``display.py -ini INI STOPS RESULT``, with the system's Python (the
only one that has the modules ``linuxcnc`` and ``hal``). STOPS is JSON: ``{"letters": "XA", "stops":
[[x, a], ...], "patience": 1.0}``, one position per joint, in machine units; every time limit is
multiplied by the patience. RESULT is JSON: ``{"came_up": bool, "trouble": text, "messages": [text,
...], "stops": [[joint values], ...]}``, each joint value a list of commanded position, motor
position less motor offset, applied correction, and motor position; a stop that was not reached is
missing.
``came_up``: homed and ready to be driven.
"""

from __future__ import annotations

import contextlib
import json
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path

import hal  # type: ignore[import-not-found]  # modules of LinuxCNC, for the system's Python only
import linuxcnc  # type: ignore[import-not-found]

POSITION_REACHED = 1e-6  # machine units; the planner itself ends within 1e-9
QUIET_READINGS = 4  # the command counts as complete one servo tick before standstill
SERVO_PERIOD = 0.001  # s


class TroubleError(Exception):
    """What went wrong, in words."""


def wait(
    condition: Callable[[], bool], seconds: float, what: str, pause: float = SERVO_PERIOD
) -> None:
    """Return when ``condition`` holds; raise TroubleError when it does not within ``seconds``."""
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            raise TroubleError(what)
        time.sleep(pause)


class Machine:
    """The running control, seen through its channels and pins."""

    def __init__(self, letters: str, patience: float) -> None:
        self.letters = letters
        self.patience = patience
        self.joints = range(len(letters))
        self.command = linuxcnc.command()
        self.status = linuxcnc.stat()
        self.errors = linuxcnc.error_channel()
        self.messages: list[str] = []
        self.component = hal.component(
            "watcher"
        )  # pins can be read only by a program that is a component
        self.component.ready()

    def pin(self, joint: int, name: str) -> float:
        return float(hal.get_value(f"joint.{joint}.{name}"))

    def collect_messages(self) -> None:
        message = self.errors.poll()
        while message:
            if message[0] in (linuxcnc.NML_ERROR, linuxcnc.OPERATOR_ERROR):
                self.messages.append(message[1])
            message = self.errors.poll()

    def is_up(self) -> bool:
        self.collect_messages()
        self.status.poll()
        return bool(self.status.joints > 0 and self.status.exec_state == linuxcnc.EXEC_DONE)

    def is_homed(self) -> bool:
        self.status.poll()
        return all(self.status.homed[joint] for joint in self.joints)

    def start(self) -> None:
        wait(self.is_up, 12 * self.patience, "the control did not come up", pause=0.02)
        for state in (linuxcnc.STATE_ESTOP_RESET, linuxcnc.STATE_ON):
            self.command.state(state)
            self.command.wait_complete()
        self.command.home(-1)
        wait(self.is_homed, 10 * self.patience, "homing did not end")
        self.command.mode(linuxcnc.MODE_MDI)
        self.command.wait_complete()
        metric = self.status.linear_units > 0.5
        self.command.mdi("G21 G90 G94 G54" if metric else "G20 G90 G94 G54")
        self.command.wait_complete()
        self.offsets = [self.pin(joint, "motor-offset") for joint in self.joints]

    def is_quiet(self, targets: Sequence[float]) -> bool:
        return all(
            self.pin(joint, "vel-cmd") == 0.0
            and abs(self.pin(joint, "pos-cmd") - targets[joint]) < POSITION_REACHED
            # a step that the control never applies keeps the correction from its target for ever
            and self.pin(joint, "backlash-vel") == 0.0
            for joint in self.joints
        )

    def drive(self, targets: Sequence[float]) -> list[list[float]]:
        """Go to a stop and return what each joint shows there."""
        words = " ".join(
            f"{letter}{target:.9f}" for letter, target in zip(self.letters, targets, strict=True)
        )
        self.command.mdi("G53 G0 " + words)
        self.command.wait_complete(60 * self.patience)
        quiet = 0
        end = time.monotonic() + 10 * self.patience
        while quiet < QUIET_READINGS:
            quiet = quiet + 1 if self.is_quiet(targets) else 0
            if time.monotonic() > end:
                raise TroubleError(f"no standstill at {targets}")
            time.sleep(SERVO_PERIOD / 2)
        return [self.reading(joint) for joint in self.joints]

    def reading(self, joint: int) -> list[float]:
        position = self.pin(joint, "pos-cmd")
        place = self.pin(joint, "motor-pos-cmd")
        applied = self.pin(joint, "backlash-filt")
        return [position, place - self.offsets[joint], applied, place]


def main(stops_file: str, result_file: str) -> None:
    wanted = json.loads(Path(stops_file).read_text())
    machine = Machine(
        wanted["letters"], wanted["patience"]
    )  # without channels there is no result: started again
    came_up = False
    trouble = ""
    stops = []
    try:
        machine.start()
        came_up = True
        for targets in wanted["stops"]:
            # # what was reached before trouble stays
            stops.append(machine.drive(targets))  # noqa: PERF401
    except (TroubleError, linuxcnc.error) as error:
        trouble = str(error)
    with contextlib.suppress(linuxcnc.error):
        machine.collect_messages()
    Path(result_file).write_text(
        json.dumps(
            {"came_up": came_up, "trouble": trouble, "messages": machine.messages, "stops": stops}
        )
    )


main(*sys.argv[3:5])
