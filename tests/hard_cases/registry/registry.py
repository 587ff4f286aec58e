"""The hard cases of cases.toml, and what a run says of each."""
import dataclasses
import pathlib
import tomllib

FILE = pathlib.Path(__file__).with_name("cases.toml")
TEXTS = ("id", "title", "wrong", "technique", "threshold", "first_oracle", "second_oracle", "where")


class RegistryError(Exception):
    """A sentence."""


@dataclasses.dataclass
class Case:
    id: str = ""
    title: str = ""
    wrong: str = ""  # what goes wrong without the technique
    technique: str = ""
    threshold: str = ""
    first_oracle: str = ""
    second_oracle: str = ""  # or "none: " and the reason
    where: str = ""
    control: str = ""  # the naive form; empty: missing
    control_test: str = ""  # "program: Suite.Test"
    tests: list = dataclasses.field(default_factory=list)  # of the same form
    lacks: str = ""  # what is still missing, beside what a run finds

    def all_tests(self):
        named = self.tests + [test for test in [self.control_test] if test and test not in self.tests]
        return [tuple(part.strip() for part in name.split(":", 1)) for name in named]


@dataclasses.dataclass
class Verdict:
    case: Case
    state: str  # "holds", "fails" or "lacks a part"
    reasons: list
    worst: str = ""
    control: str = ""


def read(chosen):
    try:
        tables = tomllib.loads(FILE.read_text(encoding="utf-8"))["case"]
    except (OSError, tomllib.TOMLDecodeError, KeyError) as error:
        raise RegistryError(f"{FILE}: cannot be read: {error}") from error
    known = {field.name for field in dataclasses.fields(Case)}
    cases = []
    for table in tables:
        unknown = sorted(set(table) - known)
        if unknown:
            raise RegistryError(f"{FILE}: {table.get('id', 'a case')} has unknown keys: {', '.join(unknown)}")
        cases.append(Case(**table))
    missing = sorted(set(chosen) - {case.id for case in cases})
    if missing:
        raise RegistryError(f"--case {missing[0]} is unknown; the cases are {cases[0].id} to {cases[-1].id}")
    return [case for case in cases if not chosen or case.id in chosen]


def worse(one, other):
    """Of two values that tests recorded, in the same unit, the greater one; what is no number is the worst."""
    if one is None or other is None:
        return other if one is None else one
    return max(one, other, key=lambda text: float("inf") if text in ("nan", "-nan") else float(text))


def verdict_of(case, results):
    failed, absent = [], []
    properties = {}
    for program, name in case.all_tests():
        test = results.get((program, name))
        if test is None or test.get("result") != "COMPLETED":
            absent.append(f"{program}: {name} did not run")
        elif test.get("failures"):
            failed.append(f"{name} failed")
        for key, value in (test or {}).items():
            if key.startswith(case.id + "_"):
                properties[key] = worse(properties.get(key), value)
    worst, control = properties.get(f"{case.id}_worst", ""), properties.get(f"{case.id}_control", "")
    lacking = [f"no {part.replace('_', ' ')}" for part in TEXTS if not getattr(case, part)]
    lacking += [] if case.tests else ["no test"]
    lacking += [] if case.control and case.control_test else ["no negative control"]
    lacking += [] if worst or not case.tests else ["no measured value"]
    lacking += [] if control or not case.control_test else ["no measured value of the control"]
    lacking += [case.lacks] if case.lacks else []
    if failed or absent:
        return Verdict(case, "fails", failed + absent, worst, control)
    return Verdict(case, "lacks a part" if lacking else "holds", lacking, worst, control)
