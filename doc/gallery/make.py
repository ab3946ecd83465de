#!/usr/bin/python3
"""Draws the pictures of doc/reference/gallery.md by the commands beside them.

Usage: make.py BUILD_FOLDER [PICTURE]...

Each section of the page has a block of commands and, for each picture, the file
that they write, in backticks and a colon, above it. The commands are run as they
stand, in BUILD_FOLDER/gallery, which has build, prm and doc; the files go to
output/gallery. With names of pictures only their sections are run. A command
that fails, or does not write its picture, ends it with exit code 1.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

from PIL import Image

PROJECT = pathlib.Path(__file__).resolve().parents[2]
PICTURE = re.compile(r"^`(output/[^`]+)`:\n\n!\[[^\]]*\]\((?:\.\./)+output/gallery/([^)]+)\)$", re.M)


def sections(page):
    """Title, commands and (file, picture) of each section."""
    for part in re.split(r"^## ", page.read_text(encoding="utf-8"), flags=re.M)[1:]:
        commands = "".join(re.findall(r"^```sh\n(.*?)^```$", part, re.S | re.M))
        yield part.partition("\n")[0], commands, PICTURE.findall(part)


def work_folder(build):
    folder = build / "gallery"
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "output").mkdir(parents=True)
    for name, target in (("build", build), ("prm", PROJECT / "prm"), ("doc", PROJECT / "doc")):
        os.symlink(target, folder / name)
    return folder


def put(source, target):
    """A drawing as it is, a picture of points with 128 colours, which is a third as large."""
    if source.suffix == ".png":
        Image.open(source).convert("RGB").quantize(128, dither=Image.Dither.NONE).save(target, optimize=True)
    else:
        shutil.copy(source, target)


def draw(folder, title, commands, pictures):
    """What went wrong, nothing if all did well."""
    start = time.monotonic()
    done = subprocess.run(["bash", "-e", "-c", commands], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, check=False)
    if done.returncode != 0:
        return f"{title}: exit code {done.returncode} of\n{commands}{done.stdout}"
    for file, picture in pictures:
        if not (folder / file).is_file():
            return f"{title}: the commands do not write {file}."
        put(folder / file, PROJECT / "output/gallery" / picture)
    print(f"{title}: {', '.join(picture for _, picture in pictures)}, {time.monotonic() - start:.0f} s", flush=True)
    return ""


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    all_sections = list(sections(PROJECT / "doc/reference/gallery.md"))
    known = [picture for _, _, pictures in all_sections for _, picture in pictures]
    wanted = sys.argv[2:] or known
    unknown = [name for name in wanted if name not in known]
    if unknown:
        sys.exit(f"doc/reference/gallery.md has no {', '.join(unknown)}. It has {', '.join(known)}.")
    folder = work_folder(pathlib.Path(sys.argv[1]).resolve())
    wrong = [draw(folder, *section) for section in all_sections
             if any(picture in wanted for _, picture in section[2])]
    print("".join(wrong), end="")
    sys.exit(1 if any(wrong) else 0)


if __name__ == "__main__":
    main()
