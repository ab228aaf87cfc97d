"""What a file's lines must look like: contracts, columns, sizes, names, tests without sleeps."""
import re
import unicodedata

from sources import read_sources

COLUMNS = 100
HEADER_LINES = 200
SOURCE_LINES = 450
FORBIDDEN_NAMES = re.compile(r"manager|handler|utils", re.IGNORECASE)
CPP_SLEEP = re.compile(r"\b(sleep_for|sleep_until|usleep|nanosleep|sleep)\s*\(")
SCRIPT_SLEEP = re.compile(r"\btime\.sleep\b|(^|[;&|({]|\bdo|\bthen)\s*sleep\s+\S")


def check_contracts(root):
    """Each header is `#pragma once`, and right after it a comment that says what it is."""
    for source in read_sources(root, [".h"]):
        if source.lines[:1] != ["#pragma once"]:
            yield f"{source.path}:1: must be #pragma once"
        elif len(source.lines) < 2 or not re.match(r"// \S.*\S", source.lines[1]):
            yield f"{source.path}:2: must begin the header's contract, a comment"


def width(line):
    """In columns: accents that combine with the letter before them take none."""
    return sum(1 for character in line if not unicodedata.combining(character))


def check_columns(root):
    """No line is wider than 100 columns."""
    for source in read_sources(root, [".h", ".cpp", ".idl", ".py"]):
        for number, line in enumerate(source.lines, 1):
            if width(line) > COLUMNS:
                place = f"{source.path}:{number}"
                yield f"{place}: must be at most {COLUMNS} columns, got {width(line)}"


def check_sizes(root):
    """One idea a file: at most 200 lines a header, 450 a source."""
    for source in read_sources(root):
        most = HEADER_LINES if source.is_header else SOURCE_LINES
        if len(source.lines) > most:
            yield f"{source.path}: must be at most {most} lines, got {len(source.lines)}"


def check_names(root):
    """No file is a Manager, a Handler or utils."""
    for source in read_sources(root, [".h", ".cpp", ".idl", ".py", ".sh"]):
        match = FORBIDDEN_NAMES.search(source.name)
        if match:
            yield f"{source.path}: '{match.group()}' in a file's name: name the idea"


def check_sleeps(root):
    """No test sleeps; it waits for the event itself."""
    for source in read_sources(root, [".h", ".cpp", ".py", ".sh"]):
        if not source.path.startswith("tests/") or source.path.startswith("tests/tidy/"):
            continue
        pattern = CPP_SLEEP if source.is_cpp else SCRIPT_SLEEP
        comment = "//" if source.is_cpp else "#"
        for number, line in enumerate(source.lines, 1):
            if pattern.search(line.split(comment)[0]):
                yield f"{source.path}:{number}: a test must not sleep: wait for the event itself"
