"""Write and read JSON documents. Only this package converts units to those of the JSON."""
