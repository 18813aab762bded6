"""The pictures of the shading book: a lit sphere and a slice of each model, drawn by the tool."""
import os
import subprocess

import shading_book

MOST_BYTES = 25000
# What each kind is drawn with; the command's own light and exposure show every model.
OPTIONS = {"sphere": ["--size", "128"], "slice": ["--size", "128"]}
# Other parameters than the defaults where those show nothing: fibres across the slice's plane have
# the same value everywhere.
SHOWN_AS = {("slice", "kajiya_kay"): "kajiya_kay:fibre=along_x"}


def draw_one(tool, kind, name, path):
    model = SHOWN_AS.get((kind, name), name)
    done = subprocess.run([tool, "brdf", kind, model, *OPTIONS[kind], "-o", path],
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        lines = done.stderr.strip().splitlines() or ["no message"]
        raise shading_book.BookFault(f"{os.path.basename(path)}: {lines[-1]} (--no-pictures "
                                     "makes the text alone)")
    if os.path.getsize(path) > MOST_BYTES:
        raise shading_book.BookFault(f"{os.path.basename(path)} has {os.path.getsize(path)} bytes, "
                                     f"more than {MOST_BYTES}")


def draw(tool, root, models, kinds):
    """Of all models but those that are made from files, which nobody has here."""
    folder = os.path.join(root, shading_book.PICTURES)
    os.makedirs(folder, exist_ok=True)
    for model in models:
        if not model.get("fromFile"):
            for kind in kinds:
                path = os.path.join(folder, f"{model['name']}-{kind}.png")
                draw_one(tool, kind, model["name"], path)
