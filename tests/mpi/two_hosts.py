#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Two hosts on one machine, with a network of a chosen latency between them: network namespaces with a name, an address
and a tunnel each, and a process that holds every packet back for a while.

usage, as root: two_hosts.py MILLISECONDS COMMAND...   runs mpirun COMMAND with one process on each
"""

import collections
import fcntl
import os
import select
import struct
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

from mpirun import ENVIRONMENT

NETWORK = "10.77.0"
NAMES = ("one", "two")
TUNSETIFF, IFF_TUN, IFF_NO_PI = 0x400454CA, 0x0001, 0x1000
MOST_BYTES = 65536
# What Open MPI needs to know: how to reach a host, and that there is no shared memory between two.
AGENT = """#!/bin/sh
name=$1
shift
case $name in
  *.1) name=one ;;
  *) name=two ;;
esac
exec ip netns exec "hardball_$name" unshare --uts sh -c "hostname $name; $*"
"""


def are_possible():
    """Whether this machine lets a process have namespaces and tunnels, and starts processes in them."""
    if os.geteuid() != 0:
        return False
    try:
        with TwoHosts(0) as hosts:
            return hosts.mpirun(["true"], capture_output=True).returncode == 0
    except (OSError, subprocess.CalledProcessError):
        return False


class TwoHosts:
    """Two hosts, while it is entered; packets between them take `delay` seconds, one way."""

    def __init__(self, delay):
        self.delay = delay

    def __enter__(self):
        self.tunnels = []
        for number, name in enumerate(NAMES, 1):
            namespace, device = f"hardball_{name}", f"hardball{number}"
            subprocess.run(["ip", "netns", "delete", namespace], capture_output=True)
            subprocess.run(["ip", "netns", "add", namespace], check=True)
            tunnel = os.open("/dev/net/tun", os.O_RDWR | os.O_NONBLOCK)
            fcntl.ioctl(tunnel, TUNSETIFF, struct.pack("16sH", device.encode(), IFF_TUN | IFF_NO_PI))
            subprocess.run(["ip", "link", "set", device, "netns", namespace], check=True)
            inside = ["ip", "-netns", namespace]
            subprocess.run([*inside, "address", "add", f"{NETWORK}.{number}/24", "dev", device], check=True)
            subprocess.run([*inside, "link", "set", device, "mtu", "1500", "up"], check=True)
            subprocess.run([*inside, "link", "set", "lo", "up"], check=True)
            self.tunnels.append(tunnel)
        self.folder = tempfile.TemporaryDirectory()
        self.agent = Path(self.folder.name, "agent")
        self.agent.write_text(AGENT)
        self.agent.chmod(0o755)
        self.is_open = True
        self.network = threading.Thread(target=self._carry)
        self.network.start()
        return self

    def __exit__(self, *_):
        self.is_open = False
        self.network.join()
        for tunnel in self.tunnels:
            os.close(tunnel)
        for name in NAMES:
            subprocess.run(["ip", "netns", "delete", f"hardball_{name}"], check=True)
        self.folder.cleanup()

    def _carry(self):
        """Takes packets from both, and hands each on when its time has come."""
        first, second = self.tunnels
        other = {first: second, second: first}
        waiting = collections.deque()
        while self.is_open:
            wait = max(0.0, waiting[0][0] - time.monotonic()) if waiting else 0.1
            for tunnel in select.select(self.tunnels, [], [], wait)[0]:
                waiting.append((time.monotonic() + self.delay, other[tunnel], os.read(tunnel, MOST_BYTES)))
            while waiting and waiting[0][0] <= time.monotonic():
                _, tunnel, packet = waiting.popleft()
                os.write(tunnel, packet)

    def on(self, name, command, **options):
        """Runs a command on a host."""
        words = ["ip", "netns", "exec", f"hardball_{name}", "unshare", "--uts"]
        words += ["sh", "-c", 'hostname "$1"; shift; exec "$@"', "sh", name, *map(str, command)]
        return subprocess.run(words, **options)

    def mpirun(self, command, processes=2, **options):
        """Runs a command in as many processes, half of them on each host."""
        environment = {**ENVIRONMENT, "OMPI_MCA_plm": "rsh", "OMPI_MCA_plm_rsh_agent": str(self.agent),
                       "OMPI_MCA_btl": "self,tcp", "OMPI_MCA_btl_tcp_if_include": f"{NETWORK}.0/24",
                       "OMPI_MCA_oob_tcp_if_include": f"{NETWORK}.0/24"}
        slots = ",".join(f"{NETWORK}.{number}:{processes // 2}" for number in (1, 2))
        return self.on("one", ["mpirun", "-n", processes, "--host", slots, *command], env=environment, **options)


if __name__ == "__main__":
    with TwoHosts(1e-3 * float(sys.argv[1])) as hosts:
        sys.exit(hosts.mpirun(sys.argv[2:]).returncode)
