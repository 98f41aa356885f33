#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""peers.py ROOT PROGRAM INPUT: converts and runs an input of CONTACT, and compares with the output of CONTACT.

peers.txt holds what is expected. The inputs are not in the repository: they lie in the folders contact_testbank and
contact_examples of $ROLLFEM_REFERENCE, or of ../shared/reference beside the repository; without them status 77."""
import os
import pathlib
import sys

ROOT, PROGRAM, NAME = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2], sys.argv[3]
sys.path.insert(0, str(ROOT / "benchmarks"))
import contact_agreement  # noqa: E402

COLUMNS = ["F_n", "p0", "F_x", "F_y"]


def expected():
    """The row of the input: cases, converted, those up to which cases are run, how many run; largest differences in %."""
    for line in (ROOT / "tests/python/peers.txt").read_text().splitlines():
        if line.split()[:1] == [NAME]:
            return [float(word) if word != "-" else None for word in line.split()[1:]]
    sys.exit(f"peers.txt has no row {NAME}")


def main():
    folder = pathlib.Path(os.environ.get("ROLLFEM_REFERENCE", ROOT.parent / "shared" / "reference"))
    found = [folder / part / f"{NAME}.inp" for part in ("contact_testbank", "contact_examples")]
    source = next((path for path in found if path.exists()), None)
    if source is None:
        print(f"SKIPPED: no {NAME}.inp in contact_testbank or contact_examples of {folder}; set ROLLFEM_REFERENCE")
        return 77
    cases, converted, last, run, *largest = expected()
    made = contact_agreement.measure(PROGRAM, source.resolve(), last=None if last is None else int(last))
    print(contact_agreement.row(NAME, made), *made.failed, sep="\n")
    wrong = []
    for what, wanted in (("cases", cases), ("converted", converted), ("run", run)):
        if getattr(made, what) != wanted:
            wrong.append(f"{getattr(made, what)} {what}, {wanted:g} expected; refused: {dict(made.refused)}")
    for what, bound in zip(COLUMNS, largest):
        off, case = made.largest.get(what, (None, 0))
        if (off is None) != (bound is None) or (bound is not None and off > bound):
            wrong.append(f"{what} differs by {off} % in case {case}, up to {bound} % expected")
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
