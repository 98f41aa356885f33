# SPDX-License-Identifier: LGPL-2.1-or-later
"""librollfem_c through ctypes. Structures and constants are read from rollfem.h, so that they fit the installed library:

    lib = rollfem_c.Library(header="/opt/rollfem/include/rollfem/rollfem.h", library="/opt/rollfem/lib/librollfem_c.so")
    pair = lib.pair(units=lib.ROLLFEM_M_N, side=lib.ROLLFEM_RIGHT)
    result = pair.solve(lib.state(lateral_shift=0.003, forward_speed=20.0, rotation_speed=43.5, vertical_force=50e3))
    result.force[1], result.patch[0].max_pressure
"""
import ctypes
import re

SCALARS = {"double": ctypes.c_double, "int": ctypes.c_int, "size_t": ctypes.c_size_t, "const char*": ctypes.c_char_p}


class RollfemError(RuntimeError):
    """What the library says of a call that it refuses, or that has no solution."""


def constants_of(text):
    """All enumerators."""
    return {name: int(value) for name, value in re.findall(r"\b(ROLLFEM_\w+) = (\d+)", text)}


def structures_of(text, constants):
    """A ctypes.Structure for each `typedef struct { ... } name;`."""
    types = dict(SCALARS)
    types.update((name, ctypes.c_int) for name in re.findall(r"typedef enum \{[^}]*\} (\w+);", text))
    found = {}
    for body, name in re.findall(r"typedef struct \{([^}]*)\} (\w+);", text):
        fields = []
        for kind, names in re.findall(r"\s*((?:const )?\w+\*?) ([^;]+);", body):
            for member in names.split(","):
                field = types[kind]
                for size in reversed(re.findall(r"\[(\w+)\]", member)):
                    field = field * (constants[size] if size in constants else int(size))
                fields.append((member.split("[")[0].strip(), field))
        types[name] = found[name] = type(name, (ctypes.Structure,), {"_fields_": fields})
    return found


class Library:
    """The library, its constants as attributes, and structures with struct_size set."""

    def __init__(self, header, library):
        with open(header, encoding="utf-8") as file:
            text = re.sub(r"/\*.*?\*/", "", file.read(), flags=re.S)
        self.__dict__.update(constants_of(text))
        self.structures = structures_of(text, constants_of(text))
        self.library = ctypes.CDLL(library)
        for name in ("rollfem_create", "rollfem_table_open"):
            getattr(self.library, name).restype = ctypes.c_void_p

    def make(self, name, **members):
        kind = self.structures["rollfem_" + name]
        return kind(struct_size=ctypes.sizeof(kind), **members)

    def state(self, **members):
        return self.make("state", **members)

    def pair(self, units, **members):
        definition = self.make("definition")
        self.library.rollfem_defaults(ctypes.byref(definition), units)
        for name, value in members.items():
            setattr(definition, name, value)
        return Pair(self, definition)

    def table(self, path):
        return Table(self, path)

    def call(self, function, owner, *structures):
        """A function that takes its owner, structures, and a place for a message."""
        message = ctypes.create_string_buffer(1000)
        status = getattr(self.library, function)(ctypes.c_void_p(owner), *map(ctypes.byref, structures), message,
                                                 ctypes.c_size_t(len(message)))
        if status != 0:
            raise RollfemError(message.value.decode())

    def opened(self, function, argument):
        message = ctypes.create_string_buffer(1000)
        owner = getattr(self.library, function)(argument, message, ctypes.c_size_t(len(message)))
        if owner is None:
            raise RollfemError(message.value.decode())
        return owner


class Pair:
    """A wheel on its rail."""

    def __init__(self, lib, definition):
        self.lib = lib
        self.owner = lib.opened("rollfem_create", ctypes.byref(definition))

    def solve(self, state):
        result = self.lib.make("result")
        self.lib.call("rollfem_solve", self.owner, state, result)
        return result

    def linearise(self, state):
        result, derivatives = self.lib.make("result"), self.lib.make("derivatives")
        self.lib.call("rollfem_linearise", self.owner, state, result, derivatives)
        return result, derivatives

    def __del__(self):
        if hasattr(self, "owner"):
            self.lib.library.rollfem_destroy(ctypes.c_void_p(self.owner))


class Table:
    """A table of creep forces for ellipses."""

    def __init__(self, lib, path):
        self.lib = lib
        self.owner = lib.opened("rollfem_table_open", str(path).encode())

    def forces(self, **ellipse):
        given, forces = self.lib.make("ellipse", **ellipse), self.lib.make("creep_forces")
        self.lib.call("rollfem_table_forces", self.owner, given, forces)
        return forces

    def __del__(self):
        if hasattr(self, "owner"):
            self.lib.library.rollfem_table_close(ctypes.c_void_p(self.owner))
