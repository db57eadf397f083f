"""Virtual controls: programs that read a control's files independently of `formats` and return the
active correction.

This package states sign, unit and interpolation of each control a second time, from the manual. It
shares no code with `formats`, which writes the files. So if both packages agree, this confirms the
files.
"""
