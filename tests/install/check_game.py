"""examples/corridor_game: the whole walk in a few small frames, refusals, Ctrl-C."""
import os
import signal
import subprocess
import sys

FRAMES = 12


def run_game(game, words):
    return subprocess.run([game, *words], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, timeout=240, check=False)


def expect(right, what, done):
    if not right:
        sys.exit(f"corridor_game: {what}\nexit code {done.returncode}\n{done.stderr}")


def walk(game, folder):
    """The walk from end to end: the program ends with 1 at the first error of any call, for doors,
    lamps, things that are picked up and what is drawn alike. Returns the pictures."""
    os.makedirs(folder)
    done = run_game(game, ["--frames", str(FRAMES), "--fps", "1.05", "--size", "64x36",
                           "-o", folder])
    expect(done.returncode == 0, "the walk failed", done)
    names = [f"{n:04d}.png" for n in range(FRAMES)]
    expect(sorted(os.listdir(folder)) == names, f"wrote {sorted(os.listdir(folder))}", done)
    expect(f"frame {FRAMES} of {FRAMES}" in done.stderr, "no progress", done)
    return [os.path.join(folder, name) for name in names]


def check_refusals(game, folder):
    """Wrong command lines: exit code 2 and the wrong word. No folder: the library's error."""
    for words, says in [([], "-o DIR is missing"),
                        (["--frames", "0", "-o", folder], ": 0"),
                        (["--frames", "2.5", "-o", folder], ": 2.5"),
                        (["--size", "64", "-o", folder], ": 64"),
                        (["--size", "64x36x2", "-o", folder], ": 64x36x2"),
                        (["--fps", "nan", "-o", folder], ": nan"),
                        (["--scale", "0.4", "-o", folder], ": 0.4"),
                        (["--start", "-1", "-o", folder], ": -1"),
                        (["--frame", "2", "-o", folder], "--frame"),
                        (["-o"], "-o")]:
        done = run_game(game, words)
        expect(done.returncode == 2 and says in done.stderr.splitlines()[0], f"{words}", done)
    missing = os.path.join(folder, "no", "folder")
    done = run_game(game, ["--frames", "1", "--size", "16x9", "-o", missing])
    expect(done.returncode == 1 and "GP_ERROR_FILE" in done.stderr, "no folder", done)
    done = run_game(game, ["--frames", "1", "--size", "0x9", "-o", folder])
    expect(done.returncode == 1 and "GP_ERROR" in done.stderr, "a size of 0", done)


def check_interrupt(game, folder):
    """Ctrl-C during the second frame or later: whole pictures stay, the exit code is 130."""
    os.makedirs(folder)
    with subprocess.Popen([game, "--frames", "100000", "--size", "64x36", "-o", folder],
                          stderr=subprocess.PIPE, text=True) as running:
        seen = ""
        while "frame 1 of" not in seen:  # until it is there; the end of the stream ends it too
            letter = running.stderr.read(1)
            if not letter:
                sys.exit(f"corridor_game ended before it was interrupted: {seen}")
            seen += letter
        running.send_signal(signal.SIGINT)
        rest = running.stderr.read()
    if running.returncode != 130 or "interrupted after" not in rest:
        sys.exit(f"corridor_game: Ctrl-C gave exit code {running.returncode}\n{seen}{rest}")
    frames = int(rest.split("interrupted after ")[1].split()[0])
    if len(os.listdir(folder)) != frames:
        sys.exit(f"{frames} frames, but {os.listdir(folder)}")
