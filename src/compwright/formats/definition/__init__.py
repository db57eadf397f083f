"""The definition of a control: schema, reading, options, line templates."""
