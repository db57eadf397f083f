"""What a definition of a control says: schema, how it is read, options, line templates."""
