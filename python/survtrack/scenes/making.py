# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""From a name and options to a scene."""

import inspect
from collections.abc import Mapping
from dataclasses import fields, replace
from typing import Any

from survtrack.errors import UsageError
from survtrack.scenes.body import Body
from survtrack.scenes.catalog import SCENES
from survtrack.scenes.conditions import Conditions
from survtrack.scenes.scene import Scene, check_filming
from survtrack.scenes.stage import Stage
from survtrack.sources.base import DEFAULT_FPS, Size

DEFAULT_SIZE = (320, 240)
DEFAULT_FRAME_COUNT = 200


def make_scene(
    name: str,
    *,
    size: Size = DEFAULT_SIZE,
    frame_count: int = DEFAULT_FRAME_COUNT,
    fps: float = DEFAULT_FPS,
    seed: int = 0,
    **options: Any,
) -> Scene:
    """One of the ready-made scenes.

    Args:
        name: one of scene_names().
        size: (width, height) of the frames in px.
        frame_count: 1 or more.
        fps: frames per second, above 0.
        seed: of everything random.
        options: those of scene_options(name): the scene's own, shape, width_px and height_px of
            its contacts, and the fields of Conditions.

    Raises:
        UsageError: an unknown name or option, a value that is not allowed, a contact that is
            never in the frame, or a scene that ends before what it is made to show.
    """
    known = scene_options(name)
    for option, value in options.items():
        if option not in known:
            raise UsageError(f'{name}: unknown option "{option}"; one of: {", ".join(known)}')
        _check_type(option, value, known[option])
    check_filming(size, frame_count, fps, seed)
    body = Body(**_chosen(options, Body))
    stage = Stage(name, size, frame_count / fps, seed, body)
    own = {option: options[option] for option in _own_options(name) if option in options}
    cast = SCENES[name](stage, **own)
    conditions = replace(cast.conditions, **_chosen(options, Conditions))
    return Scene(name, tuple(cast.objects), size, frame_count, fps, seed, conditions)


def scene_names() -> list[str]:
    """The ready-made scenes."""
    return list(SCENES)


def scene_summary(name: str) -> str:
    """What a scene shows, in a sentence or two; UsageError for an unknown name."""
    _refuse_unknown(name)
    return (inspect.getdoc(SCENES[name]) or "").splitlines()[0]


def scene_options(name: str) -> dict[str, Any]:
    """All options of a scene with their defaults (for the default size); UsageError."""
    _refuse_unknown(name)
    stage = Stage(name, DEFAULT_SIZE, DEFAULT_FRAME_COUNT / DEFAULT_FPS, 0, Body())
    return _own_options(name) | vars(stage.body) | vars(SCENES[name](stage).conditions)


def _refuse_unknown(name: str) -> None:
    if name not in SCENES:
        raise UsageError(f'unknown scene "{name}"; one of: {", ".join(SCENES)}')


def _own_options(name: str) -> dict[str, Any]:
    """The keywords of a scene's maker, with their defaults."""
    parameters = inspect.signature(SCENES[name]).parameters.values()
    return {each.name: each.default for each in parameters if each.kind is each.KEYWORD_ONLY}


def _chosen(options: Mapping[str, Any], kind: type[Body] | type[Conditions]) -> dict[str, Any]:
    """Those of the options that are fields of a class."""
    names = {field.name for field in fields(kind)}
    return {name: value for name, value in options.items() if name in names}


def _check_type(option: str, value: Any, default: Any) -> None:
    """Raise UsageError unless value is of the kind of its default; a whole number is a number."""
    kinds: dict[type, tuple[tuple[type, ...], str]] = {
        int: ((int,), "a whole number"),
        float: ((int, float), "a number"),
        str: ((str,), "a word"),
        tuple: ((tuple, list), "a list of boxes (left, top, width, height)"),
    }
    allowed, words = kinds[type(default)]
    if isinstance(value, bool) or not isinstance(value, allowed):
        raise UsageError(f"{option}: {value!r} is not allowed; {words}")
