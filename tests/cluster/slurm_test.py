#!/usr/bin/env -S python3 -B
"""evc-mpi under a real Slurm of one node, which the test starts in a scratch folder, on the loopback address, and ends.
Skipped, with the reason, where it cannot start. Usage: EVC=... EVC_MPI=... tests/cluster/slurm_test.py [TEST...]"""
import contextlib
import ctypes
import getpass
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import tempfile
import time
import unittest

import programs
from programs import CURVES, EVC_MPI, has_committed_rows, rows, run, table_hash

SCRIPT = programs.ROOT / "examples/cluster/sweep.sbatch"
SMALL = programs.ROOT / "examples/cluster/small.json"
DAEMONS = {name: next((p for p in (f"/usr/sbin/{name}", shutil.which(name)) if p and os.path.exists(p)), None)
           for name in ("munged", "slurmctld", "slurmd")}
CONFIGURATION = """\
ClusterName=openevc
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket={folder}/munge.socket
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
# Three ranks also where there are two processors.
SlurmdParameters=config_overrides
ReturnToService=2
KillWait=5
NodeName={host} NodeAddr=127.0.0.1 CPUs=4 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP
"""


def free_ports(count):
    with contextlib.ExitStack() as stack:
        sockets = [stack.enter_context(socket.socket()) for _ in range(count)]
        for s in sockets:
            s.bind(("127.0.0.1", 0))
        return [s.getsockname()[1] for s in sockets]


def ends_with_the_test():
    """In a daemon: it gets SIGTERM also when the test is killed (PR_SET_PDEATHSIG)."""
    ctypes.CDLL(None).prctl(1, signal.SIGTERM)


class Slurm:
    """A controller and one node."""

    def __init__(self):
        missing = [name for name in (*DAEMONS, "srun", "sbatch", "mpirun") if not DAEMONS.get(name, shutil.which(name))]
        if missing:
            raise unittest.SkipTest(f"no Slurm here: {', '.join(missing)} is missing (Debian: slurm-wlm, munge)")
        self.daemons = []
        # The names of sockets are short.
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="evc_slurm_", dir="/tmp"))
        self.folder.chmod(0o755)  # munge wants a socket that everybody can reach

    def begin(self, name, *arguments):
        with open(self.folder / f"{name}.out", "wb") as out:
            self.daemons.append(subprocess.Popen([DAEMONS[name], *map(str, arguments)], stdout=out, stderr=out,
                                                 stdin=subprocess.DEVNULL, preexec_fn=ends_with_the_test))

    def start(self):
        folder, host = self.folder, socket.gethostname().split(".")[0]
        for name in ("state", "spool"):
            (folder / name).mkdir()
        key = folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        configuration = folder / "slurm.conf"
        configuration.write_text(CONFIGURATION.format(host=host, user=getpass.getuser(), folder=folder,
                                                      ports=free_ports(2)), encoding="utf-8")
        # What Slurm starts is recognised by this when all is ended.
        os.environ["SLURM_CONF"] = str(configuration)
        self.begin("munged", "--foreground", f"--key-file={key}", f"--socket={folder}/munge.socket",
                   f"--pid-file={folder}/munged.pid", f"--log-file={folder}/munged.log", f"--seed-file={folder}/munge.seed")
        self.wait_for("munged", lambda: (folder / "munge.socket").exists())
        self.begin("slurmctld", "-D", "-f", configuration)
        self.begin("slurmd", "-D", "-f", configuration, "-N", host)
        self.wait_for("a node that is idle", lambda: run("sinfo", "-h", "-o", "%T").stdout.strip() == "idle")
        said = run("srun", "-n", 1, "true")
        if said.returncode != 0:
            self.cannot("srun of a command", said.stderr)

    def wait_for(self, what, there):
        limit = time.monotonic() + 40
        while not there():
            if time.monotonic() > limit or any(d.poll() is not None for d in self.daemons):
                self.cannot(what, "".join(p.read_text("utf-8", "replace")[-600:]
                                          for p in [*self.folder.glob("*.out"), *self.folder.glob("*.log")]))
            time.sleep(0.1)

    def cannot(self, what, said):
        self.end()
        raise unittest.SkipTest(f"Slurm cannot start here: {what} is missing:\n{said}")

    def others(self):
        """Processes that were started with this configuration, but for this one."""
        mark = f"SLURM_CONF={self.folder}/".encode()
        found = []
        for place in pathlib.Path("/proc").glob("[0-9]*"):
            with contextlib.suppress(OSError):
                if int(place.name) != os.getpid() and mark in (place / "environ").read_bytes():
                    found.append(int(place.name))
        return found

    def end(self):
        """Nothing of it stays: jobs, daemons, and whatever a job left behind."""
        if len(self.daemons) == 3:
            with contextlib.suppress(subprocess.TimeoutExpired):
                subprocess.run(["scancel", "-u", getpass.getuser()], capture_output=True, timeout=20)
                limit = time.monotonic() + 15
                while run("squeue", "-h").stdout.strip() and time.monotonic() < limit:
                    time.sleep(0.2)
        for daemon in reversed(self.daemons):
            daemon.terminate()
            try:
                daemon.wait(timeout=15)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        for process in self.others():
            with contextlib.suppress(OSError):
                os.kill(process, signal.SIGKILL)
        os.environ.pop("SLURM_CONF", None)
        shutil.rmtree(self.folder, ignore_errors=True)


class UnderSlurm(programs.InFolder):
    @classmethod
    def setUpClass(cls):
        cls.slurm = Slurm()
        cls.addClassCleanup(cls.slurm.end)
        cls.slurm.start()

    def submit(self, spec, results, launcher, *options):
        """The shipped batch script; returns (exit status, what the job said)."""
        said = self.folder / f"{results.stem}.txt"
        done = run("sbatch", "--wait", "--parsable", f"--output={said}", *options, SCRIPT, spec, results, cwd=self.folder,
                   env={**os.environ, "EVC_MPI": EVC_MPI, "EVC_LAUNCH": launcher})
        return done.returncode, said.read_text(encoding="utf-8") if said.exists() else done.stderr

    def test_srun_and_the_batch_script_give_the_table_of_threads(self):
        expected = self.by_threads(SMALL)
        results = self.folder / "srun.sqlite"
        done = run("srun", "--mpi=pmix", "-n", 3, EVC_MPI, "sweep", SMALL, "-o", results)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("40 computed", done.stdout)
        self.assertEqual(done.stdout.count("\n"), 1, "three programs of one rank?")
        self.assertEqual(table_hash(results), expected)
        for launcher in ("srun", "mpirun"):
            results = self.folder / f"sbatch_{launcher}.sqlite"
            status, said = self.submit(SMALL, results, launcher)
            self.assertEqual(status, 0, said)
            self.assertEqual(said.count("40 of 40 cases, 0 failed; 40 computed"), 1, said)
            self.assertEqual(table_hash(results), expected, launcher)

    def begin_job(self, spec, results, said):
        """Submits the shipped batch script and waits for the first rows. Returns (process of sbatch, number of the job)."""
        job = subprocess.Popen(["sbatch", "--wait", "--parsable", f"--output={said}", str(SCRIPT), str(spec), str(results)],
                               stdout=subprocess.DEVNULL, cwd=self.folder, env={**os.environ, "EVC_MPI": EVC_MPI})
        limit = time.monotonic() + 60
        while not has_committed_rows(results):
            self.assertLess(time.monotonic(), limit, "no rows")
            time.sleep(0.02)
        return job, run("squeue", "-h", "-o", "%i").stdout.strip()

    def test_a_job_that_is_cancelled_is_submitted_again(self):
        many = 1_000_000
        spec = self.write("many.json", CURVES % many)
        expected = self.by_threads(spec)
        results, said = self.folder / "r.sqlite", self.folder / "said.txt"
        # To the ranks alone, as --signal of the script does before the end of the time: they end by themselves.
        job, number = self.begin_job(spec, results, said)
        self.assertEqual(run("scancel", "--signal=TERM", number).returncode, 0)
        self.assertNotEqual(job.wait(timeout=60), 0)
        self.assertIn("; stopped, --resume goes on", said.read_text("utf-8"))
        there = rows(results)
        self.assertGreater(there, 0)
        self.assertLess(there, many)
        # To all of the job: srun, which gets it too, may kill the ranks before they have reported anything.
        # sbatch may return before the job has ended, and then with 0: a cancelled job counts as finished while its
        # processes still end, and it has no exit status until they have.
        job, number = self.begin_job(spec, results, said)
        self.assertEqual(run("scancel", number).returncode, 0)
        job.wait(timeout=60)
        limit = time.monotonic() + 60
        while run("squeue", "-h").stdout.strip():
            self.assertLess(time.monotonic(), limit, "the job does not end")
            time.sleep(0.1)
        more = rows(results)
        self.assertGreater(more, there)
        self.assertLess(more, many)
        status, output = self.submit(spec, results, "srun", "--ntasks=2")
        self.assertEqual(status, 1, output)  # some cases fail
        self.assertEqual(rows(results), many)
        self.assertEqual(table_hash(results), expected)

    def test_a_rank_that_is_killed_ends_the_job(self):
        spec = self.write("many.json", CURVES % 2_000_000)
        results = self.folder / "r.sqlite"
        job, _ = self.begin_job(spec, results, self.folder / "said.txt")
        ranks = {}
        for process in self.slurm.others():
            with contextlib.suppress(OSError):
                place = pathlib.Path(f"/proc/{process}")
                words = dict(w.split(b"=", 1) for w in (place / "environ").read_bytes().split(b"\0") if b"=" in w)
                if (place / "comm").read_text().strip() == "evc-mpi":
                    ranks[int(words[b"SLURM_PROCID"])] = process
        self.assertEqual(sorted(ranks), [0, 1, 2])
        os.kill(ranks[2], signal.SIGKILL)
        self.assertNotEqual(job.wait(timeout=60), 0)
        self.assertGreater(rows(results), 0)
        self.assertEqual(len(table_hash(results)), 64)

    def test_what_is_wrong_is_said_once(self):
        spec = self.write("bad.json", "{}")
        for launcher in ("srun", "mpirun"):
            status, said = self.submit(spec, self.folder / f"bad_{launcher}.sqlite", launcher)
            self.assertEqual(status, 2, said)
            self.assertEqual(said.count('bad.json: /: found no key "schema"'), 1, said)
            self.assertFalse((self.folder / f"bad_{launcher}.sqlite").exists())


if __name__ == "__main__":
    programs.main()
