# SPDX-License-Identifier: MIT
"""Joints of microslip in the programs of others.

Each module here is for one of them and is imported by its name:

``microslip.adaptors.scipy``
    Structures with joints in time by `scipy.integrate.solve_ivp`.
``microslip.adaptors.tmdsimpy``
    A joint as a nonlinear force of tmdsimpy, <https://github.com/tmd-lab/tmdsimpy>.
"""
