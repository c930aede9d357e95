"""Medians of the runs, as Markdown, CSV and JSON, and a check that all programs hold the same bed."""
from __future__ import annotations

import csv
import dataclasses
import json
import pathlib
import statistics

from cases import CASES
from programs import Job, Measured

TOLERANCE = 0.05  # share by which the programs may differ in what a case says must agree


@dataclasses.dataclass(frozen=True)
class Row:
    """The rounds of one program in one case; of the state, the median."""

    case: str
    program: str
    cores: int
    particles: int
    steps: int
    time_step: float  # [s]
    rate: float  # particle-steps a second
    rate_lowest: float
    rate_highest: float
    packstone_ratio: float | None  # packstone's rate over this one's
    memory: int  # highest of the rounds [byte]
    z: float
    kinetic: float  # [J]
    packing_fraction: float
    list_builds: int | None
    rounds: int
    settings: str


def rows_of(job: Job, runs: dict[str, list[Measured]], settings: dict[str, str]) -> list[Row]:
    """A row for each program of a case."""
    middle = {program: statistics.median(m.rate for m in rounds) for program, rounds in runs.items()}
    return [
        Row(
            case=job.case.name,
            program=program,
            cores=job.cores,
            particles=job.bed.particles,
            steps=job.steps,
            time_step=job.physics.time_step,
            rate=middle[program],
            rate_lowest=min(m.rate for m in rounds),
            rate_highest=max(m.rate for m in rounds),
            packstone_ratio=middle["packstone"] / middle[program] if "packstone" in middle else None,
            memory=max(m.memory for m in rounds),
            z=statistics.median(m.z for m in rounds),
            kinetic=statistics.median(m.kinetic for m in rounds),
            packing_fraction=statistics.median(m.packing_fraction for m in rounds),
            list_builds=rounds[-1].list_builds,
            rounds=len(rounds),
            settings=settings[program],
        )
        for program, rounds in runs.items()
    ]


COLUMNS = ("case", "program", "cores", "million particle-steps a second: median (range)", "packstone is", "memory, MB",
           "z", "kinetic energy, J", "packing fraction", "list builds")  # fmt: skip


def markdown(rows: list[Row]) -> str:
    lines = [f"| {' | '.join(COLUMNS)} |", "|---" * len(COLUMNS) + "|"]
    for r in rows:
        ratio = "" if r.packstone_ratio is None or r.program == "packstone" else f"{r.packstone_ratio:.2f} x"
        builds = "" if r.list_builds is None else r.list_builds
        lines.append(
            f"| {r.case} | {r.program} | {r.cores} "
            f"| {1e-6 * r.rate:.2f} ({1e-6 * r.rate_lowest:.2f}-{1e-6 * r.rate_highest:.2f}) | {ratio} "
            f"| {1e-6 * r.memory:.0f} | {r.z:.2f} | {r.kinetic:.3g} | {r.packing_fraction:.4f} | {builds} |"
        )
    return "\n".join(lines)


def disagreements(rows: list[Row]) -> list[str]:
    """A note for each case whose programs do not end in the same bed: a wrong bed looks faster."""
    notes = []
    for name, cores in dict.fromkeys((r.case, r.cores) for r in rows):
        quantity = CASES[name].same
        values = {r.program: getattr(r, quantity) for r in rows if (r.case, r.cores) == (name, cores)}
        if max(values.values()) - min(values.values()) > TOLERANCE * max(values.values()):
            found = ", ".join(f"{program} {value:.3g}" for program, value in values.items())
            notes.append(
                f"**NOT THE SAME BED in {name} on {cores} cores**: {quantity} differs by more than "
                f"{100 * TOLERANCE:.0f} %: {found}. The rates of this case do not compare."
            )
    return notes


def write(rows: list[Row], notes: list[str], machine: dict, folder: pathlib.Path) -> None:
    """results.md, results.json and results.csv."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "results.md").write_text("\n\n".join([markdown(rows), *notes]) + "\n")
    records = [dataclasses.asdict(r) for r in rows]
    (folder / "results.json").write_text(json.dumps({"machine": machine, "rows": records, "notes": notes}, indent=2))
    with open(folder / "results.csv", "w", newline="") as out:
        table = csv.DictWriter(out, [f.name for f in dataclasses.fields(Row)], lineterminator="\n")
        table.writeheader()
        table.writerows(records)
