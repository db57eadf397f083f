"""Virtual controls: what a control does with the files it is given, read by a second, independent
reader.

Sign, unit and interpolation of each control are stated here a second time, from its manual. Nothing
is shared with the room that writes the files: where both agree, the agreement means something.
"""
