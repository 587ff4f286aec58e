"""Pictures of the guest's screen and of the desk: read as bytes (RGB) and compared."""
import functools
import pathlib
import re
import struct
import zlib


def read_ppm(path):
    """Returns width, height and the bytes of a binary PPM file."""
    data = pathlib.Path(path).read_bytes()
    head = re.match(rb"P6\s+(\d+)\s+(\d+)\s+255\s", data)
    if head is None:
        raise ValueError(f"{path}: is no binary PPM file.")
    return int(head[1]), int(head[2]), data[head.end():]


def read_png(path):
    """Returns width, height and the bytes of a PNG file with 8 bits a channel, not interlaced; opacity is left out."""
    data = pathlib.Path(path).read_bytes()
    width, height, depth, kind, _, _, interlaced = struct.unpack(">IIBBBBB", data[16:29])
    channels = {2: 3, 6: 4}.get(kind)
    if depth != 8 or channels is None or interlaced:
        raise ValueError(f"{path}: has a form that is not read.")
    rows = _unfiltered(zlib.decompress(_image_data(data)), width * channels, channels, height)
    if channels == 3:
        return width, height, bytes(rows)
    rgb = bytearray(width * height * 3)
    for channel in range(3):
        rgb[channel::3] = rows[channel::4]
    return width, height, bytes(rgb)


def _image_data(data):
    at, parts = 8, []
    while at < len(data):
        length, name = struct.unpack(">I4s", data[at:at + 8])
        if name == b"IDAT":
            parts.append(data[at + 8:at + 8 + length])
        at += length + 12
    return b"".join(parts)


def _unfiltered(data, row_bytes, step, height):
    """Undoes the filters of PNG (section 9 of its specification)."""
    rows, above = bytearray(), bytearray(row_bytes)
    for y in range(height):
        begin = y * (row_bytes + 1)
        above = _unfiltered_row(data[begin], bytearray(data[begin + 1:begin + 1 + row_bytes]), above, step)
        rows += above
    return rows


def _unfiltered_row(kind, row, above, step):
    if kind == 0:
        return row
    for i in range(len(row)):
        left = row[i - step] if i >= step else 0
        corner = above[i - step] if i >= step else 0
        row[i] = (row[i] + (left, above[i], (left + above[i]) // 2, _paeth(left, above[i], corner))[kind - 1]) & 255
    return row


def _paeth(left, above, corner):
    by_left, by_above, by_corner = abs(above - corner), abs(left - corner), abs(left + above - 2 * corner)
    if by_left <= by_above and by_left <= by_corner:
        return left
    return above if by_above <= by_corner else corner


@functools.lru_cache(maxsize=8)  # a screen is looked at more often than it changes
def share_within(one, other, tolerance):
    """The share of the pixels of which no channel differs by more than the tolerance."""
    if one == other:
        return 1.0
    pixels, far = len(one) // 3, set()
    for i, (a, b) in enumerate(zip(one, other)):
        if a != b and not -tolerance <= a - b <= tolerance:
            far.add(i // 3)
    return 1 - len(far) / pixels


def corner(picture, share_x, share_y):
    """The bytes of the upper left part of a picture, by its share of width and height."""
    width, height, data = picture
    columns, rows = int(width * share_x), int(height * share_y)
    return b"".join(data[3 * y * width:3 * (y * width + columns)] for y in range(rows))


def without(picture, share_x, share_y):
    """The bytes of a picture but for its upper right part: from this share of its width, to this one of its height."""
    width, height, data = picture
    columns, rows = int(width * share_x), int(height * share_y)
    return b"".join(data[3 * y * width:3 * (y * width + columns)] for y in range(rows)) + data[3 * rows * width:]
