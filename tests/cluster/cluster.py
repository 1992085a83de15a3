"""A Slurm cluster of one machine on its loopback interface and in a temporary folder: munged, slurmctld, slurmd.

The daemons run inside the `with` statement and are stopped at its end. The system is not changed, and an ordinary user
can run it.
"""

import os
import pwd
import secrets
import shutil
import signal
import socket
import subprocess
import time

DAEMONS = ("munged", "slurmctld", "slurmd")
SBIN = os.pathsep.join(["/usr/sbin", "/sbin"])
PATIENCE = 60  # seconds until the node is idle

# Slurm tracks the processes of tasks without cgroups. The stated cores and memory are those that the tasks of the guide
# need, so that any machine suffices.
CONFIGURATION = """\
ClusterName=loopback
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
SlurmUser={user}
SlurmdUser={user}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
SlurmdParameters=config_overrides
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
SchedulerParameters=bf_interval=1,sched_min_interval=0
MinJobAge=300
ReturnToService=2
NodeName=loopback NodeHostname={host} NodeAddr=127.0.0.1 CPUs=8 RealMemory=8192 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP
"""


def daemon_path(name):
    return shutil.which(name, path=os.environ.get("PATH", "") + os.pathsep + SBIN)


def free_ports(count):
    """Different ports of the loopback interface that are not in use."""
    sockets = [socket.socket() for _ in range(count)]
    try:
        for one in sockets:
            one.bind(("127.0.0.1", 0))
        return [one.getsockname()[1] for one in sockets]
    finally:
        for one in sockets:
            one.close()


class Cluster:
    def __init__(self, folder):
        self.folder = os.path.realpath(folder)
        self.processes = []
        self.environment = dict(os.environ, SLURM_CONF=os.path.join(self.folder, "slurm.conf"))

    def path(self, name):
        return os.path.join(self.folder, name)

    def start(self, name, *arguments):
        with open(self.path(name + ".output"), "wb") as output:
            self.processes.append(subprocess.Popen([daemon_path(name), *arguments], stdout=output, stderr=output,
                                                   stdin=subprocess.DEVNULL, env=self.environment, cwd=self.folder,
                                                   start_new_session=True))

    def configure(self):
        os.chmod(self.folder, 0o755)  # munged requires this of the folder of its socket
        for name in ("state", "spool"):
            os.mkdir(self.path(name))
        with open(os.open(self.path("munge.key"), os.O_WRONLY | os.O_CREAT, 0o600), "wb") as key:
            key.write(secrets.token_bytes(128))
        with open(self.environment["SLURM_CONF"], "w") as file:
            file.write(CONFIGURATION.format(folder=self.folder, host=socket.gethostname().split(".")[0],
                                            ports=free_ports(2), user=pwd.getpwuid(os.getuid()).pw_name))

    def wait_for(self, what, holds):
        end = time.monotonic() + PATIENCE
        while not holds():
            dead = [process.args[0] for process in self.processes if process.poll() is not None]
            if dead or time.monotonic() > end:
                raise RuntimeError(f"{dead[0] + ' ended' if dead else 'no ' + what}:\n{self.said()}")
            time.sleep(0.2)

    def node_is_idle(self):
        told = subprocess.run(["sinfo", "-h", "-o", "%T"], env=self.environment, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL)
        return told.stdout.strip() == b"idle"

    def said(self):
        """The last lines of all logs."""
        lines = []
        for name in sorted(os.listdir(self.folder)):
            if name.endswith((".log", ".output")):
                with open(self.path(name), errors="replace") as file:
                    lines += [f"{name}: {line.rstrip()}" for line in file.readlines()[-15:]]
        return "\n".join(lines)

    def __enter__(self):
        try:
            self.configure()
            self.start("munged", "--foreground", "--force", "--num-threads=2", "--socket=" + self.path("munge.socket"),
                       "--key-file=" + self.path("munge.key"), "--pid-file=" + self.path("munge.pid"),
                       "--seed-file=" + self.path("munge.seed"))
            self.wait_for("socket of munged", lambda: os.path.exists(self.path("munge.socket")))
            self.start("slurmctld", "-D", "-c")
            self.start("slurmd", "-D", "-c", "-N", "loopback")
            self.wait_for("idle node", self.node_is_idle)
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        for process in reversed(self.processes):
            if process.poll() is None:
                process.terminate()
                try:
                    process.wait(10)
                except subprocess.TimeoutExpired:
                    os.killpg(process.pid, signal.SIGKILL)
                    process.wait()
        self.processes = []
