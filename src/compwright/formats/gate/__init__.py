"""What every definition has to pass."""
