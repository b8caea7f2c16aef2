# SPDX-License-Identifier: BSD-3-Clause
"""The film of a run: what shapes.png shows, moving. MP4 by ffmpeg where there is one, else GIF."""
import io
import math
import os
import shutil
import subprocess
import sys
import tempfile

import numpy as np
from PIL import Image, ImageColor

from . import scenery, style, words
from .trouble import Trouble

SECONDS = 10
RATE = 20                   # pictures per second; GIF counts in hundredths of a second
LARGEST = 1_500_000         # bytes
WIDTH, NARROWEST = 960, 320 # pixels; as wide as is light enough


def make(run, folder):
    """The path of the film."""
    if not run.translates:
        raise Trouble(run.path, "has no positions over time to film", "film a scene whose bodies translate")
    if len(run.times) < 2:
        raise Trouble(run.path, "holds fewer than two frames", "run it again with more --frames")
    count = min(len(run.times), SECONDS * RATE)
    frames = [run.frame(k) for k in np.round(np.linspace(0, len(run.times) - 1, count)).astype(int)]
    scene = scenery.Scenery(run, frames)
    ffmpeg = shutil.which("ffmpeg")
    width = WIDTH
    while True:
        pictures = _pictures(run, scene, frames, width)
        film = _mp4(ffmpeg, pictures) if ffmpeg else _gif(pictures)
        if len(film) <= LARGEST or width == NARROWEST:
            break
        width = max(NARROWEST, 2 * int(0.47 * width * LARGEST / len(film)))     # outlines weigh as their length
    path = os.path.join(folder, "film.mp4" if ffmpeg else "film.gif")
    if not ffmpeg:
        print("vti-plot: there is no ffmpeg here, so the film is a GIF; with it (package ffmpeg) it is an MP4, smaller and sharper",
              file=sys.stderr)
    style.write(film, path)
    return path


def _pictures(run, scene, frames, width):
    inches = 8.0
    # Even numbers of pixels, which H.264 asks for.
    height = 2 * round(0.5 * width * min(1.5, (0.9 + (inches - 0.9) * scene.half[1] / scene.half[0]) / inches))
    figure = style.new_figure(inches * (height + 0.25) / width, inches)     # a canvas drops fractions of a pixel
    figure.set_dpi(width / inches)
    axes = figure.add_subplot()
    gap = (frames[-1].t - frames[0].t) / max(1, len(frames) - 1)
    places = max(2, 1 - math.floor(math.log10(gap))) if gap > 0 else 2     # two digits of it: titles do not jump
    for k, frame in enumerate(frames):
        axes.clear()
        scene.draw(axes, frame)
        axes.set(xlabel=scene.axis_names()[0], ylabel=scene.axis_names()[1])
        axes.set_title(f"{words.plain(run.scene)}, {words.stepper_name(run.stepper)}: $t$ = {frame.t:.{places}f}"
                       + "".join("\n" + line for line in scene.meaning()))
        figure.canvas.draw()
        if k == 0:
            figure.set_layout_engine("none")    # the layout is found once: nothing may jump
        yield Image.fromarray(np.asarray(figure.canvas.buffer_rgba())[:height, :width, :3])


def _gif(pictures):
    """One palette for all, so that what does not move does not flicker and costs nothing: the colours of the scenery, which come
    and go (no picture need show a contact), and three between those that meet at edges."""
    colours = [np.array(ImageColor.getrgb(name)) for name in scenery.COLOURS]
    for one, other in scenery.EDGES:
        ends = np.array(ImageColor.getrgb(one)), np.array(ImageColor.getrgb(other))
        colours += [np.round(ends[0] + share * (ends[1] - ends[0])).astype(int) for share in (0.25, 0.5, 0.75)]
    palette = Image.new("P", (1, 1))
    palette.putpalette(np.concatenate(colours + [colours[0]] * (256 - len(colours))).tolist())
    frames = [picture.quantize(palette=palette, dither=Image.Dither.NONE) for picture in pictures]
    memory = io.BytesIO()
    frames[0].save(memory, "GIF", save_all=True, append_images=frames[1:], duration=1000 // RATE, loop=0, optimize=False)
    return memory.getvalue()


def _mp4(ffmpeg, pictures):
    """Raw pictures in, H.264 out, without anything that says when or by which version it was made."""
    first = next(pictures)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "film.mp4")
        command = [ffmpeg, "-v", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{first.width}x{first.height}",
                   "-r", str(RATE), "-i", "-", "-c:v", "libx264", "-crf", "26", "-pix_fmt", "yuv420p", "-threads", "1",
                   "-movflags", "+faststart", "-fflags", "+bitexact", "-flags:v", "+bitexact", path]
        raw = first.tobytes() + b"".join(picture.tobytes() for picture in pictures)
        done = subprocess.run(command, input=raw, capture_output=True, check=False)
        if done.returncode != 0:
            said = done.stderr.decode("utf-8", "replace").strip().splitlines() or ["it said nothing"]
            raise Trouble(ffmpeg, f"failed ({said[-1]})", "repair it, or take it off the PATH for a GIF")
        with open(path, "rb") as file:
            return file.read()
