# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The peers' side, in an environment and a process of its own."""

import json
import subprocess
from pathlib import Path
from types import TracebackType
from typing import Any, Self

RECIPE = Path(__file__).with_name("recipe.py")


class Peers:
    """Runs recipe.py with the peers' Python; one request at a time, so that rounds interleave."""

    def __init__(self, python: Path) -> None:
        self._process = subprocess.Popen(
            [python, RECIPE], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )

    def ask(self, **request: Any) -> dict[str, Any]:
        """What recipe.py answers; raises RuntimeError when it has ended."""
        assert self._process.stdin and self._process.stdout
        try:
            self._process.stdin.write(json.dumps(request) + "\n")
            self._process.stdin.flush()
        except BrokenPipeError:
            raise RuntimeError("the peers' process has ended") from None
        line = self._process.stdout.readline()
        if not line:
            raise RuntimeError(f"the peers' process ended on {request}")
        return dict(json.loads(line))

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._process.communicate()
