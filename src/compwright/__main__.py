"""Run the command line as ``python -m compwright``."""

from compwright.cli import main

if __name__ == "__main__":
    main()
