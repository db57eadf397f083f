"""SINUMERIK cross-axis tables (CEC), which correct an axis by its own or another axis' position."""
