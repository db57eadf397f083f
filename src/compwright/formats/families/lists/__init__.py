"""ISG kernel: tables in value lists, one list for each axis, with a header that names the axis."""
