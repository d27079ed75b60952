#!/usr/bin/env python3
"""Paints the example pictures of this folder: maze.png, funnel.png, harbour.png.

Each is drawn four times as large and averaged down, as a painting program's smooth brush would
leave it: grey edges between wall and air, pale blue ones between wall and water. Needs nothing but
Python's own library. Usage: make_pictures.py [FOLDER]
"""

import os
import struct
import sys
import zlib

WHITE, BLACK, BLUE, GREEN, RED = (255,) * 3, (0,) * 3, (0, 90, 255), (0, 200, 0), (220, 0, 0)
FINE = 4  # drawn pixels in a picture's pixel, each way


def write_png(path, rows):
    """Writes rows of (r, g, b) tuples as an RGB PNG."""

    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 2, 0, 0, 0)
    raw = b"".join(b"\0" + bytes(v for pixel in row for v in pixel) for row in rows)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) +
                   chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


def render(width, height, colour_at):
    """Averages colour_at(x, y), in picture pixels with y down, over FINE x FINE points."""
    rows = []
    for y in range(height):
        row = []
        for x in range(width):
            total = [0, 0, 0]
            for i in range(FINE * FINE):
                colour = colour_at(x + (i % FINE + 0.5) / FINE, y + (i // FINE + 0.5) / FINE)
                for c in range(3):
                    total[c] += colour[c]
            row.append(tuple((t + FINE * FINE // 2) // (FINE * FINE) for t in total))
        rows.append(row)
    return rows


def maze(x, y):
    """Thin walls of two pixels, some of them slanted, under a reservoir."""
    if x < 3 or x > 317 or y > 177:
        return WHITE
    for shelf, (left, right) in enumerate([(0, 260), (60, 320), (0, 260), (60, 320)]):
        wall = 58 + 30 * shelf + (0.06 if shelf % 2 == 0 else -0.06) * (x - 160)
        if left <= x <= right and abs(y - wall) < 1:
            return WHITE
    return BLUE if y < 46 and y > 8 and x < 250 else BLACK


def funnel(x, y):
    """A slanted funnel over a basin, with a tap (emitter) above and a sink (drain) below."""
    left = 40 + 0.95 * max(0.0, y - 30)
    right = 275 - 0.85 * max(0.0, y - 30)
    if 30 < y < 142 and (left - 8 < x < left or right < x < right + 8):
        return WHITE
    if x < 2 or x > 318 or y > 234:
        return WHITE
    if 118 < x < 138 and y < 6:
        return GREEN
    if 150 < x < 170 and 230 < y <= 234:
        return RED
    return BLUE if 40 < y < 115 and left <= x <= right else BLACK


def harbour(x, y):
    """A sloping beach, a breakwater of round stones, a quay and the sea between them."""
    if y > 150 - 0.35 * max(0.0, 110 - x) - 6 * ((x * 0.05) % 1) * (1 - (x * 0.05) % 1):
        return WHITE
    for cx, cy, r in [(205, 142, 16), (228, 143, 15), (216, 122, 13), (240, 147, 9)]:
        if (x - cx) ** 2 + (y - cy) ** 2 < r * r:
            return WHITE
    if x > 296 and y > 70:
        return WHITE
    return BLUE if y > 96 else BLACK


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))
    for name, width, height, picture in [("maze", 320, 180, maze), ("funnel", 320, 240, funnel),
                                         ("harbour", 320, 160, harbour)]:
        write_png(os.path.join(folder, name + ".png"), render(width, height, picture))


if __name__ == "__main__":
    main()
