"""The dependency rule of ARCHITECTURE.md, read off the #include lines.

A folder includes itself and what stands in its row, which points to lower levels only. Mains (level
3), the launcher, tests and benchmarks may include every library. Middleware stays in its corner.
"""
import pathlib
import re

from sources import read_sources

BELOW = {
    "common/base": [],
    "common/world": ["common/base"],
    "common/nn": ["common/base"],
    "common/rl": ["common/base"],
    "common/environments": ["common/rl", "common/world"],
    "common/policies": ["common/rl", "common/nn"],
    "common/team": ["common/environments", "common/policies"],
    "common/local": ["common/rl"],
    "common/run": ["common/rl"],
    "common/dds": ["common/rl"],
    "common/evaluation": ["common/world"],
    "actor": ["common/environments", "common/policies"],
    "replay": ["common/rl"],
    "learner": ["common/policies"],
}
# Level 3, and what stands beside the levels: any library.
FREE = {"deploy", "bench", "examples", "tests", "python"}

INCLUDE = re.compile(r'\s*#\s*include\s*([<"])([^>"]+)[>"]')
MIDDLEWARE = re.compile(r"(fastdds|fastrtps|fastcdr)/")


def includes_of(source):
    """(line number, is quoted, name) of each #include."""
    for number, line in enumerate(source.lines, 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match.group(1) == '"', match.group(2)


def all_below(library):
    found = set()
    waiting = [library]
    while waiting:
        for lower in BELOW[waiting.pop()]:
            if lower not in found:
                found.add(lower)
                waiting.append(lower)
    return found


def library_of(path):
    """`common/world` for common/world/strategies/strategy.h; None for what is in no library."""
    parts = path.split("/")
    if len(parts) < 2:
        return None
    return "/".join(parts[:2]) if parts[0] == "common" else parts[0]


def may_include(source, library):
    """The libraries that a file may include beside its own; None: any."""
    if library in FREE:
        return None
    allowed = all_below(library)
    if not library.startswith("common/") and source.name == "main.cpp":
        return allowed | {"common/dds", "common/run"}  # a main is its library + dds + run
    if re.search(r"_config\.(h|cpp)$", source.name):  # reads its part of the configuration
        return allowed | {"common/run"}
    return allowed


def check_levels(root):
    """Includes point to lower levels only, are written from the root, and name files that exist."""
    for source in read_sources(root):
        library = library_of(source.path)
        if library not in BELOW and library not in FREE:
            yield f"{source.path}:1: stands in no folder that the dependency rule knows"
            continue
        allowed = may_include(source, library)
        for number, quoted, name in includes_of(source):
            if not quoted:
                continue
            place = f"{source.path}:{number}: {name}"
            target = library_of(name)
            if not (pathlib.Path(root) / name).is_file():
                yield f"{place}: must be the path of a file, from the root of the project"
            elif target != library and allowed is not None and target not in allowed:
                yield f"{place}: {library} must not include {target}"
            elif target == "tests" and library not in ("tests", "bench"):
                yield f"{place}: only tests and benchmarks may include tests"


def sees_middleware(path):
    """common/dds, and the tests of its codec."""
    return library_of(path) == "common/dds" or path.startswith("tests/dds/")


def generated_headers(root):
    names = {source.name[: -len(".idl")] for source in read_sources(root, [".idl"])}
    return {name + ending for name in names for ending in (".h", "PubSubTypes.h", "TypeObject.h")}


def check_middleware(root):
    """Fast DDS and generated headers are under common/dds, and in no header that it shows."""
    generated = generated_headers(root)
    sources = {source.path: source for source in read_sources(root)}

    def is_middleware(name):
        return bool(MIDDLEWARE.match(name)) or name in generated

    for source in sources.values():
        for number, _, name in includes_of(source):
            if is_middleware(name) and not sees_middleware(source.path):
                yield f"{source.path}:{number}: {name}: belongs under common/dds only"

    shown = {}  # a header of common/dds → the file outside that includes it
    for source in sources.values():
        if sees_middleware(source.path):
            continue
        for _, quoted, name in includes_of(source):
            if quoted and library_of(name) == "common/dds":
                shown.setdefault(name, source.path)
    waiting = list(shown)
    while waiting:
        path = waiting.pop()
        if path not in sources:
            continue
        for number, quoted, name in includes_of(sources[path]):
            if is_middleware(name):
                yield (f"{path}:{number}: {name}: must not be in a header that others include, "
                       f"as {shown[path]} does")
            elif quoted and name not in shown:
                shown[name] = shown[path]
                waiting.append(name)


def check_libraries(root):
    """cereal is in .cpp and *_archive.h files; toml++ in .cpp files of common/run and configs."""
    for source in read_sources(root):
        for number, _, name in includes_of(source):
            place = f"{source.path}:{number}: {name}"
            if name.startswith("cereal/"):
                if source.is_header and not source.name.endswith("_archive.h"):
                    yield f"{place}: belongs in .cpp and *_archive.h files only"
            elif name.startswith("toml++/"):
                in_run = library_of(source.path) == "common/run"
                if source.is_header or not (in_run or source.name.endswith("_config.cpp")):
                    yield f"{place}: belongs in .cpp files of common/run and *_config.cpp only"
