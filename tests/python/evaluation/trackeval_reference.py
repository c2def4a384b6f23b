# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Scores by TrackEval itself, from files that it reads itself: what ours must equal.

TrackEval is installed by `pip install --no-deps trackeval`: its dependencies would replace cv2.
"""

import contextlib
import io
from collections.abc import Sequence
from pathlib import Path

with contextlib.redirect_stdout(io.StringIO()):  # it reports data sets that it cannot serve
    import trackeval

Row = Sequence[float]  # frame, id, left, top, width, height
PEDESTRIAN, DISTRACTOR = 1, 8  # MOT17's classes

HOTA_FIELDS = {
    "hota": "HOTA",
    "det_a": "DetA",
    "ass_a": "AssA",
    "det_re": "DetRe",
    "det_pr": "DetPr",
    "ass_re": "AssRe",
    "ass_pr": "AssPr",
    "loc_a": "LocA",
}
COUNT_FIELDS = {
    "true_positives": "CLR_TP",
    "false_positives": "CLR_FP",
    "misses": "CLR_FN",
    "id_switches": "IDSW",
    "fragments": "Frag",
    "mostly_tracked": "MT",
    "partly_tracked": "PT",
    "mostly_lost": "ML",
}


def trackeval_scores(
    folder: Path,
    truth: Sequence[Row],
    tracks: Sequence[Row],
    *,
    iou: float = 0.5,
    ignore: Sequence[bool] = (),
) -> dict[str, float]:
    """TrackEval's scores under the names of TrackScores, percentages where those are."""
    classes = [DISTRACTOR if marked else PEDESTRIAN for marked in ignore] or [PEDESTRIAN] * len(
        truth
    )
    _write(folder / "gt/seq/gt/gt.txt", truth, [f"1,{kind},1" for kind in classes])
    _write(folder / "trackers/us/data/seq.txt", tracks, ["1,-1,-1,-1"] * len(tracks))
    last = max(int(row[0]) for row in [*truth, *tracks, (1,)])
    dataset = trackeval.datasets.MotChallenge2DBox(
        {
            "GT_FOLDER": str(folder / "gt"),
            "TRACKERS_FOLDER": str(folder / "trackers"),
            "SKIP_SPLIT_FOL": True,
            "SEQ_INFO": {"seq": last},
            "BENCHMARK": "MOT17",
            "DO_PREPROC": any(ignore),
            "PRINT_CONFIG": False,
        }
    )
    raw = dataset.get_raw_seq_data("us", "seq")
    sequence = dataset.get_preprocessed_seq_data(raw, "pedestrian")
    options = {"THRESHOLD": iou, "PRINT_CONFIG": False}
    hota = trackeval.metrics.HOTA().eval_sequence(sequence)
    clear = trackeval.metrics.CLEAR(options).eval_sequence(sequence)
    identity = trackeval.metrics.Identity(options).eval_sequence(sequence)
    scores = {ours: 100 * float(hota[name].mean()) for ours, name in HOTA_FIELDS.items()}
    scores |= {name: 100 * float(clear[name.upper()]) for name in ("mota", "motp")}
    scores |= {name: 100 * float(identity[name.upper()]) for name in ("idf1", "idp", "idr")}
    scores |= {ours: int(clear[name]) for ours, name in COUNT_FIELDS.items()}
    return scores | {
        "truth_boxes": sequence["num_gt_dets"],
        "truth_ids": sequence["num_gt_ids"],
        "output_boxes": sequence["num_tracker_dets"],
        "output_ids": sequence["num_tracker_ids"],
    }


def _write(path: Path, rows: Sequence[Row], endings: Sequence[str]) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    lines = [
        f"{int(row[0])},{int(row[1])},{','.join(repr(float(x)) for x in row[2:6])},{ending}\n"
        for row, ending in zip(rows, endings, strict=True)
    ]
    path.write_text("".join(lines), encoding="ascii")
