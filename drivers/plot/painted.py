# SPDX-License-Identifier: BSD-3-Clause
"""Ellipses of many bodies as one image, painted from the back to the front. matplotlib takes some 20 microseconds for
each outline; here the samples of an image are asked which of them is on top."""
import numpy as np
from matplotlib.artist import Artist

SAMPLES = 3             # of a pixel along x and along y
CELLS = 2_000_000       # samples that are looked at together
CHEAP = 20_000_000      # samples of all outlines: of more, those that no pixel shows are left out first
LEAST = 0.71            # samples: a circle so large holds one wherever it is


class Painted(Artist):
    """Ellipses, the last one on top, in the units of the axes; angles in degrees, rim: width of outlines in points."""

    def __init__(self, centres, widths, heights, angles, colours, rim_colour, rim):
        super().__init__()
        self.set_zorder(1)      # that of matplotlib's collections
        self.set_in_layout(False)
        self.centres, self.rim = centres.astype(np.float32), rim
        self.half = np.stack([widths, heights], axis=1).astype(np.float32) / 2
        turned = np.radians(angles) if np.any(angles) else None
        self.axis = None if turned is None else np.stack([np.cos(turned), np.sin(turned)], axis=1).astype(np.float32)
        self.colours = np.concatenate([np.zeros((1, 4), np.uint8), rgba([rim_colour]), rgba(colours)])

    def draw(self, renderer):
        if not self.get_visible() or not len(self.centres):
            return
        box = self.axes.bbox
        left, bottom = int(np.floor(box.x0)), int(np.floor(box.y0))
        shape = int(np.ceil(box.y1)) - bottom, int(np.ceil(box.x1)) - left
        pixels = self.axes.transData.transform(self.centres) - (left, bottom)
        scale = self.axes.transData.transform([(1, 0)])[0, 0] - self.axes.transData.transform([(0, 0)])[0, 0]
        picture = image(shape, pixels.astype(np.float32), scale * self.half, self.axis, renderer.points_to_pixels(self.rim),
                        self.colours)
        context = renderer.new_gc()
        self._set_gc_clip(context)
        renderer.draw_image(context, left, bottom, picture)
        context.restore()


def rgba(colours):
    """Bytes [n][4] of n words #RRGGBB."""
    letters = np.ascontiguousarray(np.asarray(colours, "U7")).view(np.uint32).reshape(-1, 7)[:, 1:]
    digits = (letters & 15) + 9 * (letters >= ord("A"))
    return np.column_stack([16 * digits[:, ::2] + digits[:, 1::2], np.full(len(letters), 255)]).astype(np.uint8)


def image(shape, centres, half, axis, rim, colours):
    """Bytes [rows][columns][4], the lowest row first, of ellipses in pixels; colours: of nothing, of rims, of each."""
    fine = SAMPLES * np.array(shape)
    keep = np.arange(len(centres))
    below = None
    if np.sum(_boxes(SAMPLES * half, SAMPLES * rim) ** 2) > CHEAP:
        front = _in_front(shape, centres, half, rim)
        below = _on_top(shape, centres[front], half[front], None if axis is None else axis[front], rim, front)
        keep = np.unique((below[below > 0] - 1) >> 1)
    top = _on_top(fine, SAMPLES * centres[keep], SAMPLES * half[keep], None if axis is None else axis[keep], SAMPLES * rim, keep)
    if below is not None:
        # what shows between the middles of pixels alone has been left out: no hole stays where it was
        covered = np.pad(below > 0, 1)
        inside = np.all([covered[1 + i:1 + i + shape[0], 1 + j:1 + j + shape[1]] for i in (-1, 0, 1) for j in (-1, 0, 1)], axis=0)
        below = np.repeat(np.repeat(np.where(inside, below, 0), SAMPLES, axis=0), SAMPLES, axis=1)
        top = np.where(top > 0, top, below)
    index = np.where(top == 0, 0, np.where(top & 1, 1, (top >> 1) + 1))     # see _on_top
    total = np.zeros((*shape, 4), np.uint16)
    for i in range(SAMPLES):
        for j in range(SAMPLES):
            total += colours[index[i::SAMPLES, j::SAMPLES]]
    count = np.maximum(total[..., 3:] // 255, 1)
    return np.concatenate([(total[..., :3] + count // 2) // count, total[..., 3:] // SAMPLES**2], axis=2).astype(np.uint8)


def _boxes(half, rim):
    """Samples across the square that holds an outline, from the sample that is nearest to its centre."""
    return 2 * np.floor(np.maximum(np.max(half, axis=1) + rim / 2, LEAST) + 0.5).astype(int) + 1


def _in_front(shape, centres, half, rim):
    """Who has nobody as large in front of it in the same pixel: of a lattice, one in a row."""
    kept, boxes = [], _boxes(half, rim)
    pixel = np.clip(np.floor(centres), -1, np.array(shape[::-1])).astype(int) + 1
    place = pixel[:, 1] * (shape[1] + 2) + pixel[:, 0]
    last = np.empty((shape[0] + 2) * (shape[1] + 2), np.int64)
    for box in np.unique(boxes):
        these = np.flatnonzero(boxes == box)
        last[place[these]] = these
        kept.append(these[last[place[these]] == these])
    return np.sort(np.concatenate(kept))


def _on_top(shape, centres, half, axis, rim, numbers):
    """The ellipse of the highest place at each sample: 2 number + 1 of its rim, 2 number + 2 of what is inside of it; 0
    where there is none. Numbers rise."""
    top = np.zeros(shape, np.int32)
    boxes = _boxes(half, rim)
    low, high = -boxes, boxes + np.array([shape[1], shape[0]])[:, None]
    seen = np.all((centres.T > low) & (centres.T < high), axis=0)
    for box in np.unique(boxes[seen]):
        these = np.flatnonzero(seen & (boxes == box))
        padded = np.zeros((shape[0] + 4 * box, shape[1] + 4 * box), np.int32)
        each = max(1, CELLS // box**2)
        for first in range(0, len(these), each):
            part = these[first:first + each]
            _paint(padded, box, centres[part], half[part], None if axis is None else axis[part], rim, numbers[part])
        np.maximum(top, padded[2 * box:2 * box + shape[0], 2 * box:2 * box + shape[1]], out=top)
    return top


def _paint(padded, box, centres, half, axis, rim, numbers):
    """Those in one size of box, onto samples whose middles are half a sample from their corners, 2 box samples from the
    padded ones."""
    nearest = np.floor(centres).astype(np.int32)
    from_centre = nearest + np.float32(0.5) - centres
    along = np.arange(-(box // 2), box // 2 + 1, dtype=np.int32)
    dx = (from_centre[:, 0, None] + along)[:, None, :]
    dy = (from_centre[:, 1, None] + along)[:, :, None]
    if axis is not None:
        cos, sin = axis[:, 0, None, None], axis[:, 1, None, None]
        dx, dy = cos * dx + sin * dy, cos * dy - sin * dx
    outer, inner = np.maximum(half + rim / 2, LEAST), np.maximum(half - rim / 2, 1e-6)
    outer, inner = (size.astype(np.float32)[:, :, None, None] for size in (outer, inner))
    within = (dx / outer[:, 0]) ** 2 + (dy / outer[:, 1]) ** 2 <= 1
    filled = (dx / inner[:, 0]) ** 2 + (dy / inner[:, 1]) ** 2 <= 1
    values = (2 * numbers.astype(np.int32) + 1)[:, None, None] + filled
    rows = (nearest[:, 1, None] + along + 2 * box)[:, :, None] * padded.shape[1]
    places = rows + (nearest[:, 0, None] + along + 2 * box)[:, None, :]
    padded.reshape(-1)[places[within]] = values[within].astype(np.int32)    # of a place that is named twice the last stays
