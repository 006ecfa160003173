# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""A Slurm of one node in a folder of its own, which needs root and the packages slurm-wlm and munge."""
import contextlib
import os
import secrets
import shutil
import signal
import socket
import subprocess
import time
from pathlib import Path

PATIENCE = 30  # seconds until a daemon has started, or ended

CONFIGURATION = """
ClusterName=one
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller_port}
SlurmdPort={node_port}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CryptoType=crypto/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,batch_sched_delay=0
MpiDefault=none
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs={cores} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def why_not():
    """Why no Slurm can be started here; nothing if one can."""
    missing = [name for name in ("munged", "slurmctld", "slurmd", "sbatch", "sinfo") if not shutil.which(name, path=SEARCH)]
    if missing:
        return f"{missing[0]} is not installed"
    return "it takes root to start Slurm" if os.geteuid() != 0 else ""


SEARCH = os.pathsep.join([os.environ.get("PATH", ""), "/usr/sbin"])


def _free_ports(count):
    with contextlib.ExitStack() as stack:
        sockets = [stack.enter_context(socket.socket()) for _ in range(count)]
        for each in sockets:
            each.bind(("127.0.0.1", 0))
        return [each.getsockname()[1] for each in sockets]


def _start(folder):
    for name in ("state", "spool", "munge"):
        (folder / name).mkdir()
    folder.chmod(0o755)
    (folder / "munge").chmod(0o700)
    key = folder / "munge" / "key"
    key.write_bytes(secrets.token_bytes(1024))
    key.chmod(0o600)
    host = socket.gethostname().split(".")[0]
    controller_port, node_port = _free_ports(2)
    configuration = CONFIGURATION.format(
        host=host, folder=folder, cores=os.cpu_count(), controller_port=controller_port, node_port=node_port
    )
    (folder / "slurm.conf").write_text(configuration)
    # Otherwise slurmd looks for a cgroup of version 2 in which it may not write.
    (folder / "cgroup.conf").write_text("CgroupPlugin=cgroup/v1\nCgroupMountpoint=/sys/fs/cgroup\n")
    environment = {**os.environ, "PATH": SEARCH, "SLURM_CONF": str(folder / "slurm.conf")}
    munged = ["munged", "--force", f"--key-file={key}", f"--socket={folder}/munge.socket"]
    munged += [f"--pid-file={folder}/munged.pid", f"--log-file={folder}/munge/log", f"--seed-file={folder}/munge/seed"]
    for command in (munged, ["slurmctld"], ["slurmd"]):
        subprocess.run(command, check=True, env=environment, timeout=PATIENCE)
    for _ in range(10 * PATIENCE):
        state = subprocess.run(["sinfo", "--noheader", "--format=%t"], capture_output=True, text=True, env=environment, timeout=PATIENCE)
        if state.stdout.strip() == "idle":
            return environment
        time.sleep(0.1)
    raise RuntimeError(f"no node of Slurm is idle: {state.stdout}{state.stderr}{(folder / 'slurmd.log').read_text()}")


def _stop(folder):
    for name in ("slurmd", "slurmctld", "munged"):
        with contextlib.suppress(OSError, ValueError):
            process = int((folder / f"{name}.pid").read_text())
            os.kill(process, signal.SIGTERM)
            for _ in range(10 * PATIENCE):
                os.kill(process, 0)
                time.sleep(0.1)


@contextlib.contextmanager
def one_node_slurm(folder):
    """The environment in which the commands of Slurm reach one that runs until the end."""
    folder = Path(folder)
    try:
        yield _start(folder)
    finally:
        _stop(folder)
