# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tractive rolling of unlike cylinders by Gauss-Chebyshev quadrature, independent of the program's elements.

The problem is that of Bentall and Johnson (Int. J. Mech. Sci. 9 (1967) 389) and of Nowell and Hills (Int. J. Mech. Sci.
30 (1988) 427), who solve it with Chebyshev polynomials as well; written from the equations of two half-planes (Johnson
1985, 2.25), not from their papers, which were not available. Over the patch |X| < 1, X = (x - m)/b, with the pressure p
and the traction q on the upper body, both in units of b/(c R), c = 2 (1 - nu)/(pi G):

    PV int p/(X - T) dT - pi beta q = M + X                     contact, M = m/b
    PV int q/(X - T) dT + pi beta p = -xi R/b                   adhesion
    q = -+ mu p                                                 slip, against its direction

The patch is not symmetric, and pressure and traction are fully coupled. Material enters at X = 1. p and q are sqrt(1 -
X^2) times functions known at the N nodes T_k = cos(k pi/(N + 1)), for which the integrals are sums at the N + 1 points
between them (Erdogan and Gupta 1972). Adhesion is imposed at the point just upstream of the adhering node: that is the
solution bounded at the leading edge, and it has no singularity at the other end of an adhesion zone if and only if that
end is in the right place.
"""
import numpy as np


class Rollers:
    """`beta`: Dundurs' constant K/(1 - nu) of the pair, `friction` mu, `count` nodes across the patch."""

    def __init__(self, beta, friction, count=200):
        self.beta, self.friction, self.count = beta, friction, count
        k = np.arange(1, count + 1)
        angle = np.pi * k / (count + 1)
        between = np.pi * (2 * np.arange(1, count + 2) - 1) / (2 * (count + 1))
        self.node, self.point = np.cos(angle), np.cos(between)
        root = np.sin(angle)
        # maps values at nodes to PV int f/(X - T) dT at the points between
        self._integral = np.pi / (count + 1) * root / (self.point[:, None] - self.node)
        # maps to values at the points between, by f = sum b_n sin(n angle)
        sines = np.sin(np.outer(k, angle))
        self._between = 2 / (count + 1) * np.sin(np.outer(between, k)) @ sines
        self._whole = np.pi / (count + 1) * root  # int f dT

    def _solve(self, side, creepage, ratio):
        """(p, q, M, xi) for the state of every node: `side` 0 adheres, +-1 slips that way."""
        n = self.count
        # unknowns p (n), q (n), M, xi
        normal = np.hstack([self._integral, -np.pi * self.beta * self._between,
                            -np.ones((n + 1, 1)), np.zeros((n + 1, 1))])
        adhere = np.hstack([np.pi * self.beta * self._between[:n], self._integral[:n],
                            np.zeros((n, 1)), np.ones((n, 1))])
        slip = np.hstack([self.friction * np.diag(side.astype(float)), np.eye(n), np.zeros((n, 2))])
        last = np.zeros(2 * n + 2)
        if ratio is None:
            last[-1], value = 1.0, creepage
        else:
            last[:n], last[n:2 * n], value = -ratio * self.friction * self._whole, self._whole, 0.0
        system = np.vstack([normal, np.where((side == 0)[:, None], adhere, slip), last])
        right = np.concatenate([self.point, np.zeros(n), [value]])
        found = np.linalg.solve(system, right)
        return found[:n], found[n:2 * n], found[-2], found[-1]

    def roll(self, creepage=None, ratio=None):
        """Solution at a creepage (xi R/b) or at a force q = ratio mu p; a dict.

        "creepage" xi R/b, "force" (of q over mu P, negative when braked), "load" P in units of b^2/(c R), "p", "q" at
        `node`, "side".
        """
        side = np.zeros(self.count, int)
        seen = set()
        for _ in range(300):
            p, q, shift, xi = self._solve(side, creepage, ratio)
            bound = self.friction * np.maximum(p, 0)
            slip = xi + (self._integral @ q + np.pi * self.beta * self._between @ p)[:self.count]
            new = np.where(side == 0, np.where(np.abs(q) > bound, -np.sign(q).astype(int), 0),
                           np.where(slip * side < 0, 0, side))
            key = new.tobytes()
            if (new == side).all():
                break
            if key in seen:  # the iteration cycles: change only the worst node of each kind
                change = np.flatnonzero(new != side)
                new = side.copy()
                one = change[np.argmax(np.where(side[change] == 0, np.abs(q[change]) - bound[change],
                                                np.abs(slip[change])))]
                new[one] = 0 if side[one] else -int(np.sign(q[one]))
            seen.add(key)
            if ratio is not None and new.all():  # a given force needs a free node
                turn = np.flatnonzero(np.diff(new))
                new[turn], new[turn + 1] = 0, 0
            side = new
        else:
            raise ArithmeticError("the zones of adhesion and slip do not settle")
        load, pull = self._whole @ p, self._whole @ q
        return {"creepage": xi, "force": pull / (self.friction * load), "load": load, "p": p, "q": q, "side": side,
                "shift": shift, "slip": slip}

    def creepage(self, solution):
        """xi R/a, with a that of Hertz's contact (no friction) under the same load."""
        return solution["creepage"] * self.over_hertz(solution)

    @staticmethod
    def over_hertz(solution):
        """b/a: half the width of the patch over Hertz's at this load, where P = (pi/2) a^2/(pi c R)."""
        return np.sqrt(0.5 / solution["load"])

    def pressure(self, solution):
        """Largest pressure over Hertz's p0 = a/(pi c R) at this load."""
        return np.max(solution["p"]) * np.pi * self.over_hertz(solution)
