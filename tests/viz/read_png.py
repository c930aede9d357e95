"""Reads a PNG file of 8-bit RGB by the specification alone (https://www.w3.org/TR/png/), with nothing of packstone.

read_png.py FILE PIXELS writes the (height * width * 3) bytes to PIXELS and prints the size and what the file says.
"""
import struct
import sys
import zlib

PASS = {0: lambda left, upper, corner: 0,
        1: lambda left, upper, corner: left,
        2: lambda left, upper, corner: upper,
        3: lambda left, upper, corner: (left + upper) // 2}


def paeth(left, upper, corner):
    guess = left + upper - corner
    return min((abs(guess - left), 0, left), (abs(guess - upper), 1, upper), (abs(guess - corner), 2, corner))[2]


PASS[4] = paeth


def chunks(data):
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "no PNG signature"
    place = 8
    while place < len(data):
        size, kind = struct.unpack_from(">I4s", data, place)
        body = data[place + 8:place + 8 + size]
        (crc,) = struct.unpack_from(">I", data, place + 8 + size)
        assert crc == zlib.crc32(kind + body), f"the CRC of {kind} is wrong"
        yield kind, body
        place += 12 + size


def unfiltered(rows, width, height):
    row_bytes = width * 3
    assert len(rows) == height * (row_bytes + 1), "the pixels are too few or too many"
    above = bytes(row_bytes)
    for first in range(0, len(rows), row_bytes + 1):
        predict = PASS[rows[first]]
        row = bytearray(rows[first + 1:first + 1 + row_bytes])
        for i in range(row_bytes):
            left, corner = (row[i - 3], above[i - 3]) if i >= 3 else (0, 0)
            row[i] = (row[i] + predict(left, above[i], corner)) & 255
        yield bytes(row)
        above = row


def main(path, pixels):
    kinds, packed = [], b""
    for kind, body in chunks(open(path, "rb").read()):
        kinds.append(kind)
        if kind == b"IHDR":
            width, height, *form = struct.unpack(">IIBBBBB", body)
            assert form == [8, 2, 0, 0, 0], "not 8-bit RGB without interlacing"
            print(f"size {width} {height}")
        elif kind == b"pHYs":
            print("pHYs", *struct.unpack(">IIB", body))
        elif kind == b"tEXt":
            print("tEXt", body.decode("latin-1").replace("\0", "="))
        elif kind == b"iTXt":
            keyword, rest = body.split(b"\0", 1)
            assert rest[:4] == bytes(4)
            print("iTXt", keyword.decode() + "=" + rest[4:].decode("utf-8"))
        elif kind == b"IDAT":
            packed += body
    assert kinds[0] == b"IHDR" and kinds[-1] == b"IEND" and kinds.count(b"IEND") == 1
    with open(pixels, "wb") as out:
        out.writelines(unfiltered(zlib.decompress(packed), width, height))


sys.stdout.reconfigure(encoding="utf-8")
main(*sys.argv[1:])
