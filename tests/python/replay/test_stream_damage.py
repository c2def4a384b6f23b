# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""What is whole before a cut or damage is never lost; nothing that comes in crashes a reader."""

import random
import tracemalloc
import zlib
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fakes import Result
from survtrack.errors import InputError
from survtrack.replay import TrackStreamDecoder, TrackStreamReader, read_track_stream
from survtrack.replay.varint import put
from track_streams import decoded, pieces, runs, stream, walk


def frames_or_none(data: bytes) -> tuple[list[Any], str | None] | None:
    """Frames and problem; None when the start is refused."""
    try:
        frames, decoder = decoded(data)
    except InputError as error:
        assert str(error).startswith("x.svt: ")
        return None
    return frames, decoder.problem


def test_every_prefix_gives_its_whole_frames() -> None:
    parts = pieces(walk(8))
    data = b"".join(parts)
    whole = decoded(data)[0]
    ends = [sum(map(len, parts[: k + 1])) for k in range(len(parts))]
    for length in range(len(data)):
        frames, decoder = decoded(data[:length])
        count = max(0, sum(end <= length for end in ends) - 1)
        assert frames == whole[:count]
        assert decoder.byte_count == max((end for end in ends if end <= length), default=0)
        words = f"after frame {count} of it; what was before is whole"
        if count == 0:
            words = "in its first frame; it holds no whole frame"
        if length < ends[0]:
            words = "in its header; it holds no frames"
        assert decoder.problem is not None and decoder.problem == f"x.svt: is cut {words}"
    assert decoded(data)[1].problem is None


@given(runs(), st.data())
def test_a_cut_anywhere_in_any_run(results: list[Result], data: Any) -> None:
    parts = pieces(results)
    kept = data.draw(st.integers(0, len(results)))
    more = data.draw(st.integers(0, len(parts[kept + 1]) - 1))
    whole = decoded(b"".join(parts))[0]
    frames, decoder = decoded(b"".join(parts[: kept + 1]) + parts[kept + 1][:more])
    assert frames == whole[:kept]
    assert "is cut" in (decoder.problem or "")


@given(runs(), st.lists(st.integers(1, 40)))
def test_pieces_of_any_size_give_the_same_frames(results: list[Result], sizes: list[int]) -> None:
    data = stream(results)
    decoder, frames, at = TrackStreamDecoder(), [], 0
    for size in [*sizes, len(data)]:
        frames += decoder.feed(data[at : at + size])
        at += size
    assert frames == decoded(data)[0] and decoder.problem is None


@given(runs(), st.data())
def test_flipped_bytes_are_noticed_and_cost_no_frame_before_them(
    results: list[Result], data: Any
) -> None:
    parts = pieces(results)
    original = b"".join(parts)
    whole = decoded(original)[0]
    broken = bytearray(original)
    places = data.draw(
        st.lists(st.integers(0, len(original) - 1), min_size=1, max_size=3, unique=True)
    )
    for place in places:
        broken[place] ^= data.draw(st.integers(1, 255))
    first = min(places)
    ends = [sum(map(len, parts[: k + 1])) for k in range(len(parts))]
    read = frames_or_none(bytes(broken))
    if read is None:
        assert first < ends[0]
        return
    frames, problem = read
    count = max(0, sum(end <= first for end in ends) - 1)
    assert frames == whole[:count]
    assert problem is not None and ("is damaged" in problem or "is cut" in problem)


@given(st.binary(max_size=200))
def test_any_bytes_are_refused_or_empty(data: bytes) -> None:
    assert frames_or_none(data) in (None, ([], "x.svt: is cut in its header; it holds no frames"))


def sealed(*records: bytes) -> bytes:
    """A stream of records with right checksums, whatever is in them."""
    header = pieces([])[0]
    data, crc = bytearray(header), int.from_bytes(header[-4:], "little")
    for record in records:
        start = bytearray()
        put(start, len(record))
        crc = zlib.crc32(bytes(start) + record, crc)
        data += bytes(start) + record + crc.to_bytes(4, "little")
    return bytes(data)


@given(st.lists(st.binary(max_size=60), max_size=6))
def test_records_that_no_encoder_wrote_give_damage_or_sound_frames(records: list[bytes]) -> None:
    read = frames_or_none(sealed(*records))
    assert read is not None
    for frame in read[0]:
        for track in frame.tracks:
            assert 0 < track.id <= 2**53 and abs(track.position[0]) <= 2**36
            assert track.box.width >= 0 and track.covariance_px2[0] >= 0
        for each in frame.regions:
            assert 0 <= each.box.x < each.box.x + each.box.width <= 64
            assert 0 <= each.box.y < each.box.y + each.box.height <= 48


FLAGS_AND_PLACE = bytes([1, 0, 0])


@pytest.mark.parametrize(
    ("record", "words"),
    [
        (b"\0\0", "ends within a number"),
        (b"\0\0\x05" + b"\0" * 8, "5 tracks cannot be in 8 bytes"),
        (b"\0\0\0\0\0", r"0 regions cannot be in 1 bytes"),
        (b"\0\0\0\x08\0\0\0", r"4 regions cannot be in 3 bytes"),
        (b"\0\0\0\x02\x06\0\0\2\2\0", r"1 byte\(s\) are left over"),
        (b"\0\0\0\x02\x0e\0\0\2\2", "the flags 0x0e of a region are none of version 2"),
        (b"\0\0\0\x02\x04\0\0\2\2", "the flags 0x04 of a region are none of version 2"),
        (b"\0\0\0\x02\x02", "a region is out of bounds"),
        (b"\0\0\0\x02\x06\1\0\2\2", "a region is out of bounds"),
        (b"\0\0\0\x02\x06\0\0\2\0", "a region is out of bounds"),
        (b"\0\0\0\x02\x06\0\0\x82\1\2", "a region is out of bounds"),
        (b"\0\0\0\x02\x05" + b"\xff" * 7 + b"\x7f\0\0\2\2", "a region is out of bounds"),
        (b"\0\0\0\x02\x05\1\0\0\2", "ends within a number"),
        (b"\0\0\x01\0\x80\0\0", "the flags 0x80 are none of version 2"),
        (b"\0\0\x01\0\x40\0\0\x80\x08", "the mask 0x400 is none of version 2"),
        (b"\0\0\x01\0\x40\0\0\x04\x42", "track 1 is out of bounds"),
        (b"\0\0\x01\0\x40\0\0\x80\x04\x42", "track 1 is out of bounds"),
        (b"\0\0\x01\0\x08\0\0\x01\0\0\0", "track 1 is out of bounds"),
        (b"\0\0\x01\0\x20\0\0\0\0\x7f", "track 1 is out of bounds"),
        (b"\0\0\x01" + b"\xff" * 7 + b"\x7f" + FLAGS_AND_PLACE, "is out of bounds"),
        (b"\0" + b"\xff" * 8 + b"\x7f\0", "does not follow"),
        (b"\0" + b"\xff" * 9 + b"\0", "more than 63 bits"),
    ],
)
def test_what_is_wrong_with_a_record_is_said(record: bytes, words: str) -> None:
    frames, decoder = decoded(sealed(record))
    assert frames == []
    with pytest.raises(ValueError, match=words):
        raise ValueError(decoder.problem)
    assert (decoder.problem or "").startswith("x.svt: is damaged in its first frame: ")


def test_records_cannot_be_left_out_doubled_or_swapped_unseen() -> None:
    header, first, second, third, *_ = pieces(walk(5))
    for records in ((first, third), (first, first), (second, first)):
        frames, decoder = decoded(header + b"".join(records))
        assert len(frames) == (records[0] is first)
        assert "its checksum is wrong" in (decoder.problem or "")


def test_more_after_the_end_is_damage() -> None:
    data = stream(walk(3))
    for rest in (b"\0", data):
        frames, decoder = decoded(data + rest)
        assert len(frames) == 3
        assert "is damaged after frame 3 of it: more bytes follow its end" in (
            decoder.problem or ""
        )


def test_a_long_claim_takes_no_memory() -> None:
    """However much a stream sends, a reader keeps one record at most."""
    header = pieces([])[0]
    claim = bytearray()
    put(claim, 2**62)
    frames, decoder = decoded(header + bytes(claim))
    assert frames == [] and "a record would have" in (decoder.problem or "")
    tracemalloc.start()
    try:
        for _ in range(100):
            assert decoder.feed(bytes(1_000_000)) == []
        assert tracemalloc.get_traced_memory()[0] < 3_000_000
    finally:
        tracemalloc.stop()


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"", "x.svt: is empty"),
        (b"frame,time_s\n1,0\n", "x.svt: is no track stream: it begins with b'frame,ti'"),
        (b"\x89PNG\r\n\x1a\n", "x.svt: is no track stream: it begins with b'.*PNG"),
        (b"\x89SVT\n\x1a\n\x02", "x.svt: is no track stream"),
        (b"\x89SVT\r\n\x1a\n\x03", "x.svt: is a track stream of version 3; this survtrack reads v"),
        (b"\x89SVT\r\n\x1a\n\x01", "is a track stream of version 1; .* version 2: `survtrack run"),
        (b"\x89SVT\r\n\x1a\n\x02", "x.svt: is cut in its header; it holds no frames"),
        (b"\x89SV", "x.svt: is cut in its header; it holds no frames"),
        (b"\x89SVT\r\n\x1a\n\x02" + b"\xff" * 9, "its header is damaged: a number has more than"),
        (b"\x89SVT\r\n\x1a\n\x02\xff\x7f", "its header is damaged: it would have 16383 bytes"),
        (b"\x89SVT\r\n\x1a\n\x02\0\0\0\0\0", "its header is damaged: its checksum is wrong"),
    ],
)
def test_foreign_files_are_told_in_words(tmp_path: Path, data: bytes, words: str) -> None:
    path = tmp_path / "x.svt"
    path.write_bytes(data)
    for read in (read_track_stream, TrackStreamReader):
        with pytest.raises(InputError, match=words) as caught:
            read(path)
        assert str(caught.value).startswith(f"{tmp_path}")


@pytest.mark.parametrize(
    ("body", "words"),
    [
        (bytes([64, 48, 10, 1, 16, 4, 8, 32]), "its header is damaged: it ends within a number"),
        (bytes([64, 48, 10, 1, 16, 4, 8, 32, 0, 1]), r"is damaged: 1 byte\(s\) are left"),
        (bytes([64, 0, 10, 1, 16, 4, 8, 32, 0]), "its header's height_px is 0; 1 to 16777216"),
        (bytes([64, 48, 10, 1, 16, 0, 8, 32, 0]), "its header's steps_per_px_per_s is 0; 1 to"),
        (
            bytes([64, 48, 10, 1, 16, 4, 8, 32]) + b"\xff" * 8 + b"\x7f",
            "its header's lost_damping_ticks is 9223372036854775807; 0 to 9007199254740992",
        ),
    ],
)
def test_headers_that_no_encoder_wrote(body: bytes, words: str) -> None:
    data = b"\x89SVT\r\n\x1a\n\x02" + bytes([len(body)]) + body
    with pytest.raises(InputError, match=words):
        decoded(data + zlib.crc32(data).to_bytes(4, "little"))


def test_files_that_cannot_be_read(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"none\.svt: no such file"):
        read_track_stream(tmp_path / "none.svt")
    with pytest.raises(InputError, match="is a folder, a file is needed"):
        read_track_stream(tmp_path)


def test_a_long_file_is_read_in_pieces(tmp_path: Path) -> None:
    random.seed(1)
    path = tmp_path / "long.svt"
    path.write_bytes(stream(walk(3000)))
    assert path.stat().st_size > 40_000
    whole = read_track_stream(path)
    assert (len(whole.frames), whole.problem, whole.byte_count) == (3000, None, path.stat().st_size)
    path.write_bytes(path.read_bytes()[:-30])
    reader = TrackStreamReader(path)
    assert [*reader] == whole.frames[: len([*reader])] and len([*reader]) >= 2997
    assert "is cut after frame" in (reader.problem or "")
