"""What a run found: the table in Markdown, the JSON, and the plot of error against time in SVG."""
import html
import json
import math
import statistics


def quantile(values, share):
    return sorted(values)[min(len(values) - 1, int(share * len(values)))]


def pooled_px(peer, share):
    """The upper edge of the bin in which the quantile of all pixels of all poses lies (peer_measure.cpp)."""
    bins = {}
    for found in peer.found:
        for number, count in found["px"].items():
            bins[int(number)] = bins.get(int(number), 0) + count
    left = share * sum(bins.values())
    for number in sorted(bins):
        left -= bins[number]
        if left <= 0:
            return 2 ** ((number + 1) / 64 - 24)
    return 0.0


def figures_of(peer):
    """The numbers of a row."""
    if peer.fault or not peer.ms:
        return {"name": peer.name, "fault": peer.fault or "no poses asked for"}

    def total(key):
        return sum(found[key] for found in peer.found)
    return {"name": peer.name, "version": peer.version, "poses": len(peer.found), "surface": peer.surface,
            "build_ms": peer.build_ms, "ms_median": statistics.median(peer.ms), "ms_p95": quantile(peer.ms, 0.95),
            "triangles": statistics.median(peer.triangles) if peer.triangles else None,
            "p99_px": pooled_px(peer, 0.99), "max_px": max(found["max_px"] for found in peer.found),
            "max_m": max(found["max_m"] for found in peer.found), "bound": peer.bound, "pixels": total("pixels"),
            "beyond": total("beyond"), "beyond_poses": sum(found["beyond"] > 0 for found in peer.found),
            "compared": total("compared"), "wrong": total("wrong")}


def _row(row):
    if "fault" in row:
        return f"| {row['name']} | {row['fault']} |" + " |" * 8
    bound = {None: "none", "stated": "as each frame states"}.get(row["bound"]) or "{} {}".format(*row["bound"])
    broken = "" if row["bound"] is None else f": {row['beyond']} pixels, {row['beyond_poses']} poses"
    wrong = f"{1e6 * row['wrong'] / row['compared']:.0f}" if row["compared"] else "not compared"
    triangles = "" if row["triangles"] is None else f"{row['triangles']:,.0f}"
    return (f"| {row['name']} | {row['version']} | {row['poses']} | {row['ms_median']:.1f} | {row['ms_p95']:.1f} | {triangles} | "
            f"{row['p99_px']:.3g} | {row['max_px']:.3g} ({row['max_m']:.3g} m) | {bound}{broken} | {wrong} |")


def table_of(rows, facts):
    lines = [f"{facts['date']}, {facts['machine']}; {facts['system']}; load {facts['load']} at the start,",
             f"{facts['load_at_end']} at the end; {facts['size']}, {facts['poses']} poses, LP_NUM_THREADS={facts['threads']};",
             f"ground: {facts['ground']};", f"commit {facts['commit']}; `{facts['command']}`.", "",
             "| renderer | version | poses | ms, median | ms, 95 % | triangles | error px, 99 % | greatest | "
             "its own bound, broken in | wrong pixels of a million |", "|---|---|---|---|---|---|---|---|---|---|"]
    return "\n".join(lines + [_row(row) for row in rows]) + "\n"


def json_of(rows, peers, facts):
    poses = {peer.name: {"ms": peer.ms, "max_px": [found["max_px"] for found in peer.found],
                         "beyond": [found["beyond"] for found in peer.found]} for peer in peers if not peer.fault}
    return json.dumps({"facts": facts, "rows": rows, "by_pose": poses}, indent=1) + "\n"


# The plot: both axes logarithmic, whole decades.
WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 1000, 560, 70, 40, 350, 60
COLORS = ("#1b6ca8", "#1b9e77", "#66a61e", "#d95f02", "#e6ab02", "#7570b3", "#a6761d", "#e7298a", "#b2182b", "#666666", "#000000")


class Axis:
    def __init__(self, values, low, high):
        self.first, self.last = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))
        self.last, self.low, self.high = max(self.last, self.first + 1), low, high

    def at(self, value):
        share = (math.log10(value) - self.first) / (self.last - self.first)
        return self.low + share * (self.high - self.low)

    def decades(self):
        return [10.0 ** n for n in range(self.first, self.last + 1)]


def _text(x, y, text, anchor="start", more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{more}>{html.escape(text)}</text>'


def _axes(across, down):
    parts = []
    for value in across.decades():
        x = across.at(value)
        parts += [f'<path d="M{x:.1f} {TOP}V{HEIGHT - BOTTOM}" stroke="#ddd"/>',
                  _text(x, HEIGHT - BOTTOM + 18, f"{value:g}", "middle")]
    for value in down.decades():
        y = down.at(value)
        parts += [f'<path d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}" stroke="#ddd"/>', _text(LEFT - 8, y + 4, f"{value:g}", "end")]
    middle = (TOP + HEIGHT - BOTTOM) / 2
    return parts + [_text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 16, "time of a picture, ms (median)", "middle"),
                    _text(18, middle, "error, px", "middle", f' transform="rotate(-90 18 {middle:.1f})"'),
                    _text(LEFT, 22, "error against time: from the 99th percentile of the pixels (filled) to the greatest (open)")]


def plot_of(rows):
    drawn = [row for row in rows if "fault" not in row]
    if not drawn:
        return ""
    errors = [max(row[key], 1e-5) for row in drawn for key in ("p99_px", "max_px")]
    across = Axis([row["ms_median"] for row in drawn], LEFT, WIDTH - RIGHT)
    down = Axis(errors, HEIGHT - BOTTOM, TOP)
    parts = _axes(across, down)
    for number, row in enumerate(drawn):
        color, x = COLORS[number % len(COLORS)], across.at(row["ms_median"])
        low, high = (down.at(max(row[key], 1e-5)) for key in ("p99_px", "max_px"))
        y = TOP + 20 + 22 * number
        parts += [f'<path d="M{x:.1f} {low:.1f}V{high:.1f}" stroke="{color}" stroke-width="2"/>',
                  f'<circle cx="{x:.1f}" cy="{low:.1f}" r="5" fill="{color}"/>',
                  f'<circle cx="{x:.1f}" cy="{high:.1f}" r="5" fill="white" stroke="{color}" stroke-width="2"/>',
                  _text(x + 8, low + 4, str(number + 1)),
                  f'<circle cx="{WIDTH - RIGHT + 16}" cy="{y - 4}" r="5" fill="{color}"/>',
                  _text(WIDTH - RIGHT + 26, y, f"{number + 1} {row['name']}")]
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" '
            'font-family="sans-serif" font-size="11">\n'
            f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>\n' + "\n".join(parts) + "\n</svg>\n")
