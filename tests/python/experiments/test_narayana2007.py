# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The published numbers, the configurations, and the statements that are made from the runs."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import survtrack
from survtrack.evaluation import Boxes, TrackScores, evaluate_tracks
from survtrack.experiments import Dataset, Trial, Variant
from survtrack.experiments.narayana2007 import published, variants
from survtrack.experiments.narayana2007.differences import Statement, statements
from survtrack.experiments.narayana2007.measured import Measured, runs
from survtrack.experiments.narayana2007.reasons import reasons
from survtrack.experiments.narayana2007.vicinity import Learning
from survtrack.experiments.scene import Scene

EVERY = [
    *published.NUMBER_OF_BLOBS.values(),
    *published.INDEX.values(),
    *published.SWAP.values(),
]


def test_totals_of_the_thesis() -> None:
    assert published.TOTAL_INSTANCES == 292
    assert [errors.total for errors in EVERY] == [58, 51, 48, 56, 45, 45, 25, 18, 14]


def test_percentages_of_the_totals_are_the_corrected_ones() -> None:
    corrected = [19.9, 17.5, 16.4, 19.2, 15.4, 15.4, 8.6, 6.2, 4.8]
    assert [round(errors.percent, 1) for errors in EVERY] == corrected


def test_the_thesis_prints_means_of_the_three_percentages() -> None:
    for errors in EVERY:
        each = [
            100 * count / instances
            for count, instances in zip(errors.each, published.INSTANCES, strict=True)
        ]
        # It rounds, or cuts, to one decimal.
        assert errors.printed_percent == pytest.approx(sum(each) / 3, abs=0.11)


def merge_of(merging: str) -> object:
    return variant_of("Euclidean", merging, True).config(0.04).blobs.merge


def test_mergings_are_what_their_names_say() -> None:
    assert isinstance(merge_of("none"), survtrack.NoMergeOptions)
    for merging, threshold, scaled in (
        ("fixed_15", 15, False),
        ("vicinity_published", 10, True),
        ("vicinity_preset", variants.preset_base_px(), True),
    ):
        merge = merge_of(merging)
        assert isinstance(merge, survtrack.CloseMergeOptions)
        assert (merge.threshold_y_px, merge.threshold_x_px) == (threshold, threshold)
        assert merge.vicinity_scaled is scaled


def test_a_scaled_threshold_starts_at_what_the_sweep_says() -> None:
    assert variants.start_factor() == 3
    for name, preset in variants.CORRESPONDENCES.items():
        variant = variants.with_merging(name, variants.scaled(15))
        merge = variant.config(0.04).blobs.merge
        assert variant.preset == preset
        assert isinstance(merge, survtrack.CloseMergeOptions)
        assert (merge.threshold_y_px, merge.vicinity_scaled) == (5, True)


def test_the_velocity_factor_can_be_off_in_both_correspondences() -> None:
    way = variants.mergings()[-1]
    for name in variants.CORRESPONDENCES:
        off, on = (
            variants.Cell(name, way, velocity).variant.config(0.04).cost
            for velocity in (False, True)
        )
        assert isinstance(off, survtrack.BeliefOptions | survtrack.MatchMatrixOptions)
        assert off.velocity_break_point == 0
        assert on == survtrack.preset(variants.CORRESPONDENCES[name]).cost


def test_published_presets_count_in_frames_and_the_default_does_not() -> None:
    period = 1 / 7
    assert variants.PRESETS["narayana2007"].config(period).time_unit_s == period
    default = variants.PRESETS["survtrack"].config(period)
    assert default.to_toml() == survtrack.preset("survtrack").to_toml()


def test_two_of_the_combinations_are_presets_as_they_are_and_run_once() -> None:
    combined = [cell.variant for cell in variants.cells()]
    assert {variants.PRESETS[variants.EUCLIDEAN], variants.PRESETS[variants.BAYESIAN]} <= set(
        combined
    )
    learned = len(variants.FORMS) + len(variants.CORRESPONDENCES) * len(variants.SCALED)
    assert len(set(variants.scored())) == len(variants.scored()) == runs() - learned


def test_grids_are_learned_by_the_mergings_that_they_explain() -> None:
    assert variants.scaled_bases() == {"vicinity_published": 10, "vicinity_preset": 5}
    for name in variants.CORRESPONDENCES:
        for key in variants.SCALED:
            learned = variants.with_grid(name, key).config(0.04)
            assert learned.outputs.vicinity
            learned.set("outputs.vicinity=false")
            assert learned == variant_of(name, key, True).config(0.04)


def blank_scores() -> TrackScores:
    box = Boxes([1], [1], [[0, 0, 10, 20]])
    return evaluate_tracks(box, box)


def learning(factor: float, step: float = 2.5) -> Learning:
    """One cell, updated often, whose factors both end at `factor`, from steps of `step` px."""
    grid = np.full((1, 1, 1), factor)
    return Learning(grid, grid, np.array([[100]]), np.array([[step]]), 5.0)


def measured(errors: dict[Variant, dict[str, int]], constant: float = 5.0) -> Measured:
    """A set on which every run has 10 errors of each kind, but for those given.

    The grid of Bayesian correspondence learns from shorter steps, and its factor is larger.
    """
    usual = {"number_of_blobs_errors": 10, "index_errors": 10, "swap_errors": 10}
    return Measured(
        Dataset("made", "made.mp4", Path("gt.txt"), objects="people"),
        7.0,
        1,
        (10, 10),
        Scene(12.0, 34.0, 3.5, 0.2),
        {
            variant: Trial(replace(blank_scores(), **(usual | errors.get(variant, {}))), 1.0)
            for variant in variants.scored()
        },
        {"settling": learning(2.0), "published_mean": learning(1.0)}
        | {"published_constant": learning(constant)},
        {("Euclidean", key): learning(2.0, 6.0) for key in variants.SCALED}
        | {("Bayesian", key): learning(3.0, 2.5) for key in variants.SCALED},
    )


def variant_of(correspondence: str, merging: str, velocity: bool) -> Variant:
    return variants.Cell(correspondence, variants.merging(merging), velocity).variant


def test_equal_counts_agree_with_no_claim() -> None:
    found = statements(measured({}, constant=2.0))
    assert [one.holds for one in found] == [False] * 16
    assert [one.short for one in found[:-1]] == ["the same"] * 15


def test_claims_name_their_correspondence() -> None:
    """Each that one of them could decide otherwise; of the two others, one compares them."""
    told = [one.claim for one in statements(measured({}))]
    for name in variants.CORRESPONDENCES:
        assert sum(f"{name} correspondence (" in claim for claim in told) == 7
    assert len(set(told)) == len(told) == 16


def blobs(errors: int) -> dict[str, int]:
    return {"number_of_blobs_errors": errors}


def claim(found: list[Statement], words: str, name: str) -> Statement:
    """The one claim with these words, about a correspondence where that is named."""
    named = f"{name} correspondence (" if name else ""
    [one] = [each for each in found if words in each.claim and named in each.claim]
    return one


def test_statements_follow_the_numbers_of_the_run() -> None:
    found = statements(
        measured(
            {
                variant_of("Euclidean", "vicinity_preset", False): {"index_errors": 20},
                variant_of("Bayesian", "vicinity_preset", False): {"swap_errors": 5},
                variant_of("Euclidean", "fixed_15", True): blobs(8),
                variant_of("Euclidean", "vicinity_published", True): blobs(9),
                variant_of("Euclidean", "vicinity_preset", True): blobs(6),
                variant_of("Bayesian", "fixed_20", True): blobs(5),
                variant_of("Bayesian", "vicinity_preset", True): blobs(7),
                variants.with_merging("Bayesian", variants.scaled(12)): blobs(4),
            }
        )
    )
    none, best = (
        "fewer number-of-blobs errors than no",
        "fewer number-of-blobs errors than the best",
    )
    expected = {
        ("by the best fixed", "Euclidean"): (
            True,
            "-20.0 %",
            "10 to 8; of 10, 15, 20 px the best is 15",
        ),
        ("by the best fixed", "Bayesian"): (
            True,
            "-50.0 %",
            "10 to 5; of 10, 15, 20 px the best is 20",
        ),
        ("velocity", "Euclidean"): (True, "-33.3 %", "30 to 20 with the preset's merging"),
        ("velocity", "Bayesian"): (False, "+33.3 %", "15 to 20 with the preset's merging"),
        (f"published base, makes {none}", "Euclidean"): (True, "-10.0 %", "10 to 9"),
        (f"published base, makes {best}", "Euclidean"): (False, "+12.5 %", "8 to 9"),
        (f"published base, makes {none}", "Bayesian"): (False, "the same", "10 to 10"),
        (f"preset's base, makes {none}", "Euclidean"): (True, "-40.0 %", "10 to 6"),
        (f"preset's base, makes {best}", "Euclidean"): (True, "-25.0 %", "8 to 6"),
        (f"preset's base, makes {none}", "Bayesian"): (True, "-30.0 %", "10 to 7"),
        (f"preset's base, makes {best}", "Bayesian"): (
            False,
            "+40.0 %",
            "5 to 7; of 10, 15, 20 px",
        ),
        ("of all thresholds", "Euclidean"): (False, "+12.5 %", "8 to 9; fixed 15 px, scaled 30 px"),
        ("of all thresholds", "Bayesian"): (True, "-20.0 %", "5 to 4; fixed 20 px, scaled 12 px"),
        ("Bayesian correspondence makes", ""): (False, "the same", "20 to 20; HOTA 100.0 to 100.0"),
        ("eq. 6.4", ""): (True, "0 to 2", "factors at a clamp"),
    }
    for (words, name), (holds, short, numbers) in expected.items():
        one = claim(found, words, name)
        assert (one.holds, one.short) == (holds, short), words
        assert one.numbers.startswith(numbers)
    assert "a base of 4.0 px" in claim(found, "of all thresholds", "Bayesian").numbers
    assert "lower with 1 of 6 mergings" in claim(found, "velocity", "Euclidean").numbers
    assert "lower with 0 of 6 mergings" in claim(found, "velocity", "Bayesian").numbers


def test_reasons_are_those_that_the_numbers_support() -> None:
    told = "\n".join(reasons(measured({})))
    assert "What moves is people" in told
    assert "20 % of the true boxes overlap" in told
    assert "7 frames/s" in told
    assert "at most 3.5 px long beside a break-point of 10 px" in told
    assert "fragments, or" not in told  # 1.0 tracks per box
    assert "Bayesian" not in told  # as many numbers as Euclidean, as many number-of-blobs errors
    wide = replace(measured({}), fps=25.0, scene=Scene(50.0, 90.0, 12.0, 0.0))
    assert [reason[:10] for reason in reasons(wide)] == ["What moves"]


def test_where_the_vicinity_factor_fails_the_report_says_why_and_what_would_not() -> None:
    """12 errors with the preset's base beside 10: it reaches 15 px, the best fixed is 8 px."""
    worse = {variant_of("Bayesian", "vicinity_preset", True): blobs(12)}
    short = {variants.with_merging("Bayesian", variants.fixed(8)): blobs(9)}
    [told] = [one for one in reasons(measured(worse | short)) if "base" in one]
    assert told.startswith("Preset's base, Bayesian correspondence: 12 number-of-blobs errors, 10")
    assert "learned from 1 tracks, steps of 2.5 px per frame on average, a factor of 3.0" in told
    assert "(Euclidean: 1 tracks, steps of 6.0 px per frame on average, a factor of 2.0)" in told
    assert "95 % of the true steps are at most 3.5 px: longer ones" in told
    assert "5 px reach 15 px on average, 1.2 widths and 0.4 heights" in told
    assert "the best fixed threshold of the sweep is 8 px: too far" in told
    assert "No base of the sweep, 0.7 to 10.0 px, would make the claim hold; the best, 0.7" in told
    far = {variants.with_merging("Bayesian", variants.fixed(30)): blobs(8)}
    found = {variants.with_merging("Bayesian", variants.scaled(12)): blobs(9)}
    [told] = [one for one in reasons(measured(worse | far | found)) if "base" in one]
    assert "the best fixed threshold of the sweep is 30 px: not far enough" in told
    assert "A base of 4.0 px would make the claim hold: 9." in told
    even = replace(measured(worse), scene=Scene(12.0, 34.0, 7.0, 0.2))
    assert not any("longer ones" in one for one in reasons(even))


def test_cells_at_a_clamp_and_the_busiest() -> None:
    factors = np.array([[[3.0, 3.0, 3.0]], [[1.0, 2.0, 5.0]]])
    steps = np.array([[1.0, 2.0, 4.0]])
    grid = Learning(factors, factors[:, :, ::-1], np.array([[40, 60, 10]]), steps, 5.0)
    assert grid.at_clamp() == (2, 4)  # 1 and 5 of the first cell; the third was updated too little
    assert grid.busiest(2) == [(0, 1), (0, 0)]
    assert grid.mean_factor == pytest.approx((40 * 3 + 60 * 2 + 10 * 3) / 110)
    assert grid.mean_step_px == pytest.approx((40 * 1 + 60 * 2 + 10 * 4) / 110)
    never = Learning(factors, factors, np.zeros((1, 3), np.int64), steps, 5.0)
    assert (never.busiest(2), never.at_clamp(), never.mean_factor) == ([], (0, 0), 1.0)
    assert never.mean_step_px == 0
