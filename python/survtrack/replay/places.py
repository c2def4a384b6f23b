# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The regions that a detector read, as part of a frame's record."""

import math
from collections import defaultdict, deque
from collections.abc import Iterable
from typing import TYPE_CHECKING, NamedTuple

from survtrack._core import Box, Region, RegionKind
from survtrack.errors import InputError
from survtrack.replay.values import StreamHeader
from survtrack.replay.varint import Damaged, Numbers, put, put_signed

if TYPE_CHECKING:
    from survtrack._core import FrameResult

KIND_BITS, MOVED = 0b011, 0b100
WHOLE = RegionKind.whole_frame.value
PREDICTED = RegionKind.predicted.value
MOST_ID = 2**53

Corners = tuple[int, int, int, int]


class Place(NamedTuple):
    """A region in whole pixels: the kind of RegionKind; the id of a predicted one's track, or 0."""

    kind: int
    track_id: int
    box: Corners


class Places(NamedTuple):
    """All regions of a frame but the whole frame, and whether that was read, too."""

    whole: bool = False
    items: tuple[Place, ...] = ()


NO_PLACES = Places()


def places_of(result: "FrameResult", header: StreamHeader) -> Places:
    """The pixels that a result's regions touch; none where only the whole frame was read.

    Raises:
        InputError: a region holds a number that is not finite, or an id out of its bounds.
    """
    items = []
    whole = False
    for region in result.regions:
        kind = RegionKind[region.kind.name].value
        if kind == WHOLE:
            whole = True
        elif (box := _touched(region.box, header)) is not None:
            track_id = region.track_id if kind == PREDICTED else 0
            if not 0 <= track_id <= MOST_ID:
                raise InputError(f"a region of track {track_id}: ids from 0 to 2^53 are allowed")
            items.append(Place(kind, track_id, box))
    return Places(whole, tuple(items)) if items else NO_PLACES


def regions_of(places: Places, header: StreamHeader) -> tuple[Region, ...]:
    """What the core calls them; the whole frame last, as the detector has it."""
    regions = [
        Region(Box(*place.box), RegionKind(place.kind), place.track_id) for place in places.items
    ]
    if places.whole:
        frame = Box(0, 0, header.width_px, header.height_px)
        regions.append(Region(frame, RegionKind.whole_frame))
    return tuple(regions)


def write_places(data: bytearray, places: Places, last: Places) -> None:
    """Append them to a record, less what they were in the last one; nothing when there are none."""
    if not places.items:
        return
    put(data, 2 * len(places.items) + places.whole)
    earlier = _Earlier(last.items)
    for kind, track_id, box in places.items:
        changes = [a - b for a, b in zip(box, earlier.box(kind, track_id), strict=True)]
        data.append(kind | (MOVED if any(changes) else 0))
        if kind == PREDICTED:
            put(data, track_id)
        for change in changes if any(changes) else ():
            put_signed(data, change)


def read_places(numbers: Numbers, last: Places, header: StreamHeader) -> Places:
    """What is left of a record; raises Damaged when no encoder wrote it."""
    if not numbers.left:
        return NO_PLACES
    count, whole = divmod(numbers.number(), 2)
    if not 1 <= count <= numbers.left:
        raise Damaged(f"{count} regions cannot be in {numbers.left} bytes")
    earlier = _Earlier(last.items)
    items = []
    for _ in range(count):
        flags = numbers.byte()
        kind = flags & KIND_BITS
        if flags & ~(KIND_BITS | MOVED) or kind == WHOLE:
            raise Damaged(f"the flags {flags:#04x} of a region are none of version 2")
        track_id = numbers.number() if kind == PREDICTED else 0
        left, top, width, height = (
            side + (numbers.signed() if flags & MOVED else 0)
            for side in earlier.box(kind, track_id)
        )
        inside = 0 <= left < left + width <= header.width_px
        if not (inside and 0 <= top < top + height <= header.height_px and track_id <= MOST_ID):
            raise Damaged("a region is out of bounds")
        items.append(Place(kind, track_id, (left, top, width, height)))
    return Places(bool(whole), tuple(items))


class _Earlier:
    """The last frame's boxes by kind and track; of those that are alike in both, in their order."""

    def __init__(self, places: Iterable[Place]) -> None:
        self._boxes: defaultdict[tuple[int, int], deque[Corners]] = defaultdict(deque)
        for kind, track_id, box in places:
            self._boxes[kind, track_id].append(box)

    def box(self, kind: int, track_id: int) -> Corners:
        boxes = self._boxes.get((kind, track_id))
        return boxes.popleft() if boxes else (0, 0, 0, 0)


def _touched(box: Box, header: StreamHeader) -> Corners | None:
    """The pixels that a box covers, wholly or in part; None when it covers none of the frame's."""
    edges = (box.x, box.y, box.x + box.width, box.y + box.height)
    if not all(map(math.isfinite, edges)):
        raise InputError(f"a region is {edges} (left, top, right, bottom); finite ones are needed")
    most = (header.width_px, header.height_px)
    left, top = (min(max(math.floor(edges[k]), 0), most[k]) for k in (0, 1))
    right, bottom = (min(max(math.ceil(edges[2 + k]), 0), most[k]) for k in (0, 1))
    return None if right <= left or bottom <= top else (left, top, right - left, bottom - top)
