# SPDX-License-Identifier: BSD-3-Clause
"""What is seen of bodies: spheres, the spheres of clumps, or ellipsoids of three moments; each has a centre and an
outline."""
from dataclasses import dataclass

import numpy as np


@dataclass
class Outlines:
    """Of k things at one time."""
    x: np.ndarray           # k, 3: centres
    reach: np.ndarray       # k, 3: how far each extends along x, y and z; k, 1 of spheres
    squares: np.ndarray     # k, 3, 3: of ellipsoids R diag(half axes^2) R^T; else None
    body: np.ndarray        # k: whose they are

    def ellipses(self, plane):
        """Widths, heights and angles in degrees of the outlines in a plane of two coordinates: what an ellipsoid spans
        along a direction n of the plane is the root of n.squares n."""
        if self.squares is None:
            across = 2 * self.reach[:, 0]
            return across, across, np.zeros(len(across))
        lengths, directions = np.linalg.eigh(self.squares[:, plane][:, :, plane])
        across = 2 * np.sqrt(np.maximum(lengths, 0.0))
        return across[:, 1], across[:, 0], np.degrees(np.arctan2(directions[:, 1, 1], directions[:, 0, 1]))


def of(run, frame, radius):
    """radius: of spheres, bodies' or clumps'."""
    if run.clumps is not None:
        return Outlines(frame.spheres, radius[:, None], None, run.clumps.body)
    bodies = np.arange(run.bodies)
    if frame.ellipsoid is None:
        return Outlines(frame.x, radius[:, None], None, bodies)
    half = 0.5 * frame.ellipsoid
    squares = half @ half
    return Outlines(frame.x, np.sqrt(np.maximum(np.einsum("kii->ki", squares), 0.0)), squares, bodies)


def radius(run, frame):
    """Half the diameters; of ellipsoids half the shortest axis; bodies without any are dots a fiftieth of the scene
    wide."""
    if run.clumps is not None:
        return 0.5 * run.clumps.diameter
    if frame.ellipsoid is not None:
        return 0.5 * np.linalg.eigvalsh(frame.ellipsoid)[:, 0]
    if run.diameter is not None:
        return 0.5 * run.diameter
    return np.full(run.bodies, 0.01 * max(np.max(np.ptp(frame.x, axis=0)), 1e-3))


def turned(attitude, vectors):
    """R(attitude) vectors for unit quaternions x, y, z, w."""
    axis, w = attitude[:, :3], attitude[:, 3:]
    twice = 2 * np.cross(axis, vectors)
    return vectors + w * twice + np.cross(axis, twice)
