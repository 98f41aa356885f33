# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks that includes between modules, and between the rooms of a module, run one way.

base <- case <- scene <- result <- contact <- halfspace <- fem; result keeps results in files and knows no solver;
theories stand on halfspace; hybrid knows halfspace and the options of fem, and is given what fem finds; convert knows
cases and closed forms;
profiles and meshes know cases and scenes, no solver; track places profiles, finds their contacts and balances loads and
rotation over them, for which it knows halfspace; modelling registers what solves, opens fem at run time, and
chooses among models (of which modelling/choice knows results only); tables fills tables of creep forces and keeps them
in files; app knows all; of the bindings, interface, which others build on, hands modelling on, and python
stands on interface; capi, the C interface, knows the pair of track and files of tables; contact, the library of
CONTACT's names, fills the struct of convert and solves it by half-spaces; deal.II is seen in fem and
in hybrid/correction, which is built into the library of fem.
No model is told apart by its name: what differs is a property of its entry in the registry (contact/solve/model.hpp).
The order of the rooms of a module: ROOMS.
"""

import re

ANY = None  # every room of that module

SCENES = {"base": ANY, "case": ANY, "scene": ANY}
SOLVER = {**SCENES, "result": {"", "heat"}, "contact": ANY}

# Modules that each module, or a room of one, may include.
ALLOWED = {
    "base": {},
    "case": {"base": ANY},
    "scene": {"base": ANY, "case": ANY},
    "result/write": {**SCENES, "result": ANY},
    "result": {**SCENES},
    "contact/iteration": {"base": ANY, "scene": ANY, "result": {""}},
    "contact/solve": {"base": ANY, "scene": ANY, "result": {"", "heat"}, "contact": {"iteration"}},
    "halfspace": {**SOLVER},
    "theories": {**SOLVER, "halfspace": ANY},
    "profiles": {**SCENES},
    "meshes": {**SCENES},
    "track": {**SOLVER, "halfspace": ANY, "profiles": ANY},
    "fem": {**SOLVER, "halfspace": ANY, "meshes": ANY},
    "hybrid/correction": {**SOLVER, "halfspace": ANY, "fem": ANY, "hybrid": {""}},
    "hybrid": {**SOLVER, "halfspace": ANY, "fem": {""}},
    "modelling/choice": {"base": ANY, "result": {""}},
    "modelling": {**SOLVER, "result": ANY, "halfspace": ANY, "theories": ANY, "hybrid": ANY, "track": ANY,
               "fem": {"", "elasticity"}},
    "convert": {**SCENES, "halfspace": {"closed_forms"}},
    "tables/files": {"base": ANY, "case": ANY, "result": {"files", "hdf5"}},
    "tables": {**SOLVER, "halfspace": ANY, "track": ANY, "result": ANY},
    "app": {**SOLVER, "result": ANY, "halfspace": ANY, "hybrid": ANY, "modelling": ANY, "convert": ANY, "meshes": ANY,
            "profiles": ANY, "track": ANY, "tables": ANY, "theories": ANY, "fem": {"elasticity"}},
    "bindings/interface": {**SOLVER, "result": ANY, "modelling": ANY},
    "bindings/python": {**SOLVER, "result": ANY, "bindings": {"interface"}, "halfspace": {"closed_forms", "patch", "stress"},
                        "profiles": ANY, "track": ANY, "modelling": ANY, "tables": ANY},
    "bindings/capi": {**SOLVER, "track": {"pair"}, "tables": {"files"}},
    "bindings/contact": {**SOLVER, "halfspace": ANY, "theories": {""}, "profiles": ANY, "track": ANY, "convert": ANY},
}
# Rooms of a module, each of which may include those before it.
ROOMS = {
    "halfspace": ["closed_forms", "elasticity", "patch", "stress", "model", "curvature", ""],
    "fem": ["", "mesh", "discretisation", "linear", "trace", "stress", "plasticity", "elasticity"],
    "hybrid": ["", "correction"],
    "track": ["placement", "search", "motion", "balance", "history", "pair"],
    "case": ["", "keys", "checks", "reading"],
    "result": ["", "heat", "files", "hdf5", "write"],
    "modelling": ["program", "caches", "fem", "choice", "solving", "stress", "", "frame"],
    "tables": ["files", "filling"],
    "app": ["frame", "input", "results", "run", ""],
}
MODULES = {name.split("/")[0] for name in ALLOWED}
HEAVY = re.compile(r"^(deal\.II|mpi\.h|p4est|Epetra|ml_)")

def room_of(path):
    """Module and room of a path relative to the root: ("contact", "scene")."""
    parts = path.split("/")
    return parts[0], parts[1] if len(parts) > 2 else ""


def judge(path, bracket, name):
    """Why the include is wrong, or None."""
    module, room = room_of(path)
    if HEAVY.match(name) and module != "fem" and (module, room) != ("hybrid", "correction"):
        return "finite-element and MPI libraries are known to fem and hybrid/correction only"
    if bracket == '"' and "/" not in name:
        return "include by folder"
    other, other_room = room_of(name)
    if other not in MODULES or (other, other_room) == (module, room):
        return None
    allowed = ALLOWED.get(f"{module}/{room}", ALLOWED.get(module))
    if allowed is None:
        return f"no rule for {module}/{room}"
    if other == module and f"{module}/{room}" not in ALLOWED:
        order = ROOMS.get(module)
        if order is None or other_room in order[:order.index(room) if room in order else 0]:
            return None
        return f"{module}/{room} must not know {module}/{other_room}"
    if other not in allowed:
        return f"{module} must not know {other}"
    rooms = allowed[other]
    if rooms is not ANY and other_room not in rooms:
        return f"{module}/{room} knows only {', '.join(sorted(rooms))} of {other}"
    return None


NAMED = re.compile(r'ModelInfo\s+\w+(?:\{|\s*=\s*theory\()\s*"([a-z-]+)"')
TOLD_APART = re.compile(r'(?:[=!]=\s*"([a-z-]+)")|(?:"([a-z-]+)"\s*[=!]=)')
# There the name is a word of the case file that is written.
MAY_NAME_MODELS = {"convert"}


def told_apart(line, names):
    """The model whose name a line of code compares with, or None."""
    for match in TOLD_APART.finditer(line.split("//")[0]):
        if (name := match[1] or match[2]) in names:
            return name
    return None


def names_compared(root):
    texts = {file: file.read_text(encoding="utf-8") for module in sorted(MODULES) for file in (root / module).rglob("*.cpp")}
    names = {name for text in texts.values() for name in NAMED.findall(text)} - {"auto"}  # a word of many keys
    if len(names) < 8:
        yield f"only {len(names)} registered models found: {sorted(names)}"
    for file, text in texts.items():
        path = file.relative_to(root).as_posix()
        for number, line in enumerate(text.splitlines(), 1):
            if room_of(path)[0] not in MAY_NAME_MODELS and (name := told_apart(line, names)):
                yield f"{path}:{number}: {line.strip()}: asks for the name {name}; do: ask its entry in the registry"


def problems(root):
    self_test()
    yield from names_compared(root)
    yield from stale_names(root)
    for module in sorted(MODULES):
        files = sorted((root / module).rglob("*.[ch]pp"))
        if not files:
            yield f"{module}: no source files found in {root / module}"
        for file in files:
            path = file.relative_to(root).as_posix()
            for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
                match = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
                if not match:
                    continue
                wrong = judge(path, *match.groups())
                if wrong:
                    yield f"{path}:{number}: {line.strip()}: {wrong}"


def stale_names(root):
    """Files that comments name and that are gone."""
    sources = [p for folder in [*{a.split("/")[0] for a in ALLOWED}, "tests", "benchmarks"] for p in (root / folder).rglob("*.?pp")]
    ends = {"/".join(p.parts[-count:]) for p in sources for count in range(1, 5)}
    for path in sources:
        for number, line in enumerate(path.read_text("utf-8").splitlines(), 1):
            for name in re.findall(r"[\w/]+\.[hc]pp\b", line.partition("//")[2]):
                if name not in ends:
                    yield f"{path.relative_to(root)}:{number}: names {name}, which is not there"


def self_test():
    """Tests the checker itself, because one that cannot fail is useless."""
    def verdict(path, line):
        return judge(path, line[0], line[1:])

    assert verdict("contact/solve/a.cpp", '"halfspace/closed_forms/hertz.hpp')
    assert verdict("case/a.cpp", '"contact/iteration/normal.hpp')
    assert verdict("contact/solve/a.cpp", '"case/case.hpp')
    assert verdict("halfspace/model/a.cpp", '"fem/discretisation/body.hpp')
    assert verdict("result/write/a.cpp", '"contact/iteration/normal.hpp')
    assert verdict("profiles/a.cpp", '"contact/iteration/tangential.hpp')
    assert verdict("track/search/a.cpp", '"track/motion/placed_scenes.hpp')
    assert verdict("halfspace/patch/a.cpp", '"halfspace/model/halfspace_model.hpp')
    assert verdict("halfspace/model/a.cpp", '"theories/strip.hpp')
    assert verdict("halfspace/model/a.cpp", '"track/motion/placed_scenes.hpp')
    assert verdict("app/a.cpp", '"fem/linear/multigrid.hpp')
    assert verdict("fem/mesh/a.cpp", '"fem/linear/multigrid.hpp')
    assert verdict("hybrid/a.cpp", '"hybrid/correction/flat_twin.hpp')
    assert verdict("hybrid/a.cpp", "<deal.II/base/mpi.h")
    assert verdict("bindings/capi/a.cpp", '"modelling/registry.hpp')
    assert verdict("bindings/interface/rollfem/a.cpp", '"bindings/python/bindings.hpp')
    assert not verdict("bindings/python/a.cpp", '"bindings/interface/rollfem/rollfem.hpp')
    assert told_apart('if (model.name == "fem") {', {"fem"}) and told_apart('"fem" != name', {"fem"})
    assert not told_apart('run.name = "fem";  // == "fem"', {"fem"}) and not told_apart('word == "planar"', {"fem"})
    assert verdict("app/a.cpp", "<deal.II/base/mpi.h")
    assert verdict("fem/linear/a.cpp", '"body.hpp')
    assert not verdict("fem/linear/a.cpp", "<deal.II/base/mpi.h")
    assert not verdict("halfspace/model/a.cpp", '"contact/iteration/normal.hpp')
    assert not verdict("app/a.cpp", '"fem/elasticity/fem_model.hpp')
    assert not verdict("contact/solve/a.cpp", '"scene/geometry.hpp')
    assert not verdict("track/balance/a.cpp", '"track/motion/placed_scenes.hpp')
