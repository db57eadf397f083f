"""The public library ``compwright``, which calls the same functions as the commands."""
