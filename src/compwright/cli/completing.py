"""The command that prints a script with which a shell completes typed words."""

from __future__ import annotations

import click
from click.shell_completion import ShellComplete, get_completion_class

from compwright.cli.saying import print_lines
from compwright.cli.words import compwright, exiting

#: Set by the script while it asks for words; click answers it.
_VARIABLE = "_COMPWRIGHT_COMPLETE"


@compwright.command(
    examples=(
        "compwright completion bash > ~/.local/share/bash-completion/completions/compwright",
        "compwright completion fish > ~/.config/fish/completions/compwright.fish",
    ),
    page="docs/commands.md#completion",
)
@click.argument(
    "shell",
    type=click.Choice(["bash", "zsh", "fish"]),
    help=("The shell for which the completion script is written."),
)
@exiting
def completion(shell: str) -> int:
    """Print a script that completes commands, options, controls and files in a shell."""
    kind = get_completion_class(shell)
    assert kind is not None  # noqa: S101 - the choice above names those of click
    # not the method of bash: it starts a bash to ask for its version
    print_lines([ShellComplete.source(kind(compwright, {}, "compwright", _VARIABLE))])
    return 0
