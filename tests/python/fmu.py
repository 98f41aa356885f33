#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Imports rollfem_wheelset.fmu as a simulation program does, and holds it against examples/hunting_in_python: the same
motion, states that are restored, failures with a reason, libraries of its own. Status 77 without NumPy.
Call: fmu.py FMU EXAMPLES rollfem.h librollfem_c.so power_law.so"""
import ctypes
import pathlib
import sys
import tempfile
import xml.etree.ElementTree as xml
import zipfile

try:
    import numpy
except ImportError:
    print("NumPy is not installed: skipped")
    sys.exit(77)

LOGGER = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p,
                          ctypes.c_char_p)


class Callbacks(ctypes.Structure):
    _fields_ = [("logger", LOGGER), *((name, ctypes.c_void_p) for name in ("allocate", "free", "finished", "environment"))]


class Fmu:
    def __init__(self, path):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        zipfile.ZipFile(path).extractall(self.folder)
        self.description = xml.parse(self.folder / "modelDescription.xml").getroot()
        model = self.description.find("CoSimulation").get("modelIdentifier")
        self.library = ctypes.CDLL(str(self.folder / "binaries/linux64" / f"{model}.so"))
        self.library.fmi2Instantiate.restype = ctypes.c_void_p
        self.library.fmi2GetVersion.restype = ctypes.c_char_p
        self.variables = {v.get("name"): v for v in self.description.iter("ScalarVariable")}
        self.said = []
        self.callbacks = Callbacks(LOGGER(lambda *words: self.said.append(words[5].decode())))
        self.slave = None

    def call(self, name, *arguments):
        return getattr(self.library, name)(ctypes.c_void_p(self.slave), *arguments)

    def instantiate(self, guid=None):
        guid = guid or self.description.get("guid")
        self.slave = self.library.fmi2Instantiate(b"wheelset", 1, guid.encode(), b"", ctypes.byref(self.callbacks), 0, 0)

    def reference(self, name):
        return ctypes.byref(ctypes.c_uint(int(self.variables[name].get("valueReference"))))

    def set(self, **values):
        for name, value in values.items():
            text = isinstance(value, str)
            place = ctypes.c_char_p(value.encode()) if text else ctypes.c_double(value)
            function = "fmi2SetString" if text else "fmi2SetReal"
            assert self.call(function, self.reference(name), ctypes.c_size_t(1), ctypes.byref(place)) == 0, self.said

    def get(self, name):
        place = ctypes.c_double()
        assert self.call("fmi2GetReal", self.reference(name), ctypes.c_size_t(1), ctypes.byref(place)) == 0
        return place.value

    def initialise(self):
        self.call("fmi2SetupExperiment", 0, ctypes.c_double(0.0), ctypes.c_double(0.0), 0, ctypes.c_double(0.0))
        return self.call("fmi2EnterInitializationMode") or self.call("fmi2ExitInitializationMode")

    def step(self, time, step):
        return self.call("fmi2DoStep", ctypes.c_double(time), ctypes.c_double(step), 0)


def same_motion(fmu, example, header, library):
    """The free wheelset from 2 mm: alike to what one Jacobian for all and one for each step differ by."""
    sys.path.insert(0, example)
    import rollfem_c
    import runs
    import wheelset

    contact = wheelset.ContactForces(rollfem_c.Library(header, library))
    vehicle = runs.free(20.0)
    start = numpy.array([2e-3, 0.0, 0.0, 0.0, 0.0])
    _, series, _ = runs.integrate(vehicle, contact, start, 0.1, 0.002, jacobian_every=5)
    for k in range(10):
        assert fmu.step(0.01 * k, 0.01) == 0, fmu.said
    for k, name in enumerate(("shift", "lateral_velocity", "yaw", "yaw_rate", "extra_rotation")):
        scale = numpy.abs(series[k]).max()
        print(f"{name}: {fmu.get(name):.9g}, by the example {series[k, -1]:.9g}")
        assert abs(fmu.get(name) - series[k, -1]) <= 1e-6 * scale + 1e-12


def fall_with_the_slip_velocity(fmu):
    """A wheelset that slides at 0.4 m/s, by its yaw, has half of the fall: as with the coefficient 0.2. By a law from
    outside with a constant of its own, its power 2, it has a quarter of the fall from sqrt(2) times s_h on."""
    falls = dict(friction=0.3, kinetic_coefficient=0.1)
    for coefficient, law in ((0.2, dict(friction_law="exponential", half_velocity=0.4)),
                             (0.15, dict(friction_law="power", half_velocity=0.4 / 2**0.5, law_constant_1=2.0))):
        sliding = []
        for friction in (dict(friction=coefficient), {**falls, **law}):
            fmu.call("fmi2Reset")
            fmu.set(start_yaw=0.02, speed=20.0, **friction)
            assert fmu.initialise() == 0, fmu.said
            sliding.append(fmu.get("left_fy"))
        print(f"left_fy: {sliding[1]:.6g}, with the coefficient there {sliding[0]:.6g}")
        assert abs(sliding[1] / sliding[0] - 1.0) < 0.02
    fmu.call("fmi2Reset")


def heat_is_that_of_the_work_of_friction(fmu):
    """Full sliding: the rise goes with the work of friction, and friction by temperature takes from both."""
    found = []
    for more in (dict(), dict(heat=1.0), dict(heat=1.0, wheel_temperature=80.0, rail_temperature=80.0),
                 dict(friction_law="temperature", law_constant_2=220.0, law_constant_3=0.1)):
        fmu.call("fmi2Reset")
        fmu.set(start_yaw=0.05, speed=20.0, **more)
        assert fmu.initialise() == 0, fmu.said
        found.append([fmu.get(name) for name in ("left_temperature", "right_temperature", "left_t_gamma")])
    none, cold, warm, falling = found
    print("temperatures:", found)
    assert none[:2] == [0.0, 0.0] and none[2] == cold[2] == warm[2]
    assert abs(cold[0] - cold[1]) < 0.02 * cold[0] and cold[0] > 100.0
    assert abs(warm[0] - cold[0] - 60.0) < 1e-6, "a body that comes hotter stays so"
    assert 0.4 < falling[2] / none[2] < 0.9 and 0.4 < (falling[0] - 20.0) / (cold[0] - 20.0) < 0.9
    fmu.call("fmi2Reset")


def without_an_instance(fmu):
    """NULL is an error, not the end of the process: as an instance, and as any list or state of a sound one."""
    nothing, one = ctypes.c_void_p(), ctypes.c_size_t(1)
    lists = ("GetReal", "SetReal", "GetString", "SetString", "GetInteger", "SetInteger", "GetBoolean", "SetBoolean")
    states = ("GetFMUstate", "SetFMUstate", "FreeFMUstate")
    others = ("Reset", "SetupExperiment", "EnterInitializationMode", "ExitInitializationMode", "Terminate", "CancelStep",
              "SetDebugLogging", "GetStatus", "GetDirectionalDerivative", "SerializeFMUstate", "DoStep")
    for name in (*lists, *states, *others):
        assert getattr(fmu.library, f"fmi2{name}")(nothing, nothing, one, nothing) == 3, name
    fmu.library.fmi2FreeInstance(nothing)
    fmu.instantiate()
    assert all(fmu.call(f"fmi2{name}", nothing, one, nothing) == 3 for name in lists)
    assert all(fmu.call(f"fmi2{name}", nothing) == 3 for name in states)
    assert fmu.call("fmi2GetReal", nothing, ctypes.c_size_t(0), nothing) == 0
    fmu.library.fmi2FreeInstance(ctypes.c_void_p(fmu.slave))
    assert fmu.library.fmi2Instantiate(None, 1, None, None, None, 0, 0) is None


def main():
    path, examples, header, library, law = sys.argv[1:]
    fmu = Fmu(path)
    ctypes.CDLL(law)  # into the libraries of the FMU
    assert fmu.library.fmi2GetVersion() == b"2.0" and fmu.description.get("fmiVersion") == "2.0"
    without_an_instance(fmu)
    fmu.instantiate("another guid")
    assert fmu.slave is None and "guid" in fmu.said[-1]
    fmu.instantiate()
    for name, variable in fmu.variables.items():  # start values are those of the description
        if variable.find("Real") is not None and variable.get("causality") != "output":
            assert fmu.get(name) == float(variable.find("Real").get("start")), name
    assert fmu.step(0.0, 0.01) == 3, "a step before the initialisation"
    fmu.set(friction=-1.0)
    assert fmu.initialise() == 3 and "friction" in fmu.said[-1], fmu.said
    fmu.call("fmi2Reset")
    fmu.set(friction_law="falls")
    assert fmu.initialise() == 3 and "friction_law" in fmu.said[-1] and "rational" in fmu.said[-1], fmu.said
    fmu.call("fmi2Reset")
    fmu.set(law_constant_2=2.0)
    assert fmu.initialise() == 3 and "law_constants[1]" in fmu.said[-1], fmu.said
    fall_with_the_slip_velocity(fmu)
    heat_is_that_of_the_work_of_friction(fmu)
    fmu.set(largest_step=1e-12)
    assert fmu.initialise() == 0 and fmu.step(0.0, 0.01) == 2 and "largest_step" in fmu.said[-1], fmu.said
    fmu.call("fmi2Reset")
    fmu.set(start_shift=2e-3, wheel_profile="S1002", left_load=50e3)
    assert fmu.initialise() == 0, fmu.said
    assert fmu.get("shift") == 2e-3 and fmu.get("left_fx") * fmu.get("right_fx") < 0.0, "the larger wheel steers"
    mapped = pathlib.Path("/proc/self/maps").read_text()
    ours = {line.split()[-1] for line in mapped.splitlines() if "librollfem" in line}
    assert ours and all(name.startswith(str(fmu.folder)) for name in ours), ours
    same_motion(fmu, str(pathlib.Path(examples) / "hunting_in_python"), header, library)
    for name in ("mass", "largest_step", "start_shift"):
        place = ctypes.c_double(1.0)
        assert fmu.call("fmi2SetReal", fmu.reference(name), ctypes.c_size_t(1), ctypes.byref(place)) == 3
        assert "fixed after the initialisation" in fmu.said[-1], fmu.said
    place = ctypes.c_char_p(b"S1002-smooth")
    assert fmu.call("fmi2SetString", fmu.reference("wheel_profile"), ctypes.c_size_t(1), ctypes.byref(place)) == 3
    state = ctypes.c_void_p()
    assert fmu.call("fmi2GetFMUstate", ctypes.byref(state)) == 0
    assert fmu.step(0.1, 0.01) == 0
    once = [fmu.get(name) for name in ("shift", "yaw_rate", "left_fy", "right_t_gamma")]
    assert fmu.call("fmi2SetFMUstate", state) == 0 and fmu.step(0.1, 0.01) == 0
    assert once == [fmu.get(name) for name in ("shift", "yaw_rate", "left_fy", "right_t_gamma")]
    fmu.set(left_load=-1.0)
    assert fmu.step(0.11, 0.01) == 2 and "vertical_force" in fmu.said[-1]
    assert fmu.get("shift") == once[0], "a step that is discarded changes nothing"
    fmu.call("fmi2FreeFMUstate", ctypes.byref(state))
    fmu.library.fmi2FreeInstance(ctypes.c_void_p(fmu.slave))
    print(f"{path}: imported, {len(fmu.variables)} variables")


main()
