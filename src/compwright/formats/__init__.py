"""Convert corrections to the text that a control loads, and such text to corrections; the files in
``controller_formats`` define the text of each control.
"""
