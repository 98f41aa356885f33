#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks that a build keeps its lock when the launcher that began it is killed (the next call waits, and only then
builds), and that tests run on all cores, with one thread each. ninja and ctest are stand-ins. Call: launcher.py SOURCE_DIR"""

import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

TOOLS = "bash flock nproc awk grep dirname env readlink mkdir cat tail tr sleep".split()
NINJA = """#!/bin/bash
for word; do if [ "$word" = -n ]; then echo Building; exit 0; fi; done
echo begin >>"$WORK/log"
while [ ! -e "$WORK/go" ]; do sleep 0.02; done
echo end >>"$WORK/log"
"""


def wait_for(what):
    for _ in range(1500):
        if what():
            return
        time.sleep(0.02)
    sys.exit("nothing happened within 30 s")


def main():
    with tempfile.TemporaryDirectory() as name:
        work = pathlib.Path(name)
        log, said = work / "log", work / "said"
        launcher = shutil.copy(pathlib.Path(sys.argv[1]) / "rollfem", work / "rollfem")
        (work / "bin").mkdir()
        for tool in TOOLS:
            (work / "bin" / tool).symlink_to(shutil.which(tool))
        (work / "bin" / "ninja").write_text(NINJA)
        (work / "bin" / "ninja").chmod(0o755)
        build = work / "build-halfspace"
        build.mkdir()
        (build / "build.ninja").touch()
        (build / ".preset").write_text("halfspace-only \n")
        environment = {"PATH": str(work / "bin"), "WORK": name, "ROLLFEM_FEM": "OFF", "ROLLFEM_JOBS": "1"}

        (work / "bin" / "ctest").write_text('#!/bin/bash\necho "$OMP_NUM_THREADS" "$@" >"$WORK/tests"\n')
        (work / "bin" / "ctest").chmod(0o755)

        def call(command="build"):
            return subprocess.Popen(["/bin/bash", launcher, command], env=environment, stdin=subprocess.DEVNULL,
                                    stdout=subprocess.DEVNULL, stderr=said.open("w"))

        first = call()
        try:
            wait_for(lambda: log.exists() and log.read_text() == "begin\n")
            first.send_signal(signal.SIGKILL)
            first.wait()
            second = call()
            wait_for(lambda: "this one waits" in said.read_text() or log.read_text() != "begin\n")
            assert log.read_text() == "begin\n", "two builds in one folder"
        finally:
            (work / "go").touch()
        assert second.wait(30) == 0, said.read_text()
        assert log.read_text() == "begin\nend\nbegin\nend\n", log.read_text()
        assert call("test").wait(30) == 0, said.read_text()
        tests = (work / "tests").read_text().split()
        assert tests[0] == "1" and tests[tests.index("-j") + 1] == str(len(os.sched_getaffinity(0))), tests
    print("a build keeps its lock; tests run on all cores")


if __name__ == "__main__":
    main()
