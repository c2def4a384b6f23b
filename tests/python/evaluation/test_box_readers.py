# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""MOT text and CVML are read as they are meant, and refused with the place of what is wrong."""

import re
from pathlib import Path

import numpy as np
import pytest

from survtrack.errors import InputError
from survtrack.evaluation import Boxes, read_boxes, read_cvml, read_mot

CVML = """<?xml version="1.0" encoding="UTF-8"?>
<dataset name="two">
  <frame number="0"><objectlist>
    <object id="3"><box h="20" w="10" xc="50" yc="40"/><hypothesislist>
      <hypothesis evaluation="0.2" id="1"><movement>inactive</movement></hypothesis>
      <hypothesis evaluation="0.8" id="2"><movement>walking</movement></hypothesis>
    </hypothesislist></object>
    <object id="4"><box h="5" w="4" xc="9" yc="8"/><hypothesislist>
      <hypothesis evaluation="1.0" id="1"><movement> inactive </movement></hypothesis>
    </hypothesislist></object>
  </objectlist><grouplist>
    <group id="0"><box h="50" w="50" xc="50" yc="40"/><members>3,4</members></group>
  </grouplist></frame>
  <frame number="7"><objectlist/><grouplist/></frame>
</dataset>
"""


def write(folder: Path, text: str, name: str = "boxes.txt") -> Path:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


def test_mot_rows_keep_their_order_and_values(tmp_path: Path) -> None:
    path = write(tmp_path, "2,7,10.5,20,30,40,1,-1,-1,-1\n\n 1 , 8, -3,0, 5, 6.25, 0, -1,-1,-1\r\n")
    boxes = read_mot(path)
    assert boxes.frames.tolist() == [2, 1]
    assert boxes.ids.tolist() == [7, 8]
    np.testing.assert_array_equal(boxes.boxes, [[10.5, 20, 30, 40], [-3, 0, 5, 6.25]])
    assert not boxes.ignore.any()
    assert not boxes.boxes.flags.writeable


def test_rows_of_confidence_0_are_dropped_from_truth_only(tmp_path: Path) -> None:
    path = write(tmp_path, "1,1,0,0,9,9,1,1,1\n1,2,0,0,9,9,0,1,1\n1,3,0,0,9,9,0.2,1,1\n")
    assert read_mot(path, truth=True).ids.tolist() == [1, 3]
    assert read_mot(path).ids.tolist() == [1, 2, 3]


def test_tracks_may_be_empty_truth_may_not(tmp_path: Path) -> None:
    empty = write(tmp_path, "\n")
    assert len(read_mot(empty)) == 0
    with pytest.raises(InputError, match="holds no box to score"):
        read_mot(empty, truth=True)
    with pytest.raises(InputError, match="holds no box to score"):
        read_mot(write(tmp_path, "1,1,0,0,9,9,0\n"), truth=True)


GOOD = "1,1,0,0,9,9,1,-1,-1,-1\n"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (GOOD + "2,1,0,0,9\n", r"line 2: 5 column\(s\), expected 6 to 10"),
        ("1,1,0,0,9,9,1,1,1,1,1\n", r"line 1: 11 column\(s\)"),
        (GOOD + "2,1,0,0,9,9,1\n", "line 2: 7 columns, but the lines before it have 10"),
        ("frame,id,left,top,width,height\n", "line 1: column 1 must be a finite number.*'frame'"),
        ("1 1 0 0 9 9\n", "line 1: column 1 must be a finite number"),
        (GOOD + "\n2,1,nan,0,9,9,1,-1,-1,-1\n", "line 3: column 3 must be a finite number"),
        ("1,1,0,inf,9,9\n", "line 1: column 4 must be a finite number, not 'inf'"),
        ("1,1,0,1e999,9,9\n", "line 1: column 4 must be a finite number"),
        ("1,1_0,0,0,9,9\n", "line 1: column 2 must be a finite number, not '1_0'"),
        ("1,1,0,,9,9\n", "line 1: column 4 must be a finite number, not ''"),
        (GOOD + "0,1,0,0,9,9,1,-1,-1,-1\n", "line 2: frame 0 is not an integer from 1 on"),
        ("1.5,1,0,0,9,9\n", "line 1: frame 1.5 is not an integer from 1 on"),
        ("1e300,1,0,0,9,9\n", r"line 1: frame 1e\+300 is not an integer"),
        ("1,-1,0,0,9,9\n", "line 1: id -1 is not an integer from 0 on.*detections, not tracks"),
        ("1,2.5,0,0,9,9\n", "line 1: id 2.5 is not an integer"),
        ("1,1,0,0,0,9\n", "line 1: size 0 x 9 must be above 0"),
        ("1,1,0,0,9,-4\n", "line 1: size 9 x -4 must be above 0"),
        ("1,1,0,2e9,9,4\n", r"line 1: top 2e\+09 is not a number of pixels within"),
        (GOOD * 2, "line 2: id 1 appears twice in frame 1 .first at .*line 1"),
    ],
)
def test_bad_mot_text_is_refused_with_its_line(tmp_path: Path, text: str, message: str) -> None:
    path = write(tmp_path, text)
    with pytest.raises(InputError, match=message) as error:
        read_mot(path)
    assert str(path) in str(error.value)
    with pytest.raises(InputError, match=re.escape(str(path))):
        read_boxes(path)


def test_truth_needs_a_confidence(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"line 1: 6 column\(s\), expected 7 to 10"):
        read_mot(write(tmp_path, "1,1,0,0,9,9\n"), truth=True)


@pytest.mark.parametrize("truth", [True, False])
def test_files_that_are_none(tmp_path: Path, truth: bool) -> None:
    with pytest.raises(InputError, match=r"missing\.txt: no such file"):
        read_boxes(tmp_path / "missing.txt", truth=truth)
    with pytest.raises(InputError, match="is a folder"):
        read_boxes(tmp_path, truth=truth)
    binary = tmp_path / "video.avi"
    binary.write_bytes(b"RIFF\x9a\xff\xfe\x00AVI ")
    with pytest.raises(InputError, match=r"video\.avi: not MOT text"):
        read_boxes(binary, truth=truth)


def test_cvml_counts_from_0_and_gives_centres(tmp_path: Path) -> None:
    boxes = read_cvml(write(tmp_path, CVML))
    assert boxes.frames.tolist() == [1, 1]
    assert boxes.ids.tolist() == [3, 4]
    np.testing.assert_array_equal(boxes.boxes, [[45, 30, 10, 20], [7, 5.5, 4, 5]])
    assert boxes.ignore.tolist() == [False, True]


def test_cvml_is_known_by_its_content(tmp_path: Path) -> None:
    path = tmp_path / "truth.txt"
    path.write_bytes(b"\xef\xbb\xbf" + CVML.encode())
    assert len(read_boxes(path, truth=True)) == 2
    with pytest.raises(InputError, match="is XML, but tracks are expected as MOT text"):
        read_boxes(path)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("</dataset>", "", "broken XML"),
        ("dataset", "svg", "not CVML.*<svg>"),
        ('number="7"', "", "<frame> lacks the attribute 'number'"),
        ('number="7"', 'number="0"', "CVML frame 0: listed twice"),
        ('number="7"', 'number="-1"', "CVML frame -1: below 0"),
        ('number="7"', 'number="x"', "number='x'> is not a finite number"),
        ('number="7"', 'number="1.5"', "number='1.5'> is not an integer"),
        ('xc="9"', 'xc="nan"', "frame 0, object 4: <box xc='nan'> is not a finite number"),
        ('h="5"', 'h="0"', "frame 0, object 4: size 4 x 0 must be above 0"),
        ('<box h="5" w="4" xc="9" yc="8"/>', "", "frame 0, object 4: lacks a <box>"),
        ('id="4"', 'id="3"', "object 3: id 3 appears twice in frame 1"),
        ("walking", "inactive", "holds no box to score"),
    ],
)
def test_bad_cvml_is_refused_with_its_place(
    tmp_path: Path, old: str, new: str, message: str
) -> None:
    path = write(tmp_path, CVML.replace(old, new), "truth.xml")
    with pytest.raises(InputError, match=message) as error:
        read_boxes(path, truth=True)
    assert str(path) in str(error.value)


def test_mot_text_named_xml_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="broken XML"):
        read_boxes(write(tmp_path, GOOD, "truth.xml"), truth=True)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (([1], [1], [[0, 0, 9]]), r"shape \(N, 4\)"),
        (([1, 2], [1], [[0, 0, 9, 9]]), "frames must be 1 numbers"),
        (([1], ["a"], [[0, 0, 9, 9]]), "ids must be 1 numbers"),
        (([1], [1], [[0, 0, 9, 9]], [True, False]), "ignore must have the shape"),
        (([1, 0], [1, 1], [[0, 0, 9, 9]] * 2), "box 1: frame 0"),
    ],
)
def test_bad_arrays_are_refused(arguments: tuple[object, ...], message: str) -> None:
    with pytest.raises(InputError, match=message):
        Boxes(*arguments)  # type: ignore[arg-type]


def test_boxes_do_not_share_memory_with_what_they_were_made_of() -> None:
    table = np.array([[0.0, 0, 9, 9]])
    boxes = Boxes([1], [1], table)
    table[:] = 5
    assert boxes.boxes.tolist() == [[0, 0, 9, 9]]


def test_truth_of_the_footage(data: Path) -> None:
    pets = read_boxes(data / "mot/PETS09-S2L1/gt/gt.txt", truth=True)
    assert len(pets) == 4476  # the count that MOTChallenge gives; 174 rows have confidence 0
    assert len(np.unique(pets.ids)) == 19
    walk = read_boxes(data / "caviar/Walk1/wk1gt.xml", truth=True)
    assert len(walk) == 1559
    assert walk.frames.max() <= 611
    # CVML frame 236, object 1: h 4, w 9, centre (244, 285), walking; 4 and 5 are inactive.
    here = walk.frames == 237
    assert walk.ids[here].tolist() == [1, 4, 5]
    assert walk.boxes[here][0].tolist() == [239.5, 283, 9, 4]
    assert walk.ignore[here].tolist() == [False, True, True]
