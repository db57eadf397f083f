"""Family of scripts with repeating tables. Values are whole fractions of an encoder count."""
