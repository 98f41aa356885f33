# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every case file of the tree follows the JSON schema that `rollfem docs schema` prints, and damaged ones do not.

The validator below knows what the schema uses of draft 7."""

import json
import subprocess
import tomllib

TYPES = {"object": dict, "array": list, "string": str, "boolean": bool}


def errors(value, schema, where="case"):
    """Errors of the value, one sentence each."""
    found = []
    kind = schema.get("type")
    if kind in ("number", "integer"):
        if isinstance(value, bool) or not isinstance(value, (int, float) if kind == "number" else int):
            return [f"{where}: no {kind}"]
    elif kind and not isinstance(value, TYPES[kind]):
        return [f"{where}: no {kind}"]
    for key, holds in (("minimum", lambda b: value >= b), ("maximum", lambda b: value <= b),
                       ("exclusiveMaximum", lambda b: value < b)):
        if key in schema and not holds(schema[key]):
            found.append(f"{where}: {value} against {key} {schema[key]}")
    if "enum" in schema and value not in schema["enum"]:
        found.append(f"{where}: {value} is none of {schema['enum']}")
    if "pattern" in schema and not value.startswith(schema["pattern"].lstrip("^")):
        found.append(f"{where}: {value} does not match")
    if "anyOf" in schema and all(errors(value, part, where) for part in schema["anyOf"]):
        found.append(f"{where}: {value} is none of what is allowed")
    if isinstance(value, dict):
        known = schema.get("properties", {})
        for name, child in value.items():
            found += errors(child, known[name], f"{where}.{name}") if name in known else [f"{where}.{name}: unknown"]
        found += [f"{where}.{name}: missing" for name in schema.get("required", []) if name not in value]
    if isinstance(value, list) and "items" in schema:
        if not schema.get("minItems", 0) <= len(value) <= schema.get("maxItems", 10 ** 9):
            found.append(f"{where}: {len(value)} items")
        for number, child in enumerate(value):
            found += errors(child, schema["items"], f"{where}[{number}]")
    return found


def problems(root, program):
    schema = json.loads(subprocess.run([program, "docs", "schema"], check=True, capture_output=True).stdout)
    cases = sorted((root / "cases").rglob("*.toml"))
    wrong = [] if cases else ["there are no cases"]
    for path in cases:
        wrong += [f"{path.relative_to(root)}: {p}" for p in errors(tomllib.loads(path.read_text()), schema)]
    good = tomllib.loads((root / "cases" / "thesis_a.toml").read_text())
    for section, key, value in (("load", "normal_force", -1.0), ("friction", "coeficient", 0.3), ("wheel", "rolling_radius", "405"),
                                ("rail", "transverse_radius", 0.0), ("output", "paths", ["z"])):
        damaged = {**good, section: {**good.get(section, {}), key: value}}
        if not errors(damaged, schema):
            wrong.append(f"the schema allows {section}.{key} = {value}")
    return wrong
