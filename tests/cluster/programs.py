"""The programs evc and evc-mpi of a build, for the tests of the cluster. The environment names them: EVC, EVC_MPI."""
import contextlib
import os
import pathlib
import sqlite3
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
BUILD = ROOT / "build/cluster"
EVC = os.environ.get("EVC", str(BUILD / "evc"))
EVC_MPI = os.environ.get("EVC_MPI", str(BUILD / "evc-mpi"))
os.environ.setdefault("OPENEVC_DATA", str(ROOT / "data"))
# Open MPI does not like root, who runs tests in a container.
os.environ.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")

# Queries of curves; some brake percentages are below the tables: these cases fail.
CURVES = """{"schema":"evc-sweep/1","kind":"curves","base":{"query":"passenger_eoa"},"sample":"random","cases":%d,
 "vary":[{"at":"/train/brake_percentage","uniform":[20,200]},{"at":"/track/gradient/1/1","normal":[-5,8]},
         {"at":"/query/speeds_kmh","list":[[80,120],[100]]}],
 "measure":["by_speed.0.EBI","by_speed.P","scalars.T_be_s","notes"]}"""


def run(*command, **options):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=300, **options)


def mpirun(ranks):
    """The words before the program."""
    return ["mpirun", "--quiet", "--allow-run-as-root", "--oversubscribe", "-n", str(ranks)]


def table_hash(results):
    said = run(EVC, "sweep", "hash", results)
    assert said.returncode == 0, said.stderr
    return said.stdout.strip()


def rows(results):
    with contextlib.closing(sqlite3.connect(results)) as database:
        return database.execute("SELECT count(*) FROM cases").fetchone()[0]


def has_committed_rows(results):
    """Whether the sweep that writes this file has committed rows since it began. It keeps the file locked; but in the log
    beside it the last page of each commit is marked (https://www.sqlite.org/fileformat2.html, 4.1). Making the tables
    takes a few pages."""
    try:
        log = pathlib.Path(f"{results}-wal").read_bytes()
    except OSError:
        return False
    if len(log) < 32:
        return False
    frame, salts = 24 + int.from_bytes(log[8:12], "big"), log[16:24]
    frames = [log[at:at + 24] for at in range(32, len(log) - frame + 1, frame)]
    commits = [n for n, head in enumerate(frames) if head[8:16] == salts and head[4:8] != bytes(4)]
    return bool(commits) and commits[-1] > 20


class InFolder(unittest.TestCase):
    """A test in a scratch folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="openevc_cluster_")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")
        return self.folder / name

    def by_threads(self, spec):
        """The hash of the table that threads compute."""
        results = self.folder / "threads.sqlite"
        done = run(EVC, "sweep", spec, "-j", 2, "-o", results)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        return table_hash(results)


def main():
    """As unittest.main; exit status 77, for ctest, if everything was skipped."""
    program = unittest.main(module="__main__", exit=False, verbosity=2)
    result = program.result
    if result.wasSuccessful() and result.skipped and len(result.skipped) >= result.testsRun:
        sys.exit(77)
    sys.exit(0 if result.wasSuccessful() else 1)
