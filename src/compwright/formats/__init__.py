"""Corrections to and from the text that a control loads, driven by the definitions in
``controller_formats``.
"""
