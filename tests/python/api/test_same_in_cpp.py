# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The installed C++ library and the Python module say the same, to the last bit."""

import subprocess
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

import outside_project
import survtrack
from clips import Image
from scenes import PRESETS, run, scene

Values = list[str | float]


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Path:
    prefix, folder = tmp_path_factory.mktemp("prefix"), tmp_path_factory.mktemp("build")
    outside_project.install(prefix)
    source = outside_project.ROOT / "tests" / "same_bytes"
    return outside_project.build(prefix, folder, source) / "same_bytes"


def track_values(track: survtrack.Track) -> Values:
    P, V = track.position_covariance_px2, track.velocity_covariance_px2_per_s2
    q = track.velocity_noise_px2_per_s3
    values: Values = ["track", track.id, track.status.value, track.reported, *track.box]
    values += [*track.position, *track.velocity_px_per_s, P[0, 0], P[0, 1], P[1, 1]]
    values += [V[0, 0], V[0, 1], V[1, 1], *track.position_velocity_covariance_px2_per_s.ravel()]
    values += [q[0, 0], q[0, 1], q[1, 1]]
    values += [*track.predicted_position, *track.mean_color, track.detection]
    return [*values, track.age_frames, track.matched_frames, track.lost_frames]


def said_in_python(result: survtrack.FrameResult) -> Iterator[Values]:
    yield ["frame", result.index, result.time_s]
    for one in result.detections:
        M = one.moments_px2
        values = [*one.box, *one.position, one.area_px, *one.mean_color]
        yield ["detection", *values, M[0, 0], M[0, 1], M[1, 1], one.confidence]
    yield from (track_values(track) for track in (*result.tracks, *result.tentative))
    for match in result.matches:
        yield ["match", match.track, match.detection, match.cost, match.assigned]
    for event in result.events:
        yield ["event", event.kind.value, event.track_id, *event.box, *event.position]


def said_in_cpp(line: str) -> Values:
    kind, *numbers = line.split()
    return [kind, *(float.fromhex(n) if "0x" in n else int(n) for n in numbers)]


def crowd() -> list[Image]:
    """Squares that cross each other's ways, in noise."""
    random = np.random.default_rng(4)
    frames = []
    for k, frame in enumerate(scene(60)):
        noisy = np.clip(frame.astype(int) + random.integers(-9, 10, frame.shape), 0, 255)
        noisy[8:20, max(0, 90 - 2 * k) : 100 - 2 * k] = (230, 60, 40)
        noisy[k : k + 9, 50:58] = (20, 20, 200)
        frames.append(noisy.astype(np.uint8))
    return frames


@pytest.mark.parametrize("preset", PRESETS)
@pytest.mark.parametrize("grey", [False, True], ids=["colour", "grey"])
def test_cpp_and_python_give_the_same_bytes(
    program: Path, tmp_path: Path, preset: str, grey: bool
) -> None:
    frames = [np.ascontiguousarray(frame[..., 1]) if grey else frame for frame in crowd()]
    masks = tmp_path / "masks"
    size = ["96", "64", "1" if grey else "3"]
    ran = subprocess.run(
        [program, preset, *size, "7", masks],
        input=b"".join(frame.tobytes() for frame in frames),
        capture_output=True,
        check=True,
    )
    results = run(survtrack.Pipeline.from_preset(preset), frames, fps=7)
    ours = [values for result in results for values in said_in_python(result)]
    assert [said_in_cpp(line) for line in ran.stdout.decode().splitlines()] == ours
    assert masks.read_bytes() == b"".join(result.mask.tobytes() for result in results)
    kinds = {values[0] for values in ours}
    assert kinds == {"frame", "detection", "track", "match", "event"}, "nothing was tracked"
