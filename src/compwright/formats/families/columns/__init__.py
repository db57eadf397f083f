"""Controls whose tables are files exported by the user, with one column for each corrected axis."""
