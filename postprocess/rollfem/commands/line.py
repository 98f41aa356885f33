# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands study, compare, bench and stress, as the program hands them over (app/results/package.cpp): options by their long
names, as texts."""
import gc
import json
import os
import signal
import sys
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from .. import _core
from ..errors import InputError, OutputError, SolveError
from ..files import json_is_sound, regular
from ..figures.page import build, draw
from ..outputs import Files
from ..reader import read_result
from ..result import ModelResult, models_of
from . import comparing
from .benching import bench as measured
from .comparing import begin_comparison, compared_models, comparison_of
from .levels import Study, Wishes, known, study_of
from .subsurface import Wanted, stored_at, stress_of

Given = Mapping[str, Any]


def warn(text: str) -> None:
    """One line on stderr, even with -q."""
    print(f"warning: {text}", file=sys.stderr, flush=True)


def tell(text: str) -> None:
    """Text on standard output; a reader that has closed the pipe is no failure."""
    try:
        sys.stdout.write(text)
        sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except OSError as error:
        raise OutputError("standard output cannot be written; do: check whether its disk is full") from error


def _asked(given: Given) -> _core.Computing:
    return _core.Computing(given["command"], "quiet" in given, "resume" in given, given.get("part", [""])[0],
                           int(given.get("merge", ["0"])[0]))


def _settled(given: Given, command: str, *lists: str) -> dict[str, list[str]]:
    """The lists of a call and its case files, of which a list takes those behind it: `compare --model hertz CASE`."""
    found = {name: list(given.get(name, [])) for name in ("case", *lists)}
    for name in lists:
        while found[name] and found[name][-1].endswith(".toml") and (command == "compare" or not found["case"]):
            found["case"].insert(len(given.get("case", [])), found[name].pop())
    if not found["case"]:
        more = " [CASE.toml ...]" if command == "compare" else ""
        raise InputError(f"{command}: no case file is named; do: rollfem {command} CASE.toml{more}")
    if found["model"] != ["all"] or command != "study":
        found["model"] = _core.checked_names(found["model"], "--model")
        _core.refuse_choice(found["model"], command)
    return found


def _stem(path: str) -> str:
    return os.path.splitext(os.path.basename(path))[0]


def _doubt(case: _core.Case) -> None:
    """Warns of values that look like unit mistakes."""
    for doubt in (*case.doubts, *case.neglected):
        warn(doubt)


def _drawn(drawing: Callable[[], object], problem: str) -> bool:
    """Whether something is drawn; otherwise a warning says why not."""
    try:
        drawing()
        return True
    except (OSError, ImportError) as error:
        warn(f"{problem}: {error}")
        return False


def _finish(given: Given, made: Files, folder: str, title: str, notes: list[str], write: bool = True) -> bool:
    """Writes and draws what a command has made, and tells of it; false if it is not drawn as wanted."""
    if write:
        _core.write_files(folder, made.contents)
    wanted = "no-report" not in given
    drawn = wanted and _drawn(lambda: build(folder), "the results were written, but the report was not drawn")
    if "quiet" not in given:
        where = f"\nresults: {folder}\n" + (f"report:  {os.path.join(folder, made.kind)}.html\n" if drawn else "")
        tell(title + made.text + "".join(f"\n{note}\n" for note in notes) + where)
    return drawn or not wanted


def study(given: Given) -> bool:
    """`rollfem study`; whether all is drawn that was wanted."""
    words = _settled(given, "study", "model", "vary", "quantity", "reference")
    file = words["case"][0]
    wishes = Wishes(words["model"], words["vary"], "together" in given, int(given.get("levels", ["0"])[0]), words["quantity"],
                    words["reference"], float(given.get("reference-seconds", [Wishes.reference_seconds])[0]))
    folder = given.get("output", [os.path.join("results", f"{_stem(file)}_study")])[0]
    asked, drawn = _asked(given), True

    def at_once() -> None:
        case = _core.read_case(file, given.get("set", []))
        work = _core.Computation(wishes.named(), asked)
        if work.idle:
            return
        if work.first:
            _doubt(case)
        wishes.check(case)
        _core.refuse_other_result(folder, "study.json")
        _core.check_folder(folder)
        work.own(folder)
        made = Study(wishes, case, work)

        def body() -> None:
            nonlocal drawn
            work.keep_in(folder, case)
            made.solve()
            work.clear_line()
            if not work.first or work.ends_part():
                return
            failures = made.finish()
            drawn = _finish(given, study_of(made.record), folder, f"{case.title}\n\n", made.record.notes)
            if failures:
                raise SolveError(f"the study was written without the levels that failed: {failures}")
            work.forget_kept()

        work.compute("--model", "levels", body)

    divisible = not any(known()[name]["parallel"] for name in wishes.named())
    _core.in_parts(asked, divisible, folder, at_once)
    return drawn


@dataclass
class Task:
    """A case of a comparison with its result folder and earlier results."""

    name: str
    folder: str
    case: _core.Case
    models: list[str]
    missing: list[comparing.Missing] = field(default_factory=list)  #: models that cannot take it, according to an earlier call
    earlier: list[ModelResult] | None = None  #: results of an earlier call

    def stored(self) -> list[ModelResult] | None:
        """The results of an earlier call, if they are valid: same case and files that it reads, program and models, complete
        and undamaged."""
        if _contents(self.folder, "case.toml") != self.case.text_in_folder(self.folder):
            return None
        text, again = _contents(self.folder, "summary.json"), "; the case is computed again"
        if not json_is_sound(text):
            if text:
                warn(f"{os.path.join(self.folder, 'summary.json')} is damaged or was changed: its checksum does not match{again}")
            return None
        summary = json.loads(text)
        names = [model["name"] for model in summary["models"]]
        if (summary.get("case_checksum"), summary.get("program")) != (_core.checksum_of_case(self.case), _program()):
            return None
        if not {*self.models} <= {*names, *(name for name, *_ in self.missing)}:
            return None
        try:
            found = read_result(self.folder)
        except (OSError, ImportError) as error:
            warn(f"{error}{again}")
            return None
        if (found.case_text, [model.name for model in found.models]) == (self.case.text, names):
            return found.models
        warn(f"{os.path.join(self.folder, 'results.h5')} does not belong to this case{again}")
        return None


def _contents(folder: str, name: str) -> str:
    """Empty if there is no such file."""
    try:
        with open(os.path.join(folder, name), encoding="utf-8", errors="surrogateescape", newline="", opener=regular) as file:
            return file.read()
    except OSError:
        return ""


def _program() -> Any:
    return _core.Computation([], None).provenance("")["program"]


def _tasks(given: Given, files: list[str], models: list[str], folder: str) -> list[Task]:
    """The cases; what earlier calls found is in compare.json, which is rewritten after every case."""
    text = _contents(folder, "compare.json")
    tasks: dict[str, Task] = {}
    before = json.loads(text) if json_is_sound(text) else {}
    for file in files:
        task = Task(_stem(file), os.path.join(folder, _stem(file)), _core.read_case(file, given.get("set", [])), models)
        if task.name in tasks:
            raise InputError(f"compare: {tasks[task.name].case.file} and {file} would both be written to {task.folder}; do: give "
                             "one of them another name")
        for one in before.get("cases", ()) if before.get("kind") == "compare" else ():
            if one["name"] == task.name:
                task.missing = [(m["model"], m["reason"], False) for m in one["missing"] if not m["failed"]]
        task.earlier = task.stored() if "resume" in given else None
        tasks[task.name] = task
    return list(tasks.values())


def _reason_alone(message: str) -> str:
    """A message of InputError without its advice, because a skipped model needs no action."""
    return message.partition("; allowed:")[0].partition("; do:")[0]


def _compared(task: Task, work: _core.Computation) -> comparing.Compared:
    """Computes one case and writes its folder."""
    compared = comparing.Compared(task.name, task.case.title, task.case.file, task.case.friction_coefficient)
    if task.earlier is not None:
        if work.first:
            _core.remove_records(task.folder)
        compared.models, compared.missing = comparing.scalars_of(task.earlier), task.missing
        return compared
    try:
        work.keep_in(task.folder, task.case)
        result, missing = work.solve(task.case, task.models)
    except SolveError as error:
        if not work.together:
            raise
        compared.missing = [("every model", str(error), True)]
        return compared
    models = models_of(result)
    compared.missing = [(model, reason if failed else _reason_alone(reason), failed) for model, reason, failed in missing]
    compared.missing += [(model.name, model.shortfall, True) for model in models if model.shortfall]
    if models and work.first:
        _core.store(task.folder, result)
        if not any(failed for *_, failed in missing):
            work.forget_kept()
        compared.models = comparing.scalars_of(models)
    return compared


def _refuse(record: comparing.Record) -> None:
    """Raises for failed models and for cases that no model can take, after everything else is written."""
    failed = "; ".join(f"{one.name}, {model}: {why}" for one in record.cases for model, why, failed in one.missing if failed)
    if failed:
        raise SolveError(f"the comparison was written without the models that failed: {failed}")
    untaken = "; ".join(f"{one.name}: " + "; ".join(f"{model}: {why}" for model, why, _ in one.missing)
                        for one in record.cases if not one.models)
    if untaken:
        raise InputError(f"compare: none of the models can solve {untaken}; do: name one with --model that can "
                         "(docs/models.md), or leave the case out")


def compare(given: Given) -> bool:
    """`rollfem compare`; whether all is drawn that was wanted."""
    words = _settled(given, "compare", "model")
    models, reference = words["model"] or compared_models(), given.get("reference", [""])[0]
    if reference:
        _core.checked_names([reference], "--reference")
        if reference not in models:
            raise InputError(f"--reference {reference}: it is not among the models compared; do: add it to --model, or choose one "
                             "of them")
    name = "compare" if len(words["case"]) > 1 else f"compare_{_stem(words['case'][0])}"
    folder, drawn = given.get("output", [os.path.join("results", name)])[0], True
    tasks = _tasks(given, words["case"], models, folder)
    asked = _asked(given)
    work = _core.Computation(models if any(task.earlier is None for task in tasks) else [], asked)
    if work.idle:
        return True
    if work.first:
        for task in tasks:
            _doubt(task.case)
        _core.refuse_other_result(folder, "compare.json")
        for task in tasks:
            _core.check_directory(task.folder)
    for each in (folder, *(task.folder for task in tasks)):
        work.own(each)
    record = begin_comparison(work, models, reference)

    def body() -> None:
        nonlocal drawn
        made: Files | None = None
        for task in tasks:
            record.cases.append(_compared(task, work))
            if work.first:
                made = comparison_of(record)
                _core.write_files(folder, made.contents)
                done = "done" if record.cases[-1].models else "has no result"
                work.say(f"compare: {task.name} {done if task.earlier is None else 'was already done'}")
        if made:
            drawn = _finish(given, made, folder, "", [], write=False)
            _refuse(record)

    work.compute("--model", "load points", body)
    return drawn


def bench(given: Given) -> bool:
    """`rollfem bench`."""
    quick, as_json = "quick" in given, "json" in given
    models = [name for name, model in known().items()
              if model["built"] and not model["chooses"] and not (quick and model["parallel"])]
    asked = _core.Computing(given["command"], "quiet" in given or not as_json, False, "", 0)
    work = _core.Computation(models, asked)
    if work.idle:
        return True
    _core.switch_off_cache()
    silent = as_json or "quiet" in given or not work.first

    def body() -> None:
        rows = measured(work, quick, (lambda text: None) if silent else tell)
        if as_json and work.first:
            tell(json.dumps({"format": 1, "kind": "bench", "program": _program(), "rows": rows}, indent=1) + "\n")

    work.compute("rollfem bench", "cases", body)
    return True


def _wanted(given: Given) -> Wanted:
    """What a call of `rollfem stress` wants."""
    numbers = {name: float(given[name][0]) if name in given else None for name in ("depth", "yield-shear-stress", "yield-strength")}
    return Wanted(given["result"][0], given.get("model", ()), given.get("patch", [""])[0], [int(each) for each in given.get("point", ())],
                  [float(each) for each in given.get("creepage", ())], given.get("places", [""])[0], "depth-profile" in given,
                  *numbers.values())


def _remove_figures(folder: str) -> None:
    """Removes page and figures of an earlier call of `rollfem stress`, which this call may not draw again."""
    figures = os.path.join(folder, "figures")
    ours = ("depth_", "line_", "surface_", "plane_", "shakedown_map")
    drawn = [os.path.join(figures, name) for name in os.listdir(figures) if name.startswith(ours) and name.endswith(".svg")
             ] if os.path.isdir(figures) else []
    for path in (os.path.join(folder, "stress.html"), *drawn):
        if os.path.exists(path):
            os.remove(path)


def stress(given: Given) -> bool:
    """`rollfem stress`; whether all is drawn that was wanted."""
    result, file = stored_at(given["result"][0])
    found, warnings = stress_of(result, _wanted(given), file)
    for each in warnings:
        warn(each)
    if "json" in given:
        tell(found.contents["stress.json"])
        if "output" not in given:
            return True
    parent = os.path.dirname(file) or "."
    folder = os.path.normpath(given["output"][0] if "output" in given
                              else os.path.join(parent, "..", os.path.basename(os.path.realpath(parent)) + "_stress"))
    earlier = os.path.exists(os.path.join(folder, "stress.json"))
    _core.write_files(folder, found.contents)
    if earlier:
        _remove_figures(folder)
    wanted = "no-figures" not in given
    drawn = wanted and _drawn(lambda: draw(found, folder), "stresses are written, but figures were not drawn")
    if "json" not in given and "quiet" not in given:
        tell(f"{found.text}\nstresses: {folder} (stress.csv, stress.json{', stress.html, figures' * drawn})\n")
    return drawn or not wanted


COMMANDS: dict[str, Callable[[Given], bool]] = {"study": study, "compare": compare, "bench": bench, "stress": stress}


def _carried_out(command: str, given: Given) -> tuple[int, str]:
    """The exit status of a command, 1 if it fails, 2 if the call is wrong, and what is wrong."""
    try:
        return int(not COMMANDS[command](given)), ""
    except (OutputError, SolveError) as error:
        return 1, str(error)
    except InputError as error:
        return 2, str(error)
    except MemoryError:
        return 1, "out of memory; do: use fewer or larger elements, or more processes"
    except Exception as error:
        return 1, f"internal error: {type(error).__name__}: {error}"


def _end_as_usual() -> None:
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)


def main(command: str, given: str) -> None:
    """Carries out a command of the program, with its exit status. Process 0 reports a failure. The others wait for it to end
    them through mpirun, and report themselves only if that does not happen. None waits for another one, which may be inside a
    collective call."""
    _core.tell_of_interruptions()
    os.register_at_fork(after_in_child=_end_as_usual)  # processes that draw
    options = json.loads(given)
    _core.use_threads(options["threads"])
    status, what = _carried_out(command, options)
    if not what:
        sys.exit(status)
    gc.collect()  # locks of folders
    if rank := _core.rank():
        time.sleep(3)
        what = f"process {rank}: {what}"
    print(f"rollfem: {what}", file=sys.stderr, flush=True)
    os._exit(status)
