"""The data that packages exchange: immutable records that state their unit, direction and sign.

Inside: positions and deviations in mm (linear) or deg (rotary). Deviation = measured minus target.
Correction = what the control adds to the command.
"""
