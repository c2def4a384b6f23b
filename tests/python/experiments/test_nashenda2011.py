# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The sweep of Q: printed matrices, simulations, gaps, errata, footage, and the report."""

import json
import math
from itertools import pairwise
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

import survtrack
from clips import walking_square, write_images
from survtrack.cli.main import main
from survtrack.errors import UsageError
from survtrack.evaluation import Boxes
from survtrack.experiments import Dataset, Footage, find_datasets, load
from survtrack.experiments.nashenda2011 import (
    filters,
    gaps,
    listing,
    matrices,
    published,
    simulated,
    sweep,
    targets,
    walk,
)
from survtrack.experiments.nashenda2011.claims import claims, falling
from survtrack.experiments.nashenda2011.config import preset_config
from survtrack.experiments.nashenda2011.errata import ERRATA, Erratum, measure_errata
from survtrack.experiments.nashenda2011.footage import measure, measurements
from survtrack.experiments.nashenda2011.footage_runs import Runs

TICKS: list[int] = []
STILL, COUNT, WIDTH, FPS = 6, 126, 280, 25.0


def footage(truth: Boxes, *, frames: int = COUNT) -> Footage:
    images = walking_square(frames, width=WIDTH, height=96, side=24, still=STILL)
    size = (WIDTH, 96)
    return Footage(Dataset("made", "made", Path("gt.txt")), images, FPS, size, size, truth)


def truth_of_square(frames: int = COUNT) -> Boxes:
    rows = range(STILL, frames)
    boxes = [[4 + 2 * (k - STILL), 32, 24, 24] for k in rows]
    return Boxes([k + 1 for k in rows], [7] * len(rows), boxes)


@pytest.fixture(scope="module")
def errata() -> dict[str, Erratum]:
    return {one.key: one for one in measure_errata()}


@pytest.fixture(scope="module")
def made() -> simulated.Made:
    return simulated.measure(TICKS.append)


def test_the_printed_matrices_are_those_of_the_library() -> None:
    every = matrices.compare()
    assert len(every) == 6
    assert all(one.same for one in every)
    [misprinted] = [one for one in every if one.misprint is not None]
    assert misprinted.misprint == (11.1871, pytest.approx(1.1871, abs=5e-5))
    # The comparison can fail: other updates of q = 0, and the printed numbers without B u or R.
    assert matrices.recursion(0.0, 107)["K"][0, 0] > 0.0366
    right = filters.one(10.0, "corrected")
    for _ in range(published.FRAMES):
        right.predict([1.0])
        right.update(published.ENTERS)
    assert abs(right.K[0, 0] - 0.9946) > 1e-3


def test_filters_run_as_many_as_one() -> None:
    """estimates() is one() step by step, and the first a priori state is the start itself."""
    z = np.random.default_rng(5).normal(150, 20, (12, 3, 2))
    z[7:9] = np.nan
    for way in filters.WAYS:
        many = filters.estimates(z, 10.0, way)
        for run in range(3):
            alone = filters.one(10.0, way)
            for k in range(12):
                alone.predict([1.0 if k else 0.0])
                if not np.isnan(z[k, run, 0]):
                    alone.update(z[k, run])
                np.testing.assert_allclose(many[k, run], alone.x[:2], rtol=0, atol=1e-9)


def test_the_port_is_right_but_for_its_fault() -> None:
    z = np.random.default_rng(3).normal(200, 9, (30, 4, 2))
    for q in published.SWEEP:
        port = listing.ListingFilter(filters.MIDDLE, q, runs=4)
        answers = np.stack([port.predict() if k % 7 == 5 else port.step(z[k]) for k in range(30)])
        seen = z.copy()
        seen[5::7] = np.nan
        np.testing.assert_allclose(answers, filters.estimates(seen, q, "corrected"), atol=1e-8)
    port = listing.ListingFilter(
        filters.MIDDLE, 10.0, runs=4, R=published.R, control=published.INPUT
    )
    answers = np.stack([port.step(row) for row in z])
    np.testing.assert_allclose(answers, filters.estimates(z, 10.0, "published"), atol=1e-8)


def test_targets_are_where_they_are_said_to_be() -> None:
    steady = targets.steady(10)
    assert np.diff(steady[:, 0], axis=0) == pytest.approx(
        np.tile(targets.VELOCITY * published.PERIOD_S, (9, 1))
    )
    pushed = targets.manoeuvring(300, 5, 20.0, seed=1)
    assert pushed.shape == (300, 5, 2)
    second = np.diff(pushed, n=2, axis=0) / published.PERIOD_S**2
    lengths = np.hypot(*np.moveaxis(second, -1, 0))
    assert lengths.max() == pytest.approx(20.0)  # where a push is held on both sides
    assert np.median(lengths) == pytest.approx(20.0)
    # To and fro: never further from the steady one's way than two times the way of two pushes.
    reach = 20.0 * (targets.HOLD_FRAMES * published.PERIOD_S) ** 2
    assert np.hypot(*np.moveaxis(pushed - targets.steady(300), -1, 0)).max() < 4 * reach
    np.testing.assert_allclose(
        targets.manoeuvring(50, 2, 0.0, seed=1), np.repeat(targets.steady(50), 2, axis=1)
    )
    frames, places = targets.walk()
    assert (frames[0], frames[-1]) == (6, 121)
    row = int(np.flatnonzero(frames == 11)[0])
    assert places[row + 1, 0] - places[row, 0] == pytest.approx(-published.STEP_PX)


def test_a_steady_target_wants_q_0(made: simulated.Made) -> None:
    """The smallest error is that of a least squares line: sigma sqrt(4 / N) at its end."""
    of = made.sweep["steady"]["corrected"]
    assert falling([-of[q].truth_px for q in published.SWEEP])  # the higher, the worse
    frames = np.arange(sweep.LATE + 1, sweep.LONG_FRAMES + 1)
    expected = targets.SIGMA_PX * math.sqrt(np.mean(4 / frames))
    assert of[0.0].late_px == pytest.approx(expected, rel=0.08)
    assert of[100.0].late_px == pytest.approx(targets.SIGMA_PX, rel=0.02)
    assert falling([of[q].measured_px for q in published.SWEEP])  # and yet "better"


def test_a_manoeuvre_wants_a_q_of_its_own(made: simulated.Made) -> None:
    of = made.sweep["manoeuvring"]["corrected"]
    assert of[0.0].truth_px > 10
    assert min(of, key=lambda q: of[q].truth_px) == 10
    for by in made.best.values():
        best = [sweep.best_q(by_q) for by_q in by.values()]
        assert best[0] == 0
        assert all(later >= q for q, later in pairwise(best))
        assert 0 < best[1] < best[-1] < max(sweep.GRID_Q)
    # The more noise, the smaller.
    for acceleration in sweep.GRID_ACCELERATIONS[1:]:
        by_noise = [sweep.best_q(made.best[px][acceleration]) for px in sweep.GRID_SIGMAS_PX]
        assert all(later < q for q, later in pairwise(by_noise))


def test_the_printed_r_alone_spoils_q_1(made: simulated.Made) -> None:
    assert made.sweep["steady"]["published"][1.0].truth_px > 50
    assert made.sweep["steady"]["corrected"][1.0].truth_px < 2
    assert (matrices.smallest_eigenvalues(1.0, published.R) < 0).sum() == 62
    assert (matrices.smallest_eigenvalues(1.0, filters.RIGHT_R) > 0).all()


def test_gaps_are_predicted_and_the_listing_starts_from_zero(made: simulated.Made) -> None:
    of = made.gaps["steady"]
    for length in gaps.LENGTHS:
        assert of["ours"][0.0][length].during < 1
        assert of["listing"][0.0][length].after > 250
        assert of["listing"][100.0][length].after < 6
        for q in published.SWEEP:
            ours, port = of["ours"][q][length], of["listing"][q][length]
            assert ours.before == pytest.approx(port.before)
            assert ours.during < port.during
            assert ours.after < port.after
    # Longer gaps are worse, but for a target of which the velocity is known.
    for q in (1.0, 10.0, 50.0, 100.0):
        during = [of["ours"][q][length].during for length in gaps.LENGTHS]
        assert falling([-px for px in during])


def test_hidden_frames_are_those_of_figure_21() -> None:
    seen = gaps.hidden(targets.steady(100), 2)
    assert (np.flatnonzero(np.isnan(seen[:, 0, 0])) + 1).tolist() == [93, 94]
    one = walk.measure(lambda frames: None)
    assert one.frames[np.isnan(one.measured[:, 0])].tolist() == [93, 94]
    assert (one.skipping[10.0][[one.row(93), one.row(94)]] == 0).all()
    assert np.hypot(*(one.estimates["corrected"][10.0] - one.truth)[one.row(94)]) < 10


# What the print's figure must be, and what ours: (lowest, highest) each.
EXPECTED = {
    "r_smallest": ((-0.549, -0.548), (0.2877, 0.2877)),
    "r_largest": ((1.983, 1.984), (1.1465, 1.1465)),
    "r_innovation": ((55, 66), (0, 0)),  # half of 121
    "r_rms": ((20, math.inf), (1, 2)),
    # 8 px/s in each frame against a gain of 0.81 or so in vy; the rest is in the velocity.
    "input_y": ((2.2, 20), (0, 1e-3)),
    "input_q_0": ((1000, math.inf), (0, 0.1)),
    "input_q_10": ((0.5, 1), (0, 1e-6)),
    # At (184, 238), 301 px from (0, 0): 0.93 of it is left with a gain of about 0.07.
    "skip_q_0": ((270, 301), (0, 0.1)),
    "skip_q_100": ((0.4, 4), (0, 1e-6)),
    "start": ((67.88, 67.89), (0, 0)),
    "start_outside": ((160, 160), (0, 0)),
    "plus_sign": ((1000, math.inf), (0, 0.01)),
    "ekf": ((7.9778, 7.9779), (0, 1e-9)),
    "one_sided": ((0, 0), (400, 400)),
    "at_least": ((400, 400), (0, 0)),
    "misprint": ((11.1871, 11.1871), (1.18705, 1.18715)),
    "truth": ((0, 0.02), (4, 6)),
}


def test_every_erratum_has_its_test() -> None:
    assert [key for key, *_ in ERRATA] == list(EXPECTED)


@pytest.mark.parametrize("key", EXPECTED)
def test_the_fault_is_in_the_port_and_not_in_ours(key: str, errata: dict[str, Erratum]) -> None:
    (low, high), (our_low, our_high) = EXPECTED[key]
    assert low <= errata[key].listing <= high
    assert our_low <= errata[key].ours <= our_high


def test_segmentation_tests_by_hand() -> None:
    background = np.full((1, 4, 3), 100, np.uint8)
    frame = background.copy()
    frame[0, 1] += 37
    frame[0, 2, 0] -= 60
    frame[0, 3, 1] -= 60
    assert listing.more_than(frame, background).tolist() == [[False, False, True, True]]
    assert listing.at_least(frame, background).tolist() == [[False, True, True, True]]
    one_sided = listing.first_channel_one_sided(frame, background)
    assert one_sided.tolist() == [[False, False, False, True]]
    mask = np.zeros((12, 13), bool)
    mask[2:10, 3:10] = True
    element = np.ones((3, 3), np.uint8)
    eroded = cv2.erode(mask.astype(np.uint8), element, iterations=2) > 0
    assert (listing.eroded_twice(mask) == eroded).all()
    assert eroded.sum() == 4 * 3


def test_the_largest_blob_is_the_measurement() -> None:
    """A square of 24 px, eroded twice: its centre stays."""
    places = measurements(footage(truth_of_square()))
    assert np.isnan(places[:STILL]).all()
    expected = [(16 + 2 * (k - STILL), 44) for k in range(STILL, COUNT)]
    assert np.abs(places[STILL:] - expected).max() < 0.01
    detections = survtrack.Detector(preset_config()).process(
        footage(truth_of_square()).frames[0], 0
    )
    assert len(detections) == 0


def test_footage_against_its_truth() -> None:
    one = measure(footage(truth_of_square()))
    # 25 frames/s: every seventh frame, and the ones between them.
    assert (one.stride, one.period_s, one.object_id) == (7, 0.28, 7)
    assert (one.blobs, one.on_object) == (COUNT - STILL, COUNT - STILL)
    assert one.compared == 7 * ((COUNT - STILL) // 7 - 7)
    assert one.blob_px < 0.01
    assert one.frames_of_run[:2].tolist() == [STILL + 1, STILL + 8]
    for q, errors in one.errors["corrected"].items():
        assert errors.truth_px < (3 if q < 10 else 0.1)
        assert errors.truth_px == pytest.approx(errors.measured_px, abs=0.02)
    assert one.errors["published"][0.0].truth_px > 10
    assert one.best[one.best_q] == min(one.best.values())


def test_hidden_frames_of_footage_are_bridged() -> None:
    """At constant velocity a prediction of two frames is nearly exact; standing still is not."""
    places = np.tile(np.arange(40.0)[:, None, None], (1, 1, 2)) * 4
    scored = np.zeros((40, 1), bool)
    scored[20:] = True
    runs = Runs(places, places, scored, (0.0, 0.0), published.PERIOD_S)
    for q in (10.0, 100.0):
        assert runs.errors(q, "corrected").hidden_px < 0.1
    stopped = places.copy()
    stopped[30:] = stopped[30]
    assert (
        Runs(stopped, stopped, scored, (0.0, 0.0), 0.2685).errors(10.0, "corrected").hidden_px > 1
    )


def test_footage_that_says_nothing_is_refused() -> None:
    elsewhere = Boxes([40], [1], [[150, 2, 5, 5]])
    with pytest.raises(UsageError, match=r"^made: no blob of the 126 frames lies in a true box"):
        measure(footage(elsewhere))
    with pytest.raises(
        UsageError, match=r"^made: no blob lies in the true box 7 frames of 0\.280 s"
    ):
        measure(footage(truth_of_square(50), frames=50))


@pytest.mark.usefixtures("made")
def test_progress_counts_the_frames_of_all_runs() -> None:
    assert sum(TICKS) == simulated.frames() > 0


def test_verdicts_are_those_of_the_numbers(made: simulated.Made) -> None:
    told = {claim.claim: claim.holds for claim in claims(made, [])}
    assert len(told) == 15
    assert told["The higher q, the smaller the error to the measurement; steady, corrected"]
    assert not told["The higher q, the smaller the error to the truth; steady, corrected"]
    assert not told["The higher q, the smaller the error to the truth; manoeuvring, corrected"]
    assert told["With q = 0 the estimate cannot reach the real state; steady, published"]
    assert not told["With q = 0 the estimate cannot reach the real state; steady, corrected"]
    assert told["With q = 0 the estimate cannot reach the real state; manoeuvring, corrected"]
    assert not told["With q = 1 the estimate cannot reach the real state; steady, corrected"]
    assert not told["Through an occlusion of 2 frames q = 50 or 100 is the best; steady"]


def reproduced(out: Path, *given: object) -> tuple[Any, str]:
    assert main(["reproduce", "nashenda2011", *map(str, given), "--out", str(out), "-q"]) == 0
    results = json.loads((out / "results.json").read_text())
    found = {str(path.relative_to(out)) for path in out.rglob("*") if path.is_file()}
    assert found == {*results["outputs"], "results.json"}
    return results, (out / "report.md").read_text()


def test_the_command_needs_no_footage_and_takes_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("SURVTRACK_DATA", raising=False)
    monkeypatch.setattr(sweep, "GRID_Q", sweep.GRID_Q[::6])
    monkeypatch.setattr(sweep, "GRID_RUNS", 5)
    monkeypatch.setattr(gaps, "LENGTHS", (1, 2, 5, 10))
    write_images(tmp_path / "in", footage(truth_of_square()).frames)
    rows = [f"{k + 1},7,{4 + 2 * (k - STILL)},32,24,24,1\n" for k in range(STILL, COUNT)]
    (tmp_path / "gt.txt").write_text("".join(rows))
    given = ("--source", tmp_path / "in", "--truth", tmp_path / "gt.txt", "--resize", f"{WIDTH}x96")
    results, report = reproduced(tmp_path / "out", *given, "--fps", "25")
    for plot in results["outputs"][1:]:
        assert f"]({plot})" in report
        picture = cv2.imread(str(tmp_path / "out" / plot))
        assert picture is not None and picture.shape[1] == 880
    for claim in results["claims"]:
        holds = "**yes**" if claim["holds"] else "no"
        assert f"| {claim['claim']} | {holds} | {claim['numbers']} |" in report
    for _, fault, figure, _ in ERRATA:
        assert f"| {fault} | {figure} |" in report
    assert len(results["claims"]) == 18
    assert results["sets"][0]["frames_compared"] == 7 * 10
    assert results["refused"]["R"].startswith("R: is not positive semi-definite")
    assert results["config"]["segmenter"]["threshold_blue"] == 37
    alone, report = reproduced(tmp_path / "alone")
    assert alone["sets"] == [] and "## Footage" not in report
    assert {key: alone[key] for key in ("sweep", "best_q", "gaps", "errata", "matrices")} == {
        key: results[key] for key in ("sweep", "best_q", "gaps", "errata", "matrices")
    }
    again, _ = reproduced(tmp_path / "again")
    assert again == alone
    for name in ("report.md", "results.json", *alone["outputs"]):
        assert (tmp_path / "again" / name).read_bytes() == (tmp_path / "alone" / name).read_bytes()


def test_walk1_has_one_walker(data: Path) -> None:
    """Its blob is seen for half of the way; a filter repeats it, and cannot be nearer than it."""
    [walk1] = find_datasets(data, ["Walk1"])
    one = measure(load(walk1, published.SIZE))
    assert (one.stride, one.object_id) == (7, 1)
    assert one.on_object == one.blobs > 120
    errors = one.errors["corrected"]
    assert errors[0.0].truth_px > 2 * one.blob_px
    assert errors[100.0].truth_px == pytest.approx(one.blob_px, abs=0.05)
    assert falling([errors[q].measured_px for q in published.SWEEP])
