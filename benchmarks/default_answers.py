#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What does `rollfem run CASE` answer by default, and how fast? For the 300 scenes of benchmarks/default_scenes.py
without model and accuracy: wall time, crashes, runs beyond the limit, refused scenes, accuracy met or missing accuracy
reported; and announced against measured seconds of hybrid and finite elements.

    benchmarks/default_answers.py --program build/app/rollfem --measured ../shared/reference/measured -o /tmp/default

Existing runs are reused. --truth also solves every scene by the hybrid (or, if it refuses, by the half-space) with 80
elements across, and counts answers within their accuracy or their own error estimate.
"""

import json
import os
import re
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

import auto
import default_scenes
import scene_sets
from model_error import friction_of

WANTED = 60.0  # s
EXPECTED = re.compile(r"^auto\s+expected\s+[\d.]+ s\s+(?P<models>.+) for \d+ contacts?, about (?P<time>[\d.e+-]+) "
                      r"(?P<unit>s|min|h)$")
SECONDS = {"s": 1, "min": 60, "h": 3600}


def watched(command, cache, limit):
    """The status of a run, None beyond the limit; its seconds; its last line; and the model, announced and measured
    seconds of its last announced solution."""
    expected, last, begin = None, "", time.monotonic()
    run = subprocess.Popen(["timeout", str(limit), *command], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                           text=True, errors="replace", env={**os.environ, "ROLLFEM_CACHE": cache, "TERM": "dumb"})
    for line in run.stderr:
        last = line.strip() or last
        found = EXPECTED.match(line)
        if found:
            expected = [found["models"], float(found["time"]) * SECONDS[found["unit"]], time.monotonic()]
    status, end = run.wait(), time.monotonic()
    return {"status": None if status == 124 else status, "seconds": end - begin, "last": last,
            "expected": expected and [*expected[:2], end - expected[2]]}


def models_of(folder):
    summary = folder / "summary.json"
    return json.loads(summary.read_text("utf-8"))["models"] if summary.exists() else []


def place_of(model):
    place = model.get("place") or {}
    return tuple(place.get(name) for name in ("wheel", "position", "patch"))


def truth(options, scene):
    """Models of the finest solution; {} if neither hybrid nor half-space finishes in time."""
    kept = options.output / f"{scene.name}_truth.json"
    if not kept.exists():
        for model in ("hybrid", "halfspace"):
            folder = options.output / f"{scene.name}_{model}"
            subprocess.run(["timeout", "300", options.program, "run", str(options.output / f"{scene.name}.toml"), "--model",
                            model, "--set", "contact_grid.elements_across=80", "--no-report", "-q", "-o", str(folder)],
                           capture_output=True, check=False)
            found = models_of(folder)
            if found:
                break
        kept.write_text(json.dumps(found), "utf-8")
    return {place_of(model): model for model in json.loads(kept.read_text("utf-8"))}


def nearness(options, scene):
    """Error of the answer over 1 %, or over its own error estimate if that is larger: values up to 1 are right. None
    without a finest solution."""
    right, friction = truth(options, scene), friction_of(scene)
    worst = None
    for model in models_of(options.output / scene.name):
        if place_of(model) not in right:
            continue
        for point, other in zip(model["points"], right[place_of(model)]["points"]):
            for name in auto.QUANTITIES:
                whole = abs(friction if name == "traction_coefficient" else other[name])
                own = sum(part.get(name, 0.0) for part in (point["error_estimate"], point.get("model_error", {})))
                if whole > 0.0:
                    off = abs(point[name] - other[name]) / max(0.01 * whole, own)
                    worst = max(worst or (0.0, ""), (off, name))
    return worst


def run(options, scene):
    """Stored in a file beside the case, by its text."""
    case, kept = options.output / f"{scene.name}.toml", options.output / f"{scene.name}.json"
    if kept.exists() and case.read_text("utf-8") == scene.text:
        return json.loads(kept.read_text("utf-8"))
    case.write_text(scene.text, "utf-8")
    folder = options.output / scene.name
    with tempfile.TemporaryDirectory() as cache:  # seconds of a cold start
        row = watched([options.program, "run", str(case), "--no-report", "-o", str(folder)], cache, options.limit)
    models = models_of(folder) if row["status"] in (0, 1) else []
    row["taken"] = sorted({model["name"] for model in models})
    row["short"] = bool(models and json.loads((folder / "summary.json").read_text("utf-8"))["verdict"])
    kept.write_text(json.dumps(row), "utf-8")
    return row


def outcome(row):
    if row["status"] is None:
        return "beyond the limit"
    if row["status"] < 0 or row["status"] >= 128:
        return "crash"
    if row["status"] != 0:
        return "refused"
    return "lack said" if row["short"] else "met"


OUTCOMES = ["met", "lack said", "refused", "beyond the limit", "crash"]


def table(rows):
    lines = ["| kind | scenes | " + " | ".join(OUTCOMES) + " | within 60 s, % | median s | longest s |",
             "|---|" + "---|" * (len(OUTCOMES) + 4)]
    kinds = list(dict.fromkeys(kind for kind, _ in rows))
    for kind in [*kinds, "all"]:
        of_kind = [row for its, row in rows if kind in (its, "all")]
        counts = [sum(outcome(row) == word for row in of_kind) for word in OUTCOMES]
        seconds = [row["seconds"] for row in of_kind]
        within = sum(value <= WANTED for value in seconds)
        lines.append(f"| {kind} | {len(of_kind)} | " + " | ".join(map(str, counts))
                     + f" | {100 * within / len(of_kind):.0f} | {statistics.median(seconds):.2g} | {max(seconds):.0f} |")
    return "\n".join(lines)


def predictions(rows):
    """Table of announced times by model."""
    lines = ["| announced | runs | within a factor of 3, % | median of measured over predicted | worst |",
             "|---|---|---|---|---|"]
    known = [row["expected"] for _, row in rows if row["expected"] and row["taken"]]
    for models in sorted({models for models, *_ in known}):
        ratios = sorted(measured / predicted for name, predicted, measured in known
                        if name == models)
        held = sum(1 / 3 <= ratio <= 3 for ratio in ratios)
        lines.append(f"| {models} | {len(ratios)} | {100 * held / len(ratios):.0f} | "
                     f"{statistics.median(ratios):.2g} | {ratios[0]:.2g}, {ratios[-1]:.2g} |")
    return "\n".join(lines)


def main():
    parser = scene_sets.parser(__doc__)
    parser.add_argument("--measured", type=Path, help="folder of measured pairs; skipped without it")
    parser.add_argument("--every", type=int, default=1, help="use only every n-th of them")
    parser.add_argument("--truth", action="store_true", help="compare with the finest solution")
    parser.add_argument("--limit", type=float, default=120.0, help="s for each run")
    options = parser.parse_args()
    scene_sets.prepare(options.output)
    rows, near = [], []
    for scene in default_scenes.scenes(options.seed, options.output, options.measured)[::options.every]:
        row = run(options, scene)
        rows.append((scene.kind, row))
        tried = "{}: {:.2g} s expected, took {:.2g}".format(*row["expected"]) if row["expected"] else ""
        off = nearness(options, scene) if options.truth else None
        if off:
            near.append(off[0] <= 1.0)
        told = row["last"] if outcome(row) not in ("met", "lack said") else ""
        print(f"{scene.name}: {outcome(row)}, {row['seconds']:.1f} s, {'+'.join(row['taken'])}; {tried} {told}"
              + (f"; error {off[0]:.2g} times the allowed one ({off[1]})" if off else ""), flush=True)
    if near:
        print(f"\n{sum(near)} of {len(near)} answers with a finest solution are within 1 % or their own estimate")
    print("\n" + table(rows) + "\n\n" + predictions(rows))


if __name__ == "__main__":
    main()
