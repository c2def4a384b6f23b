# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What the dissertation says of q, and whether the numbers of this run say the same."""

from itertools import pairwise

from survtrack.experiments.nashenda2011 import published, sweep
from survtrack.experiments.nashenda2011.filters import Way
from survtrack.experiments.nashenda2011.footage import OnFootage
from survtrack.experiments.nashenda2011.simulated import Made
from survtrack.experiments.semko2007.claims import Claim

OFF_PX = 10.0  # an estimate that is further off does not reach the real state
BARELY = 0.05  # relative difference that counts as none
GAP = 2  # frames, figure 21
SAID_OF: tuple[tuple[str, Way], ...] = (
    ("steady", "published"),
    ("steady", "corrected"),
    ("manoeuvring", "corrected"),
)


def claims(made: Made, every: list[OnFootage]) -> list[Claim]:
    """All statements, those about footage for each set."""
    told = [_matrices(made), _accuracy(), *_never_reached(made), *_rises(made)]
    told += [_little_after_50(made), *_occlusion(made)]
    return told + [claim for one in every for claim in _on_footage(one)]


def _matrices(made: Made) -> Claim:
    largest = max(one.largest for one in made.matrices)
    return Claim(
        "The printed matrices are those of the recursion, to 4 decimals but for one misprint",
        all(one.same for one in made.matrices),
        f"{len(made.matrices)} matrices, largest difference {largest:.6f}",
    )


def _accuracy() -> Claim:
    """6.1: of the measurement, since no truth is known."""
    each = [1 - (at - to) / to for at, to in zip(published.ESTIMATE, published.ENTERS, strict=True)]
    return Claim(
        "q = 100: 367.62 for 367 and 274.70 for 274 are 99.83 % and 99.75 %",
        all(abs(one - of) < 0.5e-4 for one, of in zip(each, published.ACCURACY, strict=True)),
        f"{100 * each[0]:.2f} % and {100 * each[1]:.2f} %, of a measurement, and of a coordinate: "
        f"{published.ESTIMATE[0] - published.ENTERS[0]:.2f} and "
        f"{published.ESTIMATE[1] - published.ENTERS[1]:.2f} px off",
    )


def _never_reached(made: Made) -> list[Claim]:
    """5.1.1, 5.1.2."""
    told = []
    for q in (0.0, 1.0):
        for name, way in SAID_OF:
            px = made.sweep[name][way][q].truth_px
            told.append(
                Claim(
                    f"With q = {q:g} the estimate cannot reach the real state; {name}, {way}",
                    px > OFF_PX,
                    f"rms {px:.2f} px",
                )
            )
    return told


def _rises(made: Made) -> list[Claim]:
    """6.3: performance is proportional to q."""
    told = []
    for name in sweep.TARGETS:
        of = made.sweep[name]["corrected"]
        for to, each in (
            ("measurement", [of[q].measured_px for q in published.SWEEP]),
            ("truth", [of[q].truth_px for q in published.SWEEP]),
        ):
            told.append(
                Claim(
                    f"The higher q, the smaller the error to the {to}; {name}, corrected",
                    falling(each),
                    ", ".join(f"{px:.2f}" for px in each) + " px",
                )
            )
    return told


def falling(values: list[float]) -> bool:
    """Whether each is below the one before."""
    return all(later < value for value, later in pairwise(values))


def _little_after_50(made: Made) -> Claim:
    of = made.sweep["manoeuvring"]["corrected"]
    low, high = of[50.0].truth_px, of[100.0].truth_px
    return Claim(
        "q = 100 differs little from q = 50",
        abs(high - low) <= BARELY * low,
        f"rms {low:.2f} and {high:.2f} px, manoeuvring, corrected",
    )


def _occlusion(made: Made) -> list[Claim]:
    """6.2: q = 50 and q = 100 are best in an occlusion."""
    told = []
    for name in sweep.TARGETS:
        each = {q: by[GAP].during for q, by in made.gaps[name]["ours"].items()}
        best = min(each, key=each.__getitem__)
        numbers = ", ".join(f"q = {q:g}: {px:.2f}" for q, px in each.items())
        told.append(
            Claim(
                f"Through an occlusion of {GAP} frames q = 50 or 100 is the best; {name}",
                best >= 50,
                f"rms distance in its last frame, {numbers} px",
            )
        )
    return told


def _on_footage(one: OnFootage) -> list[Claim]:
    of = one.errors["corrected"]
    told = []
    for to, each in (
        ("measurement", [of[q].measured_px for q in published.SWEEP]),
        ("truth", [of[q].truth_px for q in published.SWEEP]),
        ("truth when 2 frames are hidden", [of[q].hidden_px for q in published.SWEEP]),
    ):
        told.append(
            Claim(
                f"{one.name}: the higher q, the smaller the distance to the {to}",
                falling(each),
                ", ".join(f"{px:.2f}" for px in each) + " px",
            )
        )
    return told
