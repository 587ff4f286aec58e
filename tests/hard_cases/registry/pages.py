"""The page, the JSON and the table of the hard cases."""
import html
import json

HEAD = "<!-- cases: written by registry/run -->\n"
FOOT = "<!-- end of cases -->"
STYLE = """body{font:15px/1.45 sans-serif;max-width:62em;margin:2em auto;padding:0 1em;color:#222}
h2{margin:1.6em 0 .2em;font-size:1.1em}dl{display:grid;grid-template-columns:9em 1fr;gap:.15em 1em;margin:.3em 0}
dt{color:#666}dd{margin:0}.holds{color:#146c2e}.fails{color:#b00020;font-weight:bold}.lacks{color:#8a5a00}
table{border-collapse:collapse}td,th{border:1px solid #ccc;padding:.2em .6em;text-align:left}"""


def measured(verdict):
    threshold = verdict.case.threshold
    text = f"{verdict.worst} (threshold: {threshold})" if verdict.worst else f"not recorded (threshold: {threshold})"
    return text


def write(folder, verdicts, facts):
    rows = [dict(vars(verdict.case), state=verdict.state, reasons=verdict.reasons, worst=verdict.worst,
                 control_value=verdict.control) for verdict in verdicts]
    (folder / "hard_cases.json").write_text(json.dumps({**facts, "cases": rows}, indent=1) + "\n", encoding="utf-8")
    (folder / "index.html").write_text(page_of(verdicts, facts), encoding="utf-8")


def entry_of(verdict):
    case = verdict.case
    control = case.control + (f" It gives {verdict.control}." if verdict.control else "")
    parts = [("goes wrong", case.wrong), ("what we do", case.technique), ("measured", measured(verdict)),
             ("oracles", f"{case.first_oracle}; {case.second_oracle}"), ("control", control or "none"),
             ("runs on", case.where), ("tests", "; ".join(name for _, name in case.all_tests()) or "none")]
    if verdict.reasons:
        parts.append((verdict.state, "; ".join(verdict.reasons)))
    described = "".join(f"<dt>{html.escape(name)}</dt><dd>{html.escape(text)}</dd>" for name, text in parts)
    state = f'<span class="{verdict.state.split()[0]}">{verdict.state}</span>'
    return f'<h2 id="{case.id}">{case.id} {html.escape(case.title)} {state}</h2><dl>{described}</dl>'


def page_of(verdicts, facts):
    words = {"holds": "hold", "lacks a part": "lack a part", "fails": "fail"}
    counted = {state: sum(verdict.state == state for verdict in verdicts) for state in words}
    summary = ", ".join(f"{count} {words[state]}" for state, count in counted.items() if count)
    entries = "\n".join(entry_of(verdict) for verdict in verdicts)
    run = f"Run of {facts['date']}, commit {html.escape(facts['commit'])}, {facts['machine']}."
    return (f'<!doctype html><html lang="en"><meta charset="utf-8"><title>Hard cases</title><style>{STYLE}</style>\n'
            f"<h1>Hard cases of the display's numerics</h1>\n<p>{len(verdicts)} cases: {summary}. {run}</p>\n"
            "<p>Each case states what goes wrong without its technique, what the display does, the worst value that its tests "
            "measured, what they compare with, and the naive form that must fail.</p>\n"
            f"{entries}\n</html>\n")


def cell(text):
    return text.replace("|", "\\|").replace("\n", " ")


def table_of(verdicts, facts):
    lines = [f"Run of {facts['date']}, {facts['machine']}.", "",
             "| case | technique | worst measured (threshold) | oracles | control | where | state |",
             "|---|---|---|---|---|---|---|"]
    for verdict in verdicts:
        case = verdict.case
        control = (case.control.rstrip(".") or "none") + (f": {verdict.control}" if verdict.control else "")
        said = [reason for reason in verdict.reasons if reason != case.lacks]
        state = verdict.state + (f": {'; '.join(said)}" if said else "")
        cells = (f"{case.id} {case.title}", case.technique, measured(verdict), f"{case.first_oracle}; {case.second_oracle}", control,
                 case.where, state)
        lines.append("| " + " | ".join(cell(text) for text in cells) + " |")
    return "\n".join(lines) + "\n"


def write_table(path, verdicts, facts):
    page = path.read_text(encoding="utf-8")
    begin, end = page.index(HEAD) + len(HEAD), page.index(FOOT)
    path.write_text(page[:begin] + table_of(verdicts, facts) + page[end:], encoding="utf-8")
