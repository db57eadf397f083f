"""Read result folders as entries of a history."""
