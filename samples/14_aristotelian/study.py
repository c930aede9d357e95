#!/usr/bin/python3
"""The second paper's study (docs/sample_14.md): study.py PACKSTONE FOLDER [--shallow | --reduced] [--only=MIXTURE,...] [--check]

Spheres of three mixtures sink without inertia, and fall with it, from the same places in a cylinder; fractions, volume
under the free surface both ways, coordination numbers. --shallow: 20,000 spheres instead of 80,000. --reduced: 2000 in a
cylinder of fifteen radii, equal and 2. Both with contacts a tenth as stiff and a coarser balance. --only: of equal,
uniform_1.5, uniform_2. With --check the exit code says whether the figures are the paper's, within what a bed so small
allows.
"""
import json
import math
import pathlib
import subprocess
import sys

here = pathlib.Path(__file__).parent
LARGEST = 0.01  # radius in every mixture [m]
RATIOS = {"equal": 1.0, "uniform_1.5": 1.5, "uniform_2": 2.0}  # largest over smallest radius
FRACTION = 0.3  # to begin with
# Overlap that the softened way may have, of a column of the smallest, over the radius.
DEEP_WAY = {"equal": 0.03, "uniform_1.5": 0.04, "uniform_2": 0.05}
SHALLOW_WAY = {"equal": 0.02, "uniform_1.5": 0.03, "uniform_2": 0.03}
QUICKER = ["material[0].normal_stiffness=1e6", "dynamics.unbalanced_force=0.05"]
MOTIONS = {"aristotelian": "scene.toml", "newtonian": "newtonian.toml"}


def mean_volume(ratio):
    """Of a sphere whose radius is uniform between LARGEST/ratio and LARGEST [m3]."""
    a, b = LARGEST / ratio, LARGEST
    cube = b**3 if a == b else (b**4 - a**4) / (4 * (b - a))
    return 4 / 3 * math.pi * cube


def overrides(mixture, motion, count, cylinder):
    ratio = RATIOS[mixture]
    height = count * mean_volume(ratio) / (FRACTION * math.pi * cylinder**2) + 2 * LARGEST
    side = cylinder + LARGEST
    values = [f"particles[0].count={count}", f"domain.min=[{-side},{-side},0]", f"domain.max=[{side},{side},{height}]",
              f"boundary[1].radius={cylinder}", f"boundary[1].length={height}",
              f'title="{motion.capitalize()} bed, {mixture.replace("_", " ")}"']
    if ratio > 1:
        values.append(f'particles[0].radius={{distribution="uniform",min={LARGEST / ratio},max={LARGEST}}}')
    if motion == "aristotelian":
        values.append(f"dynamics.way_overlap={(DEEP_WAY if deep else SHALLOW_WAY)[mixture]}")
    if not deep:
        values += QUICKER
    return [word for value in values for word in ("--set", value)]


def measured(packstone, folder, mixture, motion, count, cylinder):
    run = folder / f"{motion}_{mixture}"
    subprocess.run([packstone, "run", here / MOTIONS[motion], "-o", run, "--overwrite", "--quiet",
                    *(["--threads", "1"] if reduced else []), *overrides(mixture, motion, count, cylinder)], check=True)
    subprocess.run([packstone, "analyze", run, "--only", "packing,surface,structure",
                    "--pore-points", "100", "--json", run / "measures.json",
                    "--quiet"], check=True, stdout=subprocess.DEVNULL)
    return json.loads((run / "measures.json").read_text())


def distribution(measures):
    """Share of particles by contacts, those with the boundaries included, as the paper counts."""
    table = measures["structure"]["coordination_distribution"]
    shares = table["columns"].index("share_with_walls")
    return {row[0]: row[shares] for row in table["rows"]}


def tell(results):
    print(f"{'':26}{'bulk':>8}{'inside':>8}{'surface':>9}{'A h/V':>8}{'contacts':>10}{'rattlers':>10}")
    for name, m in results.items():
        packing, surface, structure = m["packing"], m["surface"], m["structure"]
        print(f"{name:26}{packing['bulk_fraction']['value']:8.4f}{packing['interior_fraction']['value']:8.4f}"
              f"{surface['surface_fraction']['value']:9.4f}"
              f"{surface['base_height_volume']['value'] / surface['surface_volume']['value']:8.4f}"
              f"{structure['coordination_with_walls']['value']:10.3f}{structure['rattler_fraction']['value']:10.3f}")
    most = max(max(distribution(m)) for m in results.values())
    print("\nshare of spheres by contacts, boundaries included")
    print(f"{'':26}" + "".join(f"{z:7}" for z in range(most + 1)))
    for name, m in results.items():
        shares = distribution(m)
        print(f"{name:26}" + "".join(f"{shares.get(z, 0):7.4f}" for z in range(most + 1)))


def wrong(results):
    """What is not as the paper has it, in words; the inside of a narrow cylinder stands for its bulk."""
    for name, m in results.items():
        fraction = m["packing"]["interior_fraction"]["value"]
        low, high = (0.61, 0.66) if "equal" in name else (0.62, 0.71)
        if not low < fraction < high:
            yield f"{name}: fraction {fraction:.4f} is not between {low} and {high}"
        volumes = m["surface"]["base_height_volume"]["value"] / m["surface"]["surface_volume"]["value"]
        if abs(volumes - 1) > 0.05:
            yield f"{name}: base times height is {volumes:.3f} of the volume under the surface"
        shares = distribution(m)
        if max(shares, key=shares.get) not in (4, 5, 6, 7):
            yield f"{name}: most spheres have {max(shares, key=shares.get)} contacts"
    for mixture in RATIOS:
        pair = [results[f"{motion} {mixture}"] for motion in MOTIONS if f"{motion} {mixture}" in results]
        if len(pair) < 2:
            continue
        fractions = [m["packing"]["interior_fraction"]["value"] for m in pair]
        contacts = [m["structure"]["coordination_mean"]["value"] for m in pair]
        if abs(fractions[0] - fractions[1]) > 0.02 or abs(contacts[0] - contacts[1]) > 0.4:
            yield f"{mixture}: Aristotelian {fractions[0]:.4f}, {contacts[0]:.2f} beside {fractions[1]:.4f}, {contacts[1]:.2f}"


packstone, folder = sys.argv[1], pathlib.Path(sys.argv[2])
reduced, shallow = "--reduced" in sys.argv, "--shallow" in sys.argv
deep = not (reduced or shallow)
count, cylinder = (2000, 0.15) if reduced else (20000, 0.5) if shallow else (80000, 0.5)
mixtures = ["equal", "uniform_2"] if reduced else list(RATIOS)
for word in sys.argv:
    if word.startswith("--only="):
        mixtures = word.removeprefix("--only=").split(",")
results = {f"{motion} {mixture}": measured(packstone, folder, mixture, motion, count, cylinder)
           for mixture in mixtures for motion in MOTIONS}
tell(results)
if "--check" in sys.argv:
    found = list(wrong(results))
    if found:
        sys.exit("\n".join(found))
