# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Truth boxes from CVML, the XML that the CAVIAR project annotated its footage in.

Source: T. List, R. B. Fisher, "CVML - An XML-based Computer Vision Markup Language", ICPR 2004.
"""

import math
from pathlib import Path
from xml.etree import ElementTree

from survtrack.errors import InputError
from survtrack.evaluation.boxes import MAX_INTEGER, Boxes
from survtrack.evaluation.files import StrPath, read_bytes


def read_cvml(path: StrPath) -> Boxes:
    """Read the objects of a CVML file; its groups are left out.

    CVML counts frames from 0, survtrack from 1: CVML's frame k becomes frame k + 1. CVML gives
    a box by its centre (xc, yc) and size (w, h), in pixels. Objects whose movement is
    `inactive`, in the hypothesis of the highest evaluation, are marked `ignore`.

    Raises:
        InputError: a missing file, XML that is broken or not CVML, attributes that are missing
            or not numbers, a frame listed twice, a break of the rules of Boxes, or no box to
            score. Frames and objects are named with CVML's own numbers.
    """
    path = Path(path)
    try:
        root = ElementTree.fromstring(read_bytes(path))
    except ElementTree.ParseError as error:
        raise InputError(f"{path}: broken XML: {error}") from error
    if root.tag != "dataset" or root.find("frame") is None:
        raise InputError(
            f"{path}: not CVML: <dataset> with <frame> elements expected, found <{root.tag}>"
        )
    frames: list[int] = []
    ids: list[int] = []
    boxes: list[tuple[float, float, float, float]] = []
    ignore: list[bool] = []
    names: list[str] = []
    seen: set[int] = set()
    for frame in root.iterfind("frame"):
        number = _integer(frame, "number", str(path))
        where = f"{path}, CVML frame {number}"
        if number < 0 or number in seen:
            raise InputError(f"{where}: " + ("below 0" if number < 0 else "listed twice"))
        seen.add(number)
        for item in frame.iterfind("objectlist/object"):
            ids.append(_integer(item, "id", f"{where}, <object>"))
            names.append(f"{where}, object {ids[-1]}")
            frames.append(number + 1)
            boxes.append(_box(item, names[-1]))
            ignore.append(_movement(item, names[-1]) == "inactive")
    if all(ignore):
        raise InputError(f"{path}: the truth holds no box to score (no objects, or all inactive)")
    return Boxes(frames, ids, boxes, ignore, where=names.__getitem__)


def _number(element: ElementTree.Element, key: str, where: str) -> float:
    text = element.get(key)
    if text is None:
        raise InputError(f"{where}: <{element.tag}> lacks the attribute {key!r}")
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise InputError(f"{where}: <{element.tag} {key}={text!r}> is not a finite number")
    return value


def _integer(element: ElementTree.Element, key: str, where: str) -> int:
    value = _number(element, key, where)
    if value != math.floor(value) or abs(value) > MAX_INTEGER:
        raise InputError(f"{where}: <{element.tag} {key}={element.get(key)!r}> is not an integer")
    return int(value)


def _box(item: ElementTree.Element, where: str) -> tuple[float, float, float, float]:
    """Left, top, width, height, in pixels."""
    box = item.find("box")
    if box is None:
        raise InputError(f"{where}: lacks a <box>")
    centre_x, centre_y, width, height = (_number(box, key, where) for key in ("xc", "yc", "w", "h"))
    return centre_x - width / 2, centre_y - height / 2, width, height


def _movement(item: ElementTree.Element, where: str) -> str:
    """What the most likely hypothesis says of the object's movement; "" when it says nothing."""
    best, movement = -math.inf, ""
    for hypothesis in item.iterfind("hypothesislist/hypothesis"):
        given = "evaluation" in hypothesis.attrib
        evaluation = _number(hypothesis, "evaluation", where) if given else 1.0
        if evaluation > best:
            best, movement = evaluation, hypothesis.findtext("movement", "").strip()
    return movement
