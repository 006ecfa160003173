# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""How tests call mpirun."""

import os
import subprocess

# More processes than processors are wanted, and root runs them in containers.
MPIRUN = ["mpirun", "--oversubscribe"]
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_mpi_yield_when_idle": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1",
               # All processes are on this machine, where nothing but shared memory may be allowed.
               "OMPI_MCA_plm": "isolated", "OMPI_MCA_pml": "ob1", "OMPI_MCA_btl": "self,vader",
               "OMPI_MCA_btl_vader_single_copy_mechanism": "none"}


def can_start_processes():
    """Not where there is no network interface at all, for one."""
    return subprocess.run(MPIRUN + ["-n", "2", "true"], env=ENVIRONMENT, capture_output=True).returncode == 0
