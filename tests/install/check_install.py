"""Installs the build into a fresh prefix, moves it, builds examples/ against it with CMake and one
of them with pkg-config, runs them and looks at the pictures that they made.
"""
import argparse
import os
import shutil
import struct
import subprocess
import sys
import zlib

from check_game import check_interrupt, check_refusals, walk

PICTURES = {
    "triangle": ["triangle.png"],
    "wrapper": ["wrapper.png"],
    "dynamic_mesh": [f"frame-{n}.png" for n in range(4)],
    "load_scene": ["loaded.png"],
    "materials": ["materials.png"],
    "overlay": ["overlay.png"],
    "realtime": ["realtime.png"],
}
# The smallest scene that shows something: one triangle under the example's own sky.
SCENE = """{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],
"max":[1,1,0]}],"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"triangle.bin"}]}"""


def run(command, **more):
    print("+", " ".join(command), flush=True)
    done = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          timeout=240, check=False, **more)
    if done.returncode != 0:
        sys.exit(f"{done.stdout}\nexit code {done.returncode}")
    return done.stdout


def png_pixels(path):
    """RGB rows of an 8-bit, non-interlaced PNG; sys.exit where the file is anything else."""
    with open(path, "rb") as file:
        data = file.read()
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        sys.exit(f"{path} is no PNG")
    position, packed, width, height = 8, b"", 0, 0
    while position < len(data):
        size, kind = struct.unpack(">I4s", data[position:position + 8])
        body = data[position + 8:position + 8 + size]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
            if (depth, colour, body[12]) != (8, 2, 0):
                sys.exit(f"{path} is not an 8-bit RGB PNG")
        elif kind == b"IDAT":
            packed += body
        position += size + 12
    raw, stride = zlib.decompress(packed), width * 3
    rows, above = [], bytearray(stride)
    for y in range(height):
        start = y * (stride + 1)
        row = bytearray(raw[start + 1:start + 1 + stride])
        unfilter(raw[start], row, above)
        rows.append(row)
        above = row
    return width, height, rows


def unfilter(kind, row, above):
    """The PNG row filters [PNG specification, section 9]."""
    for i in range(len(row)):
        left = row[i - 3] if i >= 3 else 0
        corner = above[i - 3] if i >= 3 else 0
        if kind == 1:
            add = left
        elif kind == 2:
            add = above[i]
        elif kind == 3:
            add = (left + above[i]) // 2
        elif kind == 4:
            estimate = left + above[i] - corner
            add = min((abs(estimate - left), 0, left), (abs(estimate - above[i]), 1, above[i]),
                      (abs(estimate - corner), 2, corner))[2]
        else:
            add = 0
        row[i] = (row[i] + add) & 255


def check_picture(path):
    width, height, rows = png_pixels(path)
    colours = [bytes(row[i:i + 3]) for row in rows for i in range(0, len(row), 3)]
    lit = sum(max(c) > 8 for c in colours) / len(colours)
    if lit < 0.05 or len(set(colours)) < 16:
        sys.exit(f"{path} shows nothing: {lit:.1%} of the pixels lit, {len(set(colours))} colours")
    print(f"{os.path.basename(path)}: {width}x{height}, {lit:.0%} lit, {len(set(colours))} colours")


def check_movement(paths):
    """Each picture must differ from the one before by more than the noise of its samples."""
    frames = [png_pixels(path)[2] for path in paths]
    for before, after in zip(frames, frames[1:]):
        changed = sum(abs(a - b) > 40 for r, s in zip(before, after) for a, b in zip(r, s))
        if changed < 200:
            sys.exit(f"only {changed} values differ between two frames: nothing has moved")


def install(args, work):
    """Into one folder, then moved to another: nothing installed may know where it stood first."""
    first, prefix = os.path.join(work, "first"), os.path.join(work, "prefix")
    run([args.cmake, "--install", args.build, "--prefix", first])
    os.rename(first, prefix)
    for folder, _, names in os.walk(prefix):
        for name in names:
            if not name.endswith((".cmake", ".pc", ".h", ".hpp")):
                continue
            with open(os.path.join(folder, name), encoding="utf-8") as file:
                text = file.read()
            for place in (args.source, args.build, work):
                if place in text:
                    sys.exit(f"{name} names {place}, where it was built")
    return prefix


def library_folder(prefix):
    for folder, _, names in os.walk(prefix):
        if "libglitterpath.so" in names:
            return folder
    sys.exit("libglitterpath.so was not installed")


def build_with_cmake(args, work, prefix):
    examples, build = os.path.join(work, "examples"), os.path.join(work, "examples-build")
    shutil.copytree(os.path.join(args.source, "examples"), examples)
    run([args.cmake, "-S", examples, "-B", build, f"-DCMAKE_PREFIX_PATH={prefix}",
         f"-DCMAKE_C_COMPILER={args.cc}", f"-DCMAKE_CXX_COMPILER={args.cxx}",
         f"-DCMAKE_C_FLAGS={args.flags}", f"-DCMAKE_CXX_FLAGS={args.flags}"])
    run([args.cmake, "--build", build])
    return build


def build_with_pkg_config(args, work, libraries):
    environment = dict(os.environ, PKG_CONFIG_PATH=os.path.join(libraries, "pkgconfig"))
    flags = run([args.pkg_config, "--cflags", "--libs", "glitterpath"], env=environment).split()
    program = os.path.join(work, "triangle-pkg-config")
    source = os.path.join(args.source, "examples", "triangle.c")
    run([args.cc, "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", *args.flags.split(),
         source, "-o", program, *flags])
    return program


def write_scene(folder):
    with open(os.path.join(folder, "triangle.bin"), "wb") as file:
        file.write(struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0))
    with open(os.path.join(folder, "triangle.gltf"), "w", encoding="utf-8") as file:
        file.write(SCENE)


def main():
    parser = argparse.ArgumentParser()
    for name in ("build", "source", "work", "cmake", "pkg-config", "cc", "cxx"):
        parser.add_argument("--" + name, required=True)
    parser.add_argument("--flags", default="")
    args = parser.parse_args()
    args.build, args.source, work = (os.path.abspath(p) for p in
                                     (args.build, args.source, args.work))
    shutil.rmtree(work, ignore_errors=True)
    pictures = os.path.join(work, "pictures")
    os.makedirs(pictures)

    prefix = install(args, work)
    libraries = library_folder(prefix)
    build = build_with_cmake(args, work, prefix)
    write_scene(pictures)
    arguments = {"triangle": ["triangle.png"], "wrapper": ["wrapper.png"], "dynamic_mesh": ["."],
                 "load_scene": ["triangle.gltf", "loaded"], "materials": ["materials.png"],
                 "overlay": ["overlay.png"], "realtime": ["."]}
    for example, names in PICTURES.items():
        print(run([os.path.join(build, example), *arguments[example]], cwd=pictures), end="")
        for name in names:
            check_picture(os.path.join(pictures, name))

    check_movement([os.path.join(pictures, name) for name in PICTURES["dynamic_mesh"]])
    if os.path.getsize(os.path.join(pictures, "loaded.exr")) < 10000:
        sys.exit("loaded.exr is too small for four layers")

    game = os.path.join(build, "corridor_game")
    walked = walk(game, os.path.join(pictures, "corridor"))
    for picture in walked:
        check_picture(picture)
    check_movement(walked)
    check_refusals(game, pictures)
    check_interrupt(game, os.path.join(pictures, "interrupted"))

    program = build_with_pkg_config(args, work, libraries)
    run([program, "pkg-config.png"], cwd=pictures,
        env=dict(os.environ, LD_LIBRARY_PATH=libraries))
    check_picture(os.path.join(pictures, "pkg-config.png"))
    tool = os.path.join(prefix, "bin", "glitterpath")
    if os.path.exists(tool):
        print(run([tool, "--version"]), end="")


if __name__ == "__main__":
    main()
