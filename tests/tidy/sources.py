"""The files that the tidy checks read: all of the project's own, under one root folder."""
import pathlib

LEFT_OUT = {"build", "runs", ".git", ".cache", "__pycache__"}


class Source:
    """One file: `path` relative to the root, with /; `lines` without their ends."""

    def __init__(self, root, path):
        self.path = path.relative_to(root).as_posix()
        self.name = path.name
        self.lines = path.read_text(encoding="utf-8").splitlines()

    @property
    def is_header(self):
        return self.name.endswith(".h")

    @property
    def is_cpp(self):
        return self.name.endswith((".h", ".cpp"))

    @property
    def folder(self):
        return self.path.rpartition("/")[0]


def read_sources(root, endings=(".h", ".cpp")):
    """All files below the root with one of the endings, by path."""
    root = pathlib.Path(root)
    paths = []
    for path in root.rglob("*"):
        parts = path.relative_to(root).parts
        if path.name.endswith(tuple(endings)) and not LEFT_OUT & set(parts) and path.is_file():
            paths.append(path)
    return [Source(root, path) for path in sorted(paths)]
