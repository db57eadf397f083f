"""Virtual controls: independent readers of a control's files, which return its active correction.

Sign, unit and interpolation of each control are stated here a second time, from its manual. Nothing
is shared with the room that writes the files: where both agree, the agreement means something.
"""
