# SPDX-License-Identifier: Apache-2.0
"""The energy channels of a series: what is stored, what was lost, what walls put in.

Every energy is a column `NAME_j` (J) of series.csv. The names here are those of the program's own
ledger, which keeps  work + brought in - taken out = change of stored energy + losses + residue.
"""
import numpy as np

from figures.table import NotRecorded

STORED = (("kinetic_translation", "kinetic, translation"), ("kinetic_rotation", "kinetic, spin"),
          ("gravity", "gravity"),
          ("elastic_normal", "elastic, normal"), ("elastic_tangential", "elastic, tangential"))
LOST = (("lost_normal", "normal dashpots"), ("lost_tangential", "tangential dashpots"),
        ("lost_sliding", "sliding"), ("lost_rolling", "rolling"),
        ("mindlin_residue", "Mindlin residue"))


class Ledger:
    def __init__(self, series):
        self.series = series
        if "time_s" not in series:
            raise NotRecorded("series.csv has no column time_s")
        self.time = series["time_s"]

    def column(self, name):
        values = self.series.get(f"{name}_j")
        return values if values is not None and values.dtype.kind == "f" else None

    def channels(self, which):
        """Triples of name, label and values (J) of the channels in `which` that were recorded."""
        found = ((name, label, self.column(name)) for name, label in which)
        return [channel for channel in found if channel[2] is not None]

    def losses(self):
        """All losses together (J), the Mindlin residue included, or None."""
        found = [values for _, _, values in self.channels(LOST)]
        return np.sum(found, axis=0) if found else None

    def stored(self):
        found = [values for _, _, values in self.channels(STORED)]
        return np.sum(found, axis=0) if found else None

    def work(self):
        """Work of all walls on the particles (J), or None. Walls at rest do none, so in a mill this
        is the drum's."""
        return self.column("work")

    def brought(self):
        """Energy of the particles that feeds brought in (J), or None."""
        return self.column("brought_in")

    def taken(self):
        """Energy of the particles that outlets took out (J), or None."""
        return self.column("taken_out")

    def residual(self):
        """What the balance leaves open (J), as the program counted it, or None."""
        return self.column("residual")

    def turnover(self):
        """What the residual is compared with: the largest of work, losses and stored energy."""
        sizes = (np.ptp(values) for values in (self.work(), self.losses(), self.stored())
                 if values is not None)
        return max(sizes, default=0.0)
