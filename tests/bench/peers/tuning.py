"""Finds the settings in which a program is fastest, one kind after another, by short runs."""
from __future__ import annotations

import dataclasses
import typing

from cases import CANDIDATES, Tuning
from programs import Failed, Job, run


TRIES = 2  # of each value, the faster counts: noise only slows


def tuned(program: str, job: Job, start: Tuning) -> Tuning:
    """The best of the program's candidates for this job; each kind is chosen with the earlier ones at their best."""
    best = start
    for kind, values in CANDIDATES[program].items():
        if not applies(kind, job):
            continue
        rates = dict.fromkeys(values, 0.0)
        for value in TRIES * values:
            try:
                rates[value] = max(rates[value], run(program, job, dataclasses.replace(best, **{kind: value})).rate)
            except Failed:
                pass  # stays at 0 and is not chosen
        best = dataclasses.replace(best, **{kind: max(rates, key=rates.__getitem__)})
        listing = ", ".join(f"{value}: {1e-6 * rate:.2f}" for value, rate in rates.items())
        print(f"  {kind}: {listing} million particle-steps a second", flush=True)
    print(f'    ("{job.case.name}", "{program}"): {source(best)},', flush=True)
    return best


def applies(kind: str, job: Job) -> bool:
    """Whether a kind of setting makes a difference in a job."""
    if kind in ("grid", "newton", "bind"):
        return job.cores > 1
    if kind == "bins":
        return len(job.bed.radii) > 1
    if kind == "tangential":
        return job.physics.friction == 0
    return True


def source(tuning: Tuning) -> str:
    """The tuning as it stands in the table, defaults left out."""
    given: list[str] = []
    for field in dataclasses.fields(tuning):
        value: typing.Any = getattr(tuning, field.name)
        if field.default is dataclasses.MISSING or value != field.default:
            given.append(f"{field.name}={value!r}")
    return f"Tuning({', '.join(given)})"
