"""The shapes of compensation tables: a folder for each family of controls, one interface."""
