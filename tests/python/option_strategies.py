# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Random configs, made from the library's own description of its options.

The reference page says the default and what is allowed for every option; no list is kept here.
"""

import json
import re
from collections.abc import Iterator
from typing import Any

from hypothesis import strategies as st

import survtrack

HEADING = re.compile(r"^###? `(?:\[([\w.]+)\]|([\w.]+)\.model = \"(\w+)\")`$")
ROW = re.compile(r"^\| `([\w.]+)` \| `([^`]*)` \| [^|]* \| ([^|]*) \|")
RANGE = re.compile(
    r"^(?:(above|at least|between) (\S+?))(?: and (?:at most )?(\S+?))?(, 0 or odd)?$"
)
READ_REGIONS = ("selective", "static_reference")
LIST = re.compile(r"^(\d+) numbers, each (.*)$")
LARGEST = 1e300  # of options without an upper bound

Strategy = st.SearchStrategy[Any]
Models = dict[str | None, dict[str, Strategy]]


def strategy(default: Any, allowed: str) -> Strategy:
    """Values of one option; numbers have their bounds among them."""
    if isinstance(default, bool):
        return st.booleans()
    if isinstance(default, str):
        return st.sampled_from(allowed.split(", "))
    if isinstance(default, list):
        listed = LIST.match(allowed)
        assert listed and int(listed[1]) == len(default), allowed
        return st.tuples(*(strategy(number, listed[2]) for number in default))
    found = RANGE.match(allowed)
    assert found, allowed
    above, low, high = found[1] == "above", float(found[2]), float(found[3] or LARGEST)
    if isinstance(default, int):
        numbers = st.integers(int(low), int(min(high, 400)))
        return numbers.map(lambda n: n // 2 * 2 + 1 if n % 2 else 0) if found[4] else numbers
    return st.floats(low, high, exclude_min=above)


def sections() -> dict[str, Models]:
    """Section -> model (None for sections without) -> option -> its values."""
    found: dict[str, Models] = {}
    section, model = "", None
    for line in survtrack.options_reference().splitlines():
        if heading := HEADING.match(line):
            section, model = heading[1] or heading[2], heading[3]
            found.setdefault(section, {})
            if heading[3]:
                found[section].pop(None, None)
            found[section][model] = {}
        elif (row := ROW.match(line)) and row[1].startswith(f"{section}."):
            name = row[1].removeprefix(f"{section}.")
            found[section][model][name] = strategy(json.loads(row[2]), row[3])
    return found


SECTIONS = sections()


def parts(section: str) -> Strategy:
    """A section as a dict: a model, and any of its options, those that are sections among them."""
    return st.one_of(
        st.fixed_dictionaries(
            {} if model is None else {"model": st.just(model)},
            optional=options | inner_parts(section, model),
        )
        for model, options in SECTIONS[section].items()
    )


def inner_parts(section: str, model: str | None) -> dict[str, Strategy]:
    """The sections of a section; with models only those that this one has."""
    names = [name for name in SECTIONS if name.startswith(f"{section}.")]
    if names and model is not None:
        chosen = survtrack.Config(**{section: {"model": model}}).to_dict()[section]
        assert isinstance(chosen, dict)
        names = [name for name in names if name.removeprefix(f"{section}.") in chosen]
    return {name.removeprefix(f"{section}."): parts(name) for name in names}


def options_found() -> Iterator[tuple[str, str | None, str]]:
    for section, models in SECTIONS.items():
        for model, options in models.items():
            for option in options:
                yield section, model, option


def sections_agree(config: survtrack.Config) -> bool:
    """Whether the rules between sections allow this config: the only ones beyond the bounds."""
    has_grid = config.vicinity.model == "grid"
    scaled = config.blobs.merge.model == "close" and config.blobs.merge.vicinity_scaled
    if (scaled or config.outputs.vicinity) and not has_grid:
        return False
    if config.outputs.flow and config.segmenter.model != "horn_schunck":
        return False
    if config.outputs.background and config.segmenter.model == "horn_schunck":
        return False
    lifecycle = config.lifecycle
    if isinstance(lifecycle, survtrack.CountMedianOptions):
        if lifecycle.restart_after_s > 0 and not lifecycle.keep_contacts:
            return False
        if lifecycle.keep_contacts and config.reentry.model == "remember":
            return False
    colors = config.appearance
    if isinstance(colors, survtrack.ColorHistogramOptions) and not (
        colors.weight or colors.min_intersection
    ):
        return False
    regions = config.regions
    if isinstance(regions, survtrack.PredictedRegionsOptions):
        if config.segmenter.model not in READ_REGIONS:
            return False
        if regions.acquisition == "strip" and not regions.refresh_frames:
            return False
        if config.filter.model == "mean_velocity":
            return False
        if getattr(config.filter, "covariances", "checked") == "as_published":
            return False
        # A config alone says nothing of zones.
        if regions.acquisition == "zones":
            return False
    discrete = isinstance(config.filter, survtrack.KalmanDiscreteOptions)
    if discrete and not is_covariance(config.filter, config.cost.model == "gaussian"):
        return False
    if config.filter.model == "kalman_box" and config.measurement.model != "box_center":
        return False
    return config.cost.model != "gaussian" or config.filter.model != "mean_velocity"


def is_covariance(options: survtrack.KalmanDiscreteOptions, needed: bool) -> bool:
    """Whether the filter takes its R, where a cost may need that to be positive definite."""
    if options.covariances == "as_published":
        return not needed
    xx, xy, yy = options.measurement_covariance
    return xx >= 1e-12 and yy >= 1e-12 and (xy / xx) * (xy / yy) <= 1 - 1e-6


def with_covariance(config: survtrack.Config) -> survtrack.Config:
    """The config with an R of its filter that is one: few triples of numbers are."""
    options = config.filter
    if isinstance(options, survtrack.KalmanDiscreteOptions) and options.covariances == "checked":
        xx, xy, yy = options.measurement_covariance
        xx, yy = max(abs(xx), 1e-9), max(abs(yy), 1e-9)
        most = 0.99 * min(xx, yy)
        R = (xx, min(max(xy, -most), most), yy)
        config.filter = options.replace(measurement_covariance=R)
    return config


def with_paths(
    stage: survtrack.Pipeline | survtrack.Tracker, config: survtrack.Config, size: tuple[int, int]
) -> None:
    """Load the paths that a filter along paths needs: two lines across a (width, height) frame."""
    if config.filter.model == "kalman_path":
        (width, height), limit = size, {"max_distance_px": 1e9}
        lines = {"down": [(0, 0), (width, height)], "up": [(0, height), (width, 0)]}
        paths = {name: survtrack.Path(points, **limit) for name, points in lines.items()}
        stage.load_paths(survtrack.Paths(paths, size))


def configs() -> st.SearchStrategy[survtrack.Config]:
    """Any config that a pipeline takes."""
    chosen = st.fixed_dictionaries({name: parts(name) for name in SECTIONS if "." not in name})
    time_unit_s = st.floats(1e-6, 3600)
    return st.builds(
        lambda unit, options: with_covariance(
            with_reach(survtrack.Config(time_unit_s=unit, **options))
        ),
        time_unit_s,
        chosen,
    ).filter(sections_agree)


def edges_of(tiling: survtrack.QuadrantsOptions) -> dict[str, int]:
    values = tiling.to_dict()
    return {name: int(str(values[name])) for name in values if name[:5] in ("erode", "dilat")}


def with_reach(config: survtrack.Config) -> survtrack.Config:
    """The config with an overlap of the quadrants as large as their edges need."""
    tiling = config.cleanup.tiling
    if isinstance(tiling, survtrack.QuadrantsOptions):
        edges = edges_of(tiling)
        corners = {name.split("_", 1)[1] for name in edges}
        reach = [edges[f"erode_{c}"] // 2 + edges[f"dilate_{c}"] // 2 for c in corners]
        config.set(f"cleanup.tiling.overlap_px={max(tiling.overlap_px, *reach)}")
    return config


def with_parts_in(frame: tuple[int, ...], config: survtrack.Config) -> survtrack.Config:
    """The config with a vicinity grid and tiles that a frame has room for, and no picture."""
    segmenter = config.segmenter
    if isinstance(segmenter, survtrack.StaticReferenceOptions) and segmenter.source == "picture":
        config.set("segmenter.source=median")
    if config.vicinity.model == "grid":
        config.set(f"vicinity.cell_px={min(config.vicinity.cell_px, *frame[:2])}")
    tiling = config.cleanup.tiling
    if isinstance(tiling, survtrack.WholeFrameOptions):
        for name in ("erode_px", "dilate_px"):
            config.set(f"cleanup.tiling.{name}={min(getattr(tiling, name), *frame[:2])}")
    elif isinstance(tiling, survtrack.QuadrantsOptions) and min(frame[:2]) < 2:
        config.set("cleanup.tiling.model=none")
    elif isinstance(tiling, survtrack.QuadrantsOptions):
        for name, edge in edges_of(tiling).items():
            config.set(f"cleanup.tiling.{name}={min(edge, frame[0] // 2, frame[1] // 2)}")
    return config
