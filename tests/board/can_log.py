"""Candump logs for the guest: one shows a standing aircraft in each flight phase; a player sends it at its own pace."""
import collections
import itertools
import re
import threading
import time

SECOND_US = 1_000_000
PHASE_IDENTIFIER = 1830
# Between two messages of an identifier; a position stands still after 0.25 s. The whole log keeps an emulated processor busy.
PERIOD_US = 100_000
# Rates and speeds: without them the picture of an aircraft stands.
MOVING_IDENTIFIERS = {303, 304, 305, 314, 327, 1039}
# Codes of message 1830; the panel of configs/switches/one_hot.toml has no line for some of them.
PHASE_CODES = {
    "ground": 10, "takeoff.start": 21, "takeoff.first_climb": 22, "takeoff.second_climb": 23, "cruise": 30, 
    "approach.descent": 41, "approach.initial": 42, "approach.final": 43, "approach.landing": 44,
    "go_around.abort": 51, "go_around.replanning": 52,
}

Frame = collections.namedtuple("Frame", "time_us identifier data")


def read_log(path):
    """Reads a log of frames with 11-bit identifiers and CANaerospace's data."""
    frames = []
    for line in open(path, encoding="ascii"):
        match = re.fullmatch(r"\((\d+)\.(\d{6})\) +\S+ ([0-9A-F]{3})#([0-9A-F]{8,16})\s*", line)
        if match is None:
            raise ValueError(f"{path}: is no log of the board's bus: {line.strip()!r}.")
        frames.append(Frame(int(match[1]) * SECOND_US + int(match[2]), int(match[3], 16), bytes.fromhex(match[4])))
    return frames


def write_log(frames, path):
    with open(path, "w", encoding="ascii") as out:
        for frame in frames:
            seconds, rest = divmod(frame.time_us, SECOND_US)
            out.write(f"({seconds}.{rest:06d}) can0 {frame.identifier:03X}#{frame.data.hex().upper()}\n")


def standing_second(frames):
    """The last second of a log, each message ten times at most, with its last value, and at rest."""
    newest = {(frame.identifier, frame.data[1]): frame.data for frame in frames}  # the halves of a number have types of their own
    second, due_us = [], {}
    for frame in frames:
        kind = frame.identifier, frame.data[1]
        if frame.time_us <= frames[-1].time_us - SECOND_US or frame.time_us < due_us.get(kind, 0):
            continue
        due_us[kind] = frame.time_us + PERIOD_US * 9 // 10  # the senders' own periods are no fractions of this one
        value = newest[frame.identifier, frame.data[1]][4:]
        if frame.identifier in MOVING_IDENTIFIERS:
            value = bytes(len(value))
        second.append(frame._replace(data=frame.data[:4] + value))
    return second


def phase_log(frames, phases, seconds_each):
    """A log of the standing aircraft that states each phase for so many seconds, and the time at which each one ends."""
    second = standing_second(frames)
    log, ends, codes = [], [], MessageCodes()
    shift_us = 0
    for phase in phases:
        for _ in range(seconds_each):
            for frame in second:
                data = frame.data
                if frame.identifier == PHASE_IDENTIFIER:
                    data = data[:4] + bytes([PHASE_CODES[phase]]) + data[5:]
                log.append(codes.number(Frame(frame.time_us + shift_us, frame.identifier, data)))
            shift_us += SECOND_US
        ends.append(log[-1].time_us)
    return log, ends


class MessageCodes:
    """Numbers the messages of each identifier, as their sender does."""

    def __init__(self):
        self._next = collections.Counter()

    def number(self, frame):
        code = self._next[frame.identifier] % 256
        self._next[frame.identifier] += 1
        return frame._replace(data=frame.data[:3] + bytes([code]) + frame.data[4:])


class LogPlayer(threading.Thread):
    """Sends a log at its own pace up to a time; from there on its last second again and again, so that no value becomes stale.

    What is due within a tenth of a second is sent together: every write wakes the emulator, which costs more than the frames do.

    send      takes a list of frames
    sent      frames that were sent
    late      times that this machine fell behind by more than a quarter of a second; the pace then goes on from there
    began     for each code of a phase, when its first message since play_to() was sent (time.monotonic)
    error     what ended the thread, or None
    """

    def __init__(self, send, frames):
        super().__init__(daemon=True)
        self.sent = self.late = 0
        self.began, self.error = {}, None
        self._send, self._frames = send, frames
        self._until_us = frames[0].time_us
        self._stopped = threading.Event()
        self._codes = MessageCodes()
        self._origin_s = 0.0

    def play_to(self, time_us):
        self.began = {}
        self._until_us = time_us

    def stop(self):
        self._stopped.set()
        self.join(10)

    def run(self):
        try:
            self._play()
        except Exception as error:  # the machine's end, too
            if not self._stopped.is_set():
                self.error = error

    def _play(self):
        at = 0
        self._origin_s = time.monotonic() - self._frames[0].time_us / SECOND_US
        while not self._stopped.is_set():
            batch = self._batch(at, self._until_us)
            if batch:
                self._send_in_time(batch)
                at += len(batch)
            else:
                self._repeat_second(at)

    def _batch(self, begin, until_us):
        """The frames from one on that are due within its tenth of a second."""
        if begin == len(self._frames):
            return []
        until_us = min(until_us, self._frames[begin].time_us + PERIOD_US - 1)
        return list(itertools.takewhile(lambda frame: frame.time_us <= until_us, self._frames[begin:begin + 1000]))

    def _repeat_second(self, end):
        if end == 0:
            self._stopped.wait(0.01)
            return
        last_us = self._frames[end - 1].time_us
        self._origin_s += 1
        at = end
        while at > 0 and self._frames[at - 1].time_us > last_us - SECOND_US:
            at -= 1
        while at < end and not self._stopped.is_set():
            batch = self._batch(at, last_us)
            self._send_in_time(batch)
            at += len(batch)

    def _send_in_time(self, batch):
        wait_s = self._origin_s + batch[-1].time_us / SECOND_US - time.monotonic()
        if wait_s > 0:
            self._stopped.wait(wait_s)
        elif wait_s < -0.25:
            self.late += 1
            self._origin_s -= wait_s
        for frame in batch:
            if frame.identifier == PHASE_IDENTIFIER:
                self.began.setdefault(frame.data[4], time.monotonic())
        self._send([self._codes.number(frame) for frame in batch])
        self.sent += len(batch)
