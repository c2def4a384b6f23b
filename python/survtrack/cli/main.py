# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The program `survtrack`."""

import os
from collections.abc import Sequence
from typing import Annotated

import typer

import survtrack
from survtrack.cli.evaluate import evaluate, evaluate_masks
from survtrack.cli.find import find
from survtrack.cli.link import link
from survtrack.cli.messages import exit_code, one_line, print_error
from survtrack.cli.patterns import patterns
from survtrack.cli.presets import presets
from survtrack.cli.replay import replay
from survtrack.cli.reproduce import reproduce
from survtrack.cli.run import run
from survtrack.cli.scene import scene
from survtrack.cli.segment import segment
from survtrack.cli.tune_noise import tune_noise_command

TRACEBACK = "SURVTRACK_TRACEBACK"

app = typer.Typer(
    name="survtrack",
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)
app.command("run")(run)
app.command("segment")(segment)
app.command("link")(link)
app.command("patterns")(patterns)
app.command("find")(find)
app.command("replay")(replay)
app.command("evaluate")(evaluate)
app.command("evaluate-masks")(evaluate_masks)
app.command("reproduce")(reproduce)
app.command("scene")(scene)
app.command("tune-noise")(tune_noise_command)
app.command("presets")(presets)


def _print_version(wanted: bool) -> None:
    if wanted:
        print(f"survtrack {survtrack.__version__}")
        raise typer.Exit


@app.callback()
def survtrack_command(
    version: Annotated[
        bool,
        typer.Option(
            "--version", callback=_print_version, is_eager=True, help="Print the version and exit."
        ),
    ] = False,
) -> None:
    """Track moving objects with one static camera, explainably and without a GPU.

    Exit codes: 0 done, 1 something failed, 2 wrong use, 130 or 143 interrupted.
    SURVTRACK_TRACEBACK=1 shows where in the program an error came from.
    """


def main(args: Sequence[str] | None = None) -> int:
    """Run the command line; returns the exit code.

    Args:
        args: what follows the program's name; sys.argv's when None.
    """
    # Broken images are told of in our own words.
    os.environ.setdefault("OPENCV_LOG_LEVEL", "SILENT")
    command = typer.main.get_command(app)
    try:
        code = command.main(args=args, prog_name="survtrack", standalone_mode=False)
        return code if isinstance(code, int) else 0
    except typer.Abort:
        return _fail("interrupted", 130)
    except Exception as error:
        if os.environ.get(TRACEBACK) == "1":
            raise
        return _fail(*_told(error))


def _told(error: Exception) -> tuple[str, int]:
    """Message and exit code; typer's own errors carry both."""
    if hasattr(error, "format_message") and hasattr(error, "exit_code"):
        context = getattr(error, "ctx", None)
        hint = f" (see {context.command_path} -h)" if context is not None else ""
        return f"{error.format_message()}{hint}", int(error.exit_code)
    return one_line(error), exit_code(error)


def _fail(message: str, code: int) -> int:
    print_error(message)
    return code
