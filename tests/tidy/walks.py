"""The two walks through the code that ARCHITECTURE.md prints: stops, each with a `path`."""
import pathlib
import re

STOPS = {"One transition": 8, "One weight update": 5}
ITEM = re.compile(r"\s*(?:\d+\.|[-*])\s")
PATH = re.compile(r"`([^`\s]+)`")


def stops_of(lines, section):
    """(line number, text) of the list items below the heading, or None where it is missing."""
    found = None
    for number, line in enumerate(lines, 1):
        if line.startswith("#"):
            if found is not None:
                break
            if line.lstrip("#").strip() == section:
                found = []
        elif found is not None and ITEM.match(line):
            found.append((number, line))
    return found


def check_walks(root):
    """Each walk has its number of stops, and each stop begins with files that exist."""
    document = pathlib.Path(root) / "ARCHITECTURE.md"
    if not document.is_file():
        yield "ARCHITECTURE.md: missing; it must print the walks"
        return
    lines = document.read_text(encoding="utf-8").splitlines()
    for section, count in STOPS.items():
        stops = stops_of(lines, section)
        if stops is None:
            yield f"ARCHITECTURE.md: must have a section '{section}'"
            continue
        if len(stops) != count:
            yield f"ARCHITECTURE.md: '{section}' must have {count} stops, got {len(stops)}"
        for number, text in stops:
            paths = [path for path in PATH.findall(text) if "/" in path]
            if not paths:
                yield f"ARCHITECTURE.md:{number}: must name a file in backticks"
            for path in paths:
                if not (pathlib.Path(root) / path).is_file():
                    yield f"ARCHITECTURE.md:{number}: {path}: no such file"
