# SPDX-License-Identifier: BSD-3-Clause
"""network.png: the force network of the last frame in which anything touches, from the out-contacts.h5 of a run.

    attributes of the file      contacts_of (the scene), vti_version
    /VTKHDF/Points              two for each contact: the centre of a sphere, and that of the other one or the place on the wall
    /VTKHDF/CellData            normal_force and tangential_force of each contact, and j, which is negative at walls
    /VTKHDF/Lines/NumberOfCells how many contacts each frame has; /VTKHDF/Steps/Values: its time
"""
from dataclasses import dataclass

import numpy as np
from matplotlib.collections import LineCollection

from . import style, words
from .hdf5_file import NETWORK, Reader, opened, text

THICKEST, THINNEST = 6.0, 0.2   # points
CARRIES = 1e-6          # of the largest force; bodies that just touch have less
ALONG = 1e-9            # sines of angles: so near a direction is another
COLOURS = "viridis_r"           # dark: friction holds most


@dataclass
class Network:
    scene: str
    version: str
    t: float                # of the frame; None if nothing touches in any
    ends: np.ndarray        # n, 2, 3
    at_wall: np.ndarray     # n
    normal: np.ndarray      # n
    tangential: np.ndarray  # n


def read_network(path):
    with opened(path) as file:
        reader = Reader(path, file, NETWORK)
        scene, version = text(reader.attribute("contacts_of")), text(reader.attribute("vti_version"))
        counts, times = reader.finite("/VTKHDF/Lines/NumberOfCells").astype(int), reader.finite("/VTKHDF/Steps/Values")
        reader.same_lengths({"NumberOfCells of Lines": counts, "Values of Steps": times}, "/VTKHDF")
        if not np.any(counts > 0):
            return Network(scene, version, None, np.zeros((0, 2, 3)), *np.zeros((3, 0)))
        last = int(np.flatnonzero(counts > 0)[-1])
        rows = slice(int(np.sum(counts[:last])), int(np.sum(counts[:last + 1])))
        ends = reader.finite("/VTKHDF/Points", 2, slice(2 * rows.start, 2 * rows.stop))
        j, normal, tangential = (reader.finite(f"/VTKHDF/CellData/{name}", 1, rows) for name in ("j", "normal_force", "tangential_force"))
        if ends.shape != (2 * counts[last], 3) or {len(j), len(normal), len(tangential)} != {counts[last]}:
            raise reader.trouble(f"has fewer contacts than /VTKHDF/Lines/NumberOfCells says of t = {times[last]:.4g}")
        return Network(scene, version, float(times[last]), ends.reshape(-1, 2, 3), j < 0, normal, tangential)


def draw(network):
    if network.t is None:
        return None, ["not drawn, nothing touches in any frame"]
    plane = _plane(network)
    xy, strongest = network.ends[:, :, plane], np.max(network.normal)
    thickness = THICKEST * network.normal / strongest if strongest > 0 else np.zeros(len(xy))
    share = np.where(network.normal > 0, network.tangential / np.where(network.normal > 0, network.normal, 1.0), 0.0)
    thick_last = np.argsort(thickness, kind="stable")
    low, high = np.min(xy, axis=(0, 1)), np.max(xy, axis=(0, 1))
    margin = max(0.03 * np.max(high - low), 1e-6 * np.max(np.abs([low, high])), 1e-12)
    size = high - low + 2 * margin
    figure = style.new_figure(min(11.0, max(3.0, 1.0 + 0.85 * style.WIDTH * size[1] / size[0])))
    figure.suptitle(f"{words.plain(network.scene)}: force network at $t$ = {network.t:.4g}")
    axes = figure.subplots()
    lines = LineCollection(xy[thick_last], linewidths=np.maximum(thickness, THINNEST)[thick_last], capstyle="round",
                           array=share[thick_last], cmap=COLOURS)
    lines.set_clim(0.0, np.max(share) if np.max(share) > 0 else 1.0)
    axes.add_collection(lines)
    axes.set(xlim=(low[0] - margin, high[0] + margin), ylim=(low[1] - margin, high[1] + margin), aspect="equal")
    for name, axis in zip(("x", "y"), plane):
        axes.set(**{f"{name}label": f"${'xyz'[axis]}$ (units of the scene)"})
    axes.grid(False)
    if np.any(network.tangential > 0):
        figure.colorbar(lines, ax=axes, label="force of friction over normal force", shrink=0.8)
    facts = [f"{words.counted(np.sum(network.normal > CARRIES * strongest), 'contact')} with a force.", f"Lines are as thick as their normal force; the largest is {strongest:.3g}.",
             f"vti {words.plain(network.version)}"]
    figure.supxlabel(style.below(facts), fontsize=8.5, color=style.GREY)
    return figure, []


def _plane(network):
    """The two coordinates to draw: left out is the one over which the network extends least, the last of those, but a
    floor, a plane without another one opposite, is seen from the side."""
    towards = (network.ends[:, 1] - network.ends[:, 0])[network.at_wall & (network.normal > CARRIES * np.max(network.normal))]
    long = ALONG * np.max(np.abs(towards), axis=1)
    signs = [set(np.sign(towards[np.all(np.abs(np.delete(towards, axis, axis=1)) < long[:, None], axis=1), axis])) for axis in range(3)]
    free = [axis for axis in range(3) if len(signs[axis]) != 1] or [0, 1, 2]
    wide = np.ptp(network.ends, axis=(0, 1))
    least = max(axis for axis in free if wide[axis] <= np.min(wide[free]) + 1e-9 * np.max(wide))
    return [axis for axis in range(3) if axis != least]
