# SPDX-License-Identifier: BSD-3-Clause
"""Planes and cylinders of a run where they are at a time: what lies behind them is shaded, if they stand on the plane
of the picture."""
import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.patches import PathPatch, Polygon
from matplotlib.path import Path

from . import words

WALL, BEHIND = "#8A8A8A", "#DDDDDD"
ALONG = 1e-9            # sines of angles: so near a direction is another
TICKS, TICK = 12, 0.05  # of a cylinder that turns: how many, how long in radii


def gaps(walls, frame):
    """How far the centres of all bodies are from each wall."""
    for plane in walls.planes_at(frame.t):
        yield (frame.x @ plane[:3] - plane[3]) / np.linalg.norm(plane[:3])
    for cylinder in walls.cylinders_at(frame.t):
        yield cylinder[6] - np.linalg.norm(np.cross(frame.x - cylinder[3:6], cylinder[:3]), axis=1)


def circles(walls, t, plane):
    """Of the cylinders whose axes the coordinates in plane leave out: centre, radius, and a frame of two vectors that
    turns with the cylinder."""
    for cylinder in walls.cylinders_at(t):
        axis, angle = cylinder[:3], cylinder[7]
        if np.hypot(*axis[plane]) > ALONG:
            continue
        one = np.eye(3)[plane[0]]
        other = np.cross(axis, one)
        turned = [np.cos(angle) * one + np.sin(angle) * other, np.cos(angle) * other - np.sin(angle) * one]
        yield cylinder[3:6][plane], cylinder[6], np.array(turned)[:, plane]


def notes(walls, plane):
    """What is not drawn: planes and cylinders that are seen at a slant. Planes seen from the front are glass."""
    sides = [np.hypot(*one[:3][plane]) / np.linalg.norm(one[:3]) for one in walls.planes]
    sides += [np.hypot(*one[:3][plane]) for one in walls.cylinders]
    slanted = sum(ALONG < side < 1 - ALONG for side in sides)
    return [f"{words.counted(slanted, 'wall')} not drawn, being seen at a slant"] if slanted else []


def draw(axes, plane, walls, t, window):
    """plane: the two coordinates of the picture; window: its corners, low and high."""
    for one in walls.planes_at(t):
        _half_plane(axes, one[:3][plane], one[3], np.linalg.norm(one[:3]), window)
    for cylinder in walls.cylinders_at(t):
        axis = cylinder[:3][plane]
        if abs(np.hypot(*axis) - 1) < ALONG:     # from the side: two lines
            across = np.array([-axis[1], axis[0]])
            for normal in (across, -across):
                _half_plane(axes, normal, normal @ cylinder[3:6][plane] - cylinder[6], 1, window)
    for (centre, radius, turned), spin in zip(circles(walls, t, plane), _spins(walls, plane)):
        _around(axes, centre, radius, window)
        if spin:
            _ticks(axes, centre, radius, turned)


def _spins(walls, plane):
    return walls.cylinder_spin[np.hypot(*walls.cylinders[:, plane].T) <= ALONG]


def _half_plane(axes, normal, distance, length, window):
    """What of the window is behind a plane, if its normal, so long in space, lies in the picture."""
    if abs(np.hypot(*normal) - length) > ALONG or not np.any(normal):
        return
    corners = _corners(window)
    outline, heights = [], corners @ normal - distance
    for k in range(4):
        here, after = heights[k - 1], heights[k]
        if here * after < 0:
            outline.append(corners[k - 1] + (corners[k] - corners[k - 1]) * here / (here - after))
        if after <= 0:
            outline.append(corners[k])
    if len(outline) > 2:
        axes.add_patch(Polygon(outline, facecolor=BEHIND, edgecolor=WALL, linewidth=0.8, zorder=0.5))


def _around(axes, centre, radius, window):
    """The window but for a circle."""
    circle = Path.circle(centre, radius)
    frame = Path(_corners(window)[[0, 3, 2, 1, 0]], [Path.MOVETO] + [Path.LINETO] * 3 + [Path.CLOSEPOLY])
    axes.add_patch(PathPatch(Path.make_compound_path(frame, circle), facecolor=BEHIND, edgecolor="none", zorder=0.5))
    axes.add_patch(PathPatch(circle, facecolor="none", edgecolor=WALL, linewidth=0.8, zorder=0.5))


def _ticks(axes, centre, radius, turned):
    """Short lines outside of a cylinder, which turn with it."""
    angles = 2 * np.pi * np.arange(TICKS) / TICKS
    outward = np.column_stack([np.cos(angles), np.sin(angles)]) @ turned
    ends = np.stack([centre + radius * outward, centre + (1 + TICK) * radius * outward], axis=1)
    axes.add_collection(LineCollection(ends, colors=WALL, linewidths=0.8, zorder=0.6))


def _corners(window):
    (left, bottom), (right, top) = window
    return np.array([(left, bottom), (right, bottom), (right, top), (left, top)])
