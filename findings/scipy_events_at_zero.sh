#!/usr/bin/env bash
# SciPy 1.10.1 (python3-scipy 1.10.1-2): events of scipy.integrate.solve_ivp of a slider (Jenkins element).
#
# Guess: an event is where the function changes sign, so the reserve of friction, limit - |force|, which is 0 as long as
#   the slider slips, gives one event where slip begins, three in the cycle below.
# Instead: two zeros in succession count as a change of sign. Every step during slip is an event, with every method and
#   also with direction = -1: 84 events for three slips, 375 with smaller steps. A terminal event of a run that starts
#   during slip ends it at once, after no time.
# Why it matters: the number of slips and the time between them are what one asks events for; with more accuracy
#   there are more of them.
# A way to live with it: two functions, one for each state: the reserve while it sticks, the velocity while it slips,
#   and a run for each state; or count only events that follow a time with a positive reserve.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian python3-scipy=1.10.1-2

cat >slip.py <<'END'
import numpy as np
from scipy.integrate import solve_ivp

limit = 0.3


def rate(time, state):
    velocity, force = np.cos(time), state[0]
    slips = force >= limit and velocity > 0 or force <= -limit and velocity < 0
    return [0.0 if slips else velocity]


def reserve(time, state):
    return limit - min(abs(state[0]), limit)


reserve.direction = -1


def events_of(method, step):
    result = solve_ivp(rate, (0, 2 * np.pi), [0.0], method, events=reserve, max_step=step, rtol=1e-6)
    return result.t_events[0].size


reserve.terminal = True
end = solve_ivp(rate, (0.5, 2 * np.pi), [limit], events=reserve).t[-1]
reserve.terminal = False
print("3 slips begin:", ", ".join(f"{method} {events_of(method, 0.05)} and {events_of(method, 0.01)} events"
                                  for method in ("RK45", "Radau", "LSODA")),
      f"; from slip at 0.5 s to {end} s")
assert all(events_of(method, 0.05) > 40 and events_of(method, 0.01) > 3 * events_of(method, 0.05)
           for method in ("RK45", "Radau", "LSODA"))
assert end == 0.5
END
python3 slip.py >slip.txt || fail "there are other numbers of events: $(cat slip.txt)"
seen "$(cat slip.txt)"
