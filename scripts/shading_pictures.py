"""The pictures of the shading book: a lit sphere and a slice of each model, drawn by the tool."""
import os
import subprocess

import shading_book

MOST_BYTES = 25000


def draw_one(command, path):
    done = subprocess.run([*command, "-o", path], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        lines = done.stderr.strip().splitlines() or ["no message"]
        raise shading_book.BookFault(f"{os.path.basename(path)}: {lines[-1]} (--no-pictures "
                                     "makes the text alone)")
    if os.path.getsize(path) > MOST_BYTES:
        raise shading_book.BookFault(f"{os.path.basename(path)} has {os.path.getsize(path)} bytes, "
                                     f"more than {MOST_BYTES}")


def draw(tool, root, models):
    folder = os.path.join(root, shading_book.PICTURES)
    os.makedirs(folder, exist_ok=True)
    for model in models:
        name = model["name"]
        draw_one([tool, "brdf", "sphere", name, "--size", "256"],
                 os.path.join(folder, f"{name}-sphere.png"))
        draw_one([tool, "brdf", "slice", name], os.path.join(folder, f"{name}-slice.png"))
