#!/usr/bin/python3
"""resume.py PACKSTONE [--points 100] [--seed 1] [--only NAME]: stops the samples, made small, at random moments.

Each point is a run that SIGTERM stops and that is gone on with by the other number of threads, one and two in turn; it
must end with the same bytes as a run never stopped. For people: it takes some minutes."""

import argparse
import os
import random
import shutil
import sys
import tempfile

import runs

SAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "samples")

# Keys that bring a run to seconds.
SMALL = {
    "01_density_segregation": ["particles[0].count=300", "particles[1].count=300", "dynamics.duration=0.3"],
    "02_binary_packing": ["particles[0].count=24", "particles[1].count=2500", "dynamics.duration=0.06",
                          "filling.duration=0.03", "gravity.start=0.03", "output.interval=0.02"],
    "03_equal_spheres": ["particles[0].count=500", "dynamics.duration=0.25"],
    "04_cohesive_powder": ["particles[0].count=300", "dynamics.duration=2 ms"],
    "05_funnel_discharge": ["particles[0].count=800", "stage[0].duration=0.05", "stage[1].duration=0.1"],
    "06_tapped_bed": ["particles[0].count=500", "stage[0].duration=0.1", "stage[1].duration=0.15"],
    "07_wavy_floor": ["particles[0].count=200", "dynamics.duration=0.05"],
    "08_polygon_bin": ["particles[0].count=800", "dynamics.duration=0.2"],
    "09_piston": ["particles[0].count=400", "stage[0].duration=0.03", "stage[1].duration=0.03"],
    "10_heap": ["particles[0].count=400", "dynamics.duration=0.25"],
    "11_silo": ["particles[0].count=200", "filling.portions=2", "dynamics.duration=0.8"],
    "12_overdamped": ["particles[0].count=300", "dynamics.duration=6", "output.interval=2"],
    "13_quick_rest": ["particles[0].count=500"],
    "14_aristotelian": ["particles[0].count=400"],
}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("packstone")
    parser.add_argument("--points", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", help="of the samples whose names hold this")
    arguments = parser.parse_args()
    program, chance = arguments.packstone, random.Random(arguments.seed)
    names = [name for name in SMALL if not arguments.only or arguments.only in name]
    stopped = 0
    with tempfile.TemporaryDirectory() as place:
        for number, name in enumerate(names):
            points = arguments.points // len(names) + (number < arguments.points % len(names))
            scene = [os.path.join(SAMPLES, name, "scene.toml")] + [f"--set={key}" for key in SMALL[name]]
            whole, folder = os.path.join(place, name), os.path.join(place, "stopped")

            def call(into, threads):
                return [program, "run", *scene, "-o", into, "--quiet", "--threads", str(threads)]

            seconds = runs.timed(call(whole, 1))
            done = tries = 0
            while done < points:
                tries += 1
                assert tries < 10 * points + 10, f"{name}: ends before it can be stopped"
                shutil.rmtree(folder, ignore_errors=True)
                if runs.run_for(call(folder, 1 + done % 2), chance.uniform(0, seconds), runs.TERMINATE) != 130:
                    continue  # it had ended, or had not begun to listen
                assert runs.info(program, folder)["status"] == "interrupted"
                runs.timed([program, "run", "--resume", "-o", folder, "--quiet", "--threads", str(2 - done % 2)])
                runs.check_same(program, whole, folder)
                done += 1
            stopped += done
            print(f"{name}: {done} points of {seconds:.1f} s, the same bytes", flush=True)
            shutil.rmtree(whole)
    print(f"{stopped} runs, stopped and gone on with: snapshots, history and last checkpoint byte for byte as those of "
          "runs never stopped")


if __name__ == "__main__":
    sys.exit(main())
