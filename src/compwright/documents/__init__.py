"""Write and read JSON documents. Only this room converts units to those of the JSON."""
