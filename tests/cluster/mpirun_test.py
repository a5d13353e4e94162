#!/usr/bin/env -S python3 -B
"""evc-mpi under mpirun on one machine. Usage: EVC=... EVC_MPI=... tests/cluster/mpirun_test.py [TEST...]"""
import os
import pathlib
import shutil
import signal
import subprocess
import time

import programs
from programs import CURVES, EVC, EVC_MPI, has_committed_rows, mpirun, rows, run, table_hash

SMALL = programs.ROOT / "examples/cluster/small.json"
# What was committed is kept twice a second: each disturbance needs half a second of work that is still to be done.
MANY = 800_000


def rank_of(process):
    """The rank of a process of evc-mpi, None for another one."""
    try:
        words = pathlib.Path(f"/proc/{process}/environ").read_bytes().split(b"\0")
        name = pathlib.Path(f"/proc/{process}/comm").read_text().strip()
    except OSError:
        return None
    ranks = [int(w.split(b"=")[1]) for w in words if w.startswith(b"OMPI_COMM_WORLD_RANK=")]
    return ranks[0] if ranks and name == "evc-mpi" else None


def processes_of(launcher):
    """{rank: process} of the children of this mpirun."""
    children = run("ps", "-o", "pid=", "--ppid", launcher.pid).stdout.split()
    found = {rank_of(int(child)): int(child) for child in children}
    found.pop(None, None)
    return found


class Ranks(programs.InFolder):
    hash_of_many = None

    def begin(self, ranks, spec, results, *more):
        """Ranks that compute; returns when rows are committed."""
        job = subprocess.Popen([*mpirun(ranks), EVC_MPI, "sweep", str(spec), "-o", str(results), *more],
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.addCleanup(self.end, job)
        limit = time.monotonic() + 60
        while not has_committed_rows(results):
            if job.poll() is not None:
                self.fail("it ended before it could be disturbed: " + job.communicate()[0])
            self.assertLess(time.monotonic(), limit, "no rows")
            time.sleep(0.02)
        return job

    def many(self):
        """A spec of many cases, and the hash of the table that threads compute of it."""
        spec = self.write("many.json", CURVES % MANY)
        if Ranks.hash_of_many is None:
            Ranks.hash_of_many = self.by_threads(spec)
        return spec, Ranks.hash_of_many

    @staticmethod
    def end(job):
        if job.poll() is None:
            job.kill()
        job.communicate()

    def test_the_same_table_for_any_number_of_ranks(self):
        for spec in (SMALL, self.write("curves.json", CURVES % 20_000)):
            expected = self.by_threads(spec)
            (self.folder / "threads.sqlite").unlink()
            for ranks, threads in ((1, 1), (2, 1), (3, 1), (2, 2)):
                results = self.folder / f"{spec.stem}_{ranks}_{threads}.sqlite"
                done = run(*mpirun(ranks), EVC_MPI, "sweep", spec, "-j", threads, "-o", results)
                self.assertEqual(done.returncode, 0 if spec == SMALL else 1, done.stderr)
                self.assertEqual(table_hash(results), expected, f"{ranks} ranks of {threads} threads")
                self.assertFalse(pathlib.Path(f"{results}-wal").exists())

    def test_every_rank_computes(self):
        spec = self.write("curves.json", CURVES % 100_000)
        job = self.begin(3, spec, self.folder / "r.sqlite")
        used = {}
        while job.poll() is None:
            for rank, process in processes_of(job).items():
                try:
                    times = [int(p.read_text().split()[13]) for p in pathlib.Path(f"/proc/{process}/task").glob("*/stat")]
                except (OSError, IndexError):
                    continue
                # Its largest thread but the first, which waits for messages.
                used[rank] = max(used.get(rank, 0), sum(times))
            time.sleep(0.02)
        self.assertEqual(sorted(used), [0, 1, 2])
        self.assertGreater(min(used.values()), 0.2 * max(used.values()), used)

    def test_a_rank_is_killed_and_another_number_of_ranks_goes_on(self):
        spec, expected = self.many()
        results = self.folder / "killed.sqlite"
        had = 0
        # The first one creates the file, the others go on with it; the last rank to be killed is the one that writes.
        for ranks, killed in ((3, 1), (2, 1), (2, 0)):
            job = self.begin(ranks, spec, results, *(["--resume"] if had else []))
            os.kill(processes_of(job)[killed], signal.SIGKILL)
            said = job.communicate(timeout=60)[0]
            self.assertNotEqual(job.returncode, 0, said)
            there = rows(results)
            self.assertGreater(there, had, "what was committed is lost")
            self.assertLess(there, MANY)
            had = there
        rest = run(*mpirun(2), EVC_MPI, "sweep", spec, "--resume", "-o", results)
        self.assertEqual(rest.returncode, 1, rest.stderr)
        self.assertEqual(rows(results), MANY)
        self.assertEqual(table_hash(results), expected)
        again = run(*mpirun(3), EVC_MPI, "sweep", spec, "--resume", "-o", results)
        self.assertIn("; 0 computed", again.stdout)

    def test_a_signal_ends_it_with_whole_results(self):
        spec, expected = self.many()
        results = self.folder / "stopped.sqlite"
        had = 0
        # Of mpirun, as Ctrl-C does it; of one rank.
        for number, whose in ((signal.SIGINT, None), (signal.SIGTERM, None), (signal.SIGTERM, 1), (signal.SIGTERM, 0)):
            job = self.begin(2, spec, results, *(["--resume"] if had else []))
            os.kill(job.pid if whose is None else processes_of(job)[whose], number)
            said = job.communicate(timeout=60)[0]
            self.assertNotEqual(job.returncode, 0)
            if whose is not None:
                self.assertEqual(job.returncode, 1, said)
                self.assertIn("; stopped, --resume goes on", said)
            there = rows(results)
            self.assertGreater(there, had)
            had = there
        if had < MANY:
            self.assertEqual(run(*mpirun(2), EVC_MPI, "sweep", spec, "--resume", "-o", results).returncode, 1)
        self.assertEqual(table_hash(results), expected)

    def test_what_is_wrong_is_said_once_and_every_rank_ends_with_2(self):
        good = self.write("good.json", CURVES % 100)
        bad = self.write("bad.json", CURVES.replace("/train/brake", "/trian/brake") % 100)
        results = self.folder / "r.sqlite"
        for arguments, expected in (
                (f"sweep {bad} -o {results}", f"{bad}: /vary/0/at: found /trian/brake_percentage, which leads nowhere"),
                (f"sweep {self.folder}/absent.json -o {results}", "absent.json: found No such file or directory"),
                (f"sweep {good} -o {self.folder}/absent/r.sqlite", "found No such file or directory"),
                (f"sweep {good} -o -", "evc-mpi sweep: -o: found standard output"),
                (f"sweep {good} -j 0 -o {results}", "evc-mpi sweep: -j: found 0"),
                ("sweep", "evc-mpi sweep: found no description"),
                ("run", 'evc-mpi: found "run", expected one of sweep')):
            said = run(*mpirun(3), "sh", "-c", f'"{EVC_MPI}" {arguments}; echo "status $?"')
            with self.subTest(arguments):
                self.assertEqual(said.stdout.split("\n"), ["status 2"] * 3 + [""], said.stderr)
                self.assertEqual(said.stderr.count("\n"), 1, said.stderr)
                self.assertIn(expected, said.stderr)
                self.assertFalse(results.exists())

    def test_a_rank_with_other_files_is_named(self):
        data = programs.ROOT / "data"
        shutil.copytree(data, self.folder / "data", ignore=shutil.ignore_patterns("passenger_eoa.json", "cab"))
        query = (data / "curves/passenger_eoa.json").read_text("utf-8")
        other = self.folder / "data/curves/passenger_eoa.json"
        spec = self.write("spec.json", CURVES % 100)
        results = self.folder / "r.sqlite"
        # Rank 1 has no such file, or one with other words.
        for text, expected in ((None, "passenger_eoa"), (query.replace('"name": "', '"name": "other '), "differ from those of rank 0")):
            if text is not None:
                other.write_text(text, encoding="utf-8")
            said = run(*mpirun(3), "sh", "-c", f'[ "$OMPI_COMM_WORLD_RANK" != 1 ] || export OPENEVC_DATA="{self.folder}/data"; '
                       f'"{EVC_MPI}" sweep "{spec}" -o "{results}"; echo "status $?"')
            self.assertEqual(said.stdout.split("\n"), ["status 2"] * 3 + [""], said.stderr)
            self.assertEqual(said.stderr.count("\n"), 1, said.stderr)
            self.assertTrue(said.stderr.startswith("rank 1: "), said.stderr)
            self.assertIn(expected, said.stderr)
            self.assertFalse(results.exists())

    def test_an_installed_one_has_its_data(self):
        build, prefix = pathlib.Path(EVC_MPI).parent, self.folder / "prefix"
        said = run("cmake", "--install", build, "--component", "cluster", "--prefix", prefix)
        self.assertEqual(said.returncode, 0, said.stderr)
        self.assertTrue(os.access(prefix / "share/openevc/cluster/sweep.sbatch", os.X_OK))
        self.assertFalse((prefix / "include").exists())
        # Under another name a query is found in the data of the installation alone.
        (prefix / "share/openevc/curves/passenger_eoa.json").rename(prefix / "share/openevc/curves/elsewhere.json")
        spec = self.write("spec.json", (CURVES % 100).replace("passenger_eoa", "elsewhere"))
        results = self.folder / "r.sqlite"
        environment = {key: value for key, value in os.environ.items() if key != "OPENEVC_DATA"}
        said = run(*mpirun(2), prefix / "bin/evc-mpi", "sweep", spec, "-o", results, env=environment)
        self.assertIn(said.returncode, (0, 1), said.stderr)
        self.assertEqual(rows(results), 100)

    def test_standard_input_csv_and_few_cases(self):
        text = CURVES % 2
        spec = self.write("spec.json", text)
        expected = run(EVC, "sweep", spec, "--format", "csv").stdout
        self.assertEqual(expected.count("\n"), 3)
        said = run(*mpirun(3), EVC_MPI, "sweep", "-", "--format", "csv", input=text)
        self.assertEqual(said.stdout, expected, said.stderr)
        dry = run(*mpirun(3), EVC_MPI, "sweep", spec, "--dry-run")
        self.assertEqual(dry.returncode, 0)
        self.assertEqual(dry.stdout, run(EVC, "sweep", spec, "--dry-run").stdout)


if __name__ == "__main__":
    programs.main()
