"""Tests that can fail: each is built, is named by what it claims, and checks something."""
import pathlib
import re

from sources import read_sources

CASE = re.compile(r"TEST_CASE\(\s*((?:\"(?:[^\"\\]|\\.)*\"\s*)+)")
ASSERTION = re.compile(r"\b(CHECK|REQUIRE|FAIL|Check|Require|Expect)\w*(<\w+>)?\(")
FEWEST_WORDS = 3


def cases_of(text):
    """(line number, name, body) of each TEST_CASE; bodies end with a } in the first column."""
    for match in CASE.finditer(text):
        number = text.count("\n", 0, match.start()) + 1
        name = "".join(re.findall(r'"((?:[^"\\]|\\.)*)"', match.group(1)))
        yield number, name, text[match.end():].split("\n}", 1)[0]


def check_tests(root):
    """TEST_CASEs are in *_test.cpp files that CMake builds; each claims and checks something."""
    root = pathlib.Path(root)
    cmake = "\n".join("\n".join(source.lines)
                      for source in read_sources(root, ["CMakeLists.txt", ".cmake"]))
    for source in read_sources(root, [".cpp"]):
        text = "\n".join(source.lines)
        cases = list(cases_of(text))
        is_test = source.name.endswith("_test.cpp")
        if cases and not is_test:
            yield f"{source.path}: a file of tests must be called *_test.cpp"
        if is_test and not cases:
            yield f"{source.path}: has no TEST_CASE"
        if is_test and not re.search(rf"\b{re.escape(source.name)}\b", cmake):
            yield f"{source.path}: no CMake file builds it"
        for number, name, body in cases:
            if len(name.split()) < FEWEST_WORDS:
                yield f"{source.path}:{number}: '{name}': a test's name must be a claim"
            if not ASSERTION.search(body):
                yield f"{source.path}:{number}: '{name}': checks nothing, so it cannot fail"
