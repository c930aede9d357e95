"""Runs a command and writes its peak resident memory [kB] beside its exit code: launch.py FILE COMMAND...

Stands between mpirun and each process, so that the peak of each is known; FILE gets the rank as its ending.
A process of its own because the peak that the system reports starts from the memory of whoever started it.
"""
import os
import sys


def main() -> int:
    file, command = sys.argv[1], sys.argv[2:]
    pid = os.posix_spawnp(command[0], command, os.environ)
    _, status, usage = os.wait4(pid, 0)
    rank = os.environ.get("OMPI_COMM_WORLD_RANK", "0")
    with open(f"{file}.{rank}", "w") as out:
        print(usage.ru_maxrss, file=out)
    return os.waitstatus_to_exitcode(status)


if __name__ == "__main__":
    sys.exit(main())
