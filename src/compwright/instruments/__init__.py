"""Read measurement files as records, from bytes. The entry is `compwright.instruments.reading`."""
