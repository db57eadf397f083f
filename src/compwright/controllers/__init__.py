"""Virtual controls: programs that read a control's files independently of `formats` and return the
active correction.

Sign, unit and interpolation of each control are stated here a second time, from its manual. Nothing
is shared with the room that writes the files: where both agree, the agreement means something.
"""
