# SPDX-License-Identifier: BSD-3-Clause
"""Planes that stand on none of the coordinate planes, so that no picture in two coordinates shows them from the side:
there bodies and walls are seen in a frame of the first such plane, along it and off it."""
from dataclasses import replace

import numpy as np

ALONG = 1e-9            # components of unit vectors: so small is none


def axes_of(walls):
    """Rows are the axes of the frame, the last of them normal to the plane; None if coordinates show all that there
    is."""
    normals = walls.planes[:, :3]
    if len(walls.cylinders) or not len(normals) or np.any(np.abs(normals) <= ALONG):
        return None
    normal = normals[0] / np.linalg.norm(normals[0])
    along = np.eye(3)[0] - normal[0] * normal
    along /= np.linalg.norm(along)
    return np.array([along, np.cross(normal, along), normal])


def of_walls(axes, walls):
    planes = np.column_stack([walls.planes[:, :3] @ axes.T, walls.planes[:, 3]])
    return replace(walls, planes=planes, plane_velocity=walls.plane_velocity @ axes.T)


def of_frame(axes, frame):
    def seen(vectors):
        return None if vectors is None else vectors @ axes.T
    ellipsoid = None if frame.ellipsoid is None else axes @ frame.ellipsoid @ axes.T
    return replace(frame, x=seen(frame.x), spheres=seen(frame.spheres), ellipsoid=ellipsoid,
                   attitude=None if frame.attitude is None else _product(_quaternion(axes), frame.attitude))


def _quaternion(axes):
    """x, y, z, w of a rotation matrix: of 4 q q^T the column with the largest entry on the diagonal."""
    r = axes
    k = np.array([[1 + r[0, 0] - r[1, 1] - r[2, 2], r[0, 1] + r[1, 0], r[0, 2] + r[2, 0], r[2, 1] - r[1, 2]],
                  [r[0, 1] + r[1, 0], 1 - r[0, 0] + r[1, 1] - r[2, 2], r[1, 2] + r[2, 1], r[0, 2] - r[2, 0]],
                  [r[0, 2] + r[2, 0], r[1, 2] + r[2, 1], 1 - r[0, 0] - r[1, 1] + r[2, 2], r[1, 0] - r[0, 1]],
                  [r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1], 1 + np.trace(r)]])
    column = k[:, np.argmax(np.diag(k))]
    return column / np.linalg.norm(column)


def _product(p, q):
    """p q of one quaternion and many."""
    vector = p[3] * q[:, :3] + q[:, 3:] * p[:3] + np.cross(p[:3], q[:, :3])
    return np.column_stack([vector, p[3] * q[:, 3] - q[:, :3] @ p[:3]])
