# SPDX-License-Identifier: BSD-3-Clause
"""Bodies as circles and ellipses in a plane, with what shapes.png and the film have in common: one plane and one window
for all frames, planes, lines between bodies, marks that turn with the bodies, and contacts."""
import numpy as np
from matplotlib.collections import EllipseCollection, LineCollection

from . import level, outlines, painted, walls

MOST_MARKED = 2000      # bodies; of more one could see neither marks nor contacts
MOST_DRAWN = 5000       # outlines; more are painted as an image, as matplotlib would take minutes
SMALL = 1 / 100         # of the window: smaller bodies have thin rims and no marks, which would hide their colours
FAR = 3                 # times their own size: bodies that get further are followed, or they would be dots
BODY, RIM, MARK, CONTACT = "#CFE6F5", "#0072B2", "#000000", "#E69F00"
# Fragments that are left when bonds break, from the first frame on by their size; those of one body are pale.
FRAGMENTS, SINGLE = (BODY, "#F4D9A8", "#CDE8C4", "#F2C6CB", "#DCCDEB", "#D8D2A0", "#A8DAD5", "#EBCBB0", "#B3B9EE", "#EFEF9E"), "#F2F2F2"
CLUMPS = FRAGMENTS[:6]
# Of which a picture is made, and between which its edges are smoothed.
COLOURS = ("#FFFFFF", RIM, MARK, CONTACT, walls.WALL, walls.BEHIND, SINGLE, *FRAGMENTS)
EDGES = ((BODY, RIM), (RIM, "#FFFFFF"), (MARK, "#FFFFFF"), (MARK, BODY), (CONTACT, RIM), (CONTACT, MARK), (walls.WALL, "#FFFFFF"),
         (MARK, RIM), *((colour, RIM) for colour in (SINGLE, *FRAGMENTS[1:])))


class Scenery:
    def __init__(self, run, frames):
        """frames: all that will be drawn, the first of them at t = 0; or as many as show how far the bodies get. They
        may come one by one: but for the first none is kept."""
        self.run = run
        self.detailed = run.bodies <= MOST_MARKED
        self.level = level.axes_of(run.walls)
        self.walls = run.walls if self.level is None else level.of_walls(self.level, run.walls)
        first, moved, extents, times = self._look_at(frames)
        self.plane = _plane(moved, 3 if self.level is None else 2, self.walls)
        lows, highs = (np.array(ends)[:, self.plane] for ends in zip(*extents))
        largest, low, high = np.max(highs - lows), np.min(lows, axis=0), np.max(highs, axis=0)
        self.follows = np.max(high - low) > FAR * largest
        if self.follows:
            low, high = np.zeros(2), np.max(highs - lows, axis=0)
        else:
            low, high = self._with_cylinders(times, low, high)
        # a point has a window, too
        margin = max(0.04 * np.max(high - low), 1e-6 * np.max(np.abs([low, high])), 1e-12)
        self.small = 2 * np.min(self.radius) < SMALL * (np.max(high - low) + 2 * margin)
        self.marked = run.turns and self.detailed and not self.small and not run.breaks and run.clumps is None
        if self.marked:     # ends of marks are a radius away from their bodies
            margin = max(margin, 1.05 * np.max(self.radius))
        self.middle, self.half = (low + high) / 2, (high - low) / 2 + margin
        self.outward = _outward(first, self.plane) if self.marked else None
        # The scene says which bodies never touch, those that something holds together being the usual ones.
        apart = run.lines.tolist() if run.touching != 2 and self.detailed else []
        self.apart = {tuple(sorted(pair)) for pair in apart}

    def _look_at(self, frames):
        """One pass: the first frame, how far bodies move along x, y and z, and of each frame what it extends over, and
        its time."""
        first, moved, extents, times = None, np.zeros(3), [], []
        self.fragment_colours = {}
        for frame, colours in _with_colours(map(self._seen, frames)):
            if first is None:
                first, self.radius = frame, outlines.radius(self.run, frame)
            moved = np.maximum(moved, np.max(np.abs(frame.x - first.x), axis=0))
            extents.append(self._extent(frame))
            times.append(frame.t)
            self.fragment_colours[frame.t] = colours
        return first, moved, extents, times

    def _seen(self, frame):
        return frame if self.level is None else level.of_frame(self.level, frame)

    def _extent(self, frame):
        seen = outlines.of(self.run, frame, self.radius)
        return np.min(seen.x - seen.reach, axis=0), np.max(seen.x + seen.reach, axis=0)

    def _with_cylinders(self, times, low, high):
        """The window that shows the cylinders seen along their axes, too, but for those that dwarf the bodies."""
        for t in times:
            for centre, radius, _ in walls.circles(self.walls, t, self.plane):
                if 2 * radius <= FAR * np.max(high - low):
                    low, high = np.minimum(low, centre - radius), np.maximum(high, centre + radius)
        return low, high

    def window(self, frame):
        middle = np.mean(self._extent(frame), axis=0)[self.plane] if self.follows else self.middle
        return middle - self.half, middle + self.half

    def axis_names(self):
        return [f"${'xyz'[axis]}$" for axis in self.plane] if self.level is None else ["along the plane", "normal to the plane"]

    def meaning(self):
        """What marks and colours stand for, of those that can appear: a line or none."""
        said = ["black: a direction fixed in each body"] if self.marked else []
        if self.run.breaks:
            said.append("colours: fragments, single bodies pale")
        elif self.run.clumps is not None:
            said.append("colours: clumps")
        elif self.run.diameter is not None and self.detailed and (self.run.walls.names or self.run.touching):
            said.append("orange: in contact")
        return ["; ".join(said)] if said else []

    def draw(self, axes, frame):
        """Returns whether any body is in contact."""
        frame = self._seen(frame)
        run, xy, window = self.run, frame.x[:, self.plane], self.window(frame)
        seen = outlines.of(run, frame, self.radius)
        left_out = 3 - sum(self.plane)      # x to the right and z up are seen from -y, the other planes from +
        behind_first = np.argsort((-1 if left_out == 1 else 1) * seen.x[:, left_out], kind="stable")
        touching = np.zeros(len(seen.x), bool) if run.breaks else self._touching(frame)
        walls.draw(axes, self.plane, self.walls, frame.t, window)
        fills = np.where(touching, CONTACT, self._fills(frame, seen))[behind_first]
        ellipses = [part[behind_first] for part in seen.ellipses(self.plane)]
        axes.add_artist(_ellipses(axes, seen.x[behind_first][:, self.plane], *ellipses, fills, 0.15 if self.small else 0.5))
        if self.detailed:
            if len(frame.lines):
                axes.add_collection(LineCollection(xy[frame.lines], colors=RIM, linewidths=0.7))
            if self.marked:     # marks would hide the fragments, and clumps have a shape that turns
                tips = xy + 2 * self.radius[:, None] * outlines.turned(frame.attitude, self.outward)[:, self.plane]
                axes.add_collection(LineCollection(np.stack([xy, tips], axis=1), colors=MARK, linewidths=0.6))
        (left, bottom), (right, top) = window
        axes.set(xlim=(left, right), ylim=(bottom, top), aspect="equal")
        axes.grid(False)
        return bool(np.any(touching))

    def _fills(self, frame, seen):
        """Colours of what is seen: one for all, those of the fragments that bodies are in, or of clumps each its
        own."""
        if self.run.clumps is not None:
            return np.array(CLUMPS)[(seen.body + seen.body // len(CLUMPS)) % len(CLUMPS)]
        return _painted(frame, self.fragment_colours[frame.t]) if frame.t in self.fragment_colours else fragment_colours([frame])[0]

    def _touching(self, frame):
        """Bodies that overlap a plane, or another body which the scene lets them touch; of clumps the colours say
        more."""
        touching = np.zeros(len(self.radius), bool)
        if self.run.diameter is None or self.run.clumps is not None or not self.detailed:
            return touching
        for gap in walls.gaps(self.walls, frame):
            touching |= gap < self.radius
        for i in range(len(frame.x) - 1 if self.run.touching else 0):
            distance = np.linalg.norm(frame.x[i + 1:] - frame.x[i], axis=1)
            for j in i + 1 + np.flatnonzero(distance < self.radius[i] + self.radius[i + 1:]):
                if (i, j) not in self.apart:
                    touching[[i, j]] = True
        return touching


def _plane(moved, some, walls_of):
    """The two coordinates to draw; left out is the one, of some from the first on, in which bodies move least, the last
    of them if that does not tell. Cylinders that turn are seen along their axes, floors from the side: what a plane
    without another one opposite is normal to is not left out, but where such planes are normal to all."""
    turning, sides = _signs(walls_of.cylinders[walls_of.cylinder_spin != 0, :3]), _signs(walls_of.planes[:, :3])
    free = ([axis for axis in range(some) if np.any(turning[:, axis])]
            or [axis for axis in range(some) if len(set(sides[:, axis]) - {0.0}) != 1] or list(range(some)))
    least = max(axis for axis in free if moved[axis] <= np.min(moved[free]) + 1e-9 * np.max(moved))
    return [axis for axis in range(3) if axis != least]


def _signs(vectors):
    """1 or -1 in the place of the coordinate that a vector is along, of those that are along one."""
    signs = np.sign(np.where(np.abs(vectors) > level.ALONG, vectors, 0.0))
    return signs[np.sum(np.abs(signs), axis=1) == 1]


def _outward(frame, plane):
    """The body-fixed direction of each mark. At t = 0 it is in the picture's plane and points away from the middle of
    all bodies; bodies in a row have it across the row, where it cannot be taken for a bond."""
    away = frame.x[:, plane] - frame.x[:, plane].mean(axis=0)
    spread, directions = np.linalg.eigh(away.T @ away)
    if spread[0] <= 1e-12 * spread[1]:
        away = np.tile(directions[:, 0], (len(away), 1))
    length = np.linalg.norm(away, axis=1, keepdims=True)
    marks = np.zeros((len(away), 3))
    marks[:, plane] = np.where(length > 1e-12 * max(np.max(length), 1e-300), away / np.maximum(length, 1e-300), (1.0, 0.0))
    return outlines.turned(frame.attitude * (-1, -1, -1, 1), marks)


def fragment_colours(frames):
    """Of each frame the colours of all bodies."""
    return [_painted(frame, colours) for frame, colours in _with_colours(frames)]


def _with_colours(frames):
    """Frames and the colours of their fragments by number. A fragment keeps its colour: of the pieces that one has
    broken into the one with most of its bodies does, and each other one gets a colour that no fragment has, while there
    is one, else that of the fewest bodies."""
    before = None
    for frame in frames:
        colour = {}
        if frame.fragment is not None:
            fragment = _fragments(frame)
            sizes = np.bincount(fragment, minlength=len(frame.x))
            colour = _inherited(fragment, sizes, *before) if before else {}
            held = [0] * len(FRAGMENTS)
            for other, index in colour.items():
                held[index] += int(sizes[other])
            several = np.flatnonzero(sizes > 1)
            for piece in several[np.argsort(-sizes[several], kind="stable")].tolist():
                if piece not in colour:
                    colour[piece] = held.index(min(held))
                    held[colour[piece]] += int(sizes[piece])
            before = fragment, colour
        yield frame, colour


def _fragments(frame):
    """The fragment of each body; one without bonds is its own."""
    return np.where(frame.fragment < 0, np.arange(len(frame.x)), frame.fragment).astype(int)


def _painted(frame, colour):
    """Of all bodies, given those of the fragments of several."""
    if frame.fragment is None:
        return np.full(len(frame.x), BODY)
    return np.array([FRAGMENTS[colour[piece]] if piece in colour else SINGLE for piece in _fragments(frame)])


def _inherited(fragment, sizes, fragment_before, colour_before):
    """fragment -> colour of those that are the largest part of one that had it."""
    several = sizes[fragment] > 1
    both, shared = np.unique(fragment[several] * len(sizes) + fragment_before[several], return_counts=True)
    pairs = np.stack(np.divmod(both, len(sizes)))
    colour, passed_on = {}, set()
    for k in np.argsort(-shared, kind="stable"):
        piece, whole = map(int, pairs[:, k])
        if whole in colour_before and piece not in colour and whole not in passed_on:
            colour[piece] = colour_before[whole]
            passed_on.add(whole)
    return colour


def _ellipses(axes, centres, widths, heights, angles, colours, rim):
    if len(centres) > MOST_DRAWN:
        return painted.Painted(centres, widths, heights, angles, colours, RIM, rim)
    return EllipseCollection(widths, heights, angles, units="xy", offsets=centres,
                             transOffset=axes.transData, facecolors=colours, edgecolors=RIM, linewidths=rim)
