# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What the report says of its filter, and whether the numbers of this run say the same."""

import math

from survtrack.experiments.omalley2000 import published, region_trials
from survtrack.experiments.omalley2000.footage_runs import Read
from survtrack.experiments.omalley2000.measured import Made
from survtrack.experiments.semko2007.claims import Claim


def claims(made: Made, read: list[Read]) -> list[Claim]:
    """All statements."""
    text, listing = made.errors["text"], made.errors["listing"]
    raw_t, raw_v_s, raw_v_t = made.raw
    travel = published.START[2] * published.PERIOD_S
    part = text.worst_s / published.LENGTH
    return [
        Claim(
            "The predicted S is at most 1.4 % of the length from the measured one (figure 6), here",
            part < published.LARGEST_ERROR + 0.0005,
            f"{100 * part:.2f} % by the text's values, "
            f"{100 * listing.worst_s / published.LENGTH:.2f} % by the listing's",
        ),
        Claim(
            "The filter makes T smoother (figure 9)",
            text.t < raw_t,
            f"rms error {text.t:.3f}, measured {raw_t:.3f}",
        ),
        Claim(
            "The filter makes vT smoother (figure 8)",
            text.v_t < raw_v_t,
            f"rms error {text.v_t:.3f}, raw {raw_v_t:.3f} per s",
        ),
        Claim(
            "The filtered vS is nearer to the truth than the raw one (figure 7)",
            text.v_s < raw_v_s,
            f"rms error {text.v_s:.2f}, listing's values {listing.v_s:.2f}, raw {raw_v_s:.2f} "
            "per s",
        ),
        Claim(
            "3 sigma_S of the prediction hold the car (2.3)",
            text.within > 0.99,
            f"in {100 * text.within:.0f} % of the frames: 3 sigma_S are {text.three_sigma_s:.2f}, "
            f"a frame's way {travel:.2f}, the worst error {text.worst_s:.2f}",
        ),
        *_of_regions(made),
        *(_of_footage(one) for one in read if one.runs["3 sigmas"].scores is not None),
    ]


def _of_footage(one: Read) -> Claim:
    whole, parts = one.runs["whole frame"], one.runs["3 sigmas"]
    assert whole.scores is not None and parts.scores is not None
    return Claim(
        f"{one.name}: at most half of the pixels are read for at most one point of MOTA",
        parts.pixels <= 0.5 and parts.scores.mota >= whole.scores.mota - 1,
        f"{100 * parts.pixels:.0f} %, MOTA {parts.scores.mota:.1f} against {whole.scores.mota:.1f}",
    )


def _of_regions(made: Made) -> list[Claim]:
    printed = made.regions.one("text", "published", 3.0)
    ours = made.regions.one("identified", "whole object", 3.0)
    rate, saving = region_trials.WANTED_RATE, region_trials.WANTED_SAVING
    return [
        Claim(
            "The whole car is never outside of its region (4), by the printed values and rule",
            bool(printed.looked.hits.all()),
            f"inside in {100 * printed.looked.hit_rate:.1f} % of the frames, lost "
            f"{printed.looked.losses} times",
        ),
        Claim(
            f"Regions that hold the whole object in {100 * rate:.0f} % of the frames or more read "
            f"{100 * saving:.0f} % less than the smallest constant box that does so as often",
            ours.looked.hit_rate >= rate and ours.saving >= saving,
            f"identified values, 3 sigmas: {100 * ours.looked.hit_rate:.2f} %, "
            f"{100 * ours.saving:.0f} % less",
        ),
        *_of_films(made),
        Claim(
            "On data drawn from the model the hit rate is that of theory, to a percent",
            all(abs(inside - theory) < 0.01 for inside, theory in made.regions.drawn.values()),
            ", ".join(
                f"{sigmas:g} sigmas {100 * inside:.1f} ({100 * theory:.1f}) %"
                for sigmas, (inside, theory) in made.regions.drawn.items()
            ),
        ),
    ]


def _of_films(made: Made) -> list[Claim]:
    rate, saving = region_trials.WANTED_RATE, region_trials.WANTED_SAVING
    text, ours = made.filmed
    return [
        *(
            Claim(
                f"The same through the whole pipeline, by the preset {one.preset}",
                one.hit_rate >= rate and one.saving >= saving,
                f"{100 * one.hit_rate:.2f} %, in the worst drive "
                f"{100 * one.worst_hit_rate:.2f} %; {_less(one.saving)}, "
                f"{100 * one.pixels:.1f} % of the pixels read",
            )
            for one in (text, ours)
        ),
        Claim(
            f"The same by {ours.preset} beside constant boxes fitted to each drive afterwards",
            ours.hit_rate >= rate and ours.saving_of_fitted >= saving,
            f"{100 * ours.hit_rate:.2f} %, {_less(ours.saving_of_fitted)}",
        ),
    ]


def _less(saving: float) -> str:
    if math.isnan(saving):
        return "never followed"
    return f"{abs(100 * saving):.0f} % {'less' if saving >= 0 else 'more'}"
