# Holds JSON files against a JSON Schema, draft 7, with Python's jsonschema: judge_json.py SCHEMA, the
# names of the files on standard input. Prints "FILE validates" or "FILE fails: REASON" for each.
# Used by tests/support/judges.cpp.
# SPDX-License-Identifier: MIT
import json
import sys

import jsonschema

with open(sys.argv[1], encoding="utf-8") as file:
    schema = json.load(file)
jsonschema.Draft7Validator.check_schema(schema)
validator = jsonschema.Draft7Validator(schema)
for name in sys.stdin.read().splitlines():
    try:
        with open(name, encoding="utf-8") as file:
            error = next(validator.iter_errors(json.load(file)), None)
    except ValueError as exception:  # not JSON, or not UTF-8
        print(name, "fails:", str(exception).replace("\n", " "))
        continue
    print(name, "validates" if error is None else "fails: " + error.message.replace("\n", " ")[:200])
