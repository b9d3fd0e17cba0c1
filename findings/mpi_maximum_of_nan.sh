#!/usr/bin/env bash
# Open MPI 4.1.4 (openmpi-bin 4.1.4-3+b1) and MPICH 4.0.2 (mpich 4.0.2-3+b1): MPI_Allreduce with MPI_MAX of the
# residuals 1, 2, NaN and 4 of four ranks.
#
# Guess: NaN on every rank or 4 on every rank: it wins or is left out, and an all-reduction gives all ranks the same.
# Instead: Open MPI gives 2 on every rank: the NaN is gone, and the 4 with it. MPICH gives the ranks different results,
#   among them NaN, 2 and 4. The maximum of two numbers is a comparison, which is false with a NaN, so
#   that the operand that stands second wins; MPICH has each rank combine in an order of its own.
# Why it matters: the largest residual of all ranks decides whether an iteration ends. One rank whose march or
#   joint has failed is not seen, hides the residual of another, or makes some ranks go on and others stop, which
#   then wait for each other.
# A way to live with it: reduce a flag isfinite() as well; or the sum of squares, in which a NaN stays.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian python3=3.11.2-1+b1 openmpi-bin=4.1.4-3+b1 libopenmpi3=4.1.4-3+b1 mpich=4.0.2-3+b1 libmpich12=4.0.2-3+b1

# By ctypes, since no compiler is needed for it: the handles are constants in MPICH and addresses in Open MPI.
cat >maximum.py <<'END'
import ctypes
import sys

name, *values = sys.argv[1:]
mpi = ctypes.CDLL(name, mode=ctypes.RTLD_GLOBAL)
if "mpich" in name:
    world, double, maximum = (ctypes.c_int(handle) for handle in (0x44000000, 0x4C00080B, 0x58000001))
else:
    world, double, maximum = (ctypes.c_void_p(ctypes.addressof(ctypes.c_char.in_dll(mpi, f"ompi_mpi_{handle}")))
                              for handle in ("comm_world", "double", "op_max"))
mpi.MPI_Init(None, None)
rank, result = ctypes.c_int(), ctypes.c_double()
mpi.MPI_Comm_rank(world, ctypes.byref(rank))
value = ctypes.c_double(float(values[rank.value]))
mpi.MPI_Allreduce(ctypes.byref(value), ctypes.byref(result), 1, double, maximum, world)
with open(f"result.{rank.value}", "w") as file:
    file.write(f"{result.value:g}\n")
mpi.MPI_Finalize()
END

maximum() { # LAUNCHER… LIBRARY VALUE…: what each rank has
  rm -f result.*
  "${launcher[@]}" python3 maximum.py "$@" >run.log 2>&1 || fail "does not run: $(tail -n 3 run.log)"
  cat result.0 result.1 result.2 result.3 | xargs
}

export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
launcher=(mpirun.openmpi --oversubscribe -np 4)
plain="$(maximum libmpi.so.40 1 2 3 4)"
[[ "$plain" == "4 4 4 4" ]] || fail "Open MPI: the maximum of 1 to 4 is $plain"
open="$(maximum libmpi.so.40 1 2 nan 4)"
launcher=(mpiexec.hydra -n 4)
plain="$(maximum libmpich.so.12 1 2 3 4)"
[[ "$plain" == "4 4 4 4" ]] || fail "MPICH: the maximum of 1 to 4 is $plain"
mpich="$(maximum libmpich.so.12 1 2 nan 4)"
[[ "$open" == "2 2 2 2" ]] || fail "Open MPI gives $open"
(("$(tr ' ' '\n' <<<"$mpich" | sort -u | wc -l)" > 1)) || fail "MPICH gives all ranks the same: $mpich"
seen "the maximum of 1 2 nan 4 is $open by Open MPI and $mpich by MPICH on the ranks"
