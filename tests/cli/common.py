# SPDX-License-Identifier: Apache-2.0
"""What the tests of the program share: running it, a small scene, comparing run folders.

A test script declares its tests with @test("a sentence") and ends with main(). Each test gets an
empty folder of its own, in memory where there is /dev/shm, as the many syncs of checkpoints can be
very slow on a busy disk, and is passed when it returns. The first argument of a script is the path
of the program; words after it pick the tests whose sentences hold them.
"""
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import traceback

PROGRAM = os.path.abspath(sys.argv[1]) if len(sys.argv) > 1 else ""
SOURCE = pathlib.Path(os.environ.get("QUERN_SOURCE_DIR", pathlib.Path(__file__).parents[2]))
SKIPPED = 77
INPUT, IO, UNSTABLE, INTERRUPTED = 2, 3, 6, 7  # exit codes

# About 900 balls; 0.06 s of it take some two seconds on one thread.
MILL = """\
format: quern-scene/1
title: Small mill for tests of the program
seed: 7
time: {end: 0.06 s, step: auto, rayleigh_fraction: 0.2}
materials:
  ball:  {young: 20 MPa, poisson: 0.3, density: 2500 kg/m3}
  liner: {like: ball, poisson: 0.4}
contacts:
  ball-ball:  {friction: 0.3, restitution: 0.7}
  ball-liner: {friction: 0.5, restitution: 0.5}
drum:
  diameter: 60 mm
  length: 15 mm
  material: liner
  ends: periodic
  speed: 70 %critical
  lifters: {count: 6, height: 4 mm, top: 4 mm, face_angle: 70 deg}
particles:
  balls: {material: ball, diameter: 2.5 mm, filling: 30 %, jitter: 50 %}
measure:
  series: 20 steps
  fields: {every: 10 steps, start: 100 steps, duration: 50 ms, cells: 1 2 4}
  traces: {ids: 1 50 100, every: 50 steps}
output: {frames: 5 ms, checkpoint: 60 s, pictures: no}
"""

_tests = []
_children = []


class Skip(Exception):
    """Raised by a test that this machine can't do."""


def test(sentence):
    def keep(function):
        _tests.append((sentence, function))
        return function

    return keep


def changed(text, *pairs):
    """The text with each (old, new) replaced; old must be there exactly once."""
    for old, new in pairs:
        assert text.count(old) == 1, f"{old!r} is {text.count(old)} times in the scene"
        text = text.replace(old, new)
    return text


def write(name, text):
    path = pathlib.Path(name)
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


class Done:
    """A finished command: exit code, stdout, stderr."""

    def __init__(self, code, out, err):
        self.code, self.out, self.err = code, out, err

    def expect(self, code, *parts):
        """The exit code, and pieces of text in stderr."""
        assert self.code == code, f"exit code {self.code}, not {code}\n{self.out}{self.err}"
        for part in parts:
            assert part in self.err, f"{part!r} is not in:\n{self.err}"
        return self


def quern(*arguments, env=None, timeout=120):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, timeout=timeout,
                          env={**os.environ, **(env or {})})
    return Done(done.returncode, done.stdout.decode(), done.stderr.decode())


def run(scene, folder, *more, threads=1, env=None):
    return quern("run", scene, "-o", folder, "--quiet", "--threads", threads, *more, env=env)


def start(scene, folder, *more):
    """Starts a run and does not wait for it."""
    child = subprocess.Popen(
        [PROGRAM, "run", scene, "-o", folder, "--quiet", "--threads", "1", *map(str, more)],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    _children.append(child)
    return child


def end_children():
    """Those that a failed test has left running."""
    for child in _children:
        if child.poll() is None:
            child.kill()
            child.communicate()
    _children.clear()


def work_folder():
    """A new folder in memory if there is room for it, else in the current folder."""
    memory = "/dev/shm"
    roomy = os.access(memory, os.W_OK) and shutil.disk_usage(memory).free > 60_000_000
    return pathlib.Path(tempfile.mkdtemp(prefix=f"quern-{pathlib.Path(sys.argv[0]).stem}-",
                                         dir=memory if roomy else os.getcwd()))


def wait(child):
    out, err = child.communicate(timeout=120)
    return Done(child.returncode, out.decode(), err.decode())


def wait_until(condition, seconds=20.0):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "waited in vain"
        time.sleep(0.002)


def summary(folder):
    return json.loads((pathlib.Path(folder) / "summary.json").read_text())


def state_hash(folder):
    found = summary(folder)["state_hash"]
    assert len(found) == 16 and int(found, 16) != 0
    return found


def checkpoints(folder):
    return sorted((pathlib.Path(folder) / "checkpoints").glob("checkpoint_*.h5"))


def tree(folder):
    """Every file and folder inside: name to checksum."""
    found = {}
    for path in sorted(pathlib.Path(folder).rglob("*")):
        is_file = path.is_file()
        found[str(path)] = hashlib.sha256(path.read_bytes()).hexdigest() if is_file else "folder"
    return found


def h5_contents(path):
    """Datasets and attributes of an HDF5 file: name to bytes."""
    import h5py

    found = {}

    def keep(name, item):
        for key, value in item.attrs.items():
            found[f"{name}@{key}"] = bytes(repr(value), "utf8")
        if isinstance(item, h5py.Dataset):
            found[name] = item[()].tobytes() if item.shape is not None else b""

    with h5py.File(path, "r") as file:
        file.visititems(keep)
        keep("", file)
    return found


def check_same_recordings(a, b):
    """Two folders tell the same: state, series, traces, fields and frames."""
    a, b = pathlib.Path(a), pathlib.Path(b)
    assert state_hash(a) == state_hash(b), "state_hash differs"
    for name in ("series.csv", "traces.csv", "trace_contacts.csv"):
        assert len((a / name).read_bytes()) > 1000, f"hardly anything in {name}"
        assert (a / name).read_bytes() == (b / name).read_bytes(), f"{name} differs"
    for name in ("fields.h5", "series.h5"):
        one, other = h5_contents(a / name), h5_contents(b / name)
        assert len(one) > 20 and one == other, f"{name} differs in " + ", ".join(
            sorted(k for k in {*one, *other} if one.get(k) != other.get(k)))
    frames = sorted(p.name for p in (a / "frames").iterdir())
    assert frames == sorted(p.name for p in (b / "frames").iterdir()), "other frames"
    for name in frames:
        assert (a / "frames" / name).read_bytes() == (b / "frames" / name).read_bytes(), name


def check_tidy(folder):
    """Nothing half-written, and nothing that does not belong there."""
    known = ("checkpoint_", "frame_", "frames.hdf.series", "liner_", "liner.hdf.series",
             "fields.h5", "log.txt", "quern.lock", "resolved.yaml", "scene.yaml", "series.csv",
             "series.h5", "summary.json", "traces.csv", "trace_contacts.csv", "frames",
             "checkpoints")
    for path in pathlib.Path(folder).rglob("*"):
        assert ".partial" not in path.name, f"{path} is left over"
        assert path.name.startswith(known), f"{path} does not belong there"


def main():
    passed = failed = skipped = 0
    home = work_folder()
    for number, (sentence, function) in enumerate(_tests):
        if not all(word in sentence for word in sys.argv[2:]):
            continue
        place = home / f"{number:02d}"
        place.mkdir(parents=True)
        os.chdir(place)
        begun = time.monotonic()
        try:
            function()
            passed += 1
            verdict = "ok"
        except Skip as reason:
            skipped += 1
            verdict = f"skipped: {reason}"
        except Exception:
            failed += 1
            verdict = "FAILED\n" + traceback.format_exc()
        print(f"{time.monotonic() - begun:6.2f} s  {sentence}: {verdict}", flush=True)
        end_children()
        os.chdir(home.parent)
        shutil.rmtree(place, ignore_errors=True)
    shutil.rmtree(home, ignore_errors=True)
    if skipped:
        print(f"{skipped} skipped")
    print(f"{passed} passed, {failed} failed")
    sys.exit(1 if failed else SKIPPED if skipped and not passed else 0)
