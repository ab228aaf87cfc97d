"""Figures from what a run has written: a learning curve, a map with traffic, a comparison.

  python3 python/figures.py learning-curve RUN --out FILE.svg
  python3 python/figures.py traffic MAP.json TRACE.csv --out FILE.svg
  python3 python/figures.py compare DIR

Reads files only; never talks to a running cluster. The format follows from the name of the
output (svg, png, pdf); those of a comparison are written into its folder.
"""

import argparse
import collections
import csv
import json
import pathlib

try:
    import matplotlib
except ImportError:
    raise SystemExit("figures need matplotlib (Debian: python3-matplotlib)") from None

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend must be chosen first)

import comparison_figures  # noqa: E402  (needs matplotlib)


def draw_learning_curve(run: pathlib.Path, out: pathlib.Path) -> None:
    """AGI on the evaluation seeds against training time, with best classical strategy and bound."""
    evaluations, summary = [], json.loads((run / "summary.json").read_text())
    with open(run / "metrics.jsonl", encoding="utf-8") as lines:
        for line in lines:
            record = json.loads(line)
            if record.get("kind") == "evaluation":
                evaluations.append((record["time_s"], record["agi_s"]))
    if not evaluations:
        raise SystemExit(f"{run}/metrics.jsonl: no evaluation has been written yet")
    figure, axes = plt.subplots(figsize=(7, 4))
    seconds, agi = zip(*evaluations)
    axes.plot(seconds, agi, marker=".", color="#1f6fb2", label="policy in training")
    best_classical = summary["best_classical_agi_s"]["mean"]
    axes.axhline(best_classical, color="#b2561f", linestyle="--",
                 label=f"best classical: {summary['best_classical']}, {best_classical:.2f} s")
    bound = summary["lower_bound_agi_s"]
    if bound is not None:
        axes.axhline(bound, color="#555555", linestyle=":", label=f"lower bound, {bound:.2f} s")
    axes.set_ylim(0.95 * (bound or min(agi)), max(1.6 * best_classical, 1.05 * min(agi)))
    axes.set_xlabel("training time (s)")
    axes.set_ylabel("average graph idleness (s)")
    axes.set_title(f"{summary['map']}, {summary['agents']} robots")
    axes.legend(frameon=False, fontsize=9)
    axes.grid(alpha=0.3)
    figure.tight_layout()
    figure.savefig(out)


def draw_traffic(map_file: pathlib.Path, trace: pathlib.Path, out: pathlib.Path) -> None:
    """The map: wide edges and pale vertices were used most in the trace's first episode."""
    graph = json.loads(map_file.read_text())
    positions = {str(node["id"]): node["pos"] for node in graph["nodes"]}
    traversals, visits = collections.Counter(), collections.Counter()
    last_vertex, end_s = {}, 0.0
    with open(trace, encoding="utf-8", newline="") as lines:
        lines.readline()  # the comment with warm-up, window and map
        for row in csv.DictReader(lines):
            if row["episode"] != "0":
                break
            if row["event"] == "end":
                end_s = float(row["time_s"])
                continue
            robot, vertex = row["robot"], row["vertex"]
            visits[vertex] += 1
            if robot in last_vertex:
                traversals[frozenset((last_vertex[robot], vertex))] += 1
            last_vertex[robot] = vertex
    figure, axes = plt.subplots(figsize=(8, 6))
    most = max(traversals.values(), default=1)
    for link in graph.get("links") or graph.get("edges"):
        ends = str(link["source"]), str(link["target"])
        used = traversals[frozenset(ends)] / most
        xs, ys = zip(*(positions[end] for end in ends))
        axes.plot(xs, ys, color=plt.cm.viridis(1.0 - used), linewidth=1.0 + 6.0 * used, zorder=1,
                  solid_capstyle="round")
    xs, ys = zip(*positions.values())
    interval_s = [end_s / max(visits[vertex], 1) for vertex in positions]
    dots = axes.scatter(xs, ys, c=interval_s, cmap="magma_r", s=60, edgecolors="black",
                        linewidths=0.6, zorder=2)
    figure.colorbar(dots, ax=axes, label="mean time between visits (s)", shrink=0.8)
    axes.set_aspect("equal")
    axes.invert_yaxis()  # maps count y downwards, as pictures do
    axes.set_xlabel("x (m)")
    axes.set_ylabel("y (m)")
    axes.set_title("traffic: wide edges are travelled most")
    figure.tight_layout()
    figure.savefig(out)


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    curve = commands.add_parser("learning-curve")
    curve.add_argument("run", type=pathlib.Path)
    traffic = commands.add_parser("traffic")
    traffic.add_argument("map", type=pathlib.Path)
    traffic.add_argument("trace", type=pathlib.Path)
    for command in (curve, traffic):
        command.add_argument("--out", type=pathlib.Path, required=True)
    compare = commands.add_parser("compare")
    compare.add_argument("folder", type=pathlib.Path)
    arguments = parser.parse_args()
    if arguments.command == "compare":
        for name in comparison_figures.draw_comparison(arguments.folder):
            print(f"wrote {arguments.folder / name}.svg and .png")
        return
    if arguments.command == "learning-curve":
        draw_learning_curve(arguments.run, arguments.out)
    else:
        draw_traffic(arguments.map, arguments.trace, arguments.out)
    print(f"wrote {arguments.out}")


if __name__ == "__main__":
    main()
