"""The common data of all rooms: immutable records that contain their own unit, direction, sign and
origin.

Inside: positions and deviations in mm (linear) or deg (rotary). Deviation = measured minus target.
Correction = what the control adds to the command.
"""
