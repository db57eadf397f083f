"""FANUC pitch error data: whole increments between points, in one array that all axes share."""
