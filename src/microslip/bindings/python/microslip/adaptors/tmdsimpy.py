# SPDX-License-Identifier: MIT
"""A joint as a nonlinear force of tmdsimpy, <https://github.com/tmd-lab/tmdsimpy>.

>>> import numpy as np
>>> import microslip
>>> from microslip.adaptors.tmdsimpy import JointForce
>>> joint = microslip.Joint.four_parameter(0.2, 0.25, -0.5, 0.0)
>>> force = JointForce(np.array([[1.0]]), np.array([[1.0]]), joint)
>>> harmonics, jacobian, _ = force.aft(np.array([0, 1.0, 0]), 1.0, np.array([0, 1]))
>>> bool(abs(harmonics[1] / joint.secant_stiffness(1.0) - 1) < 1e-5)
True

and then ``VibrationSystem(M, K).add_nl_force(force)``. tmdsimpy itself is not needed for it.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np

from .. import _core
from .._arguments import ArrayLike, RealArray, real_array, sequence, whole
from .._errors import InputError
from .._joint import Joint, Memory

if TYPE_CHECKING:
    _Base = object
else:
    try:
        from tmdsimpy.nlforces.nonlinear_force import HystereticForce as _Base
    except ImportError:  # it asks for the methods of a force, not for its class
        _Base = object


@lru_cache(maxsize=16)
def _tables(harmonics: int, samples: int) -> _core.HarmonicForce:
    return _core.HarmonicForce(harmonics, samples)


class JointForce(_Base):
    """Joints between degrees of freedom: the hysteretic force of tmdsimpy, with exact memory.

    Where `tmdsimpy` can be imported, it is a subclass of its ``HystereticForce``.

    A joint is virgin at a local displacement of 0, as in microslip; the class ``JenkinsForce`` of
    tmdsimpy takes it as virgin at the mean. Where the mean is 0, both are the same. After
    ``set_prestress_mu`` and an update of the history it is virgin where that left it.

    Parameters
    ----------
    Q : array_like
        From the degrees of freedom to the local displacements u [m], shape (joints, N).
    T : array_like
        From the local forces to those of the degrees of freedom, shape (N, joints).
    joint : Joint or sequence of Joint
        One for all, or one per row of Q.

    Raises
    ------
    ValueError
        Where shapes do not fit or an object is not a joint.
    """

    def __init__(self, Q: ArrayLike, T: ArrayLike, joint: Union[Joint, Sequence[Joint]]) -> None:
        self.Q = real_array(Q, "Q", ndim=2)
        self.T = real_array(T, "T", ndim=2)
        if self.T.shape != self.Q.shape[::-1]:
            raise InputError(f"T has the shape {self.T.shape}; must have {self.Q.shape[::-1]},"
                             " that of Q transposed")  # fmt: skip
        count = len(self.Q)
        joints = [joint] * count if isinstance(joint, Joint) else sequence(joint, "joint", "joints")
        if len(joints) != count:
            raise InputError(f"joint has {len(joints)}; must have {count}, one per row of Q")
        self.joints = tuple(joints)
        self.slips_freely = False
        self.init_history()

    def nl_force_type(self) -> int:
        """1: a hysteretic force."""
        return 1

    def init_history(self) -> None:
        """All joints virgin at 0."""
        self.memories = [Memory(joint) for joint in self.joints]
        self.virgin_at = np.zeros(len(self.joints))

    def set_prestress_mu(self) -> None:
        """The joints slip without force until `reset_real_mu`."""
        self.slips_freely = True

    def reset_real_mu(self) -> None:
        """Restores the joints after `set_prestress_mu`."""
        self.slips_freely = False

    def force(self, X: ArrayLike, update_hist: bool = False) -> tuple[RealArray, RealArray]:
        """The force after a step from the present state of the history.

        Parameters
        ----------
        X : array_like
            Displacements of the degrees of freedom, m, shape (N,).
        update_hist : bool
            Whether the step is taken.

        Returns
        -------
        F : ndarray
            N, shape (N,).
        dFdX : ndarray
            N/m, shape (N, N).
        """
        local = self.Q @ real_array(X, "X", length=self.Q.shape[1], per="one per degree of freedom")
        if self.slips_freely:
            responses = [(0.0, 0.0)] * len(self.joints)
            if update_hist:
                self.init_history()
                self.virgin_at = local
        else:
            path = local - self.virgin_at
            responses = [memory.trial(u) for memory, u in zip(self.memories, path)]
            if update_hist:
                for memory, u in zip(self.memories, path):
                    memory.advance(u)
        forces, tangents = np.transpose(responses)
        return self.T @ forces, (self.T * tangents) @ self.Q

    def aft(
        self,
        U: ArrayLike,
        w: float,
        h: Any,
        Nt: int = 128,
        tol: float = 1e-7,
        calc_grad: bool = True,
    ) -> tuple[Any, ...]:
        """Harmonics of the force in steady vibration.

        Parameters
        ----------
        U : array_like
            Displacements of the degrees of freedom, m, shape (N*Nhc,): all of the mean, then of the
            cosine of the first harmonic, of its sine, ...
        w : float
            Angular frequency, rad/s; joints do not ask for it.
        h : array_like of int
            Harmonics of U, rising; 0 is the mean.
        Nt : int
            Samples of a cycle, above 2 h_max + 1; between them the memory is exact.
        tol : float
            Not needed: the steady cycle is computed at once.
        calc_grad : bool
            Whether derivatives are returned.

        Returns
        -------
        Fnl : ndarray
            Forces, N, in the order of U.
        dFnldU : ndarray
            N/m, shape (N*Nhc, N*Nhc).
        dFnldw : ndarray
            Zeros, N s/rad, shape (N*Nhc,).
        """
        kept = _Kept(np.asarray(h))
        components = kept.places.size
        given = real_array(U, "U", ndim=None)
        samples = whole(Nt, "Nt", 2 * kept.highest + 2)
        dofs = self.Q.shape[1]
        if given.shape != (dofs * components,):
            raise InputError(f"U has the shape {given.shape}; must have {(dofs * components,)}")
        local = self.Q @ given.reshape(components, dofs).T
        forces = np.zeros(local.shape)
        blocks = np.zeros((len(self.joints), components, components))
        if not self.slips_freely:
            for j, joint in enumerate(self.joints):
                forces[j], blocks[j] = self._harmonics(joint, local[j], kept, samples, self.virgin_at[j])
        harmonics = (self.T @ forces).T.reshape(-1)
        if not calc_grad:
            return (harmonics,)
        jacobian = np.einsum("aj,jmn,jb->manb", self.T, blocks, self.Q)
        return harmonics, jacobian.reshape(given.size, given.size), np.zeros(given.size)

    @staticmethod
    def _harmonics(joint: Joint, local: RealArray, kept: _Kept, samples: int,
                   virgin_at: float) -> tuple[RealArray, RealArray]:  # fmt: skip
        full = np.zeros(2 * kept.highest + 1)
        full[kept.places] = kept.signs * local
        full[0] -= virgin_at
        force, jacobian, *_ = _tables(kept.highest, samples).evaluate(joint._core, full)
        return (
            kept.signs * force[kept.places],
            kept.signs[:, None] * jacobian[np.ix_(kept.places, kept.places)] * kept.signs,
        )

    def local_force_history(
        self,
        unlt: ArrayLike,
        unltdot: Optional[ArrayLike] = None,
        h: Any = None,
        cst: Optional[ArrayLike] = None,
        unlth0: Optional[ArrayLike] = None,
        max_repeats: int = 2,
        atol: float = 1e-10,
        rtol: float = 1e-10,
    ) -> tuple[RealArray, None, None]:
        """Forces of a steady cycle, for loops.

        Parameters
        ----------
        unlt : array_like
            Local displacements, m, shape (samples, joints). A joint reverses at samples: motion
            beyond them in between is not seen.
        unltdot, h, cst, unlth0, max_repeats, atol, rtol
            Not needed.

        Returns
        -------
        ft : ndarray
            Local forces of the steady cycle, N, shape (samples, joints).
        None, None
            In place of the derivatives, which `aft` has.
        """
        path = real_array(unlt, "unlt", ndim=2) - self.virgin_at
        forces = np.zeros(path.shape)
        if not self.slips_freely:
            for j, joint in enumerate(self.joints):
                memory = Memory(joint)
                memory.march(path[:, j])
                forces[:, j] = memory.march(path[:, j])
        return forces, None, None


class _Kept:
    """Indices of the real numbers (x_0, Re x_1, Im x_1, ...) of harmonics h, and the sign of each:
    tmdsimpy has x_0, cosines and sines, Im x_n = -sine."""

    def __init__(self, h: Any) -> None:
        if h.ndim != 1 or h.size == 0 or h.dtype.kind not in "iu" or h[0] < 0 or np.any(np.diff(h) < 1):
            raise InputError(f"h = {h}; must be harmonics, whole numbers that rise")
        self.highest = max(int(h[-1]), 1)
        moving = h[h > 0]
        mean = np.zeros(int(h[0] == 0), dtype=int)
        self.places = np.concatenate((mean, np.stack((2 * moving - 1, 2 * moving), 1).reshape(-1)))
        self.signs = np.concatenate((np.ones(mean.size), np.tile((1.0, -1.0), moving.size)))
