"""clang-format 14 (Debian 12's) leaves every source as it is. Another version formats otherwise."""
import shutil
import subprocess

from sources import read_sources

VERSION = "14."


def missing_tool():
    """Why the check cannot run here, or None."""
    if shutil.which("clang-format") is None:
        return "clang-format is not installed"
    answer = subprocess.run(["clang-format", "--version"], capture_output=True, text=True)
    if f"version {VERSION}" not in answer.stdout:
        return f"needs clang-format {VERSION}x, got {answer.stdout.strip()}"
    return None


def check_formatting(root):
    """clang-format would change nothing."""
    paths = [source.path for source in read_sources(root)]
    if not paths:
        return
    command = ["clang-format", "--dry-run", "--ferror-limit=1", *paths]
    answer = subprocess.run(command, cwd=root, capture_output=True, text=True)
    for line in answer.stderr.splitlines():
        if "[-Wclang-format-violations]" in line:
            yield line.split(": warning:")[0] + ": clang-format -i would change it"
    if answer.returncode != 0:
        yield f"clang-format: exit status {answer.returncode}: {answer.stderr.strip()}"
