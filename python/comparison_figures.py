"""Pictures of a comparison, from results.csv and episodes.csv of `ronda compare --out`.

AGI and WI against the number of robots with their bounds, a heat map of ratios, and box plots over
episodes, each as SVG and PNG beside the tables. Under the thesis protocol the final idleness takes
the place of AGI.
"""

import collections
import csv
import math
import pathlib
import re

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend must be chosen first)

plt.rcParams["svg.hashsalt"] = "ronda"  # equal results give equal files

COLOURS = ["#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#17a2b8", "#8c564b", "#e377c2",
           "#7f7f00", "#003f5c", "#00a676", "#a00040", "#5c5cff"]
MARKERS = ["o", "s", "^", "D", "v", "P", "X", "<", ">", "p", "h", "*", "d", "8", "H"]
TITLES = {"agi_s": "average graph idleness (s)", "wi_s": "worst idleness (s)",
          "final_s": "final idleness (s)"}
SHORT = {"agi": "AGI", "final": "final idleness"}
LOG_FROM = 6.0  # greatest over least, from which an axis is logarithmic
MOST_ANNOTATED = 80  # columns of a heat map


class Panel:
    """The cells of one map under one condition."""

    def __init__(self, map_name, condition):
        name = pathlib.Path(map_name).stem
        self.slug = re.sub(r"[^A-Za-z0-9.]+", "-", f"{map_name} {condition}".strip())
        self.title = f"{name}, {condition}" if condition else name
        self.map_title, self.condition = name, condition
        self.cells = {}  # (contestant, agents) → row of results.csv

    def agents(self):
        return sorted({agents for _, agents in self.cells})

    def values(self, contestant, column):
        """(agents, value) where there is one."""
        rows = ((agents, self.cells[contestant, agents][column]) for agents in self.agents())
        return [(agents, float(text)) for agents, text in rows if text]


class Style:
    """Each contestant's colour and marker, the same in all pictures; policies are drawn wide."""

    def __init__(self, rows):
        self.kinds = {}
        for row in rows:
            self.kinds.setdefault(row["contestant"], row["kind"])
        self.contestants = list(self.kinds)

    def of(self, contestant):
        i = self.contestants.index(contestant)
        return {"color": COLOURS[i % len(COLOURS)], "marker": MARKERS[i % len(MARKERS)],
                "linewidth": 2.2 if self.kinds[contestant] == "policy" else 1.2}


def read_panels(rows):
    """(map, condition) → Panel; the maps of one condition stand together."""
    panels = {}
    for row in rows:
        key = row["map"], row["conditions"]
        panel = panels.setdefault(key, Panel(*key))
        panel.cells[row["contestant"], int(row["agents"])] = row
    conditions = list(dict.fromkeys(condition for _, condition in panels))
    return dict(sorted(panels.items(), key=lambda item: conditions.index(item[0][1])))


def read_episodes(file, metric):
    """(map, condition) → (contestant, agents) → values, one an episode."""
    values = collections.defaultdict(lambda: collections.defaultdict(list))
    with open(file, encoding="utf-8", newline="") as lines:
        for row in csv.DictReader(lines):
            cell = row["contestant"], int(row["agents"])
            values[row["map"], row["conditions"]][cell].append(float(row[f"{metric}_s"]))
    return values


def grid(count, most_columns, size):
    """A figure of `count` axes, `size` inches each."""
    columns = min(count, most_columns)
    rows = math.ceil(count / columns)
    figure, axes = plt.subplots(rows, columns, squeeze=False,
                                figsize=(size[0] * columns, size[1] * rows))
    for unused in axes.flat[count:]:
        unused.set_visible(False)
    return figure, list(axes.flat[:count])


def set_log(axis, values):
    """A logarithmic scale with plain numbers at the ticks, where the values span enough."""
    positive = [value for value in values if value > 0.0]
    if not positive or max(positive) < LOG_FROM * min(positive):
        return
    set_scale = axis.axes.set_yscale if axis.axis_name == "y" else axis.axes.set_xscale
    set_scale("log")
    wide = max(positive) > 30.0 * min(positive)
    axis.set_major_locator(matplotlib.ticker.LogLocator(subs=(1.0,) if wide else (1.0, 2.0, 5.0)))
    axis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g"))
    axis.set_minor_formatter(matplotlib.ticker.NullFormatter())


def save(figure, folder, name):
    for ending, metadata in (("svg", {"Date": None}), ("png", None)):
        figure.savefig(folder / f"{name}.{ending}", dpi=150, bbox_inches="tight", metadata=metadata)
    plt.close(figure)
    return name


def draw_contestants(axes, panel, style, column):
    """Each contestant's line with its interval; the handles, and all values that are drawn."""
    handles, seen = {}, []
    ci95 = re.sub("_s$", "_ci95_s", column)
    for contestant in style.contestants:
        agents, means = zip(*panel.values(contestant, column))
        seen += means
        handles[contestant], = axes.plot(agents, means, markersize=5, markeredgewidth=0.0,
                                         **style.of(contestant))
        half_widths = [half for _, half in panel.values(contestant, ci95)]
        if half_widths:
            low = [max(mean - half, 0.5 * mean) for mean, half in zip(means, half_widths)]
            high = [mean + half for mean, half in zip(means, half_widths)]
            axes.fill_between(agents, low, high, alpha=0.12, linewidth=0.0,
                              color=style.of(contestant)["color"])
    return handles, seen


def draw_bound(axes, panel, style, column):
    """As draw_contestants; nothing where the column has no bound."""
    bound_column = "lower_bound_" + column
    if bound_column not in next(iter(panel.cells.values())):
        return {}, []
    agents, bounds = zip(*panel.values(style.contestants[0], bound_column))
    line, = axes.plot(agents, bounds, color="black", linestyle="--", linewidth=1.2,
                      marker="_" if len(agents) == 1 else None)
    return {"lower bound": line}, list(bounds)


def draw_lines(panels, style, column, folder):
    """One panel a map and condition: a column of results.csv against the number of robots."""
    maps = len({panel.map_title for panel in panels.values()})
    figure, all_axes = grid(len(panels), min(maps, 4) if maps > 1 else 4, (4.4, 3.8))
    for panel, axes in zip(panels.values(), all_axes):
        handles, seen = draw_contestants(axes, panel, style, column)
        bound_handles, bounds = draw_bound(axes, panel, style, column)
        handles.update(bound_handles)
        set_log(axes.yaxis, seen + bounds)
        axes.set_xticks(panel.agents() if len(panel.agents()) <= 12 else panel.agents()[::2])
        axes.set_title(panel.title, fontsize=10)
        axes.set_xlabel("number of robots")
        axes.set_ylabel(TITLES[column])
        axes.grid(alpha=0.25, which="both", linewidth=0.5)
        axes.label_outer()
        axes.tick_params(labelleft=True, labelbottom=True)
    figure.tight_layout()
    figure.legend(handles.values(), handles.keys(), loc="center left", bbox_to_anchor=(1.0, 0.5),
                  frameon=False, fontsize=9)
    return save(figure, folder, re.sub("_s$", "", column))


def draw_heat_map(panels, style, metric, folder):
    """Ratios to the best classical strategy, or to the bound; one row of maps a condition."""
    to_best = all(row["to_best_classical"] for panel in panels.values()
                  for row in panel.cells.values())
    column = "to_best_classical" if to_best else "agi_to_lower_bound"
    by_condition = collections.defaultdict(list)
    for panel in panels.values():
        by_condition[panel.condition].append(panel)
    most = max(sum(len(panel.agents()) for panel in some) for some in by_condition.values())
    height = 0.3 * len(style.contestants) + 1.0
    figure, all_axes = plt.subplots(len(by_condition), 1, squeeze=False,
                                    figsize=(max(5.0, 0.46 * most + 2.5),
                                             height * len(by_condition)),
                                    constrained_layout=True)
    norm = matplotlib.colors.LogNorm(0.5, 2.0) if to_best else matplotlib.colors.LogNorm(1.0, 4.0)
    for (condition, some), axes in zip(by_condition.items(), all_axes.flat):
        places = [(panel, agents) for panel in some for agents in panel.agents()]
        ratios = [[float(panel.cells[contestant, agents][column]) for panel, agents in places]
                  for contestant in style.contestants]
        image = axes.imshow(ratios, cmap="RdYlGn_r" if to_best else "YlOrRd", norm=norm,
                            aspect="auto")
        if len(places) <= MOST_ANNOTATED:
            for y, row in enumerate(ratios):
                for x, ratio in enumerate(row):
                    dark = abs(norm(ratio) - 0.5) > 0.4 if to_best else norm(ratio) > 0.7
                    axes.text(x, y, f"{ratio:.2f}" if ratio < 9.95 else f"{ratio:.0f}",
                              ha="center", va="center", fontsize=7,
                              color="white" if dark else "black")
        axes.set_xticks(range(len(places)), [agents for _, agents in places], fontsize=8)
        axes.set_yticks(range(len(style.contestants)), style.contestants, fontsize=8)
        begin = 0
        for panel in some:
            end = begin + len(panel.agents())
            axes.text((begin + end - 1) / 2, -0.75, panel.map_title, ha="center", va="bottom",
                      fontsize=9)
            if begin > 0:
                axes.axvline(begin - 0.5, color="white", linewidth=4)
            begin = end
        if len(by_condition) > 1:
            axes.set_ylabel(condition or "default conditions")
        axes.set_xlabel("number of robots", fontsize=9)
        axes.tick_params(length=0)
        for spine in axes.spines.values():
            spine.set_visible(False)
    label = f"{SHORT[metric]} to best classical" if to_best else "AGI to lower bound"
    bar = figure.colorbar(image, ax=all_axes, extend="both", fraction=0.03, pad=0.02, label=label)
    ticks = [0.5, 0.7, 1.0, 1.4, 2.0] if to_best else [1.0, 1.5, 2.0, 3.0, 4.0]
    bar.set_ticks(ticks, labels=[f"{tick:g}" for tick in ticks])
    bar.ax.minorticks_off()
    return save(figure, folder, f"{metric}_ratios")


def draw_boxes(panel, episodes, style, metric, folder):
    """One set of axes a team size: a box for each contestant's episodes, the bound dashed."""
    figure, all_axes = grid(len(panel.agents()), 3, (4.6, 0.24 * len(style.contestants) + 1.3))
    for agents, axes in zip(panel.agents(), all_axes):
        values = [episodes[contestant, agents] for contestant in style.contestants]
        boxes = axes.boxplot(values, vert=False, patch_artist=True, widths=0.6,
                             flierprops={"markersize": 3},
                             medianprops={"color": "black"})
        for box, contestant in zip(boxes["boxes"], style.contestants):
            box.set_facecolor(style.of(contestant)["color"])
            box.set_alpha(0.6)
        axes.set_yticks(range(1, len(values) + 1), style.contestants, fontsize=8)
        axes.invert_yaxis()
        bound = panel.cells[style.contestants[0], agents].get(f"lower_bound_{metric}_s")
        if bound:
            axes.axvline(float(bound), color="black", linestyle="--", linewidth=1.2,
                         label="lower bound")
            axes.legend(loc="lower right", fontsize=8)
        set_log(axes.xaxis, [value for some in values for value in some])
        axes.set_title(f"{agents} robot{'' if agents == 1 else 's'}", fontsize=10)
        axes.grid(alpha=0.25, axis="x", which="both", linewidth=0.5)
        axes.set_xlabel(TITLES[f"{metric}_s"], fontsize=9)
    figure.suptitle(panel.title)
    figure.tight_layout()
    return save(figure, folder, f"{metric}_episodes_{panel.slug}")


def draw_comparison(folder: pathlib.Path) -> list:
    """The names of the pictures, without their endings."""
    with open(folder / "results.csv", encoding="utf-8", newline="") as lines:
        rows = list(csv.DictReader(lines))
    panels, style = read_panels(rows), Style(rows)
    headline = "final" if rows[0]["protocol"] == "thesis" else "agi"
    episodes = read_episodes(folder / "episodes.csv", headline)
    names = [draw_lines(panels, style, column, folder) for column in (f"{headline}_s", "wi_s")]
    names.append(draw_heat_map(panels, style, headline, folder))
    for key, panel in panels.items():
        names.append(draw_boxes(panel, episodes[key], style, headline, folder))
    return names
