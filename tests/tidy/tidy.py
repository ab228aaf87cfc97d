#!/usr/bin/env python3
"""Checks the project's own files: tidy.py CHECK ROOT.

Prints one line for each breach and exits with 1 where there is one; with 77 where the check cannot
run on this machine. Python's standard library only.
"""
import argparse
import sys

import claims
import documents
import formatting
import includes
import text
import walks

CHECKS = {
    "columns": text.check_columns,
    "comments": text.check_comments,
    "contracts": text.check_contracts,
    "decisions": documents.check_decisions,
    "formatting": formatting.check_formatting,
    "levels": includes.check_levels,
    "libraries": includes.check_libraries,
    "links": documents.check_links,
    "middleware": includes.check_middleware,
    "names": text.check_names,
    "sizes": text.check_sizes,
    "sleeps": text.check_sleeps,
    "tests": claims.check_tests,
    "walks": walks.check_walks,
}
CANNOT_RUN = 77


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("check", choices=CHECKS)
    parser.add_argument("root")
    arguments = parser.parse_args()
    if arguments.check == "formatting" and formatting.missing_tool():
        print(formatting.missing_tool())
        return CANNOT_RUN
    breaches = list(CHECKS[arguments.check](arguments.root))
    for breach in breaches:
        print(breach)
    return 1 if breaches else 0


if __name__ == "__main__":
    sys.exit(main())
