"""What a file's lines must look like: contracts, columns, comments, sizes, names, tests without
sleeps."""
import re
import unicodedata

from sources import read_sources

COLUMNS = 100
HEADER_LINES = 200
SOURCE_LINES = 450
FUNCTION_LINES = 80
# CMake looks for packages in files that are called FindNAME.cmake.
SNAKE_CASE = re.compile(r"[a-z0-9_]+(\.[a-z0-9_]+)*|Find\w+\.cmake")
OPEN_POINT = re.compile(r"\b(TODO|FIXME|HACK)\b")
# Examples in a contract are indented behind their //, so they are not meant.
CODE_COMMENT = re.compile(
    r"\s*// ?(((if|for|while|switch) \(|return\b|#include\b).*[;{]"
    r"|[\w:.>\[\]-]+(\(.*\)| [-+*/|&]?= \S+( [-+*/%<>&|?:]+ \S+)*|\+\+|--);)$")
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


def functions_of(lines):
    """(line number, lines) of what ends with a } in the first column; classes end with };."""
    begin = None
    for number, line in enumerate(lines, 1):
        if line == "}" and begin:
            yield begin, number - begin + 1
        elif re.match(r"[A-Za-z]", line) and not line.startswith("namespace"):
            begin = number


def check_sizes(root):
    """One idea a file: at most 200 lines a header, 450 a source, 80 a function."""
    for source in read_sources(root):
        most = HEADER_LINES if source.is_header else SOURCE_LINES
        if len(source.lines) > most:
            yield f"{source.path}: must be at most {most} lines, got {len(source.lines)}"
        lists_definitions = source.name.endswith("_reference.h")  # a test's slow second version
        for number, size in functions_of(source.lines):
            if size > FUNCTION_LINES and not lists_definitions:
                place = f"{source.path}:{number}"
                yield f"{place}: a function must be at most {FUNCTION_LINES} lines, got {size}"


def check_names(root):
    """Files and folders are in snake_case; none is a Manager, a Handler or utils."""
    for source in read_sources(root, [".h", ".cpp", ".idl", ".py", ".sh", ".cmake"]):
        match = FORBIDDEN_NAMES.search(source.path)
        if match:
            yield f"{source.path}: '{match.group()}' in a file's name: name the idea"
        for part in source.path.split("/"):
            if not SNAKE_CASE.fullmatch(part):
                yield f"{source.path}: '{part}' must be snake_case"


def check_comments(root):
    """Comments say why: no code that is commented out, no open points."""
    for source in read_sources(root, [".h", ".cpp", ".idl"]):
        for number, line in enumerate(source.lines, 1):
            if CODE_COMMENT.match(line):
                yield f"{source.path}:{number}: code in a comment: delete it"
            if OPEN_POINT.search(line):
                yield f"{source.path}:{number}: an open point belongs in an issue, not in the code"


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
