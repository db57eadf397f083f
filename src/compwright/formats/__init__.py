"""Convert corrections to and from the text that a control loads, by the definitions in
``controller_formats``.
"""
