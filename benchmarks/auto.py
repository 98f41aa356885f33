#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Does the model auto meet the accuracy, and at what cost? For the scenes of benchmarks/scene_sets.py at 5, 1 and 0.2
%: its answer against a fine hybrid; its CPU time against finite elements throughout (as its own account predicts them)
and against an oracle, which knows all results and takes the cheapest of several half-space grids and the fine hybrid
that meets the accuracy.

    benchmarks/auto.py --program build/app/rollfem -o /tmp/auto

Existing runs are reused, including those of benchmarks/model_error.py in the same folder.
"""

import re

import scene_sets
from model_error import friction_of, whole_of

# Default of accuracy_of.
QUANTITIES = ["max_pressure", "semi_axis_x", "semi_axis_y", "traction_coefficient"]
GRIDS = [16, 24, 32, 48, 80]
# Time of finite elements on auto's finest grid relative to the grid for 1 % (modelling/choice/laws.cpp).
FINEST_OVER_ONE_PERCENT = (48 / 24) ** 1.5


def farthest(result, truth, friction):
    """The largest relative error over quantities and load points, and its name."""
    if "failed" in result:
        return float("inf"), result["failed"]
    worst = (0.0, "")
    for number, (point, right) in enumerate(zip(result["models"][0]["points"], truth["models"][0]["points"])):
        whole = {**right, "friction": friction}
        for name in QUANTITIES:
            worst = max(worst, (abs(point[name] - right[name]) / whole_of(whole, name), f"{name} at {number + 1}"))
    return worst


def own_account(result, friction):
    """The result's own error estimate: the largest sum of error bar and model error."""
    return max((point["error_estimate"].get(name, 0.0) + point.get("model_error", {}).get(name, 0.0))
               / whole_of({**point, "friction": friction}, name)
               for point in result["models"][0]["points"] for name in QUANTITIES)


def seconds_of_elements(result):
    """Time of finite elements by auto's account of its choice; None: they are not expected to suffice."""
    told = result["models"][0]["choice"] if "models" in result else ""
    found = re.search(r"finite elements(?: would take about|, \d+ across,) ([\d.e+]+) (s|min|h)", told)
    return float(found.group(1)) * {"s": 1, "min": 60, "h": 3600}[found.group(2)] if found else None


class Runs:
    """Rows of one scene."""

    def __init__(self, options, scene):
        self.options, self.scene, self.friction = options, scene, friction_of(scene)

    def run(self, word, model, **keys):
        return scene_sets.run(self.options.program, self.options.output, f"{self.scene.name}_{word}",
                          self.scene.with_keys(**keys), "--model", model)

    def chosen(self, percent):
        return self.run(f"auto_{percent:g}", "auto", accuracy=str(percent / 100))

    def on_grid(self, across):
        word = "hybrid" if across is None else f"half{across}"
        model = "hybrid" if across is None else "halfspace"
        return self.run(word, model, contact_grid__elements_across=str(across or self.options.across))

    def oracle(self, truth, accuracy):
        """Seconds and name of the cheapest run that meets the accuracy; the fine hybrid always does."""
        rows = [(self.on_grid(across), f"half-space, {across} across") for across in GRIDS]
        close = [(run["cpu"], name) for run, name in rows if farthest(run, truth, self.friction)[0] <= accuracy]
        return min([*close, (truth["cpu"], "hybrid")])

    def row(self, percent):
        truth = self.on_grid(None)
        if "failed" in truth:
            return {"failed": truth["failed"]}
        auto = self.chosen(percent)
        error, where = farthest(auto, truth, self.friction)
        seconds, best = self.oracle(truth, percent / 100)
        elements = seconds_of_elements(auto)
        if elements is None:
            coarser = seconds_of_elements(self.chosen(1))
            elements = None if coarser is None else FINEST_OVER_ONE_PERCENT * coarser
        taken = auto["models"][0]["name"] if "models" in auto else "none"
        return {"scene": self.scene.name, "error": 100 * error, "where": where, "taken": taken, "cpu": auto["cpu"],
                "own": 100 * own_account(auto, self.friction) if "models" in auto else float("inf"),
                "status": auto["status"], "oracle": seconds, "oracle_takes": best, "elements": elements}


def table_line(percent, rows):
    met = [row for row in rows if row["error"] <= percent]
    said = [row for row in rows if row["error"] > percent and row["status"] == 1]
    taken = ", ".join(f"{sum(row['taken'] == name for row in rows)} {name}" for name in ("halfspace", "hybrid", "fem"))
    with_elements = [row for row in rows if row["elements"] is not None]
    elements = sum(row["elements"] for row in with_elements)
    ratio = sum(row["cpu"] for row in with_elements) / elements if elements else float("nan")
    oracle = sum(row["oracle"] for row in rows)
    total = sum(row["cpu"] for row in rows)
    return (f"| {percent:g} % | {len(rows)} | {100 * len(met) / len(rows):.0f} | {len(said)} | {taken} | {total:.0f} | "
            f"{elements:.0f}, {100 * ratio:.2g} % | {oracle:.0f}, {total / oracle:.2g} |")


def main():
    parser = scene_sets.parser(__doc__)
    parser.add_argument("--randoms", type=int, default=40, help="number of random scenes beside the 20 fixed ones")
    parser.add_argument("--every", type=int, default=1, help="use only every n-th of them")
    parser.add_argument("--across", type=int, default=80, help="elements across of the fine hybrid")
    parser.add_argument("--percent", type=float, nargs="+", default=[5.0, 1.0, 0.2])
    parser.add_argument("--rows", action="store_true", help="show every scene instead of only those that miss")
    options = parser.parse_args()
    scene_sets.prepare(options.output)
    lines = []
    for percent in options.percent:
        rows = []
        for scene in scene_sets.scenes(options.seed, options.randoms)[::options.every]:
            row = Runs(options, scene).row(percent)
            if "failed" in row:
                print(f"{scene.name}: {row['failed']}")
                continue
            rows.append(row)
            if options.rows or row["error"] > percent:
                print(f"{percent:g} % {row['scene']}: {row['taken']}, {row['cpu']:.2g} s, error {row['error']:.2g} % "
                      f"({row['where']}), own estimate {row['own']:.2g} %, status {row['status']}; "
                      f"oracle: {row['oracle_takes']}, {row['oracle']:.2g} s", flush=True)
        if rows:
            lines.append(table_line(percent, rows))
    print("\n| accuracy | scenes | met, % | missed and reported | taken | s | finite elements: s, auto of it | oracle: s, "
          "auto over it |\n|---|---|---|---|---|---|---|---|\n" + "\n".join(lines))


if __name__ == "__main__":
    main()
