"""Family of tables with whole increments by section, in one array of points that all axes share."""
