"""From test results to decisions: wanted correction, table, and the improvement to expect."""
