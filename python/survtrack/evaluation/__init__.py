# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""The judge: scores tracks and foreground masks against ground truth.

evaluate_tracks gives HOTA, CLEAR MOT and identity scores, equal to TrackEval, and the counts of
Narayana 2007; evaluate_masks gives CDnet's; flow_error gives Middlebury's errors of optical flow.
Importing this package loads neither scipy nor cv2; scoring does.
"""

from survtrack.evaluation.boxes import Boxes
from survtrack.evaluation.cvml import read_cvml
from survtrack.evaluation.flow_files import FlowError, flow_error, read_flo, write_flo
from survtrack.evaluation.masks import MaskScores, evaluate_masks
from survtrack.evaluation.mot import read_mot
from survtrack.evaluation.readers import read_boxes
from survtrack.evaluation.tracks import TrackScores, evaluate_tracks

__all__ = [
    "Boxes",
    "FlowError",
    "MaskScores",
    "TrackScores",
    "evaluate_masks",
    "evaluate_tracks",
    "flow_error",
    "read_boxes",
    "read_cvml",
    "read_flo",
    "read_mot",
    "write_flo",
]
