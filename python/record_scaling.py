#!/usr/bin/env python3
"""Records a run that is scaled 2 -> 6 -> 1 actors, with a kill -9 in between, as text.

    python/record_scaling.py build/release/bin/ronda runs/scaled > recording.txt

Prints each command, what it answers, and the rates before and after; at the end summary.json.
"""
import json
import os
import pathlib
import signal
import subprocess
import sys
import time

SETTLE_S = 8.0  # rates are those of the last two seconds


def say(program, *arguments):
    print("$ ronda", *arguments, flush=True)
    subprocess.run([program, *arguments], check=False)


def read(folder):
    try:
        return json.loads((folder / "status.json").read_text())
    except (FileNotFoundError, json.JSONDecodeError):
        return {"state": "starting", "processes": []}


def rates(folder):
    time.sleep(SETTLE_S)
    status = read(folder)
    totals = status["totals"]
    print(f"  {status['actors_wanted']} actors: {status['decisions_per_s']:.0f} decisions/s, "
          f"{status['updates_per_s']:.0f} updates/s; {totals['sent']} sent, {totals['stored']} "
          f"stored, {totals['lost']} lost, {totals['doubled']} doubled", flush=True)


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    train = ["train", "--map", "cumberland", "--agents", "10", "--actors", "2", "--for", "10m",
             "--run", str(folder), "--plain"]
    print("$ ronda", *train, "&", flush=True)
    with open(f"{folder}.txt", "w", encoding="utf-8") as output:
        with subprocess.Popen([program, *train], stdout=output) as launcher:
            while read(folder)["state"] == "starting" and launcher.poll() is None:
                time.sleep(0.1)
            rates(folder)
            say(program, "scale", "--run", str(folder), "--actors", "6")
            rates(folder)
            victim = next(process["pid"] for process in read(folder)["processes"]
                          if process["role"] == "actor" and process["index"] == 3)
            print(f"$ kill -9 {victim}   # actor 3", flush=True)
            os.kill(victim, signal.SIGKILL)
            rates(folder)
            say(program, "scale", "--run", str(folder), "--actors", "1")
            rates(folder)
            say(program, "stop", "--run", str(folder))
    print(f"$ cat {folder}/summary.json")
    print((folder / "summary.json").read_text(), end="")
    print("What the launcher said:")
    for line in pathlib.Path(f"{folder}.txt").read_text(encoding="utf-8").splitlines():
        if " %  " not in line:
            print("  " + line)


if __name__ == "__main__":
    main()
