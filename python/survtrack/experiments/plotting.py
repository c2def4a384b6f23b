# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Plots with matplotlib, an optional dependency that is imported when the first one is made."""

import io
from typing import TYPE_CHECKING

from survtrack.errors import SurvtrackError

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

# Okabe and Ito's colours, which readers with any colour vision tell apart; markers and dashes
# repeat what they say.
BLUE, ORANGE, GREEN, GREY = "#0072B2", "#D55E00", "#009E73", "#555555"
WIDTH_IN, DPI = 8.0, 110  # 880 px: as wide as a README is shown


def require_matplotlib() -> None:
    """Raise SurvtrackError that says what to install when there is no matplotlib."""
    try:
        import matplotlib.figure  # noqa: F401
    except ImportError as error:
        raise SurvtrackError("plots need matplotlib: pip install survtrack[plot]") from error


def new_figure(height_in: float) -> "Figure":
    """An empty figure that no window or global state of matplotlib knows of."""
    require_matplotlib()
    from matplotlib.figure import Figure

    return Figure(figsize=(WIDTH_IN, height_in), dpi=DPI, layout="constrained")


def plain(axes: "Axes") -> None:
    """Only the lines that help to read a value."""
    axes.spines[["top", "right"]].set_visible(False)
    axes.grid(axis="y", color="#DDDDDD", linewidth=0.8)
    axes.set_axisbelow(True)


def png(figure: "Figure") -> bytes:
    """The figure as a PNG file, the same bytes for the same figure; Agg draws it."""
    data = io.BytesIO()
    figure.savefig(data, format="png", backend="agg", metadata={"Software": None})
    return data.getvalue()
