# SPDX-License-Identifier: BSD-3-Clause
"""The film of a run: what shapes.png shows, moving. MP4 by ffmpeg where there is one, else GIF."""
import gc
import io
import itertools
import math
import os
import shutil
import subprocess
import sys
import tempfile

import numpy as np
from PIL import Image, ImageColor

from . import progress, scenery, style, words
from .trouble import Trouble

SECONDS = 10
RATE = 20                   # pictures per second; GIF counts in hundredths of a second
LARGEST = 1_500_000         # bytes
WIDTH, NARROWEST = 960, 320 # pixels; as wide as is light enough
INCHES = 8.0


def make(run, folder):
    """The path of the film."""
    if not run.translates:
        raise Trouble(run.path, "has no positions over time to film", "film a scene whose bodies translate")
    if len(run.times) < 2:
        raise Trouble(run.path, "holds fewer than two frames", "run it again with fewer steps between frames (--frames)")
    count = min(len(run.times), SECONDS * RATE)
    chosen = np.round(np.linspace(0, len(run.times) - 1, count)).astype(int)
    ffmpeg = shutil.which("ffmpeg")
    with progress.Bar() as bar:
        film = _light(bar, run, chosen, lambda pictures: _mp4(ffmpeg, pictures) if ffmpeg else _gif(pictures))
    path = os.path.join(folder, "film.mp4" if ffmpeg else "film.gif")
    if not ffmpeg:
        print("vti-plot: there is no ffmpeg here, so the film is a GIF; with it (package ffmpeg) it is an MP4, smaller and sharper",
              file=sys.stderr)
    style.write(film, path, " with -o")
    return path


def _light(bar, run, chosen, encoded):
    """The film as wide as is light enough. Pictures are drawn once, and kept as small as they can be for narrower
    films."""
    scene, width, kept = scenery.Scenery(run, map(run.frame, chosen)), WIDTH, []
    film = encoded(bar.over(_keeping(_pictures(run, scene, chosen), kept), len(chosen)))
    while len(film) > LARGEST and width > NARROWEST:
        width = max(NARROWEST, 2 * int(0.47 * width * LARGEST / len(film)))     # outlines weigh as their length
        film = encoded(bar.over(_narrower(kept, (width, _height(scene, width))), len(chosen)))
    return film


def _height(scene, width):
    """An even number of pixels, which H.264 asks for."""
    return 2 * round(0.5 * width * min(1.5, (0.9 + (INCHES - 0.9) * scene.half[1] / scene.half[0]) / INCHES))


def _pictures(run, scene, chosen):
    height = _height(scene, WIDTH)
    figure = style.new_figure(INCHES * (height + 0.25) / WIDTH, INCHES)     # a canvas drops fractions of a pixel
    figure.set_dpi(WIDTH / INCHES)
    axes = figure.add_subplot()
    gap = float(run.times[chosen[-1]] - run.times[chosen[0]]) / (len(chosen) - 1)
    places = max(2, 1 - math.floor(math.log10(gap))) if gap > 0 else 2     # two digits of it: titles do not jump
    for frame in map(run.frame, chosen):
        axes.clear()
        if not scene.detailed:
            gc.collect()    # what has been drawn refers to itself: of many bodies it would pile up
        scene.draw(axes, frame)
        axes.set(xlabel=scene.axis_names()[0], ylabel=scene.axis_names()[1])
        axes.set_title(f"{words.plain(run.scene)}, {words.stepper_name(run.stepper)}: $t$ = {frame.t:.{places}f}"
                       + "".join("\n" + line for line in scene.meaning()))
        figure.canvas.draw()
        figure.set_layout_engine("none")    # the layout is found once: nothing may jump
        yield Image.fromarray(np.asarray(figure.canvas.buffer_rgba())[:height, :WIDTH, :3])


def _keeping(pictures, kept):
    for picture in pictures:
        memory = io.BytesIO()
        picture.save(memory, "PNG", compress_level=1)
        kept.append(memory.getvalue())
        yield picture


def _narrower(kept, size):
    for png in kept:
        with Image.open(io.BytesIO(png)) as picture:
            yield picture.resize(size, Image.Resampling.HAMMING)     # sharp, and without halos, which weigh


def _gif(pictures):
    """One palette for all, so that what does not move does not flicker and costs nothing: the colours of the scenery,
    which come and go (no picture need show a contact), and three between those that meet at edges."""
    colours = [np.array(ImageColor.getrgb(name)) for name in scenery.COLOURS]
    for one, other in scenery.EDGES:
        ends = np.array(ImageColor.getrgb(one)), np.array(ImageColor.getrgb(other))
        colours += [np.round(ends[0] + share * (ends[1] - ends[0])).astype(int) for share in (0.25, 0.5, 0.75)]
    palette = Image.new("P", (1, 1))
    palette.putpalette(np.concatenate(colours + [colours[0]] * (256 - len(colours))).tolist())
    frames = (picture.quantize(palette=palette, dither=Image.Dither.NONE) for picture in pictures)
    memory = io.BytesIO()
    next(frames).save(memory, "GIF", save_all=True, append_images=frames, duration=1000 // RATE, loop=0, optimize=False)
    return memory.getvalue()


def _mp4(ffmpeg, pictures):
    """Raw pictures in, H.264 out, without anything that says when or by which version it was made."""
    first = next(pictures)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "film.mp4")
        command = [ffmpeg, "-v", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{first.width}x{first.height}",
                   "-r", str(RATE), "-i", "-", "-c:v", "libx264", "-crf", "26", "-pix_fmt", "yuv420p", "-threads", "1",
                   "-movflags", "+faststart", "-fflags", "+bitexact", "-flags:v", "+bitexact", path]
        failed = _feed(command, itertools.chain([first], pictures))
        if failed is not None:
            raise Trouble(ffmpeg, f"failed ({failed})", "repair it, or take it off the PATH for a GIF")
        with open(path, "rb") as file:
            return file.read()


def _feed(command, pictures):
    """Pictures into the command's standard input as they come. Returns the last that it said if it fails, else None."""
    with tempfile.TemporaryFile() as said:
        with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=said) as encoder:
            try:
                for picture in pictures:
                    encoder.stdin.write(picture.tobytes())
                encoder.stdin.close()
            except BrokenPipeError:     # it has ended, and its status tells why
                pass
            except BaseException:
                encoder.kill()
                raise
        if encoder.returncode == 0:
            return None
        said.seek(0)
        return (said.read().decode("utf-8", "replace").strip().splitlines() or ["it said nothing"])[-1]
