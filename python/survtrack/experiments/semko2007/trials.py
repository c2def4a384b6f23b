# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The artificial data of V.B: white blobs on black, whose way is known."""

from dataclasses import dataclass

from survtrack.scenes import Body, Pace, Path, Scene, SceneObject, steady, surging, weave

SIZE = (384, 288)
FPS = 25.0
SPEED_PX_PER_S = 60.0
FRAMES = 125
SWING, PERIOD_S = 0.6, 2.0
REMOVED = 75  # the frame from which the middle contact of three is gone
AWAY = 12  # frames that it is away in the trial in which it comes back: one less than 13

ELLIPSE = Body("ellipse", 28.0, 56.0)  # about 1230 px^2, above the preset's 560
LANES, STARTS, HEADINGS = (50.0, 144.0, 238.0), (48.0, 344.0, 20.0), (0.0, 180.0, 0.0)


@dataclass(frozen=True)
class Trial:
    """One of the published trials: its key in results.json, its name in tables, its scene."""

    key: str
    label: str
    scene: Scene


def trials(seed: int = 0) -> list[Trial]:
    """Those without a loss."""
    rising, even = (
        surging(SPEED_PX_PER_S, SWING, PERIOD_S, 0.0, FRAMES / FPS),
        steady(SPEED_PX_PER_S),
    )
    line = Path((40.0, 70.0), 25.0)
    bend = weave((40.0, 144.0), 0.0, 90.0, 80.0, 400.0)
    rows = [
        ("one_constant", "one, constant speed and direction", [(line, even)]),
        ("one_speed", "one, varying speed", [(line, rising)]),
        ("one_direction", "one, varying direction", [(bend, even)]),
        ("three_constant", "three, constant speed and direction", _three(even)),
        ("three_direction", "three, constant speed, varying direction", _three(even, 60.0)),
        ("three_speed", "three, varying speed, constant direction", _three(rising)),
    ]
    return [
        Trial(key, label, _scene(key, [_contact(k, *way) for k, way in enumerate(ways, 1)], seed))
        for key, label, ways in rows
    ]


def removed(seed: int = 0) -> Trial:
    """Three contacts, of which the middle one is gone from REMOVED on."""
    [one, two, three] = _three(steady(SPEED_PX_PER_S))
    contacts = [
        _contact(1, *one),
        _contact(2, *two, until=REMOVED),
        _contact(3, *three),
    ]
    return Trial("removed", "three, one is removed", _scene("removed", contacts, seed))


def hidden(seed: int = 0) -> Trial:
    """The same, but the middle one is there again after AWAY frames."""
    [one, two, three] = _three(steady(SPEED_PX_PER_S))
    contacts = [
        _contact(1, *one),
        _contact(2, *two, until=REMOVED),
        _contact(3, *three),
        _contact(4, *two, since=REMOVED + AWAY),
    ]
    label = f"three, one is away for {AWAY} frames"
    return Trial("hidden", label, _scene("hidden", contacts, seed))


def _three(pace: Pace, turn_deg: float = 0.0) -> list[tuple[Path, Pace]]:
    """To the right, to the left, to the right."""
    ways = []
    for k, y in enumerate(LANES):
        start, heading = ((STARTS[k], y), HEADINGS[k])
        way = weave(start, heading, turn_deg, 60.0, 400.0) if turn_deg else Path(start, heading)
        ways.append((way, pace))
    return ways


def _contact(
    id: int, path: Path, pace: Pace, *, since: int | None = None, until: int | None = None
) -> SceneObject:
    """From a frame, until before another; half a frame off, so that rounding decides nothing."""
    first, end = (None if k is None else (k - 0.5) / FPS for k in (since, until))
    return SceneObject(id, ELLIPSE, path, pace, from_s=first, until_s=end)


def _scene(key: str, contacts: list[SceneObject], seed: int) -> Scene:
    return Scene(key, tuple(contacts), SIZE, FRAMES, FPS, seed)
