"""What both scripts need: runs that are stopped, and what they leave held against a run never stopped."""

import json
import os
import signal
import subprocess
import time

import h5py


def info(program, folder):
    """What `packstone info` tells of a folder."""
    told = subprocess.run([program, "info", "--json", folder], capture_output=True, text=True)
    if told.returncode != 0:
        raise AssertionError(f"info fails on {folder}: {told.stderr}")
    return json.loads(told.stdout)


def files_of(folder, ending):
    """Names of files in a folder that end so, in order; none where it is not there."""
    names = os.listdir(folder) if os.path.isdir(folder) else []
    return sorted(name for name in names if name.endswith(ending))


def leftovers(folder):
    """Files under temporary names, anywhere in a folder."""
    return [os.path.join(where, name) for where, _, names in os.walk(folder) for name in names if ".partial" in name]


def content(path):
    with open(path, "rb") as file:
        return file.read()


def check_opens(path):
    """Reads every dataset of a snapshot."""
    with h5py.File(path, "r") as file:
        file.visititems(lambda _, item: item[()] if isinstance(item, h5py.Dataset) else None)


def newest_checkpoint(program, folder):
    told = info(program, folder)["checkpoints"]
    name = max(told, key=lambda key: (told[key]["time"], told[key]["step"]))
    return os.path.join(folder, "checkpoint", name)


def check_same(program, whole, other):
    """Raises AssertionError where two finished runs differ in a byte of snapshots, history or last checkpoint."""
    snapshots = files_of(os.path.join(whole, "snapshots"), ".vtkhdf")
    assert snapshots == files_of(os.path.join(other, "snapshots"), ".vtkhdf"), f"{other}: other snapshots"
    names = [os.path.join("snapshots", name) for name in snapshots] + ["history.csv", "scene.toml"]
    for name in names:
        assert content(os.path.join(whole, name)) == content(os.path.join(other, name)), f"{other}/{name} differs"
    ends = [content(newest_checkpoint(program, folder)) for folder in (whole, other)]
    assert ends[0] == ends[1], f"{other}: the last checkpoint differs"


def run_for(command, seconds, how):
    """Runs a command, sends it a signal after a time; returns its exit code (negative: the signal that ended it)."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    try:
        process.wait(seconds)
    except subprocess.TimeoutExpired:
        process.send_signal(how)
    errors = process.communicate()[1]
    if process.returncode not in (0, 130, -how):
        raise AssertionError(f"{' '.join(command)}: exit code {process.returncode}: {errors}")
    return process.returncode


def timed(command):
    """Wall time of a command that must succeed [s]."""
    start = time.monotonic()
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(command)}: exit code {done.returncode}: {done.stderr}")
    return time.monotonic() - start


KILL, TERMINATE = signal.SIGKILL, signal.SIGTERM
