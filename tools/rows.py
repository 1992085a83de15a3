#!/usr/bin/python3
"""Makes the tables of doc/json.md, from doc/pulloff-1.schema.json and from the rows of a result (src/core/result), and the
definitions of a result in that schema, from the same rows and the keys of a scene (src/text/keys).

Usage: rows.py PRINT_ROWS SOURCE_TREE [--write | --page FILE]

Without an option the schema is compared with the rows; --write replaces the definitions that are made from them. The page is
stored without its tables: --page, a step of the build, writes it with them. In the stored page

- `<!-- rows: NAME -->` stands for the table of a definition that is made from rows;
- `<!-- schema: NAME, ... -->` for that of definitions which are written by hand in the schema: the meaning of a key is its
  `description`, when it is null or absent its `$comment`, and the heading of that column the `$comment` of the definition;
  keys with the same texts share a row;
- names that only a space separates stand for one table each;
- `…` in the table of the request for the words or the parameters of the laws or profiles.

Exit status: 0 the schema agrees, 1 otherwise.
"""

import json
import pathlib
import re
import subprocess
import sys

COLUMNS = ("key", "type", "unit", "si", "error", "null", "omitted", "of", "says")
NULL = {"type": "null"}
# The keys of a result that do not come from its rows: the request, and the table of its profile.
BEFORE = {"result": {"key": "input", "says": "the request, defaults included", "of": "input"}}
AFTER = {"work": {"key": "profile_table", "says": "the table of the profile", "null": "absent for other profiles",
                  "omitted": "1", "of": "profile_table"}}
NAMELESS = dict.fromkeys(COLUMNS, "") | {"type": "part", "omitted": "0"}


def blocks(program):
    """The rows of each definition, in order. A row that follows from several blocks counts once."""
    found = {}
    for line in subprocess.run([program], capture_output=True, text=True, check=True).stdout.splitlines():
        name, *cells = line.split("\t")
        rows = found.setdefault(name, [])
        row = dict(zip(COLUMNS, cells, strict=True))
        if name in BEFORE and not rows:
            rows.append(NAMELESS | BEFORE[name])
        rows.append(row)
        if name == "result" and row["key"] in AFTER:
            rows.append(NAMELESS | AFTER[row["key"]])
    return found


def value_of(row):
    """The JSON Schema of the value of a row."""
    kind, of = row["type"], row["of"]
    number = {"type": ["number", "null"] if row["null"] else "number"}
    if kind == "number":
        return number
    if kind == "extended":
        return {"oneOf": [number, {"const": "inf"}]}
    if kind == "automatic":
        return {"type": ["number", "string", "null"]}
    if kind == "text":
        return {"type": ["string", "null"] if row["null"] else "string"}
    if kind == "count":
        return {"type": "integer", "minimum": 0}
    if kind == "word" and of.endswith(" status"):
        return {"oneOf": [{"enum": of.split()[:-1]}, {"$ref": "#/$defs/status"}]}
    if kind == "word":
        return {"enum": of.split()}
    if kind in ("part", "list", "status"):
        value = {"$ref": f"#/$defs/{of or kind}"}
        value = {"type": "array", "items": value} if kind == "list" else value
        return {"oneOf": [value, NULL]} if row["null"] and row["omitted"] == "0" else value
    return {"integer": {"type": "integer"}, "flag": {"type": "boolean"},
            "label": {"type": "string"},
            "unit": {"enum": ["pi w R", "pi w epsilon"]},
            "labels": {"type": "array", "items": {"type": "string"}, "minItems": 2, "maxItems": 2}}[kind]


def wrapped(words, width=108):
    """A JSON array of texts, in one line if there is room."""
    whole = json.dumps(words)
    if len(whole) + 18 <= width:
        return whole
    lines = [""]
    for word in map(json.dumps, words):
        if len(lines[-1]) + len(word) + 10 > width:
            lines.append("")
        lines[-1] += (" " if lines[-1] else "") + word + ","
    return "[\n        " + "\n        ".join(lines).rstrip(",") + "\n      ]"


def described(row):
    """The JSON Schema of the value of a row, with its meaning and when it is null or absent."""
    words = {"description": row["says"], "$comment": row["null"]}
    return {key: text for key, text in words.items() if text} | value_of(row)


def definition(name, rows):
    """The text of a definition of the schema. A document may have more keys than a result. Keys of a scene, and those in SI
    units, have no description: a row of a key says whose it is."""
    value = value_of if name == "input" or "physical" in name else described
    keys = ",\n        ".join(f'"{row["key"]}": {json.dumps(value(row), ensure_ascii=False)}' for row in rows)
    required = wrapped([row["key"] for row in rows if row["omitted"] == "0"])
    closed = "" if name == "result" else ',\n      "additionalProperties": false'
    return (f'    "{name}": {{\n      "type": "object",\n      "properties": {{\n        {keys}\n      }},\n'
            f'      "required": {required}{closed}\n    }}')


def table(name, rows):
    """The lines of a table of the page. Columns without an entry are left out."""
    columns = {"unit": "unit", "error": "error", "null": "null or absent" if name == "result" else "null"}
    columns = {key: title for key, title in columns.items() if any(row[key] for row in rows)}
    lines = [f"| `{name}` | meaning | " + "".join(f"{title} | " for title in columns.values()),
             "|---" * (2 + len(columns)) + "|"]
    for row in rows:
        part = f" (`{row['of']}`)" if row["type"] in ("part", "list") and row["of"] != row["key"] else ""
        words = ": " + ", ".join(f"`{word}`" for word in row["of"].split()) if row["type"] == "word" else ""
        words = words if "`" not in row["says"] else ""
        cells = [f"`{row['error']}`" if key == "error" and row[key] else row[key] for key in columns]
        lines.append(f"| `{row['key']}` | {row['says']}{part}{words} | " + "".join(f"{cell} | " for cell in cells))
    return "\n".join(line.rstrip() for line in lines)


def table_of_schema(names, schema):
    """The lines of a table of definitions that are written by hand, each key once."""
    column = schema[names[0]].get("$comment", "")
    rows = {}
    for name in names:
        for key, value in schema[name]["properties"].items():
            if "description" in value:
                rows.setdefault((value["description"], value.get("$comment", "")), []).append(f"`{key}`")
    lines = [f"| {', '.join(f'`{name}`' for name in names)} | meaning |" + (f" {column} |" if column else ""),
             "|---" * (3 if column else 2) + "|"]
    lines += [f"| {', '.join(keys)} | {says} |" + (f" {null} |" if column else "") for (says, null), keys in rows.items()]
    return "\n".join(lines)


def page_with_tables(text, found, schema):
    """The stored page with the tables of the definitions, and without the paragraph that says that it has none."""
    for owner in ("law", "profile"):
        words = next(row["of"].split() for row in found["input"] if row["key"] == owner)
        listed = ", ".join(f"`{word}`" for word in words)
        text = replaced(text, rf"^(\| `{owner}` \| [^|:]*: )… \|", rf"\g<1>{listed} |", owner)
        listed = ", ".join(f"`{row['key']}`" for row in found["input"] if row["says"] == owner and row["type"] == "number")
        text = replaced(text, rf"^\| … (\| parameters of the {owner} \|)", rf"| {listed} \g<1>", f"parameters of the {owner}")
    request = re.search(r"^\| `input` \| meaning .*(?:\n\|.*)*", text, re.M)[0]
    lacking = [row["key"] for row in found["input"] if f"`{row['key']}`" not in request]
    if lacking:
        sys.exit(f"doc/json.md: the table of `input` lacks {', '.join(lacking)}")
    text = re.sub(r"^<!-- (rows|schema): (.*) -->$", lambda place: "\n\n".join(
        f"<!-- {place[1]}: {names} -->" for names in re.split(r"(?<!,) ", place[2])), text, flags=re.M)
    for name, rows in found.items():
        text = text if name == "input" else replaced(text, rf"^<!-- rows: {name} -->$", table(name, rows), name)
    text = re.sub(r"^<!-- schema: (.*) -->$", lambda names: table_of_schema(names[1].split(", "), schema), text, flags=re.M)
    return replaced(text, r"^<!-- as it is stored -->\n(?:.+\n)+\n", "", "the paragraph on the stored page")


def in_si(found):
    """The definitions of a result in SI units: blocks with numbers that have a dimension, which have the unit in their key."""
    def has_dimension(row):
        return row["si"] or (row["type"] in ("part", "list") and any(map(has_dimension, found.get(row["of"], []))))

    def changed(row):
        row = row | {"key": f"{row['key']}_{row['si']}" if row["si"] else row["key"]}
        return row | {"of": f"physical_{row['of']}"} if row["type"] in ("part", "list") and has_dimension(row) else row

    names = {"curve_point", "profile_point", "contact"}
    result = [row for row in found["result"] if has_dimension(row)]
    waiting = [row["of"] for row in result + found["contact"]]
    while waiting:
        name = waiting.pop()
        if name not in names and any(map(has_dimension, found.get(name, []))):
            names.add(name)
            waiting += [row["of"] for row in found[name]]
    said = {f"physical_{name}": [changed(row) for row in found[name]] for name in sorted(names - {""})}
    units = NAMELESS | {"key": "units", "of": "units"}
    points = [NAMELESS | {"key": key, "type": "list", "of": f"physical_{key}_point", "omitted": "1"} for key in ("curve", "profile")]
    points.append(NAMELESS | {"key": "contact", "of": "physical_contact", "omitted": "1"})
    points.append(NAMELESS | {"key": "profile_approach_m", "type": "number", "null": "as in `solve`", "omitted": "1"})
    said["record_physical"] = [units, *map(changed, result)]
    bodies = NAMELESS | {"key": "bodies", "of": "bodies", "omitted": "1"}
    said["physical"] = [NAMELESS | {"key": "input", "of": "physical_input"}, bodies, *said["record_physical"], *points]
    return said


def replaced(text, pattern, new, what):
    """The text with the one place that fits a pattern replaced."""
    places = re.findall(pattern, text, re.M)
    if len(places) != 1:
        sys.exit(f"{what}: {len(places)} places: expected 1")
    return re.sub(pattern, lambda found: found.expand(new) if "\\g<" in new else new, text, flags=re.M)


def schema_with_definitions(text, found):
    """The JSON Schema with the definitions of the rows."""
    found["input"].append(NAMELESS | {"key": "load_unit", "type": "unit"})
    for name, rows in found.items():
        text = replaced(text, rf'^    "{name}": {{\n(?:     .*\n)*    }}', definition(name, rows), name)
    pattern = r'^    "(?:physical(?!_input)\w*|record_physical)": {\n(?:     .*\n)*    }(?:,\n)?'
    text = re.sub(pattern, "", text, flags=re.M)
    defined = "".join(definition(name, rows) + ",\n" for name, rows in in_si(found).items())
    return replaced(text, r'^    "theory_physical": {\n', defined + '    "theory_physical": {\n', "theory_physical")


def main():
    program, root, *more = sys.argv[1:]
    page, schema = pathlib.Path(root, "doc/json.md"), pathlib.Path(root, "doc/pulloff-1.schema.json")
    found, text = blocks(program), schema.read_text(encoding="utf-8")
    if more[:1] == ["--page"]:
        made = page_with_tables(page.read_text(encoding="utf-8"), found, json.loads(text)["$defs"])
        pathlib.Path(more[1]).write_text(made, encoding="utf-8")
        return 0
    renewed = schema_with_definitions(text, found)
    if renewed != text and more == ["--write"]:
        schema.write_text(renewed, encoding="utf-8")
    elif renewed != text:
        print(f"{schema.name} does not agree with keys and rows: run tools/rows.py with --write")
    return 1 if renewed != text and not more else 0


if __name__ == "__main__":
    sys.exit(main())
