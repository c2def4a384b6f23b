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
    [way] = [one for one in variants.mergings() if one.key == merging]
    return variants.Cell("Euclidean", way, True).variant.config(0.04).blobs.merge


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
    merge = variants.with_merging(variants.scaled(15)).config(0.04).blobs.merge
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
    assert len(set(variants.scored())) == len(variants.scored()) == runs() - len(variants.FORMS)


def blank_scores() -> TrackScores:
    box = Boxes([1], [1], [[0, 0, 10, 20]])
    return evaluate_tracks(box, box)


def learning(factor: float) -> Learning:
    """One cell, updated often, whose factors both end at `factor`."""
    grid = np.full((1, 1, 1), factor)
    return Learning(grid, grid, np.array([[100]]), 5.0)


def measured(errors: dict[Variant, dict[str, int]], constant: float = 5.0) -> Measured:
    """A set on which every run has 10 errors of each kind, but for those given."""
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
    )


def variant_of(correspondence: str, merging: str, velocity: bool) -> Variant:
    [way] = [one for one in variants.mergings() if one.key == merging]
    return variants.Cell(correspondence, way, velocity).variant


def test_equal_counts_agree_with_no_claim() -> None:
    found = statements(measured({}, constant=2.0))
    assert [one.holds for one in found] == [False] * 10
    assert [one.short for one in found[:-1]] == ["the same"] * 9


def claim(found: list[Statement], words: str) -> Statement:
    [one] = [each for each in found if words in each.claim]
    return one


def test_statements_follow_the_numbers_of_the_run() -> None:
    found = statements(
        measured(
            {
                variant_of("Euclidean", "vicinity_preset", False): {"index_errors": 20},
                variant_of("Bayesian", "vicinity_preset", False): {"swap_errors": 5},
                variant_of("Euclidean", "fixed_15", True): {"number_of_blobs_errors": 8},
                variant_of("Euclidean", "vicinity_published", True): {"number_of_blobs_errors": 9},
                variant_of("Euclidean", "vicinity_preset", True): {"number_of_blobs_errors": 6},
            }
        )
    )
    expected = {
        "merging by the best fixed": (True, "-20.0 %", "10 to 8; of 10, 15, 20 px the best is 15"),
        "index + swap errors, Euclidean": (True, "-33.3 %", "30 to 20 with the preset's merging"),
        "index + swap errors, Bayesian": (False, "+33.3 %", "15 to 20 with the preset's merging"),
        "published base, makes fewer number-of-blobs errors than no": (True, "-10.0 %", "10 to 9"),
        "published base, makes fewer number-of-blobs errors than the": (False, "+12.5 %", "8 to 9"),
        "preset's base, makes fewer number-of-blobs errors than no": (True, "-40.0 %", "10 to 6"),
        "preset's base, makes fewer number-of-blobs errors than the": (True, "-25.0 %", "8 to 6"),
        "Bayesian correspondence makes fewer": (False, "the same", "20 to 20; HOTA 100.0 to 100.0"),
        "eq. 6.4": (True, "0 to 2", "factors at a clamp"),
    }
    for words, (holds, short, numbers) in expected.items():
        one = claim(found, words)
        assert (one.holds, one.short) == (holds, short), words
        assert one.numbers.startswith(numbers)
    assert "lower with 1 of 6 mergings" in claim(found, "errors, Euclidean").numbers
    assert "lower with 0 of 6 mergings" in claim(found, "errors, Bayesian").numbers


def test_reasons_are_those_that_the_numbers_support() -> None:
    worse = {"number_of_blobs_errors": 12}
    base = variant_of("Euclidean", "vicinity_published", True)
    told = "\n".join(reasons(measured({base: worse})))
    assert "What moves is people" in told
    assert "10 px times a vicinity factor of 2.0 on average at the end is 20 px: 1.7 widths" in told
    assert "20 % of the true boxes overlap" in told
    assert "7 frames/s" in told
    assert "at most 3.5 px long beside a break-point of 10 px" in told
    assert "fragments, or" not in told  # 1.0 tracks per box
    assert "Bayesian" not in told  # as many numbers as Euclidean
    wide = replace(measured({}), fps=25.0, scene=Scene(50.0, 90.0, 12.0, 0.0))
    assert [reason[:10] for reason in reasons(wide)] == ["What moves"]


def test_cells_at_a_clamp_and_the_busiest() -> None:
    factors = np.array([[[3.0, 3.0, 3.0]], [[1.0, 2.0, 5.0]]])
    grid = Learning(factors, factors[:, :, ::-1], np.array([[40, 60, 10]]), 5.0)
    assert grid.at_clamp() == (2, 4)  # 1 and 5 of the first cell; the third was updated too little
    assert grid.busiest(2) == [(0, 1), (0, 0)]
    assert grid.mean_factor == pytest.approx((40 * 3 + 60 * 2 + 10 * 3) / 110)
    never = Learning(factors, factors, np.zeros((1, 3), np.int64), 5.0)
    assert (never.busiest(2), never.at_clamp(), never.mean_factor) == ([], (0, 0), 1.0)
