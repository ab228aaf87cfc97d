"""What Markdown files point to exists; decisions are numbered files with a title."""
import pathlib
import re

from sources import read_sources

LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
CODE = re.compile(r"`[^`]*`")
FOLDERS = "actor bench cmake common deploy docs idl learner maps python replay tests".split()
PATH = re.compile(rf"`((?:{'|'.join(FOLDERS)})/[a-z0-9_./-]+)`")
DECISION = re.compile(r"(\d{4})-[a-z0-9]+(-[a-z0-9]+)*\.md")


def prose_of(source):
    """(line number, line) outside of fenced code."""
    fenced = False
    for number, line in enumerate(source.lines, 1):
        if line.lstrip().startswith("```"):
            fenced = not fenced
        elif not fenced:
            yield number, line


def anchors_of(path):
    """The anchors that GitHub gives the headings of a Markdown file."""
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.startswith("#"):
            title = line.lstrip("#").strip().lower()
            yield re.sub(r"[^\w\- ]", "", title).replace(" ", "-")


def check_links(root):
    """Relative links, their anchors, and paths of the project in backticks lead somewhere."""
    root = pathlib.Path(root)
    for source in read_sources(root, [".md"]):
        here = root / source.path
        for number, line in prose_of(source):
            place = f"{source.path}:{number}"
            for link in LINK.findall(CODE.sub("", line)):
                name, _, anchor = link.partition("#")
                if re.match(r"[a-z]+:", name):
                    continue  # elsewhere
                target = (here.parent / name) if name else here
                if not target.exists():
                    yield f"{place}: {link}: leads to no file"
                elif anchor and anchor not in anchors_of(target):
                    yield f"{place}: {link}: leads to no heading"
            for path in PATH.findall(line):
                if not any((root / (path + end)).exists() for end in ("", ".h", ".cpp", ".cmake")):
                    yield f"{place}: {path}: no such file"


def check_decisions(root):
    """docs/adr has files NNNN-title.md, each number once, that begin with `# N. Title`."""
    numbers = {}
    for source in read_sources(root, [".md"]):
        if source.folder != "docs/adr":
            continue
        match = DECISION.fullmatch(source.name)
        if not match:
            yield f"{source.path}: must be called NNNN-title-in-lower-case.md"
            continue
        number = int(match.group(1))
        if number in numbers:
            yield f"{source.path}: {numbers[number]} has the number {number} already"
        numbers[number] = source.path
        if not source.lines or not re.match(rf"# {number}\. \S", source.lines[0]):
            yield f"{source.path}:1: must be '# {number}. Title'"
