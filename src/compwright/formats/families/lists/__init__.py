"""Family of tables in one list per axis. Entries have an index; the header names the axis."""
