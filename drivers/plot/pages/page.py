# SPDX-License-Identifier: BSD-3-Clause
"""A page of headings, paragraphs, tables and pictures, written as Markdown and as HTML from the same blocks."""
import argparse
import html
import os
import re
import sys

from ..trouble import Trouble

STYLE = ("body{max-width:60em;margin:2em auto;padding:0 1em;font:16px/1.5 sans-serif;color:#222}"
         "img{max-width:100%;border:1px solid #ddd}td,th{padding:.2em .8em;border-bottom:1px solid #ddd;text-align:left}"
         "code{background:#f3f3f3}")


def machine_of(folder):
    """The lines "key: value" of FOLDER/machine.txt as one, empty where there is none: on what times were taken."""
    path = os.path.join(folder, "machine.txt")
    if not os.path.isfile(path):
        return ""
    with open(path, encoding="utf-8", errors="replace") as file:
        return "; ".join(line.strip() for line in file if line.strip())


ALONE = ("Times of this page may be compared with each other, but not with those of a page that was measured on another machine or "
         "another day.")


class Page:
    def __init__(self, folder, title):
        self.folder, self.title, self.blocks = folder, title, []

    def heading(self, text):
        self.blocks.append(("heading", text))

    def part(self, text):
        """A heading above headings, of the same rank as the page's title."""
        self.blocks.append(("part", text))

    def text(self, text):
        """One paragraph; **bold** and `code` are the only marks."""
        self.blocks.append(("text", " ".join(text.split())))

    def picture(self, *path):
        """Named only where it was drawn."""
        path = os.path.join(*path)
        if os.path.isfile(os.path.join(self.folder, path)):
            self.blocks.append(("picture", path))
        else:
            self.text(f"(`{path}` was not drawn.)")

    def table(self, head, rows):
        self.blocks.append(("table", (head, rows)))

    def markdown(self):
        parts = [f"# {self.title}"]
        for kind, content in self.blocks:
            if kind in ("part", "heading"):
                parts.append(f"{'#' if kind == 'part' else '##'} {content}")
            elif kind == "picture":
                parts.append(f"![{content}]({content})")
            elif kind == "table":
                head, rows = content
                parts.append("\n".join("| " + " | ".join(row) + " |" for row in [head, ["---"] * len(head), *rows]))
            else:
                parts.append(content)
        return "\n\n".join(parts) + "\n"

    def html(self):
        parts = [f"<h1>{html.escape(self.title)}</h1>"]
        for kind, content in self.blocks:
            if kind in ("part", "heading"):
                rank = "h1" if kind == "part" else "h2"
                parts.append(f"<{rank}>{html.escape(content)}</{rank}>")
            elif kind == "picture":
                parts.append(f'<p><a href="{html.escape(content)}"><img src="{html.escape(content)}" '
                             f'alt="{html.escape(content)}"></a></p>')
            elif kind == "table":
                head, rows = content
                cells = ["".join(f"<{tag}>{_marked(cell)}</{tag}>" for cell in row)
                         for tag, row in [("th", head), *(("td", row) for row in rows)]]
                parts.append("<table>" + "".join(f"<tr>{row}</tr>" for row in cells) + "</table>")
            else:
                parts.append(f"<p>{_marked(content)}</p>")
        return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{html.escape(self.title)}</title>'
                f"<style>{STYLE}</style></head><body>\n" + "\n".join(parts) + "\n</body></html>\n")


def _marked(text):
    text = re.sub(r"\*\*(.+?)\*\*", r"<strong>\1</strong>", html.escape(text))
    return re.sub(r"`(.+?)`", r"<code>\1</code>", text)


def write_page(name, source, build):
    """The program of a page: FOLDER [--into DIR]. build(folder, into, below) is told where the page goes and below
    which folder beside it its pictures go; None: beside it."""
    parser = argparse.ArgumentParser(prog=f"python3 -m plot.pages.{name}", description=f"The page {name}.md.")
    parser.add_argument("folder", help=source)
    parser.add_argument("--into", metavar="DIR", help=f"write DIR/{name}.md and its pictures into DIR/{name} (default: into the "
                        "folder)")
    given = parser.parse_args()
    try:
        build(given.folder, given.into or given.folder, name if given.into else None)
    except (Trouble, OSError) as trouble:
        sys.exit(f"{name}: {trouble}")
