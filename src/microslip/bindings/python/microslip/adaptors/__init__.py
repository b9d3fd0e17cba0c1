# SPDX-License-Identifier: MIT
"""Adaptors of joints of microslip for other programs.

Each module is for one program and is imported by its name:

``microslip.adaptors.scipy``
    Time integration of structures with joints by `scipy.integrate.solve_ivp`.
``microslip.adaptors.tmdsimpy``
    A joint as a nonlinear force of tmdsimpy, <https://github.com/tmd-lab/tmdsimpy>.
"""
