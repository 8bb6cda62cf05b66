"""Runs MPI programs from pvpython, which is an MPI program itself."""
import os
import re
import subprocess
import tempfile

# Prefixes of the variables that mark a process as part of an MPI run.
OF_THIS_PROCESS = ("PMIX_", "PMI_", "ORTE_", "OMPI_")
# Settings of vfm_mpi_environment in Testing/CMakeLists.txt.
SETTINGS = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
            "OMPI_MCA_mpi_yield_when_idle": "1",
            "OMPI_MCA_pml": "ob1", "OMPI_MCA_btl": "self,vader",
            "OMPI_MCA_ess_singleton_isolated": "1", "OMPI_MCA_odls_base_sigkill_timeout": "0"}
LIMIT = 600  # seconds; other users share the machine
# Notice that a rank failed, which Open MPI 5 always prints.
LAUNCHER_NOTE = re.compile(r"^-{60,}\n.*?^-{60,}\n", re.DOTALL | re.MULTILINE)


def mpi_run(ranks, command, folder=None, without=(), **environment):
    """Runs a command on some ranks, by mpiexec if there are several; returns the completed process.

    Notices of mpiexec are removed from standard error. without:
    prefixes of environment variables that are not passed on.
    """
    variables = {name: value for name, value in os.environ.items()
                 if not name.startswith(OF_THIS_PROCESS + tuple(without))}
    launcher = ["mpiexec", "--oversubscribe", "--bind-to", "none", "-n",
                str(ranks)] if ranks > 1 else []
    with tempfile.TemporaryDirectory() as sessions:
        own = {"OMPI_MCA_orte_tmpdir_base": sessions}
        result = subprocess.run(
            launcher + command, env={**variables, **SETTINGS, **own, **environment}, cwd=folder,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=LIMIT)
    if ranks > 1:
        result.stderr = LAUNCHER_NOTE.sub("", result.stderr)
    return result
