# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
"""Pictures out of a container, with the damage named."""

from collections.abc import Iterator

import av
from av.container import InputContainer
from av.video.frame import VideoFrame
from av.video.stream import VideoStream

from survtrack.errors import InputError


class Decoder:
    """Iterates the pictures of a container's first video stream.

    A recording may start amid a group of pictures, so that packets before the first picture may
    fail; later ones may not.

    Attributes:
        count: pictures so far.
        discarded: packets so far that the container says not to show: those before the start of
            its edit list.
    """

    def __init__(self, container: InputContainer, name: str) -> None:
        self.count = 0
        self.discarded = 0
        self._container = container
        self._name = name

    def __iter__(self) -> Iterator[VideoFrame]:
        """Raises InputError when the container or a picture after the first is broken."""
        packets = self._container.demux(self._container.streams.video[0])
        while True:
            try:
                packet = next(packets, None)
                if packet is None:
                    return
                pictures = [] if self._is_cut(packet) else packet.decode()
            except (av.FFmpegError, OSError) as error:
                if self.count == 0 and isinstance(error, av.InvalidDataError):
                    continue
                cause = getattr(error, "strerror", None) or error
                raise InputError(
                    f"{self._name}: cannot be decoded after frame {self.count}: {cause}"
                ) from error
            self.discarded += packet.is_discard
            for picture in pictures:
                self.count += 1
                yield picture

    def _is_cut(self, packet: "av.Packet[VideoStream]") -> bool:
        """True for the half packet at the end of a file that was cut short.

        In a transport stream the same mark means that something was lost on the way, which
        decoders are made to conceal.
        """
        return packet.is_corrupt and self._container.format.name != "mpegts"
