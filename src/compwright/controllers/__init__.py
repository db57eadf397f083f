"""Virtual controls: what a control does with given files. A second, independent reader reads these
files.

Sign, unit and interpolation of each control are stated here a second time, from its manual. Nothing
is shared with the room that writes the files: where both agree, the agreement means something.
"""
