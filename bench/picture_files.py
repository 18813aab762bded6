"""Reads plain EXR files and writes PNG files, without any package: the agreement with Cycles must
be checkable wherever Python is. Scan lines, uncompressed or ZIP, half or float, one part."""
import struct
import zlib

# [OpenEXR file layout; "Compression", "Pixel data"]
MAGIC = 20000630
LINES_OF_COMPRESSION = {0: 1, 2: 1, 3: 16}  # none, ZIP of one line, ZIP of 16
HALF, FLOAT = 1, 2


def _string(data, at):
    end = data.index(b"\0", at)
    return data[at:end].decode(), end + 1


def _header(data):
    if struct.unpack_from("<I", data)[0] != MAGIC or data[5] & 0x1A:
        raise ValueError("not an EXR file of one part with scan lines")
    attributes, at = {}, 8
    while data[at] != 0:
        name, at = _string(data, at)
        _, at = _string(data, at)
        size, = struct.unpack_from("<i", data, at)
        attributes[name] = data[at + 4:at + 4 + size]
        at += 4 + size
    return attributes, at + 1


def _channels(raw):
    channels, at = [], 0
    while raw[at] != 0:
        name, at = _string(raw, at)
        channels.append((name, struct.unpack_from("<i", raw, at)[0]))
        at += 16
    return channels


def _unzip(packed, size):
    """Deflate, then differences of bytes, then the two halves of the bytes interleaved."""
    if len(packed) == size:
        return packed
    data = bytearray(zlib.decompress(packed))
    for i in range(1, len(data)):
        data[i] = (data[i - 1] + data[i] - 128) & 255
    half = (len(data) + 1) // 2
    result = bytearray(len(data))
    result[0::2], result[1::2] = data[:half], data[half:]
    return bytes(result)


def read_exr(path):
    """(width, height, [red, green, blue]), each a list of floats, top row first."""
    with open(path, "rb") as file:
        data = file.read()
    attributes, at = _header(data)
    x0, y0, x1, y1 = struct.unpack("<4i", attributes["dataWindow"])
    width, height = x1 - x0 + 1, y1 - y0 + 1
    compression = attributes["compression"][0]
    if compression not in LINES_OF_COMPRESSION:
        raise ValueError(f"{path}: compression {compression} is not read here")
    run = LINES_OF_COMPRESSION[compression]
    channels = _channels(attributes["channels"])
    bytes_a_line = sum(width * (2 if kind == HALF else 4) for _, kind in channels)
    planes = {name: [0.0] * (width * height) for name in _colour_names(channels)}
    for offset in struct.unpack_from(f"<{(height + run - 1) // run}Q", data, at):
        y, size = struct.unpack_from("<ii", data, offset)
        lines = min(run, y1 - y + 1)
        pixels = _unzip(data[offset + 8:offset + 8 + size], bytes_a_line * lines)
        _take_lines(pixels, channels, width, y - y0, lines, planes)
    return width, height, [planes[name] for name in _colour_names(channels)]


def _colour_names(channels):
    """The main picture: R, G, B, or what Blender calls Composite.Combined.R."""
    names = [name for name, _ in channels]
    for prefix in [""] + sorted({n.rsplit(".", 1)[0] + "." for n in names if "." in n}):
        if all(prefix + c in names for c in "RGB"):
            return [prefix + c for c in "RGB"]
    raise ValueError("the EXR file has no colours")


def _take_lines(pixels, channels, width, first, lines, planes):
    at = 0
    for y in range(first, first + lines):
        for name, kind in channels:
            letter, size = ("e", 2) if kind == HALF else ("f", 4) if kind == FLOAT else ("I", 4)
            if name in planes:
                planes[name][y * width:(y + 1) * width] = struct.unpack_from(
                    f"<{width}{letter}", pixels, at)
            at += width * size


def _chunk(kind, data):
    body = kind + data
    return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))


def _filtered(line, above):
    """The filter with the smallest differences. [PNG specification, 9.2 and 12.7]"""
    left = bytes(3) + line[:-3]
    choices = [(1, bytes((a - b) & 255 for a, b in zip(line, left))),
               (2, bytes((a - b) & 255 for a, b in zip(line, above))),
               (3, bytes((a - (b + c) // 2) & 255 for a, b, c in zip(line, left, above)))]
    kind, best = min(choices, key=lambda c: sum(min(x, 256 - x) for x in c[1]))
    return bytes([kind]) + best


def write_png(path, width, height, rgb):
    """`rgb`: bytes, top row first."""
    lines, above = [], bytes(3 * width)
    for y in range(height):
        line = bytes(rgb[3 * width * y:3 * width * (y + 1)])
        lines.append(_filtered(line, above))
        above = line
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        file.write(_chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)))
        file.write(_chunk(b"IDAT", zlib.compress(b"".join(lines), 9)))
        file.write(_chunk(b"IEND", b""))
