"""Show documents as terminal text, plots, HTML and commissioning card. This room computes
nothing.
"""
